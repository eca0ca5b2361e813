"""Facts as tables: equal members share a column, so that twelve cylinders need two; different ones have a row each."""

import itertools
import textwrap
from collections.abc import Iterator, Sequence
from functools import reduce
from typing import NamedTuple, TypeAlias

import numpy as np
from rich.text import Text

from cranktrain.analysis.dimensions import dimension_named
from cranktrain.cli.screen.columns import grid_lines
from cranktrain.cli.screen.text import GAP, table
from cranktrain.grouping import grouped
from cranktrain.language import said as _
from cranktrain.layout.question import ResultDimension
from cranktrain.motion import Array
from cranktrain.record import record
from cranktrain.saying.amounts import Figures, figures, in_cycle
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.sections import Column, Grid, HasFacts
from cranktrain.saying.wording import ABSENT, ranged

_MOST_COLUMNS = 3
"""Of a table with one row for each fact; facts that need more groups get one row for each group."""

_OF_MACHINE = ResultDimension("", "")


@record
class FactRow:
    """A fact as text.

    Attributes
    ----------
    entry : Entry
    unit : str
    texts : dict of str
        By member; a member may lack the fact.
    """

    entry: Entry
    unit: str
    texts: dict[str, str]

    @property
    def head(self) -> tuple[str, str, str]:
        """Name, symbol and unit."""
        return self.entry.name, self.entry.symbol, self.unit

    def text(self, member: str) -> str:
        """What stands for a member; nothing where it lacks the fact."""
        return self.texts.get(member, "")


class _Family(NamedTuple):
    """Facts with common members: of the pistons and chambers that are called alike, of the banks, …

    dimension is that of its family, or its own; none of facts of the machine. title says what the members are.
    """

    dimension: str
    title: str
    members: tuple[str, ...]
    rows: list[FactRow]


_Line: TypeAlias = tuple[str, list[str]]
"""Label and texts of a line of a table with one column for each fact."""


def fact_tables(result: HasFacts, names: Sequence[str], width: int) -> Iterator[str | Text]:
    """Lay out facts.

    Parameters
    ----------
    result : HasFacts
    names : sequence of str
        Which of its facts.
    width : int
        Columns of the screen.

    Yields
    ------
    str or Text
        Tables, one below the other: their lines, and paragraphs that name their columns.
    """
    flat = [name for name in names if len(result.catalogue[name].dimensions) <= 1]
    for i, (_dimension, title, members, rows) in enumerate(_families([_row(result, name) for name in flat])):
        narrow, groups = _narrow(rows, members, width)
        if narrow:
            if i:
                yield ""
            yield from _by_fact(narrow, groups, members, width)
        wide = [row for row in rows if row not in narrow]
        if wide:
            yield from _by_member(wide, _lines(wide, members), width, _(title) if title else "")
    deep = [result.catalogue[name] for name in names if name not in flat]
    for dimensions in dict.fromkeys(entry.dimensions for entry in deep):
        entries = [entry for entry in deep if entry.dimensions == dimensions]
        yield from _deep(result, entries, width)


def _row(result: HasFacts, name: str) -> FactRow:
    """Write a fact with at most one dimension; one member needs no name."""
    entry = result.catalogue[name]
    members = tuple(label for titles in result.titles_of(entry).values() for label in titles)
    shown = figures(np.atleast_1d(_values(result, entry)), entry.shown)
    return FactRow(entry, shown.unit, dict(zip(members if len(members) > 1 else ("",), shown.texts, strict=True)))


def _values(result: HasFacts, entry: Entry) -> Array:
    """What a result holds of a fact; crank angles as they are said."""
    values: Array = getattr(result, entry.name)
    return in_cycle(values, result.cycle, "deg") if entry.is_place else values


def _families(rows: Sequence[FactRow]) -> list[_Family]:
    """Sort facts by their dimension; of one family, a part of the members belongs with all of them."""
    families: list[_Family] = []
    for row in rows:
        members = tuple(row.texts)
        own = dimension_named(row.entry.dimensions[0]) if len(members) > 1 else _OF_MACHINE
        dimension, title = (own.family, "") if own.family else (own.name, own.title)
        for i, family in enumerate(families):
            is_part = set(family.members) <= set(members) or set(members) <= set(family.members)
            if family.dimension == dimension and is_part:
                families[i] = family._replace(members=max(family.members, members, key=len), rows=[*family.rows, row])
                break
        else:
            families.append(_Family(dimension, title, members, [row]))
    return families


