"""A sheet on paper: its columns side by side, in each the parts one below the other, in the room that they want."""

from collections.abc import Sequence
from typing import NamedTuple

from cranktrain.panels.parts import (
    BarChart,
    CurveCard,
    DrawnThrows,
    Notes,
    Part,
    Polars,
    Ruler,
    ShaftShapes,
    Sheet,
    SheetColumn,
    Stack,
    Stars,
    Table,
    ThrowAtAngle,
    WearCircles,
)
from cranktrain.viz.paper.bars import bars_height, draw_bars, draw_modes
from cranktrain.viz.paper.curves import draw_card, draw_stack
from cranktrain.viz.paper.head import headed_page
from cranktrain.viz.paper.page import LINE, Box, Figure, Page, drawing_settings
from cranktrain.viz.paper.polar import draw_polars
from cranktrain.viz.paper.rays import STARS_HEIGHT, draw_stars, draw_wear
from cranktrain.viz.paper.tables import LEAST_ROW, draw_table, table_height
from cranktrain.viz.throw.parts import draw_ruler, draw_throw_at_angle, draw_throws, fitted_throws

_AXIS, _BETWEEN = 14.0, 8.0
"""Left of curves for the figures of their axes, and between two columns. [mm]"""
_PART = 2.0
"""Between two parts of a column. [mm]"""
_LEAST_THROW = 35.0
"""Height from which there is room for a machine under its loads. [mm]"""
_LEAST_TABLE = 3
"""Rows that are left of a table whose column has no room."""

_LOWER, _LINE_FOOT = 0.5, 10.0
"""Part of a sheet below throws that take its whole width, and what these need for scale and notes. [mm]"""
_COLUMNS, _NARROW_AXIS = 6.0, 14.0
"""Between two columns of curves below them, and left of each. [mm]"""


class _Room(NamedTuple):
    """How high a part is to be, with low rows, and at least; whether it takes what is left, or can be left out. [mm]"""

    usual: float
    tight: float
    least: float
    fills: bool = False
    is_optional: bool = False


@drawing_settings()
def draw_sheet(sheet: Sheet, size: str = "A4") -> Figure:
    """Draw a sheet.

    Parameters
    ----------
    sheet : Sheet
    size : "A4" or "A3"
        Lying.

    Returns
    -------
    Figure
        In millimetres of paper: a throw is to the scale that the sheet says.
    """
    page, box = headed_page(sheet, size)
    if any(isinstance(part, DrawnThrows) for part in sheet.columns[0].parts):
        _draw_machine(page, sheet, box)
        return page.figure
    rooms = list(_columns(sheet.columns, box))
    going_on: list[str] = []
    for column, room in reversed(list(zip(sheet.columns, rooms, strict=True))):
        lines = [line for note in going_on for line in page.wrapped(note, room.width)]
        foot = LINE * len(lines) + 2.0 if lines else 0.0
        page.notes(room.left, room.bottom + LINE * (len(lines) - 1), lines)
        going_on = _draw_column(page, column, room._replace(bottom=room.bottom + foot, height=room.height - foot))
    return page.figure


def _columns(columns: Sequence[SheetColumn], box: Box) -> list[Box]:
    """Rooms of columns side by side."""
    rooms: list[Box] = []
    left = box.left
    for number, column in enumerate(columns):
        begin = left + (_BETWEEN if number else 0.0)
        left += column.share * box.width
        rooms.append(box._replace(left=begin, width=left - begin))
    return rooms


def _draw_column(page: Page, column: SheetColumn, box: Box) -> list[str]:
    """Draw the parts of a column one below the other; give the notes that found no room."""
    going_on: list[str] = []
    top = box.bottom + box.height
    for part, height in zip(*_fitted(page, column.parts, box), strict=True):
        room = box._replace(bottom=top - height, height=height)
        if isinstance(part, Notes):
            going_on += _draw_notes(page, part, room)
        else:
            _draw(page, part, room)
        top -= height + _PART
    return going_on


def _draw_notes(page: Page, notes: Notes, room: Box) -> list[str]:
    """Draw notes one below the other; give those that find no room."""
    sentences, lines = list(map(str, notes.sentences)), list[str]()
    most = int((room.height + 1.0) / LINE)
    while sentences:
        folded = page.wrapped(sentences[0], room.width)
        if notes.can_go_on and len(lines) + len(folded) > most:
            break
        lines += folded
        del sentences[0]
    page.notes(room.left, room.bottom + room.height - 3.0, lines)
    return sentences


