"""What sheets of plans have in common: their head, rooms for pictures, tables, scale factors at the foot."""

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import said as _
from cranktrain.layout.speed import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.panels.formulas import formula
from cranktrain.plans.lettering import pin_letters
from cranktrain.plans.positions import plan_angles, scale_words
from cranktrain.plans.together import placed_together, places_called, together_name
from cranktrain.plans.vectors import pair, spoken_name
from cranktrain.quantities import chosen_unit
from cranktrain.saying.scales import Scale
from cranktrain.saying.wording import plain
from cranktrain.viz.paper.head import speed_words, title_block
from cranktrain.viz.paper.page import LINE, MARGIN, Box, Page, fitting_scale, paper
from cranktrain.viz.paper.sketch import Sketch, bounds_of, labelled_bounds
from cranktrain.viz.paper.style import MUTED
from cranktrain.viz.paper.tables import ROW, write_table

MOST = 24
"""Positions or polygons on one sheet."""

WITH_TABLE = 2
"""Up to so many polygons stand beside the mechanism and a table of their vectors."""

LOWEST = 4.0
"""How low rows of positions may be made. [mm]"""

_PASSES = 3
"""How often a scale is corrected."""

VECTOR_COLUMNS = (0.53, 0.74, 1.0)
"""Where the columns of a table of vectors end: names of a chain's pins are words."""


def plan_page(
    machine: Machine,
    angles: int | Sequence[float],
    size: str,
    title: str,
    mechanism: str | None,
    *,
    has_key: bool = True,
    curve: SpeedCurve | None = None,
) -> tuple[Page, Box]:
    """Begin a sheet, at the speed of a curve or a constant one, with a key where pins have letters; give the rest."""
    refuse_more(MOST, len(plan_angles(angles)), _("must be at most {most} to a sheet", most=MOST))
    page = Page(*paper(size))
    places = places_called(machine, mechanism)
    words = _("{title}, mechanism {name}") if len(places) == 1 else _("{title}, cylinder {name}")
    whose = words.format(title=title, name=together_name(places)) if len(machine.places) > 1 else title
    top = title_block(page, machine, whose, speed_words(curve))
    letters = pin_letters(placed_together(machine, places, np.zeros(1)))
    if letters and has_key:
        key = ", ".join(f"{letter} {spoken_name(pin).replace('_', ' ')}" for pin, letter in letters.items())
        page.text(MARGIN, top - 4.5, _("Pins: {key}", key=key))
        top -= 6.0
    return page, Box(MARGIN, MARGIN, page.width - 2 * MARGIN, top - 4.0 - MARGIN)


def few_angles(angles: int | Sequence[float], what: str) -> Array:
    """Give the crank angles of what has room for only a few on a sheet. [deg]"""
    chosen = plan_angles(angles)
    refuse_more(WITH_TABLE, len(chosen), _("must be at most {n} for {what}", n=WITH_TABLE, what=what))
    return chosen


def refuse_more(most: int, n: int, allowed: str) -> None:
    """Refuse more crank angles than there is room for, and say what is allowed."""
    if n > most:
        raise InputError([Problem("", _("{n} crank angles", n=n), allowed)])


def cells_of(box: Box, n: int) -> list[Box]:
    """Divide a room among n pictures: one above the other if few, else in a grid, row by row."""
    columns = (
        1
        if n <= WITH_TABLE
        else next(columns for columns in (2, 3, 4, 6) if columns * (columns - 1) >= n or columns == 6)
    )
    rows = -(-n // columns)
    width, height = box.width / columns, (box.height - 6.0) / rows
    lefts = box.left + np.arange(columns) * width
    bottoms = box.bottom + 6.0 + np.arange(rows)[::-1] * height
    return [Box(float(left), float(bottom), width, height) for bottom in bottoms for left in lefts][:n]


def centre(page: Page, sketch: Sketch, box: Box) -> tuple[float, float]:
    """Draw a sketch in the middle of a room; give where its origin is. [mm]"""
    origin = origin_in(sketch, box)
    page.draw(sketch, origin)
    return origin


def origin_in(sketch: Sketch, box: Box) -> tuple[float, float]:
    """Where a sketch's origin is if it stands in the middle of a room. [mm]"""
    # Names of loads are long, and may reach farther than what is drawn.
    has_loads = any(line.layer == "LOADS" for line in sketch.lines)
    bounds = labelled_bounds(sketch) if has_loads else bounds_of(sketch.outline())
    low, high = (corner / sketch.scale for corner in bounds)
    return pair(box.middle - (low + high) / 2)


def centre_at_angle(page: Page, angle: float, sketch: Sketch, box: Box, head: float = 5.0, before: str = "") -> None:
    """Draw a sketch in the middle of a room, below a heading with the crank angle [deg] so high. [mm]"""
    page.heading(box.left, box.bottom + box.height - 4.0, f"{before}φ = {angle:g}°")
    centre(page, sketch, box._replace(height=box.height - head))


def write_beside(
    page: Page,
    box: Box,
    left: float,
    rows: Iterable[tuple[str, ...]],
    notes: Iterable[str] = (),
    *,
    shares: tuple[float, ...] = (),
    line: float = ROW,
    gap: float = 2.0,
    n_heads: int = 1,
) -> float:
    """Write a table in what a room has from `left` on, as `write_table` does, and notes a gap below it; give where.

    All in mm of paper.
    """
    place = (left, box.bottom + box.height, box.left + box.width - left)
    sentences = list(notes)
    below = write_table(page, list(rows), place, shares, line, n_heads) - gap
    page.notes(left, below, sentences)
    return below - LINE * len(sentences)


def row_height(n_rows: Sequence[int], height: float) -> float:
    """How high the rows of tables below each other may be, each with a head and a note, in a room so high. [mm]"""
    free = height - len(n_rows) * (2 * LINE + 3.0)
    return max(LOWEST, min(ROW, free / sum(n_rows)))


def fitted_scale(drawn: Callable[[float], Sketch], room: tuple[float, float], metal: float) -> float:
    """Choose a round scale at which a sketch with its words fits a room: what has a size on paper keeps it.

    It begins with the scale at which some metal of it, so long [mm], fits the longer side: at another, what has a size
    on paper would hide a small machine, and cover a large one with lines and dots without number.
    """
    scale = fitting_scale(metal, 0.0, (max(room), 1.0))
    for _pass in range(_PASSES):
        low, high = labelled_bounds(drawn(scale))
        needed = fitting_scale(*pair(high - low), room)
        if needed == scale:
            break
        scale = needed
    return scale


def scale_of(letter: str, scale: float, shown: Scale) -> str:
    """Write a scale factor, in a unit."""
    symbol = formula(rf"\mu_{letter}")
    return f"{symbol} = {plain(float(shown.of(scale)))} {shown.label}/mm"


def length_scale(metre: float) -> str:
    """Write the scale factor of lengths: in metres, as the texts have it, unless other units are chosen for lengths."""
    return scale_of("l", metre, Scale(chosen_unit("m") or "m"))


def write_scales(page: Page, box: Box, scales: Sequence[str], metal: float | None) -> None:
    """Say the scale factors at the foot."""
    start = box.left
    if metal is not None:
        start = page.scale_bar(box.left, box.bottom, metal) + 6.0 + 2.0 * len(scale_words(metal)) + 34.0
    page.text(start, box.bottom - 0.4, "     ".join(scales), fontsize=9.0)
    page.text(
        box.left + box.width, box.bottom - 0.4, _("1 mm is 1 mm on the sheet as printed"), ha="right", color=MUTED
    )
