"""A sketch: lines, circles and labels in millimetres of metal, on layers, that any drawing program can take.

What has a size on paper (ticks of a hatch, gaps beside a label) is given in paper millimetres times the scale.
Labels go beside their points, clear of each other and, where there is room, of the lines.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.ties import first_smallest

Layer = Literal["LINKS", "GUIDES", "PATHS", "PLAN_V", "PLAN_A", "LOADS", "TEXT", "DIMENSIONS", "DRIVE"]
Habit = Literal[
    "outline",
    "rod",
    "thin",
    "hatch",
    "dotted",
    "curve",
    "axis",
    "arrow",
    "vector",
    "load",
    "part",
    "chord",
    "construction",
    "none",
]
Fill = Literal["none", "paper", "light", "dark", "ink"]
Manner = Literal["symbol", "number", "name", "words"]

LAYERS: tuple[Layer, ...] = ("LINKS", "GUIDES", "PATHS", "PLAN_V", "PLAN_A", "LOADS", "TEXT", "DIMENSIONS")
"""Of every drawing; DRIVE is there where a machine has one."""

_CHARACTER, _LINE, _SYMBOL_LINE = 1.75, 3.2, 4.2
"""Width of a character, height of a line of text and of symbols on paper. [mm]"""

_DIRECTIONS = np.deg2rad(np.arange(0.0, 360.0, 30.0))
_REACHES = (3.0, 4.2, 6.5, 9.5, 13.0)
_NEAR = 3
"""How far from its point a label is tried [mm of paper]; a number only at so many of them, or it says nothing."""


_NOT_ITS_OWN = 40.0
"""What it costs to stand nearer to another label's point."""


_WHITE = 0.5
"""How far the white behind a label goes beyond its box. [mm of paper]"""

_OVER_MARK, _OVER_CURVE = 60.0, 200.0
"""What it costs to lie over a mark, and over a point of a curve that is to be seen whole."""


class Line(NamedTuple):
    """A polyline, or several of them with NaN between; shape (2, n). [mm]"""

    points: Array
    layer: Layer
    habit: Habit
    order: int = 0
    is_closed: bool = False
    fill: Fill = "none"


class Circle(NamedTuple):
    """A circle: centre, radius. [mm]"""

    centre: Array
    radius: float
    layer: Layer
    habit: Habit
    order: int = 0
    fill: Fill = "none"


class Label(NamedTuple):
    """A word, its middle at a point [mm].

    A symbol is set as mathematics: a_BA^n; a number and a name stand on white, and a name is bold.
    """

    position: Array
    text: str
    manner: Manner = "words"


@dataclass
class Sketch:
    """What is drawn, in the order in which it came; `scale` is millimetres of metal in one of paper."""

    scale: float
    lines: list[Line] = field(default_factory=list)
    circles: list[Circle] = field(default_factory=list)
    labels: list[Label] = field(default_factory=list)

    def add(self, parts: "Iterable[Line | Circle | Label]") -> None:
        """Take parts in."""
        lists: dict[type, list[Any]] = {Line: self.lines, Circle: self.circles, Label: self.labels}
        for part in parts:
            lists[type(part)].append(part)

    def outline(self) -> Iterator[Array]:
        """Give the points between which everything drawn lies, shape (2, n)."""
        for line in self.lines:
            yield line.points
        for circle in self.circles:
            yield circle.centre[:, np.newaxis] + circle.radius * np.array([[-1.0, 1.0], [-1.0, 1.0]])


def bounds_of(outlines: Iterable[Array]) -> tuple[Array, Array]:
    """Lower left and upper right corner of what points fill, each array of shape (2, n). [mm]"""
    points = np.concatenate(list(outlines), axis=1)
    return np.nanmin(points, axis=1), np.nanmax(points, axis=1)


