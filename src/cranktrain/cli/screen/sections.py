"""Sections on the screen: the one place where what is shown as data becomes lines."""

from collections.abc import Iterable, Iterator
from textwrap import shorten

from rich.cells import cell_len
from rich.console import Console
from rich.text import Text

from cranktrain.cli.screen.columns import grid_lines
from cranktrain.cli.screen.text import GAP, INDENT, page, section, show_heading, table
from cranktrain.language import Words
from cranktrain.saying.sections import Command, Grid, PagePart, Part, Rows, ShownSection, Unfolded

_CUT = " …"
_LONGEST = 34
"""A first cell that is longer has a width of its own, where another is cut to have room."""


def show_page(head: Words, sections: Iterable[PagePart]) -> None:
    """Show a page of sections below its head, or nothing of it where one of them cannot be made."""
    with page(str(head)) as console:
        show_sections(console, sections)


def show_sections(console: Console, sections: Iterable[PagePart]) -> None:
    """Show sections one below the other.

    Parameters
    ----------
    console : Console
    sections : iterable of PagePart
    """
    for one in sections:
        if not isinstance(one, ShownSection):
            console.print()
            console.print(str(one))
        elif one.parts:
            width = console.width - INDENT
            section(console, str(one.heading), (line for part in one.parts for line in _lines(part, width)))
        else:
            show_heading(console, str(one.heading))


def _lines(part: Part, width: int) -> Iterator[str | Text]:
    """Lay out a part."""
    match part:
        case Grid():
            yield from grid_lines(part, width)
        case Rows():
            yield from _rows(part, width) if part.cut is None else _cut(part, part.cut, width)
        case Unfolded():
            yield Text(str(part.words), "bold" if part.is_head else "")
        case Command():
            command = f"`{part.typed}`"
            yield f"{command if cell_len(command) < width else part.instead}: {part.shows}"
        case _:
            yield str(part)


def _rows(rows: Rows, width: int) -> list[Text]:
    """Lay out rows of words; a first cell is as wide as those elsewhere that it is like."""
    cells = [list(map(str, row)) for row in rows.cells]
    heads = list(map(str, rows.heads)) or [""] * len(cells[0])
    if rows.like:
        room = max(cell_len(str(one)) for one in rows.like)
        cells = [[row[0].ljust(room), *row[1:]] for row in cells]
    return table(heads, cells, right=rows.right, fold=width if rows.is_folded else None)


def _cut(rows: Rows, cut: int, width: int) -> Iterator[Text]:
    """Lay out rows of which one column is cut where there is no room."""
    cells = [list(map(str, row)) for row in rows.cells]
    heads = list(map(str, rows.heads)) or [""] * len(cells[0])
    of_first = [cell_len(str(one)) for one in rows.like or [row[0] for row in cells]]
    usual = max((room for room in of_first if room <= _LONGEST), default=0)
    others = [column for i, column in enumerate(zip(heads, *cells, strict=True)) if i not in (0, cut)]
    room = width - GAP - sum(max(map(cell_len, column)) + GAP for column in others)
    for row in cells:
        left = room - max(usual, cell_len(row[0]))
        row[cut] = shorten(row[cut], max(left, 1), placeholder=_CUT)
        row[0] = row[0] if 0 in rows.right else row[0].ljust(usual)
    lines = iter(table(heads, [row for row in cells if cell_len(row[0]) <= usual], right=rows.right))
    if any(heads):
        yield next(lines)
    for row in cells:
        yield next(lines) if cell_len(row[0]) <= usual else Text((" " * GAP).join(row))
