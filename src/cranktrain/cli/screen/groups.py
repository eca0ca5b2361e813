"""Rows in groups, aligned: names, a column for each lot of members that are alike, units, words."""

from collections.abc import Iterator, Mapping, Sequence
from string import digits
from typing import NamedTuple

from rich.cells import cell_len
from rich.text import Text

from cranktrain.cli.screen.amounts import Written, filled, written
from cranktrain.cli.screen.text import GAP, INDENT, folded
from cranktrain.grouping import grouped
from cranktrain.language import _
from cranktrain.numerics.ties import first_largest, first_smallest
from cranktrain.one_line import visible
from cranktrain.saying.rows import AnswerLine
from cranktrain.saying.wording import ABSENT, ranged

_MOST_COLUMNS = 4
_LONGEST_NAME = 12

_WIDEST = 9
"""Columns that are wider leave no room for words."""
_NAMED, _LONGEST = 3, 48
"""How many values that differ are named one by one, in how many characters; of more there is a range."""


class MemberColumns(NamedTuple):
    """Columns of a group of rows: their names, and one of the members of each; none where all members are alike."""

    names: tuple[str, ...] = ()
    first: tuple[str, ...] = ()


def member_columns(rows: Sequence[Mapping[str, str]]) -> MemberColumns:
    """Find columns such that members in one have the same text in every row.

    Parameters
    ----------
    rows : sequence of mappings of member to text
        Those that are not alike for all members.

    Returns
    -------
    MemberColumns
        None where rows are of other members, or where there would be more columns than are read.
    """
    if not rows:
        return MemberColumns()
    members = list(max(rows, key=len))
    together = [row for row in rows if set(row) <= set(members)]
    same = grouped((tuple(row.get(member, "") for row in together), member) for member in members)
    if not 1 < len(same) <= _MOST_COLUMNS:
        return MemberColumns()
    lots = list(same.values())
    return MemberColumns(tuple(name_of(lot, members) for lot in lots), tuple(lot[0] for lot in lots))


def name_of(some: Sequence[str], members: Sequence[str]) -> str:
    """Name some of the members by what they have in common: bank L of 1L to 6L, `exhaust` of 1.exhaust to 6.exhaust.

    Examples
    --------
    >>> name_of(["1L", "2L"], ["1L", "2L", "1R", "2R"])
    'L'
    >>> name_of(["1S", "3S"], ["1S", "2S", "3S"])
    '1S, 3S'
    """
    for common in (_side, _ending):
        named = dict.fromkeys(map(common, some))
        if len(named) == 1 and "" not in named and len(members) > 1:
            (name,) = named
            if [member for member in members if common(member) == name] == list(some):
                return name
    said = ranged(members, [members.index(one) for one in some])
    return said if len(said) <= _LONGEST_NAME or len(some) < 2 else f"{some[0]} +{len(some) - 1}"


def _ending(member: str) -> str:
    """What stands behind the number."""
    return member.lstrip(digits).lstrip(".")


def _side(member: str) -> str:
    """What stands behind the last dot."""
    return member.rpartition(".")[2] if "." in member else ""


class RowGroup(NamedTuple):
    """Rows of one question under its title."""

    title: str
    rows: Sequence[AnswerLine]


class _Line(NamedTuple):
    """A row as text: cells, none where words say all, the label of their unit, and words."""

    name: str
    cells: tuple[str, ...]
    label: str
    words: str


class _Lines(NamedTuple):
    """A group as text, with the names of its columns."""

    title: str
    heads: tuple[str, ...]
    lines: list[_Line]


def group_lines(groups: Sequence[RowGroup], width: int) -> Iterator[Text]:
    """Lay out groups of rows.

    Parameters
    ----------
    groups : sequence of RowGroup
    width : int
        Columns of the screen.

    Yields
    ------
    Text
        Lines, each group's title first, with the names of its columns.
    """
    laid = [_laid(group) for group in groups]
    lines = [line for one in laid for line in one.lines]
    names = max((cell_len(line.name) for line in lines), default=0)
    cells = [
        cell
        for one in laid
        for row in ([one.heads], (line.cells for line in one.lines))
        for part in row
        for cell in part
    ]
    each = GAP + max(map(cell_len, cells), default=0)
    # Where some group has two columns, single values stand in the second one, so that units stand below each other.
    shift = each if max((len(one.heads) for one in laid), default=0) == 2 and each <= _WIDEST else 0
    for one in laid:
        indent = INDENT + names
        heads = "".join(f"{head:>{each}}" for head in one.heads)
        yield Text(f"{visible(one.title):<{indent}}{heads}".rstrip(), style="bold")
        for line in one.lines:
            yield from _folded(line, names, each, shift, width)


def _laid(group: RowGroup) -> _Lines:
    """Write the rows of a group."""
    texts = [written(row.values, row.unit) if row.values.size else Written((), "") for row in group.rows]
    unlike = [
        dict(zip(row.members, one.texts, strict=True))
        for row, one in zip(group.rows, texts, strict=True)
        if len(set(one.texts)) > 1
    ]
    columns = member_columns(unlike)
    return _Lines(
        group.title, columns.names, [_line(row, one, columns) for row, one in zip(group.rows, texts, strict=True)]
    )


def _line(row: AnswerLine, found: Written, columns: MemberColumns) -> _Line:
    """Write a row: in the columns, or in one where all are alike, or who has what in words."""
    words = filled(row.words, row.pieces)
    of = dict(zip(row.members or ("",), found.texts, strict=False))
    different = dict.fromkeys(found.texts)
    if len(different) <= 1:
        return _Line(row.name, tuple(different), found.label, words)
    by_name = {name_of(members, row.members): text for text, members in _holders(row, found).items()}
    for chosen, texts in ((columns.first, of), (columns.names, by_name)):
        if chosen and set(chosen) <= set(texts):
            return _Line(row.name, tuple(texts[one] for one in chosen), found.label, words)
    gap = "" if words[:1] in ("", ",", ";") else " "
    return _Line(row.name, (), "", f"{_by_name(row, found)}{gap}{words}")


def _holders(row: AnswerLine, found: Written) -> dict[str, list[str]]:
    """Members by what is written of them."""
    return grouped(zip(found.texts, row.members, strict=True))


def _by_name(row: AnswerLine, found: Written) -> str:
    """Say who has what, or from what to what they go."""
    alike = _holders(row, found)
    each = ", ".join(
        _("{value} ({who})", value=found.whole(text), who=name_of(members, row.members))
        for text, members in alike.items()
        if text != ABSENT
    )
    if len(alike) <= _NAMED and len(each) <= _LONGEST:
        return each
    least, most = (row.members[pick(row.values)] for pick in (first_smallest, first_largest))
    texts = dict(zip(row.members, found.texts, strict=True))
    return _(
        "{least} ({one}) to {most} ({other})", least=texts[least], one=least, most=found.whole(texts[most]), other=most
    )


def _folded(line: _Line, names: int, each: int, shift: int, width: int) -> Iterator[Text]:
    """Fold a row to the width; what is too long goes on below its values."""
    indent = INDENT + names + GAP
    start = f"{' ' * INDENT}{line.name:<{names}}{' ' * shift if len(line.cells) == 1 else ''}"
    if line.cells:
        start += "".join(f"{cell:>{each}}" for cell in line.cells)
        start += f" {line.label}" if line.label else ""
        start += "" if not line.words or line.words[0] in ",;" else " "
    else:
        start += " " * GAP
    for part in folded(start + line.words, width, indent=" " * min(indent, width // 2), at_hyphens=True):
        yield Text(visible(part))
