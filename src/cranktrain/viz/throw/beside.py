"""Throws that are drawn beside each other: one sketch of several, each about its own shaft."""

from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.plans.vectors import pair
from cranktrain.viz.paper.labels import labelled_bounds
from cranktrain.viz.paper.page import fitting_scale
from cranktrain.viz.paper.sketch import Circle, Label, Line, Sketch

_PASSES = 3
"""How often a scale is corrected: hatches and words keep their size on paper."""

_GAP = 6.0
"""Between two throws on paper. [mm]"""


class Bounds(NamedTuple):
    """Lower left and upper right corner of a sketch. [mm of metal]"""

    low: Array
    high: Array


class Beside(NamedTuple):
    """Throws in one sketch, the scale, and where their shafts are in it. [mm of metal]"""

    sketch: Sketch
    scale: float
    places: tuple[Array, ...]


def fitted(drawn: Callable[[float], Sequence[Sketch]], rough: float, room: tuple[float, float]) -> Beside:
    """Put throws in a row or in a column, whichever may be drawn larger, to a round scale that fits a room.

    Parameters
    ----------
    drawn : callable scale → sketches
        One for each throw.
    rough : float
        Scale to begin with.
    room : (width, height)
        [mm of paper]
    """
    scale = rough
    for _pass in range(_PASSES):
        scale = min(needed for needed, _found in _both_ways(drawn(scale), scale, room))
    return at_scale(drawn, scale, room)


def at_scale(drawn: Callable[[float], Sequence[Sketch]], scale: float, room: tuple[float, float]) -> Beside:
    """Put throws beside each other to a scale, as `fitted` does."""
    return min(_both_ways(drawn(scale), scale, room), key=lambda way: way[0])[1]


def _both_ways(sketches: Sequence[Sketch], scale: float, room: tuple[float, float]) -> Iterator[tuple[float, Beside]]:
    """Throws in a row and in a column, each with the scale that would fit the room."""
    bounds = [Bounds(*labelled_bounds(sketch)) for sketch in sketches]
    for is_row in (True, False):
        places, (low, high) = arranged(bounds, _GAP * scale, is_row=is_row)
        yield fitting_scale(*pair(high - low), room), Beside(together(sketches, places), scale, places)


def arranged(bounds: Sequence[Bounds], gap: float, *, is_row: bool) -> tuple[tuple[Array, ...], Bounds]:
    """Give where the shafts go so that throws stand in a row or a column, and the bounds of all; the first stays."""
    axis = 0 if is_row else 1
    places = [np.zeros(2)]
    for before, own in pairwise(bounds):
        step = np.zeros(2)
        step[axis] = before.high[axis] - own.low[axis] + gap if is_row else before.low[axis] - own.high[axis] - gap
        places.append(places[-1] + step)
    low = np.min([place + own.low for place, own in zip(places, bounds, strict=True)], axis=0)
    high = np.max([place + own.high for place, own in zip(places, bounds, strict=True)], axis=0)
    return tuple(places), Bounds(low, high)


def together(sketches: Sequence[Sketch], places: Sequence[Array]) -> Sketch:
    """Join sketches to one scale, each with its origin at a place."""
    whole = Sketch(sketches[0].scale)
    for sketch, place in zip(sketches, places, strict=True):
        whole.add(_moved(sketch, place))
    return whole


def _moved(sketch: Sketch, by: Array) -> Iterator[Line | Circle | Label]:
    """Parts of a sketch elsewhere."""
    yield from (line._replace(points=line.points + by[:, np.newaxis]) for line in sketch.lines)
    yield from (circle._replace(centre=circle.centre + by) for circle in sketch.circles)
    yield from (label._replace(position=label.position + by) for label in sketch.labels)
