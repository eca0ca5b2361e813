"""Throws that are drawn beside each other: one sketch of several, each about its own shaft."""

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.ties import smallest_of
from cranktrain.plans.vectors import pair
from cranktrain.viz.paper.page import fitting_scale
from cranktrain.viz.paper.sketch import Circle, Label, Line, Sketch, labelled_bounds

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
    """Put throws in as many rows as let them be drawn largest, to a round scale that fits a room.

    Parameters
    ----------
    drawn : callable scale → sketches
        One for each throw.
    rough : float
        Scale to begin with.
    room : (width, height)
        [mm of paper]
    """
    scale, sketches = rough, drawn(rough)
    for _pass in range(_PASSES):
        needed = min(needed for needed, _places in _all_ways(sketches, scale, room))
        if needed == scale:
            break
        scale, sketches = needed, drawn(needed)
    return _best(sketches, scale, room)


def at_scale(drawn: Callable[[float], Sequence[Sketch]], scale: float, room: tuple[float, float]) -> Beside:
    """Put throws beside each other to a scale, as `fitted` does."""
    return _best(drawn(scale), scale, room)


def _best(sketches: Sequence[Sketch], scale: float, room: tuple[float, float]) -> Beside:
    """Join the throws in the arrangement that could be drawn largest."""
    _needed, places = smallest_of(_all_ways(sketches, scale, room), lambda way: way[0])
    return Beside(together(sketches, places), scale, places)


def _all_ways(
    sketches: Sequence[Sketch], scale: float, room: tuple[float, float]
) -> Iterator[tuple[float, tuple[Array, ...]]]:
    """The scale that would fit the room, and where the shafts are, of throws in one row, in more, in a column."""
    for places, (low, high) in arrangements([Bounds(*labelled_bounds(one)) for one in sketches], _GAP * scale):
        yield fitting_scale(*pair(high - low), room), places


def arrangements(bounds: Sequence[Bounds], gap: float) -> Iterator[tuple[tuple[Array, ...], Bounds]]:
    """Give where the shafts go so that throws stand in one row, in more, in a column; and the bounds of all.

    Each arrangement has its shafts in line, down and across; the first one stays where it is.
    """
    sizes = dict.fromkeys(-(-len(bounds) // n_rows) for n_rows in range(1, len(bounds) + 1))
    return (_arranged(bounds, gap, n_columns) for n_columns in sizes)


def _arranged(bounds: Sequence[Bounds], gap: float, n_columns: int) -> tuple[tuple[Array, ...], Bounds]:
    """Arrange throws in rows of so many, each column as wide and each row as high as needed."""
    number = np.arange(len(bounds))
    lows, highs = (np.array(corners) for corners in zip(*bounds, strict=True))
    across = _steps(lows[:, 0], highs[:, 0], number % n_columns, gap)
    down = _steps(-highs[:, 1], -lows[:, 1], number // n_columns, gap)
    places = np.stack([across, -down], axis=1)
    return tuple(places), Bounds(np.min(places + lows, axis=0), np.max(places + highs, axis=0))


def _steps(lows: Array, highs: Array, line: NDArray[np.intp], gap: float) -> Array:
    """Where the lines go in which throws stand so that none touches the next; the first line at 0."""
    n_lines = int(np.max(line)) + 1
    ends = np.array([np.max(highs[line == k]) for k in range(n_lines)])
    begins = np.array([np.min(lows[line == k]) for k in range(n_lines)])
    return np.concatenate([[0.0], np.cumsum(ends[:-1] - begins[1:] + gap)])[line]


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
