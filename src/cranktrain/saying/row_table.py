"""Groups of rows as texts: names, a column for each lot of members that are alike, units, words."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from cranktrain.grouping import grouped
from cranktrain.language import Words
from cranktrain.numerics.ties import largest_of
from cranktrain.record import record
from cranktrain.saying.amounts import Written, filled, written
from cranktrain.saying.row_words import by_name, holders, name_of, with_values
from cranktrain.saying.rows import AnswerLine

_MOST_COLUMNS = 4


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
    members = list(largest_of(rows, len))
    together = [row for row in rows if set(row) <= set(members)]
    same = grouped((tuple(row.get(member, "") for row in together), member) for member in members)
    if not 1 < len(same) <= _MOST_COLUMNS:
        return MemberColumns()
    lots = list(same.values())
    return MemberColumns(tuple(name_of(lot, members) for lot in lots), tuple(lot[0] for lot in lots))


@record
class WrittenRow:
    """A row as text.

    Attributes
    ----------
    name : str
    cells : tuple of str
        One of each column, or one for all; none where words say all.
    label : str
        Of their unit.
    words : str
        What is said behind them.
    quantities : tuple of str
        Names in the catalogue of all that it tells.
    """

    name: str
    cells: tuple[str, ...]
    label: str
    words: str
    quantities: tuple[str, ...]


@record
class WrittenGroup:
    """A group of rows as text, with the names of its columns."""

    title: str
    heads: tuple[str, ...]
    rows: tuple[WrittenRow, ...]


def written_group(title: Words, rows: Sequence[AnswerLine]) -> WrittenGroup:
    """Write the rows of a group, in the language and the units of whoever reads them now."""
    texts = [written(row.values, row.unit) if row.values.size else Written((), "") for row in rows]
    unlike = [
        dict(zip(row.whose, one.texts, strict=True))
        for row, one in zip(rows, texts, strict=True)
        if len(set(one.texts)) > 1
    ]
    columns = member_columns(unlike)
    each = zip(rows, texts, strict=True)
    return WrittenGroup(str(title), columns.names, tuple(_written_row(row, one, columns) for row, one in each))


def _written_row(row: AnswerLine, found: Written, columns: MemberColumns) -> WrittenRow:
    """Write a row: in the columns, or in one where all are alike, or who has what in words."""
    of = dict(zip(row.whose or ("",), found.texts, strict=False))
    different = dict.fromkeys(found.texts)
    if len(different) <= 1:
        return WrittenRow(str(row.name), tuple(different), found.label, filled(row.words), row.quantities)
    of_each = {name_of(members, row.whose): text for text, members in holders(row, found).items()}
    for chosen, texts in ((columns.first, of), (columns.names, of_each)):
        if chosen and set(chosen) <= set(texts):
            cells = tuple(texts[one] for one in chosen)
            return WrittenRow(str(row.name), cells, found.label, filled(row.words), row.quantities)
    return WrittenRow(str(row.name), (), "", with_values(row, by_name(row, found)), row.quantities)
