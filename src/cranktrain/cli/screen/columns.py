"""Numbers in columns: as many side by side as the screen has room for, the rest below."""

from collections.abc import Iterator, Sequence

from rich.cells import cell_len
from rich.text import Text

from cranktrain.cli.screen.text import GAP, table
from cranktrain.saying.section_texts import written_column
from cranktrain.saying.sections import Column, Grid

_ROOM_FOR_WORDS = 26
"""Words that have less room beside their row stand below the table."""
_BELOW = " " * 7
"""Before words that stand below their row."""


def grid_lines(grid: Grid, width: int) -> Iterator[str | Text]:
    """Lay out columns, as many side by side as there is room for, each lot with the labels of the rows.

    Parameters
    ----------
    grid : Grid
    width : int
        Columns of the screen.

    Yields
    ------
    str or Text
        Lines; of a legend a paragraph.
    """
    columns = [written_column(column) for column in grid.columns]
    title, labels, words = str(grid.title), list(map(str, grid.labels)), list(map(str, grid.words))
    below = words if labels else []
    if words and not labels:
        if width - sum(map(_width, columns)) >= _ROOM_FOR_WORDS:
            yield from _with_words(columns, words, width)
            return
        labels = [str(row) for row in range(len(words))]
    for i, part in enumerate(_side_by_side(columns, width - max(map(cell_len, (title, *labels))))):
        if i and not below:
            yield ""
        has_units = grid.names_quantities or any(column.unit for column in part)
        lines = _table(part, labels, title, has_units=has_units)
        yield from _above_words(lines, below) if below else lines
        if grid.names_quantities:
            named = (f"{column.symbol or column.head} {column.quantity}" for column in part if column.quantity)
            yield ", ".join(dict.fromkeys(named))
    if words and not below:
        yield ""
        yield from table(("", ""), list(zip(labels, words, strict=True)), right=(0,), fold=width)


def _with_words(columns: Sequence[Column], words: Sequence[str], width: int) -> list[Text]:
    """Lay out one table with the words behind the numbers."""
    heads = [*(str(column.head) for column in columns), ""]
    units = [*(column.unit for column in columns), ""]
    cells = [[*texts, text] for *texts, text in zip(*map(_texts, columns), words, strict=True)]
    return table(heads, [units, *cells], right=range(len(columns)), fold=width)


def _above_words(lines: Sequence[Text], words: Sequence[str]) -> Iterator[Text]:
    """Put the words of each row below it."""
    yield from lines[: -len(words)]
    for line, text in zip(lines[-len(words) :], words, strict=True):
        yield line
        yield Text(_BELOW + text)


def _table(columns: Sequence[Column], labels: Sequence[str], title: str, *, has_units: bool) -> list[Text]:
    """Lay out one table, however wide; a title stands above the labels."""
    units = [["", *(column.unit for column in columns)]] if has_units else []
    cells = [list(row) for row in zip(labels, *map(_texts, columns), strict=True)]
    return table([title, *(str(column.head) for column in columns)], [*units, *cells], right=range(1, len(columns) + 1))


def _side_by_side(columns: Sequence[Column], room: int) -> list[list[Column]]:
    """Divide columns so that each part has room; a column that alone has none stands alone."""
    parts: list[list[Column]] = [[]]
    for column in columns:
        if parts[-1] and sum(map(_width, parts[-1])) + _width(column) > room:
            parts.append([])
        parts[-1].append(column)
    return parts


def _width(column: Column) -> int:
    """Columns of the screen that a column takes, with the gap before it."""
    return GAP + max(map(cell_len, (str(column.head), column.unit, *_texts(column))))


def _texts(column: Column) -> list[str]:
    """What stands in a column that is written."""
    return list(map(str, column.values))
