"""Numbers in columns: as many side by side as the screen has room for, the rest below."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from rich.cells import cell_len
from rich.console import Console
from rich.text import Text

from cranktrain.cli.screen.text import GAP, INDENT, section, table

_ROOM_FOR_WORDS = 26
"""Words that have less room beside their row stand below the table."""


class Column(NamedTuple):
    """A column: symbol, unit, the texts of its rows, and what the symbol stands for."""

    head: str
    unit: str
    texts: tuple[str, ...]
    name: str = ""

    @property
    def width(self) -> int:
        """Columns of the screen that it takes, with the gap before it."""
        return GAP + max(map(cell_len, (self.head, self.unit, *self.texts)))


def column_tables(columns: Sequence[Column], labels: Sequence[str], width: int) -> Iterator[Text]:
    """Lay out rows that have labels.

    Parameters
    ----------
    columns : sequence of Column
    labels : sequence of str
        Of the rows.
    width : int
        Columns of the screen.

    Yields
    ------
    Text
        Lines of one or more tables with an empty line between them, each with the labels.
    """
    for i, part in enumerate(side_by_side(columns, width - max(map(cell_len, labels), default=0))):
        if i:
            yield Text()
        yield from column_table(part, labels, has_units=any(column.unit for column in part))


def section_of_columns(console: Console, heading: str, columns: Sequence[Column], labels: Sequence[str]) -> None:
    """Show rows that have labels under a heading."""
    section(console, heading, column_tables(columns, labels, console.width - INDENT))


def column_table(
    columns: Sequence[Column], labels: Sequence[str], title: str = "", *, has_units: bool = True
) -> list[Text]:
    """Lay out one table, however wide; a title stands above the labels."""
    units = [["", *(column.unit for column in columns)]] if has_units else []
    cells = [[label, *(column.texts[row] for column in columns)] for row, label in enumerate(labels)]
    return table([title, *(column.head for column in columns)], [*units, *cells], right=range(1, len(columns) + 1))


def worded_tables(columns: Sequence[Column], words: Sequence[str], width: int) -> Iterator[Text]:
    """Lay out rows that sentences belong to.

    Parameters
    ----------
    columns : sequence of Column
    words : sequence of str
        Of the rows.
    width : int
        Columns of the screen.

    Yields
    ------
    Text
        Lines of a table with the words behind the numbers; where there is no room for them, of tables with numbered
        rows, and of a list of the words.
    """
    if width - sum(column.width for column in columns) < _ROOM_FOR_WORDS:
        keys = [str(row) for row in range(len(words))]
        yield from column_tables(columns, keys, width)
        yield Text()
        yield from table(("", ""), list(zip(keys, words, strict=True)), right=(0,), fold=width)
        return
    heads = [*(column.head for column in columns), ""]
    units = [*(column.unit for column in columns), ""]
    cells = [[*(column.texts[row] for column in columns), text] for row, text in enumerate(words)]
    yield from table(heads, [units, *cells], right=range(len(columns)), fold=width)


def side_by_side(columns: Sequence[Column], room: int) -> list[list[Column]]:
    """Divide columns so that each part has room; a column that alone has none stands alone."""
    parts: list[list[Column]] = [[]]
    for column in columns:
        if parts[-1] and sum(one.width for one in parts[-1]) + column.width > room:
            parts.append([])
        parts[-1].append(column)
    return parts
