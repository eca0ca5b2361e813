"""A detail at a scale of its own, where a crank is too small on a sheet to be seen."""

from collections.abc import Callable

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.plans.positions import scale_words
from cranktrain.viz.paper.page import Box, Page, fitting_scale
from cranktrain.viz.paper.sketch import Circle, Sketch, dots

_SMALLEST = 5.0
"""Radius on paper from which a crank is seen well enough. [mm]"""

RADIUS, _FIGURES = 27.0, 10.0
"""Radius of a detail, and what the figures about the shaft need of it. [mm]"""

_STEP, _EVERY = 3.0, 6
"""Between places that are tried for a detail [mm]; of the dots along lines only every so manyth is looked at."""

_NAME = "A"


def is_too_small(crank_radius: float, scale: float) -> bool:
    """Whether a crank [mm] is too small at a scale to be seen."""
    return crank_radius / scale < _SMALLEST


def draw_detail(
    page: Page, drawn: Callable[[float], Sketch], size: float, whole: Sketch, origin: tuple[float, float], room: Box
) -> None:
    """Draw the shaft larger, where the room beside the whole is largest, and say to which scale.

    Parameters
    ----------
    page : Page
    drawn : callable scale → Sketch
        About the shaft. [mm of metal in one of paper]
    size : float
        How far from the shaft it must be seen. [mm]
    whole : Sketch
        The mechanism as it is drawn, with the shaft at `origin`.
    origin : (x, y)
        [mm of paper]
    room : Box
        In which to find a place.
    """
    scale = fitting_scale(size, size, (RADIUS - _FIGURES, RADIUS - _FIGURES))
    place, _away = _free_place(whole, origin, room)
    page.draw(drawn(scale), place, within=RADIUS)
    reach = max(RADIUS * scale / whole.scale, 2.5)
    for radius, middle in ((RADIUS, place), (reach, origin)):
        page.draw(Sketch(1.0, circles=[Circle(np.zeros(2), radius, "DIMENSIONS", "thin", 8)]), middle)
    side = -1.0 if place[0] > origin[0] else 1.0
    page.text(origin[0] + side * (reach + 1.2), origin[1] + reach, _NAME, ha="right" if side < 0 else "left")
    page.text(place[0], place[1] + RADIUS + 1.5, f"{_NAME} ({scale_words(scale)})", ha="center")


def has_room(whole: Sketch, origin: tuple[float, float], room: Box) -> bool:
    """Whether a detail can stand beside the whole; parameters as `draw_detail` takes them."""
    if min(room.width - 2 * RADIUS - 1.0, room.height - 2 * RADIUS - 6.0) <= 0.0:
        return False
    return _free_place(whole, origin, room)[1] > RADIUS + 1.0


def _free_place(whole: Sketch, origin: tuple[float, float], room: Box) -> tuple[tuple[float, float], float]:
    """Find the middle of a detail that is farthest from all that is drawn, and how far that is. [mm of paper]"""
    taken: Array = np.array(origin)[:, np.newaxis] + np.concatenate(
        [dots(line.points / whole.scale)[:, ::_EVERY] for line in whole.lines if line.habit != "hatch"], axis=1
    )
    x = np.arange(room.left + RADIUS + 1.0, room.left + room.width - RADIUS, _STEP)
    y = np.arange(room.bottom + RADIUS + 1.0, room.bottom + room.height - RADIUS - 5.0, _STEP)
    tried = np.stack([part.ravel() for part in np.meshgrid(x, y)])
    away = np.min(np.hypot(*(tried[:, :, np.newaxis] - taken[:, np.newaxis, :])), axis=1)
    best = first_largest(away)
    return (float(tried[0, best]), float(tried[1, best])), float(away[best])