class Wish(NamedTuple):
    """A label to place: its point [mm of the sketch], the direction from it that it would rather lie in [rad].

    A symbol or a name keeps off the lines; a number stands on white, may lie over them, and is left out where there is
    no room.
    """

    point: Array
    text: str
    towards: float
    manner: Manner = "symbol"


def placed_labels(
    wishes: Sequence[Wish],
    lines: Iterable[Array],
    scale: float,
    marks: Sequence[Circle] = (),
    others: Sequence[Label] = (),
    curves: Iterable[Array] = (),
) -> Iterator[Label]:
    """Place labels one by one, each at the free place that is best for it; a number without any is left out.

    Parameters
    ----------
    wishes : sequence of Wish
    lines : iterable of arrays, shape (2, n)
        Polylines to keep clear of. [mm of the sketch]
    scale : float
        Millimetres of the sketch in one of paper.
    marks : sequence of Circle
        Which a number may not lie over, as it may over lines.
    others : sequence of Label
        That have their places already.
    curves : iterable of arrays, shape (2, n)
        Polylines to keep clear of that a number may not lie over either. [mm of the sketch]

    Yields
    ------
    Label
    """
    obstacles = _dots_of(lines, scale)
    on_curves = _dots_of(curves, scale)
    points = np.reshape([wish.point for wish in wishes], (-1, 2)).T / scale
    corners = [label_outline(label._replace(position=label.position / scale), 1.0) for label in others]
    taken: list[Array] = [np.stack([np.min(box, axis=1), np.max(box, axis=1)]) for box in corners]
    for wish in wishes:
        size = _size(wish.text.translate({ord(mark): None for mark in "_^"}), wish.manner)
        point = wish.point[:, np.newaxis] / scale
        places = point + _ways(size, _REACHES[: _NEAR if wish.manner == "number" else None])
        boxes = _boxes(places, size)
        over = _n_inside(_beyond(boxes), on_curves)
        under = _n_under(boxes, taken)
        cost = (
            _cost(places - point, wish, under, _n_inside(boxes, obstacles))
            + _OVER_CURVE * over
            + _OVER_MARK * sum(_is_over(boxes, mark, scale) for mark in marks)
            + _NOT_ITS_OWN * _is_nearer_to_another(places, point, points)
        )
        best = first_smallest(cost)
        if wish.manner == "number" and (under[best] or over[best]):
            continue
        taken.append(boxes[..., best])
        yield Label(places[:, best] * scale, wish.text, wish.manner)


def _size(text: str, manner: Manner) -> tuple[float, float]:
    """Width and height of a label. [mm of paper]"""
    return _CHARACTER * len(text) + 0.8, _SYMBOL_LINE if manner == "symbol" else _LINE


def label_outline(label: Label, scale: float) -> Array:
    """Outline of a label's box, closed, shape (2, 5). [mm of the sketch]"""
    width, height = _size(label.text, label.manner)
    corners = 0.5 * np.array([[-width, width, width, -width, -width], [-height, -height, height, height, -height]])
    return label.position[:, np.newaxis] + scale * corners


def labelled_bounds(sketch: Sketch) -> tuple[Array, Array]:
    """Lower left and upper right corner of a sketch with its words. [mm of the sketch]"""
    return bounds_of([*sketch.outline(), *(label_outline(label, sketch.scale) for label in sketch.labels)])


def _ways(size: tuple[float, float], reaches: Sequence[float]) -> Array:
    """Ways from a point to where its label is tried, nearest first; a wide one must stand farther to the side."""
    stretch = 1.0 + 0.12 * (size[0] - size[1]) * np.abs(np.cos(_DIRECTIONS))
    once = [reach * np.array([np.cos(_DIRECTIONS), np.sin(_DIRECTIONS)]) * stretch for reach in reaches]
    return np.concatenate(once, axis=1)


def _boxes(places: Array, size: tuple[float, float]) -> Array:
    """Lower left and upper right corner of a label at each place, shape (2, 2, n)."""
    half = np.array(size)[:, np.newaxis] / 2
    return np.stack([places - half, places + half])


