"""Sketch of a polygon of forces: sides head to tail, whole reactions of which sides are parts, chords."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.plans.force_polygons import ForcePolygon
from cranktrain.plans.force_sides import PolygonForce
from cranktrain.plans.vectors import angle_of
from cranktrain.viz.paper.sketch import Circle, Habit, Sketch, Wish, placed_labels
from cranktrain.viz.plans.sketches import arrow

_SYMBOL, _SEEN = 4.0, 0.6
"""A force shorter than this has its number in the table instead of its symbol beside it; and nothing. [mm]"""

_APART = 1.0
"""A whole reaction is drawn where both its parts are longer than this. [mm]"""

_ASIDE, _OVER = 0.9, 0.85
"""How far a line stands beside one that it would cover, and how near it may run to one that it does not. [mm]"""

_PLACES, _CLEAR = (0.5, 0.36, 0.64, 0.22, 0.78), 7.0
"""Where along a force its symbol may be; other lines at such a distance are far enough. [mm]"""

_LEAST = 1e-9
"""Of a length by which is divided. [mm]"""


class _Drawn(NamedTuple):
    """A force to draw: its number among the sides, 0 for none; from where to where; its manner; where its symbol is."""

    force: PolygonForce
    number: int
    start: Array
    end: Array
    habit: Habit
    middle: float

    @property
    def length(self) -> float:
        """Length on paper. [mm]"""
        return float(np.hypot(*(self.end - self.start)))


def force_polygon_sketch(polygon: ForcePolygon) -> Sketch:
    """Polygon in drawing millimetres from a ring: inertia dashed, parts of a reaction thin, chords dash-dotted."""
    sketch = Sketch(1.0)
    drawn = list(_to_draw(polygon))
    lines: list[Array] = []
    for one in drawn:
        lines.append(_beside(np.stack([one.start, one.end], axis=1), lines))
        sketch.add(arrow(lines[-1][:, 0], lines[-1][:, 1], "LINKS", one.habit))
    sketch.add([Circle(polygon.corners[:, 0], 0.7, "LINKS", "outline", 6, "paper")])
    wishes = list(_wishes(drawn, lines, np.mean(polygon.corners, axis=1)))
    sketch.add(placed_labels(wishes, list(sketch.outline()), 1.0))
    return sketch


def _wishes(drawn: Sequence[_Drawn], lines: Sequence[Array], middle: Array) -> Iterator[Wish]:
    """Symbols of forces, or numbers of short ones, where other lines are farthest."""
    for i, (one, line) in enumerate(zip(drawn, lines, strict=True)):
        others = [other for j, other in enumerate(lines) if j != i]
        places = sorted(_PLACES, key=lambda place, own=one.middle: abs(place - own))
        points = [line @ np.array([1.0 - place, place]) for place in places]
        rooms = [min((_distance(point, other) for other in others), default=_CLEAR) for point in points]
        point = points[first_largest(np.round(np.minimum(rooms, _CLEAR)))]
        towards = _outward(point - middle, angle_of(one.end - one.start))
        if one.length > _SYMBOL:
            yield Wish(point, one.force.symbol, towards)
        elif one.length > _SEEN and one.number:
            yield Wish(point, str(one.number), towards, "number")


def _distance(point: Array, line: Array) -> float:
    """How far a point is from a line between two others. [mm]"""
    along = line[:, 1] - line[:, 0]
    share = float(np.clip(along @ (point - line[:, 0]) / max(float(along @ along), _LEAST), 0.0, 1.0))
    return float(np.hypot(*(line[:, 0] + share * along - point)))


def _to_draw(polygon: ForcePolygon) -> Iterator[_Drawn]:
    """Sides, then whole reactions, then chords."""
    corners = polygon.corners.T
    wholes = [span for span in polygon.wholes if min(polygon.length(part) for part in polygon.parts(span)) > _APART]
    split = {span.force.joint for span in wholes}
    for i, force in enumerate(polygon.forces):
        is_part = force.cause == "reaction" and force.joint in split
        habit: Habit = "part" if force.cause == "inertia" else "rod" if is_part else "vector"
        yield _Drawn(force, i + 1, corners[i], corners[i + 1], habit, 0.5)
    for span in wholes:
        yield _Drawn(span.force, 0, corners[span.start], corners[span.end], "vector", 0.36)
    for span in polygon.chords:
        yield _Drawn(span.force, 0, corners[span.start], corners[span.end], "chord", 0.64)


def _beside(ends: Array, lines: Sequence[Array]) -> Array:
    """Give a line, moved beside those that it would cover, away from them."""
    direction = ends[:, 1] - ends[:, 0]
    across = np.array([direction[1], -direction[0]]) / max(float(np.hypot(*direction)), _LEAST)
    for steps in ((0.0,), (1.0, -1.0), (2.0, -2.0)):
        tried = [ends + (step * _ASIDE * across)[:, np.newaxis] for step in steps]
        room = [min((_room(one, line) for line in lines), default=np.inf) for one in tried]
        if max(room) >= _OVER:
            return tried[first_largest(room)]
    return ends


def _room(one: Array, other: Array) -> float:
    """How far two lines lie apart where they run beside one another, at most; infinite where they do not. [mm]"""
    direction = other[:, 1] - other[:, 0]
    length = max(float(np.hypot(*direction)), _LEAST)
    away = one - other[:, :1]
    along = direction @ away / length
    low, high = max(float(np.min(along)), 0.0), min(float(np.max(along)), length)
    if high - low < _OVER:
        return float("inf")
    aside = (direction[0] * away[1] - direction[1] * away[0]) / length
    slope = (aside[1] - aside[0]) / (along[1] - along[0])
    return float(np.max(np.abs(aside[0] + slope * (np.array([low, high]) - along[0]))))


def _outward(away: Array, along: float) -> float:
    """Direction across a side, away from the middle; to its left where the middle is on it."""
    across = np.array([-np.sin(along), np.cos(along)])
    side = -1.0 if float(across @ away) < -1e-6 else 1.0
    return angle_of(side * across)
