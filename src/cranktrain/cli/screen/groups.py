"""Rows in groups, aligned: names, a column for each lot of members that are alike, units, words."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from rich.cells import cell_len
from rich.text import Text

from cranktrain.cli.screen.text import GAP, INDENT, folded
from cranktrain.grouping import grouped
from cranktrain.language import Words
from cranktrain.one_line import visible
from cranktrain.saying.amounts import Written, filled, written
from cranktrain.saying.row_words import by_name, holders, name_of, with_values
from cranktrain.saying.rows import AnswerLine

_MOST_COLUMNS = 4

_WIDEST = 9
"""Columns that are wider leave no room for words."""


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


def group_lines(groups: Sequence[tuple[Words, Sequence[AnswerLine]]], width: int) -> Iterator[Text]:
    """Lay out groups of rows.

    Parameters
    ----------
    groups : sequence of (Words, sequence of AnswerLine)
        Under their titles.
    width : int
        Columns of the screen.

    Yields
    ------
    Text
        Lines, each group's title first, with the names of its columns.
    """
    laid = [_laid(str(title), rows) for title, rows in groups]
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


def _laid(title: str, rows: Sequence[AnswerLine]) -> _Lines:
    """Write the rows of a group."""
    texts = [written(row.values, row.unit) if row.values.size else Written((), "") for row in rows]
    unlike = [
        dict(zip(row.whose, one.texts, strict=True))
        for row, one in zip(rows, texts, strict=True)
        if len(set(one.texts)) > 1
    ]
    columns = member_columns(unlike)
    return _Lines(title, columns.names, [_line(row, one, columns) for row, one in zip(rows, texts, strict=True)])


def _line(row: AnswerLine, found: Written, columns: MemberColumns) -> _Line:
    """Write a row: in the columns, or in one where all are alike, or who has what in words."""
    of = dict(zip(row.whose or ("",), found.texts, strict=False))
    different = dict.fromkeys(found.texts)
    if len(different) <= 1:
        return _Line(str(row.name), tuple(different), found.label, filled(row.words))
    of_each = {name_of(members, row.whose): text for text, members in holders(row, found).items()}
    for chosen, texts in ((columns.first, of), (columns.names, of_each)):
        if chosen and set(chosen) <= set(texts):
            return _Line(str(row.name), tuple(texts[one] for one in chosen), found.label, filled(row.words))
    return _Line(str(row.name), (), "", with_values(row, by_name(row, found)))


def _folded(line: _Line, names: int, each: int, shift: int, width: int) -> Iterator[Text]:
    """Fold a row to the width; what is too long goes on below its values."""
    indent = INDENT + names + GAP
    start = f"{' ' * INDENT}{line.name:<{names}}{' ' * shift if len(line.cells) == 1 else ''}"
    if line.cells:
        start += "".join(f"{cell:>{each}}" for cell in line.cells)
        start += f" {line.label}" if line.label else ""
        whole = start + line.words
    else:
        whole = start + " " * GAP + line.words
    for part in folded(whole, width, indent=" " * min(indent, width // 2), at_hyphens=True):
        yield Text(visible(part))