def _groups(rows: Sequence[FactRow], members: Sequence[str]) -> list[list[int]]:
    """Put members together that are equal in all of some facts."""
    return reduce(lambda groups, row: _split(groups, row, members), rows, [list(range(len(members)))])


def _split(groups: Sequence[Sequence[int]], row: FactRow, members: Sequence[str]) -> list[list[int]]:
    """Part groups of members that are not equal in one more fact."""
    found = grouped(((i, row.text(members[k])), k) for i, group in enumerate(groups) for k in group)
    return sorted(found.values())


def _narrow(rows: Sequence[FactRow], members: Sequence[str], width: int) -> tuple[list[FactRow], list[list[int]]]:
    """Choose the facts, fewest groups first, that go together into one table with few columns."""
    chosen: list[FactRow] = []
    groups = [list(range(len(members)))]
    for row in sorted(rows, key=lambda row: len(_groups([row], members))):
        finer = _split(groups, row, members)
        if len(finer) == 1 or (len(finer) <= _MOST_COLUMNS and _natural_width([*chosen, row], finer, members) <= width):
            chosen, groups = [*chosen, row], finer
    return [row for row in rows if row in chosen], groups


def _natural_width(rows: Sequence[FactRow], groups: Sequence[Sequence[int]], members: Sequence[str]) -> int:
    """Columns of the screen that a table by fact takes."""
    heads = sum(max(len(row.head[i]) for row in rows) + GAP for i in range(3))
    return heads + sum(
        GAP + max(len(ranged(members, group)), *(len(row.text(members[group[0]])) for row in rows)) for group in groups
    )


def _by_fact(
    rows: Sequence[FactRow], groups: Sequence[Sequence[int]], members: Sequence[str], width: int
) -> list[Text]:
    """One row for each fact, one column for each group; of all, whose names are too long, they are not named."""
    has_room = len(groups) > 1 or _natural_width(rows, groups, members) <= width
    heads = ["", "", "", *(ranged(members, group) if has_room else _("all") for group in groups)]
    cells = [[*row.head, *(row.text(members[group[0]]) for group in groups)] for row in rows]
    return table(heads, cells, right=range(3, len(heads)))


def _lines(rows: Sequence[FactRow], members: Sequence[str], outer: str = "") -> list[_Line]:
    """One line for each group of members of which there is anything to say."""
    groups = _groups(rows, members)
    return [
        (" ".join(filter(None, (outer, ranged(members, group) if len(groups) > 1 else ""))), texts)
        for group in groups
        if set(texts := [row.text(members[group[0]]) for row in rows]) != {ABSENT}
    ]


def _deep(result: HasFacts, entries: Sequence[Entry], width: int) -> Iterator[str | Text]:
    """Facts with more dimensions, as of each piston by each method: a line for each method and group of pistons."""
    *outer, members = result.titles_of(entries[0]).values()
    shown = [_of_members(_values(result, entry), entry) for entry in entries]
    lines: list[_Line] = []
    rows: list[FactRow] = []
    for i, names in enumerate(itertools.product(*outer)):
        start = i * len(members)
        rows = [
            FactRow(entry, one.unit, dict(zip(members, one.texts[start : start + len(members)], strict=True)))
            for entry, one in zip(entries, shown, strict=True)
        ]
        lines += _lines(rows, members, ", ".join(names))
    yield from _by_member(rows, lines, width)


def _of_members(values: Array, entry: Entry) -> Figures:
    """Write values with several dimensions; what is rounding beside the largest of its own mode is nothing."""
    axes = tuple(i for i, name in enumerate(entry.dimensions) if not dimension_named(name).is_apart)
    beside = np.fmax.reduce(np.abs(values), axis=axes, keepdims=True, initial=0.0)
    return figures(values.ravel(), entry.shown, np.broadcast_to(beside, values.shape).ravel())


def _by_member(rows: Sequence[FactRow], lines: Sequence[_Line], width: int, title: str = "") -> Iterator[str | Text]:
    """One column for each fact, as many as there is room for side by side, and the facts' names below."""
    labels = [textwrap.wrap(label, width // 2, break_on_hyphens=False) or [""] for label, _texts in lines]
    columns = [
        Column(
            row.entry.symbol or row.entry.name,
            [
                cell
                for (_label, texts), label in zip(lines, labels, strict=True)
                for cell in [texts[i], *([""] * (len(label) - 1))]
            ],
            row.unit,
            quantity=row.entry.name,
        )
        for i, row in enumerate(rows)
    ]
    beside = [part for label in labels for part in label]
    yield ""
    yield from grid_lines(Grid(columns, beside, title, names_quantities=True), width)