def _is_nearer_to_another(places: Array, point: Array, points: Array) -> Array:
    """Whether a label would stand nearer to another label's point than to its own."""
    others = points[:, np.newaxis] - places[..., np.newaxis]
    return np.min(np.hypot(*others), axis=1) < np.hypot(*(places - point)) - 0.5


def _is_over(boxes: Array, mark: Circle, scale: float) -> Array:
    """Whether a label would lie over a mark."""
    centre = mark.centre[:, np.newaxis] / scale
    return np.hypot(*(np.clip(centre, *boxes) - centre)) < mark.radius / scale


def _cost(away: Array, wish: Wish, under: Array, inside: Array) -> Array:
    """How bad each place is: over a label, over lines, far away, on the wrong side."""
    turn = np.arctan2(away[1], away[0]) - wish.towards
    return (
        1000.0 * under
        + (0.15 if wish.manner == "number" else 4.0) * inside
        + 1.5 * np.hypot(*away)
        + (8.0 if wish.manner == "number" else 2.0) * (1 - np.cos(turn))
    )


def _n_under(boxes: Array, taken: Sequence[Array]) -> Array:
    """How many labels a label would lie over."""
    low, high = boxes[..., np.newaxis]
    of_low, of_high = np.reshape(taken, (-1, 2, 2)).transpose(1, 2, 0)[:, :, np.newaxis]
    return np.count_nonzero(np.all((low < of_high) & (of_low < high), axis=0), axis=1)


def _n_inside(boxes: Array, dots: Array) -> Array:
    """How many points of the lines a label would cover."""
    least, most = np.min(boxes[0], axis=1), np.max(boxes[1], axis=1)
    near = np.all((dots > least[:, np.newaxis]) & (dots < most[:, np.newaxis]), axis=0)
    (left, low), (right, high) = boxes[..., np.newaxis]
    x, y = dots[:, near]
    return np.count_nonzero((x > left) & (x < right) & (y > low) & (y < high), axis=1)


def hides(box: Array, points: Array) -> bool:
    """Whether a label's outline, shape (2, 5), with the white about it lies over one of some points. [mm of paper]"""
    corners = np.stack([np.min(box, axis=1), np.max(box, axis=1)])[..., np.newaxis]
    return bool(_n_inside(_beyond(corners), points)[0])


def _beyond(boxes: Array) -> Array:
    """Corners of labels with the white about them, shape (2, 2, n)."""
    return boxes + np.array([-_WHITE, _WHITE])[:, np.newaxis, np.newaxis]


def _dots_of(lines: Iterable[Array], scale: float) -> Array:
    """Points along polylines. [mm of paper]"""
    return np.concatenate([np.zeros((2, 0)), *(dots(line / scale) for line in lines)], axis=1)


def dots(line: Array) -> Array:
    """Points along a polyline, half a millimetre of paper apart, shape (2, n)."""
    starts, steps = line[:, :-1], np.diff(line, axis=1)
    lengths = np.hypot(*steps)
    closed = np.isfinite(lengths)
    starts, steps = starts[:, closed], steps[:, closed]
    counts = np.maximum(2, (lengths[closed] / 0.5).astype(np.intp))
    of = np.repeat(np.arange(counts.size, dtype=np.intp), counts)
    number = np.arange(of.size) - np.repeat(np.cumsum(counts) - counts, counts)
    return starts[:, of] + steps[:, of] * (number / (counts[of] - 1))


def together(points: Array, reach: float) -> list[list[int]]:
    """Group points, shape (2, n), that lie nearer than `reach` to the first of their group."""
    groups: dict[int, list[int]] = {}
    for i, point in enumerate(points.T):
        near = (first for first in groups if np.hypot(*(point - points[:, first])) < reach)
        groups.setdefault(next(near, i), []).append(i)
    return list(groups.values())
