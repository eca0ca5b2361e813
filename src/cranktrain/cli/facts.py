"""Facts as tables: equal members share a column, so that twelve cylinders need two and nine different ones their own."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from rich.console import RenderableType
from rich.padding import Padding
from rich.text import Text

from cranktrain.analysis import Result
from cranktrain.catalogue import Entry
from cranktrain.cli.figures import figures
from cranktrain.cli.screen import table
from cranktrain.wording import ranged

_MOST_COLUMNS = 3
"""Of a table with one row for each fact; facts that need more groups get one row for each group."""

_GAP = 2


@dataclass(frozen=True)
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


def fact_tables(result: Result, names: Sequence[str], width: int) -> Iterator[RenderableType]:
    """Lay out facts.

    Parameters
    ----------
    result : Result
    names : sequence of str
        Which of its facts.
    width : int
        Columns of the screen.

    Yields
    ------
    RenderableType
        Tables, one below the other.
    """
    for members, rows in _families(result, names):
        narrow, groups = _narrow(rows, members, width)
        if narrow:
            yield _by_fact(narrow, groups, members)
        wide = [row for row in rows if row not in narrow]
        if wide:
            yield from _by_group(wide, members, width)


def _families(result: Result, names: Sequence[str]) -> list[tuple[tuple[str, ...], list[FactRow]]]:
    """Sort facts into families with common members: the pistons' (and chambers' of the same names), the banks', …"""
    families: list[tuple[tuple[str, ...], list[FactRow]]] = []
    for name in names:
        entry, value = result.facts[name]
        members = tuple(label for labels in result.labels_of(entry).values() for label in labels)
        members = members if len(members) > 1 else ("",)
        shown = figures(np.atleast_1d(value), entry.unit)
        row = FactRow(entry, shown.unit, dict(zip(members, shown.texts, strict=True)))
        for i, (known, rows) in enumerate(families):
            if set(known) <= set(members) or set(members) <= set(known):
                families[i] = (max(known, members, key=len), [*rows, row])
                break
        else:
            families.append((members, [row]))
    return families


def _groups(rows: Sequence[FactRow], members: Sequence[str]) -> list[list[int]]:
    """Put members together that are equal in all of some facts."""
    found: dict[tuple[str | None, ...], list[int]] = {}
    for i, member in enumerate(members):
        found.setdefault(tuple(row.texts.get(member) for row in rows), []).append(i)
    return list(found.values())


def _narrow(rows: Sequence[FactRow], members: Sequence[str], width: int) -> tuple[list[FactRow], list[list[int]]]:
    """Choose the facts, fewest groups first, that go together into one table with few columns."""
    chosen: list[FactRow] = []
    groups: list[list[int]] = [list(range(len(members)))]
    for row in sorted(rows, key=lambda row: len(_groups([row], members))):
        finer = _groups([*chosen, row], members)
        if len(finer) == 1 or (len(finer) <= _MOST_COLUMNS and _natural_width([*chosen, row], finer, members) <= width):
            chosen, groups = [*chosen, row], finer
    return [row for row in rows if row in chosen], groups


def _natural_width(rows: Sequence[FactRow], groups: Sequence[Sequence[int]], members: Sequence[str]) -> int:
    """Columns of the screen that a table by fact takes."""
    heads = sum(max(len(row.head[i]) for row in rows) + _GAP for i in range(3))
    return heads + sum(
        _GAP + max(len(ranged(members, group)), *(len(row.texts.get(members[group[0]], "")) for row in rows))
        for group in groups
    )


def _by_fact(rows: Sequence[FactRow], groups: Sequence[Sequence[int]], members: Sequence[str]) -> RenderableType:
    """One row for each fact, one column for each group."""
    heads = ["", "", "", *(ranged(members, group) for group in groups)]
    cells = [[*row.head, *(row.texts.get(members[group[0]], "") for group in groups)] for row in rows]
    return table(heads, cells, right=3, fold=False)


def _by_group(rows: Sequence[FactRow], members: Sequence[str], width: int) -> Iterator[RenderableType]:
    """One row for each group, one column for each fact, and the names of the facts below."""
    groups = _groups(rows, members)
    labels = [ranged(members, group) for group in groups]
    room = width - max(map(len, labels))
    columns: list[list[str]] = []
    named: list[str] = []
    for row in rows:
        symbol = row.entry.symbol or row.entry.name
        column = [symbol, row.unit, *(row.texts.get(members[group[0]], "") for group in groups)]
        if columns and sum(_width(one) for one in [*columns, column]) > room:
            yield from _transposed(labels, columns, named)
            columns, named = [], []
        columns.append(column)
        named.append(f"{symbol} {row.entry.name}")
    yield from _transposed(labels, columns, named)


def _width(column: Sequence[str]) -> int:
    return _GAP + max(map(len, column))


def _transposed(labels: Sequence[str], columns: Sequence[Sequence[str]], named: Sequence[str]) -> Iterator[RenderableType]:
    """Lay out columns of symbol, unit and texts beside the labels of their rows."""
    heads = ["", *(column[0] for column in columns)]
    rows = zip(("", *labels), *(column[1:] for column in columns), strict=True)
    yield Padding(table(heads, rows, right=1, fold=False), (1, 0, 0, 0))
    yield Text(", ".join(named), style="dim")
