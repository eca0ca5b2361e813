"""A detail at a scale of its own, where a crank is too small on a sheet to be seen."""

from collections.abc import Callable

import numpy as np

from cranktrain.motion import Array
from cranktrain.plans.positions import scale_words
from cranktrain.viz.paper.labels import dots
from cranktrain.viz.paper.page import Box, Page, fitting_scale
from cranktrain.viz.paper.sketch import Circle, Sketch

_SMALLEST = 5.0
"""Radius on paper from which a crank is seen well enough. [mm]"""

_RADIUS, _FIGURES = 27.0, 10.0
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
    scale = fitting_scale(size, size, (_RADIUS - _FIGURES, _RADIUS - _FIGURES))
    place = _free_place(whole, origin, room)
    page.draw(drawn(scale), place, within=_RADIUS)
    reach = max(_RADIUS * scale / whole.scale, 2.5)
    for radius, middle in ((_RADIUS, place), (reach, origin)):
        page.draw(Sketch(1.0, circles=[Circle(np.zeros(2), radius, "DIMENSIONS", "thin", 8)]), middle)
    side = -1.0 if place[0] > origin[0] else 1.0
    page.text(origin[0] + side * (reach + 1.2), origin[1] + reach, _NAME, ha="right" if side < 0 else "left")
    page.text(place[0], place[1] + _RADIUS + 1.5, f"{_NAME} ({scale_words(scale)})", ha="center")


def _free_place(whole: Sketch, origin: tuple[float, float], room: Box) -> tuple[float, float]:
    """Find the middle of a detail that is farthest from all that is drawn. [mm of paper]"""
    taken: Array = np.array(origin)[:, np.newaxis] + np.concatenate(
        [dots(line.points / whole.scale)[:, ::_EVERY] for line in whole.lines if line.habit != "hatch"], axis=1
    )
    x = np.arange(room.left + _RADIUS + 1.0, room.left + room.width - _RADIUS, _STEP)
    y = np.arange(room.bottom + _RADIUS + 1.0, room.bottom + room.height - _RADIUS - 5.0, _STEP)
    tried = np.stack([part.ravel() for part in np.meshgrid(x, y)])
    away = np.min(np.hypot(*(tried[:, :, np.newaxis] - taken[:, np.newaxis, :])), axis=1)
    best = int(np.argmax(away))
    return float(tried[0, best]), float(tried[1, best])
