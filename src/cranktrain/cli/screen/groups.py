"""Rows in groups, aligned: names, a column for each lot of members that are alike, units, words."""

from collections.abc import Iterator, Sequence

from rich.cells import cell_len
from rich.text import Text

from cranktrain.cli.screen.text import GAP, INDENT, folded
from cranktrain.language import Words
from cranktrain.one_line import visible
from cranktrain.saying.row_table import WrittenRow, written_group
from cranktrain.saying.rows import AnswerLine

_WIDEST = 9
"""Columns that are wider leave no room for words."""


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
    laid = [written_group(title, rows) for title, rows in groups]
    lines = [line for one in laid for line in one.rows]
    names = max((cell_len(line.name) for line in lines), default=0)
    cells = [
        cell
        for one in laid
        for row in ([one.heads], (line.cells for line in one.rows))
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
        for line in one.rows:
            yield from _folded(line, names, each, shift, width)


def _folded(line: WrittenRow, names: int, each: int, shift: int, width: int) -> Iterator[Text]:
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
