"""Room for polygons of forces on a sheet: side by side in rows, each with its words, at the largest scale that fits."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.plans.force_polygons import ForcePolygon, rescaled
from cranktrain.plans.force_sides import INITIAL
from cranktrain.plans.positions import fitting, rounded_scale
from cranktrain.plans.vectors import pair
from cranktrain.scales import scale_for
from cranktrain.viz.figures import with_unit
from cranktrain.viz.paper.page import Box, Page, mathematics
from cranktrain.viz.paper.sketch import Sketch, labelled_bounds
from cranktrain.viz.plans.force_rows import group_words, packed
from cranktrain.viz.plans.force_sketches import force_polygon_sketch

_HEAD, _MOMENT, _GAP = 6.0, 5.0, 6.0
"""Height of a heading, of a line with a crank's moment, and what lies between two polygons. [mm]"""

_LETTER = 2.0
"""Width of a letter of a heading. [mm]"""

_SMALLEST = 18.0
"""Size of a sheet's polygon of the most forces that can be read. [mm]"""


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
