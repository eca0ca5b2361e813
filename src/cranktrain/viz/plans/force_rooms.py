"""Room for polygons of forces on a sheet: in rows, each with its words, at the largest scale that fits; how drawn."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.panels.figures import with_unit
from cranktrain.panels.formulas import mathematics
from cranktrain.plans.force_polygons import ForcePolygon, rescaled
from cranktrain.plans.force_sides import INITIAL, PolygonForce
from cranktrain.plans.positions import fitting, rounded_scale
from cranktrain.plans.vectors import angle_of, pair
from cranktrain.saying.scales import scale_for
from cranktrain.viz.paper.page import Box, Page
from cranktrain.viz.paper.sketch import Circle, Habit, Sketch, Wish, labelled_bounds, placed_labels
from cranktrain.viz.plans.force_rows import group_words, packed
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

_HEAD, _MOMENT, _GAP = 6.0, 5.0, 6.0
"""Height of a heading, of a line with a crank's moment, and what lies between two polygons. [mm]"""

_LETTER = 2.0
"""Width of a letter of a heading. [mm]"""

_SMALLEST = 18.0
"""Size of a sheet's polygon of the most forces that can be read. [mm]"""


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


class DrawnPolygon(NamedTuple):
    """A polygon with its sketch, and the corners of what that covers with its labels. [mm]"""

    polygon: ForcePolygon
    sketch: Sketch
    low: Array
    high: Array

    @property
    def above(self) -> float:
        """Height of the words above the polygon. [mm]"""
        return _HEAD + _MOMENT * (self.polygon.sort == INITIAL)

    @property
    def size(self) -> Array:
        """Width and height that it needs. [mm]"""
        width, height = self.high - self.low
        words = _LETTER * len(group_words(self.polygon))
        return np.array([max(float(width), words) + _GAP, float(height) + self.above + _GAP])


def drawn_polygon(polygon: ForcePolygon) -> DrawnPolygon:
    """Draw a polygon, and measure it with its labels."""
    sketch = force_polygon_sketch(polygon)
    return DrawnPolygon(polygon, sketch, *labelled_bounds(sketch))


def fitting_polygons(
    groups: Sequence[Sequence[ForcePolygon]], room: tuple[float, float]
) -> list[list[list[DrawnPolygon]]] | None:
    """Draw the polygons of each angle as large as they fit in rows, all to one scale; None where they would be specks.

    Parameters
    ----------
    groups : sequence of sequences of ForcePolygon
        Of each angle.
    room : (width, height)
        Of each angle. [mm]

    Returns
    -------
    list, of each angle a list of rows
    """
    if min(room) <= 0.0:
        return None
    outlines = [polygon.corners * polygon.scale for group in groups for polygon in group]
    one = scale_for("N", 0.0).one
    scale = fitting(outlines, room, one=one)
    largest = max(outlines, key=lambda outline: (outline.shape[1], float(np.max(np.ptp(outline, axis=1)))))
    coarsest = float(np.max(np.ptp(largest, axis=1))) / _SMALLEST
    while scale <= coarsest:
        found = [_rows([drawn_polygon(rescaled(one, scale)) for one in group], room) for group in groups]
        if all(rows for rows in found):
            return found
        scale = rounded_scale(1.01 * scale, one=one)
    return None


def _rows(pictures: Sequence[DrawnPolygon], room: tuple[float, float]) -> list[list[DrawnPolygon]]:
    """Put pictures side by side in as many rows as they need; none where the room does not suffice."""
    rows = packed(pictures, lambda row: _width(row) <= room[0])
    return rows if max(map(_width, rows)) <= room[0] and sum(map(_height, rows)) <= room[1] else []


def _width(row: Sequence[DrawnPolygon]) -> float:
    return sum(float(one.size[0]) for one in row)


def _height(row: Sequence[DrawnPolygon]) -> float:
    return max(float(one.size[1]) for one in row)


def draw_rows(page: Page, rows: Sequence[Sequence[DrawnPolygon]], box: Box) -> None:
    """Draw rows of polygons in a room, of which what is left is shared among them."""
    top = box.bottom + box.height
    whole = sum(map(_height, rows))
    for row in rows:
        height = _height(row) * box.height / whole
        widths = np.array([one.size[0] for one in row])
        lefts = box.left + np.cumsum([0.0, *widths]) * box.width / np.sum(widths)
        for i, picture in enumerate(row):
            _draw(page, picture, Box(lefts[i], top - height, lefts[i + 1] - lefts[i], height))
        top -= height


def _draw(page: Page, picture: DrawnPolygon, box: Box) -> None:
    """Draw a polygon in the middle of its room, below its heading."""
    top = box.bottom + box.height
    page.heading(box.left + 4.0, top - 4.0, group_words(picture.polygon))
    if picture.polygon.sort == INITIAL:
        size = picture.polygon.moment  # in the sense of rotation
        moment = f"{mathematics('M_b')} = {with_unit(size, scale_for('N*m', abs(size)))}"
        page.text(box.left + 4.0, top - 9.0, moment)
    below = box._replace(height=box.height - picture.above)
    page.draw(picture.sketch, pair(below.middle - (picture.low + picture.high) / 2))
