"""What sheets of plans have in common: their head, rooms for pictures, tables, scale factors at the foot."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.layout.speed_curve import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.plans.lettering import pin_letters
from cranktrain.plans.positions import plan_angles
from cranktrain.plans.together import placed_together, places_called, together_name
from cranktrain.plans.vectors import spoken_name
from cranktrain.viz.paper.page import MARGIN, Page, formula, is_formula, muted, paper, scale_words
from cranktrain.viz.paper.sketch import Sketch
from cranktrain.viz.paper.style import SYMBOL
from cranktrain.viz.paper.words import running_words, speed_words, zero_words
from cranktrain.viz.sheets.motion import title_block

MOST = 24
"""Positions or polygons on one sheet."""

ROW, LEAST_ROW = 5.2, 4.5
"""Height of a row of a table, and how low it may be made where there is no room. [mm]"""

WITH_TABLE = 2
"""Up to so many polygons stand beside the mechanism and a table of their vectors."""


VECTOR_COLUMNS = (0.53, 0.74, 1.0)
"""Where the columns of a table of vectors end: names of a chain's pins are words."""


class Box(NamedTuple):
    """A room on paper. [mm]"""

    left: float
    bottom: float
    width: float
    height: float


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
    n = len(plan_angles(angles))
    if n > MOST:
        allowed = _("must be at most {most} to a sheet").format(most=MOST)
        raise InputError([Problem("", _("{n} crank angles").format(n=n), allowed)])
    width, height = paper(size)
    page = Page(width, height)
    places = places_called(machine, mechanism)
    of_one, of_both = _("{title}, mechanism {name}"), _("{title}, cylinder {name}")
    words = of_one if len(places) == 1 else of_both
    whose = words.format(title=title, name=together_name(places)) if len(machine.places) > 1 else title
    top = title_block(page, machine, [running_words(machine)], [f"{whose}. {zero_words(machine)}"], speed_words(curve))
    letters = pin_letters(placed_together(machine, places, np.zeros(1)))
    if letters and has_key:
        key = ", ".join(f"{letter} {spoken_name(pin).replace('_', ' ')}" for pin, letter in letters.items())
        page.text(MARGIN, top - 4.5, _("Pins: {key}").format(key=key))
        top -= 6.0
    return page, Box(MARGIN, MARGIN, width - 2 * MARGIN, top - 4.0 - MARGIN)


def few_angles(angles: int | Sequence[float], what: str) -> Array:
    """Give the crank angles of what has room for only a few on a sheet. [deg]"""
    chosen = plan_angles(angles)
    if len(chosen) > WITH_TABLE:
        allowed = _("must be at most {n} for {what}").format(n=WITH_TABLE, what=what)
        raise InputError([Problem("", _("{n} crank angles").format(n=len(chosen)), allowed)])
    return chosen


def cells_of(box: Box, n: int) -> Iterator[Box]:
    """Divide a room among n pictures: one above the other if few, else in a grid, row by row."""
    columns = (
        1
        if n <= WITH_TABLE
        else next(columns for columns in (2, 3, 4, 6) if columns * (columns - 1) >= n or columns == 6)
    )
    rows = -(-n // columns)
    width, height = box.width / columns, (box.height - 6.0) / rows
    for i in range(n):
        bottom = box.bottom + 6.0 + (rows - 1 - i // columns) * height
        yield Box(box.left + i % columns * width, bottom, width, height)


def centre(page: Page, sketch: Sketch, box: Box) -> None:
    """Draw a sketch in the middle of a room."""
    low_x, high_x, low_y, high_y = (value / sketch.scale for value in sketch.bounds())
    page.draw(
        sketch,
        (box.left + box.width / 2 - (low_x + high_x) / 2, box.bottom + box.height / 2 - (low_y + high_y) / 2),
    )


def scale_of(letter: str, scale: float, unit: str) -> str:
    """Write a scale factor."""
    symbol = formula(rf"\mu_{letter}")
    return f"{symbol} = {scale:.6g} {unit}/mm"


def write_scales(page: Page, box: Box, scales: Sequence[str], metal: float | None) -> None:
    """Say the scale factors at the foot."""
    start = box.left
    if metal is not None:
        start = page.scale_bar(box.left, box.bottom, metal) + 6.0 + 2.0 * len(scale_words(metal)) + 34.0
    page.text(start, box.bottom - 0.4, "     ".join(scales), fontsize=9.0)
    page.text(box.left + box.width, box.bottom - 0.4, _("1 mm is 1 mm on the sheet as printed"), ha="right", **muted())


def unit_words(unit: str) -> str:
    """Write a unit with its squares as exponents."""
    return unit.replace("^2", "²")


def write_table(
    page: Page,
    rows: Sequence[Sequence[str]],
    place: tuple[float, float, float],
    shares: tuple[float, ...] = (),
    line: float = ROW,
) -> float:
    """Write a table: a head, rows, all but the first column to the right; give where it ends. [mm]

    `shares` are where the other columns end, in parts of the width; evenly, unless given. `line` is a row's height.
    """
    left, top, width = place
    columns = len(rows[0])
    y = top - 4.0
    for number, row in enumerate(rows):
        for column, words in enumerate(row):
            share = shares[column - 1] if shares else 0.1 + 0.9 * column / (columns - 1)
            is_symbol = is_formula(words)
            page.text(
                left if column == 0 else left + width * share,
                y,
                words,
                ha="left" if column == 0 else "right",
                fontsize=SYMBOL if is_symbol else 8.0,
                fontweight="bold" if number == 0 else "normal",
            )
        if number == 0:
            page.rule(y - 1.6, left, left + width)
            y -= 1.2
        y -= line
    return y


def figure(value: float) -> str:
    """Write a number with five figures, and a true minus."""
    digits = max(0, 4 - int(np.floor(np.log10(abs(value))))) if abs(value) > 1e-9 else 0
    return _with_true_minus(f"{value:.{min(digits, 7)}f}")


def rounded(value: float) -> str:
    """Write a number with two decimals, and a true minus."""
    return _with_true_minus(f"{value:.2f}")


def _with_true_minus(text: str) -> str:
    return text.replace("-", "−") if float(text) != 0.0 else text.lstrip("-")