def _draw(page: Page, part: Part, box: Box) -> None:
    """Draw a part in its room."""
    match part:
        case Stack():
            draw_stack(page, part, box._replace(left=box.left + _AXIS, width=box.width - _AXIS - 4.0))
        case CurveCard():
            draw_card(page, part, box)
        case Polars():
            draw_polars(page, part, box)
        case BarChart():
            draw_bars(page, part.bars, box)
        case Stars():
            draw_stars(page, part, box)
        case WearCircles():
            draw_wear(page, part, box)
        case ShaftShapes():
            draw_modes(page, part, box)
        case Table():
            draw_table(page, part, box)
        case ThrowAtAngle():
            draw_throw_at_angle(page, part, box)
        case _:
            raise AssertionError(part)


def _room_for(page: Page, part: Part, box: Box) -> _Room:
    """How high a part is to be in a column."""
    match part:
        case CurveCard():
            height = part.height * box.height
            return _Room(height, height, height, is_optional=part.is_optional)
        case Polars(height=float() as share):
            return _Room(share * box.height, share * box.height, part.least)
        case BarChart():
            height = bars_height(part.bars, part.height * box.height)
            return _Room(height, height, height)
        case Stars():
            return _Room(STARS_HEIGHT, STARS_HEIGHT, STARS_HEIGHT)
        case Table():
            least = table_height(page, part, box.width, LEAST_ROW, min(_LEAST_TABLE, part.n_rows))
            tight = table_height(page, part, box.width, LEAST_ROW)
            return _Room(table_height(page, part, box.width), tight, least)
        case Notes(can_go_on=False):
            n = sum(len(page.wrapped(sentence, box.width)) for sentence in part.sentences)
            return _Room(LINE * n, LINE * n, LINE * n)
        case ThrowAtAngle():
            return _Room(0.0, 0.0, _LEAST_THROW, fills=True, is_optional=True)
        case _:
            return _Room(0.0, 0.0, 0.0, fills=True)


def _fitted(page: Page, parts: Sequence[Part], box: Box) -> tuple[list[Part], list[float]]:
    """Find the heights of the parts of a column, and which of them are drawn.

    Where there is no room for all as they would be, what is optional is left out, rows of tables are made low, then
    pictures smaller, and then rows are left out.
    """
    kept = [(part, _room_for(page, part, box)) for part in parts]
    if _missing([room.usual for _part, room in kept], box) > 0.0:
        kept = [(part, room) for part, room in kept if not room.is_optional or room.fills]
    heights = [room.usual for _part, room in kept]
    # Diagrams that fill what a table leaves are read by their size.
    if _missing(heights, box) > 0.0 or any(isinstance(part, Polars) and room.fills for part, room in kept):
        heights = [room.tight for _part, room in kept]
    for wants_table in (False, True):
        for place, (part, room) in enumerate(kept):
            missing = _missing(heights, box)
            if missing > 0.0 and isinstance(part, Table) is wants_table:
                heights[place] = max(room.least, heights[place] - missing)
    left = -_missing(heights, box)
    fillers = [place for place, (_part, room) in enumerate(kept) if room.fills]
    for place in fillers:
        heights[place] = max(left / len(fillers), 0.0)
    drawn = [place for place, (_part, room) in enumerate(kept) if not room.is_optional or heights[place] >= room.least]
    return [kept[place][0] for place in drawn], [heights[place] for place in drawn]


def _missing(heights: Sequence[float], box: Box) -> float:
    """How much room is missing for parts of some heights. [mm]"""
    return sum(heights) + _PART * (len(heights) - 1) - box.height


def _draw_machine(page: Page, sheet: Sheet, box: Box) -> None:
    """Draw throws beside their curves, or where these are wide above curves in two columns."""
    (throws, *_others), (ruler, stack, *_more) = (column.parts for column in sheet.columns)
    assert isinstance(throws, DrawnThrows)
    assert isinstance(ruler, Ruler)
    assert isinstance(stack, Stack)
    middle = sheet.columns[0].share * box.width
    lower = box.bottom + _LOWER * box.height
    beside = box._replace(width=middle - 4.0)
    above = box._replace(bottom=lower + _LINE_FOOT, height=(1 - _LOWER) * box.height - _LINE_FOOT)
    drawn, is_above = fitted_throws(throws, beside, above)
    draw_throws(page, throws, drawn)
    if not is_above:
        left, right = box.left + middle + 12.0, box.left + box.width
        below = draw_ruler(page, ruler, left, right, box.bottom + box.height)
        draw_stack(page, stack, Box(left, box.bottom, right - left, below - box.bottom))
        return
    half = 0.5 * (box.width - _COLUMNS)
    below = draw_ruler(page, ruler, box.left + _NARROW_AXIS, box.left + half, lower - 4.0)
    n = -(-len(stack.panels) // 2)
    for number, some in enumerate((stack.panels[:n], stack.panels[n:])):
        left = box.left + number * (half + _COLUMNS) + _NARROW_AXIS
        if some:
            room = Box(left, box.bottom, half - _NARROW_AXIS, below - box.bottom)
            draw_stack(page, Stack(some, of_motion=True), room, is_narrow=True)
