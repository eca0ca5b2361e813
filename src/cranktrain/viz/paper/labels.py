"""Where labels go: beside their points, clear of each other and, where there is room, of the lines."""

from collections.abc import Iterable, Iterator, Sequence
from typing import Literal, NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.viz.paper.shapes import angle_of
from cranktrain.viz.paper.sketch import Label

_CHARACTER, _LINE, _SYMBOL_LINE = 1.75, 3.2, 4.2
"""Width of a character, height of a line of text and of symbols on paper. [mm]"""

_DIRECTIONS = np.deg2rad(np.arange(0.0, 360.0, 30.0))
_REACHES = (3.0, 4.2, 6.5, 9.5, 13.0)
_NEAR = 3
"""How far from its point a label is tried [mm of paper]; a number only at so many of them, or it says nothing."""


_NOT_ITS_OWN = 40.0
"""What it costs to stand nearer to another label's point."""


_OVER_MARK = 60.0
"""What it costs to lie over a mark."""


class Wish(NamedTuple):
    """A label to place: its point [mm of the sketch], the direction from it that it would rather lie in [rad].

    A symbol or a name keeps off the lines; a number stands on white and may lie over them.
    """

    point: Array
    text: str
    towards: float
    manner: Literal["symbol", "number", "name"] = "symbol"

    @property
    def is_number(self) -> bool:
        """Whether it stands on white, over lines, and is left out where there is no room."""
        return self.manner == "number"


class RoundMark(NamedTuple):
    """A round mark: centre and radius. [mm of the sketch]"""

    centre: Array
    radius: float


def placed_labels(
    wishes: Sequence[Wish], lines: Iterable[Array], scale: float, marks: Sequence[RoundMark] = ()
) -> Iterator[Label]:
    """Place labels one by one, each at the free place that is best for it; a number without any is left out.

    Parameters
    ----------
    wishes : sequence of Wish
    lines : iterable of arrays, shape (2, n)
        Polylines to keep clear of. [mm of the sketch]
    scale : float
        Millimetres of the sketch in one of paper.
    marks : sequence of RoundMark
        Which a number may not lie over, as it may over lines.

    Yields
    ------
    Label
    """
    obstacles = np.concatenate([dots(line / scale) for line in lines], axis=1)
    points = np.stack([wish.point for wish in wishes], axis=1) / scale
    taken: list[tuple[float, float, float, float]] = []
    for wish in wishes:
        size = _size(wish.text.translate({ord(mark): None for mark in "_^"}), is_symbol=wish.manner == "symbol")
        point = wish.point / scale
        best = min(
            (
                point + reach * np.array([np.cos(direction), np.sin(direction)]) * _stretch(size, direction)
                for reach in _REACHES[: _NEAR if wish.is_number else None]
                for direction in _DIRECTIONS
            ),
            key=lambda middle: (
                _cost(middle, point, wish, size, taken, obstacles)
                + _OVER_MARK * sum(_is_over(_box(middle, size), mark, scale) for mark in marks)
                + _NOT_ITS_OWN * _is_nearer_to_another(middle, point, points)
            ),
        )
        if wish.is_number and _n_under(_box(best, size), taken):
            continue
        taken.append(_box(best, size))
        is_symbol = wish.manner == "symbol"
        yield Label(
            best * scale, wish.text, is_bold=wish.manner == "name", is_framed=not is_symbol, is_symbol=is_symbol
        )


def _size(text: str, *, is_symbol: bool) -> tuple[float, float]:
    """Width and height of a label. [mm of paper]"""
    return _CHARACTER * len(text) + 0.8, _SYMBOL_LINE if is_symbol else _LINE


def label_outline(label: Label, scale: float) -> Array:
    """Outline of a label's box, closed, shape (2, 5). [mm of the sketch]"""
    width, height = _size(label.text, is_symbol=label.is_symbol)
    corners = 0.5 * np.array([[-width, width, width, -width, -width], [-height, -height, height, height, -height]])
    return label.position[:, np.newaxis] + scale * corners


def _is_nearer_to_another(middle: Array, point: Array, points: Array) -> bool:
    """Whether a label would stand nearer to another label's point than to its own."""
    away = np.hypot(*(points - middle[:, np.newaxis]))
    return bool(np.min(away) < np.hypot(*(middle - point)) - 0.5)


def _stretch(size: tuple[float, float], direction: float) -> float:
    """How much farther a wide label must stand to the side than above."""
    return 1.0 + 0.12 * (size[0] - size[1]) * abs(float(np.cos(direction)))


def _box(middle: Array, size: tuple[float, float]) -> tuple[float, float, float, float]:
    """Least and largest x, least and largest y of a label."""
    x, y = float(middle[0]), float(middle[1])
    return x - size[0] / 2, x + size[0] / 2, y - size[1] / 2, y + size[1] / 2


def _is_over(box: tuple[float, float, float, float], mark: RoundMark, scale: float) -> bool:
    """Whether a label would lie over a mark."""
    centre = mark.centre / scale
    nearest = np.clip(centre, (box[0], box[2]), (box[1], box[3]))
    return bool(np.hypot(*(nearest - centre)) < mark.radius / scale)


def _cost(
    middle: Array,
    point: Array,
    wish: Wish,
    size: tuple[float, float],
    taken: Sequence[tuple[float, float, float, float]],
    obstacles: Array,
) -> float:
    """How bad a place is: over a label, over lines, far away, on the wrong side."""
    left, right, low, high = _box(middle, size)
    over = _n_under((left, right, low, high), taken)
    inside = (obstacles[0] > left) & (obstacles[0] < right) & (obstacles[1] > low) & (obstacles[1] < high)
    away = middle - point
    turn = angle_of(away) - wish.towards
    crossed = (0.15 if wish.is_number else 4.0) * float(np.count_nonzero(inside))
    return (
        1000.0 * over
        + crossed
        + 1.5 * float(np.hypot(*away))
        + (8.0 if wish.is_number else 2.0) * (1 - float(np.cos(turn)))
    )


def _n_under(own: tuple[float, float, float, float], taken: Sequence[tuple[float, float, float, float]]) -> int:
    """How many labels a label would lie over."""
    left, right, low, high = own
    return sum(left < box[1] and box[0] < right and low < box[3] and box[2] < high for box in taken)


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
    groups: list[list[int]] = []
    for i in range(points.shape[1]):
        near = (of for of in groups if np.hypot(*(points[:, i] - points[:, of[0]])) < reach)
        found = next(near, None)
        if found is None:
            groups.append([i])
        else:
            found.append(i)
    return groups
