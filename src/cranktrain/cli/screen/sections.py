"""Sections on the screen: the one place where what is shown as data becomes lines."""

from collections.abc import Iterable, Iterator
from textwrap import shorten

from rich.cells import cell_len
from rich.console import Console
from rich.text import Text

from cranktrain.cli.screen.columns import grid_lines
from cranktrain.cli.screen.compared import compared_lines
from cranktrain.cli.screen.groups import group_lines
from cranktrain.cli.screen.text import GAP, INDENT, heading_lines, page, paragraph, show_lines, table
from cranktrain.language import Words
from cranktrain.saying.sections import (
    Answer,
    Command,
    Compared,
    FactTables,
    Failure,
    Grid,
    PagePart,
    Part,
    Rows,
    ShownSection,
    Unfolded,
)

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
    show_lines(console, page_lines(sections, console.width))


def page_lines(sections: Iterable[PagePart], width: int) -> Iterator[Text]:
    """Lay out sections one below the other, each after an empty line, in a width of columns."""
    for one in sections:
        match one:
            case ShownSection():
                yield from _section(one, width)
            case Answer():
                yield from (Text(), *group_lines(one.groups, width))
            case Compared():
                yield from (Text(), *compared_lines(one, width))
            case _:
                yield from (Text(), *paragraph(str(one), width))


def _section(one: ShownSection, width: int) -> Iterator[Text]:
    """Lay out a section; nothing where its parts have no lines, but the head of what follows."""
    lines = [line for part in one.parts for line in _lines(part, width - INDENT)]
    if lines or not one.parts:
        yield from heading_lines(str(one.heading), width)
    yield from (Text(" " * INDENT) + line for line in lines)


def _lines(part: Part, width: int) -> Iterator[Text]:
    """Lay out a part."""
    match part:
        case Grid():
            yield from _folded(grid_lines(part, width), width)
        case FactTables():
            from cranktrain.cli.screen.facts import fact_tables  # an answer needs none

            yield from _folded(fact_tables(part.of, part.names, width), width)
        case Rows():
            yield from _rows(part, width) if part.cut is None else _cut(part, part.cut, width)
        case Unfolded():
            yield Text(str(part.words), "bold" if part.is_head else "")
        case Command():
            command = f"`{part.typed}`"
            said = f"{command if cell_len(command) < width else part.instead}: {part.shows}"
            yield from paragraph(said, width)
        case Failure():
            yield from paragraph(str(part.words), width, "red")
        case _:
            yield from paragraph(str(part), width)


def _folded(lines: Iterable[str | Text], width: int) -> Iterator[Text]:
    """Fold what is no line yet."""
    for line in lines:
        yield from [line] if isinstance(line, Text) else paragraph(line, width)


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
