"""Polar diagrams on paper: loads of bearings and pins side by side to one scale, with rings and the largest load."""

from collections.abc import Iterable, Sequence
from itertools import islice
from math import sqrt
from typing import NamedTuple

import numpy as np

from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.numerics.ties import largest_of
from cranktrain.panels.parts import Polars
from cranktrain.panels.shapes import PolarDiagram
from cranktrain.plans.positions import fitting
from cranktrain.plans.stroke_lines import unit
from cranktrain.plans.vectors import angle_of, pair
from cranktrain.saying.scales import scale_for
from cranktrain.saying.wording import either_of, plain
from cranktrain.viz.paper.page import Box, Page
from cranktrain.viz.paper.rings import RING_SCALES, PolarRings, ring_numbers, ring_step
from cranktrain.viz.paper.sketch import Circle, Label, Sketch, Wish, dots, label_outline, placed_labels
from cranktrain.viz.paper.style import COLOURS, INK, MUTED

_BESIDE, _HEAD = 3.5, 7.0
"""Room about a diagram, and over it for its title. [mm]"""
_WORDS = 4.2
"""Of a line of words below the diagrams. [mm]"""
_MARK, _SMALL_MARK, _RINGED = 0.55, 0.4, 0.9
"""Radii of a mark of the crank angle, of one in a small diagram, and of the ring about the largest load. [mm]"""
_MARKED = ((36.0, 30), (22.0, 60), (0.0, 90))
"""From which size of a diagram of one turn on [mm], and each how many degrees of the crank, marks stand."""
_NUMBERED = ((70.0, 60), (40.0, 90), (0.0, 180))
"""From which size of a diagram on [mm], and each how many degrees of one turn, marks have their crank angles."""
_SMALL, _THIN = 30.0, 0.7
"""A smaller diagram [mm] has small marks, thin curves [pt], and of numbers its largest load's and the rings'."""
_NAME, _NAMED = 2.0, 4.2
"""Below a diagram for the crank angle of its largest load; how far from this that stands. [mm]"""
_BESIDE_LARGEST = 15.0
"""A mark so near to the largest load has no number of its own. [deg]"""
_EDGE = 3.0
"""How far axes and rings go beyond the curves. [mm]"""
_LEGIBLE = 40.0
"""Size of the largest diagram from which methods side by side are told apart. [mm]"""
_LETTER = 2.0
"""Width of a letter of a title. [mm]"""


class MethodPen(NamedTuple):
    """Width of a method's curve [pt], its colour, dashes in widths, and its layer."""

    width: float
    colour: str
    dashes: tuple[float, ...]
    layer: float


_ALONE = MethodPen(1.2, INK, (), 6.0)
"""Of a curve that is of no method."""
_PENS = (
    MethodPen(1.5, INK, (), 6.0),
    MethodPen(0.9, COLOURS["s"], (6.0, 2.0), 5.0),
    MethodPen(0.8, COLOURS["v"], (1.2, 1.4), 5.0),
    MethodPen(0.7, COLOURS["j"], (9.0, 2.0, 1.5, 2.0), 4.0),
    MethodPen(0.7, COLOURS["T"], (), 3.0),
    MethodPen(0.8, COLOURS["p"], (3.0, 1.5), 4.0),
)
"""Of methods in the order of trust, of those behind see `method_pen`: no meaning is in colour alone."""


def method_pen(place: int) -> MethodPen:
    """Pen of the method at a place in the order of trust, from 0; behind all pens a dash with ever more dots."""
    if place < len(_PENS):
        return _PENS[place]
    n_dots = place - len(_PENS) + 2
    return MethodPen(0.7, COLOURS["N"], (6.0, 1.5, *n_dots * (1.2, 1.5)), 3.0)


def line_of_method(place: int | None) -> dict[str, object]:
    """How the curve of a method is drawn by its place in the order of trust, None of what is by no method."""
    pen = _ALONE if place is None else method_pen(place)
    line = (0, pen.dashes) if pen.dashes else "-"
    return {"color": pen.colour, "linewidth": pen.width, "linestyle": line, "zorder": pen.layer}


def cells(box: Box, n: int, aspect: float = 1.0) -> list[Box]:
    """Rooms for n pictures, row by row, of as many columns as make pictures of an aspect largest."""

    def size(n_columns: int) -> float:
        n_rows = -(-n // n_columns)
        return min(box.width / n_columns / aspect, box.height / n_rows)

    n_columns = largest_of(range(1, n + 1), size)
    return _in_rows([box], n, n_columns, box.height / -(-n // n_columns))


def _in_rows(sheets: Sequence[Box], n: int, n_columns: int, height: float) -> list[Box]:
    """Rooms for n pictures in rows of a height, from the top of the first sheet on. [mm]"""
    width = sheets[0].width / n_columns
    rooms = (
        Box(sheet.left + column * width, sheet.bottom + sheet.height - (row + 1) * height, width, height)
        for sheet in sheets
        for row in range(_n_rows(sheet, height))
        for column in range(n_columns)
    )
    return list(islice(rooms, n))


def _n_rows(sheet: Box, height: float) -> int:
    """How many rows of a height a sheet has room for."""
    return int(sheet.height / height * (1 + 1e-9))


class _Extent(NamedTuple):
    """Of all diagrams of a sheet: the widest and the highest [N], and letters of the longest title."""

    width: float
    height: float
    n_letters: int

    def room_in(self, room: Box) -> tuple[float, float]:
        """What a room leaves for a diagram. [mm]"""
        around = 2 * (_BESIDE + 1.0)
        return room.width - around, room.height - _HEAD - around + _BESIDE - _NAME

    def size_in(self, room: Box) -> float:
        """The larger side of the largest diagram in a room [mm], 0 where a title is wider."""
        if self.n_letters * _LETTER > room.width:
            return 0.0
        sides = zip(self.room_in(room), (self.width, self.height), strict=True)
        return max(self.width, self.height) * min(side / load for side, load in sides if load > 0.0)


def _in_groups(page: Page, box: Box, n: int, n_beside: int, extent: _Extent) -> list[Box]:
    """Rooms for n pictures, rows of whole groups of them; on as many sheets as make the largest legible."""
    n_groups = n // n_beside
    sheets: list[Box] = []
    rooms: list[Box] = []
    while len(sheets) < n_groups and not (rooms and extent.size_in(rooms[0]) >= _LEGIBLE):
        sheets.append(page.sheet(len(sheets), box))
        rows = [(k, _row_height(sheets, -(-n_groups // k))) for k in range(1, n_groups + 1)]
        tried = [_in_rows(sheets, n, k * n_beside, height) for k, height in rows]
        rooms = largest_of(tried, lambda some: extent.size_in(some[0]))
    page.lengthen(len(sheets))
    return rooms


def _row_height(sheets: Sequence[Box], n_rows: int) -> float:
    """The largest height of rows of which some sheets together have room for so many. [mm]"""
    heights = (sheet.height / n for sheet in sheets for n in range(1, n_rows + 1))
    return max(one for one in heights if sum(_n_rows(sheet, one) for sheet in sheets) >= n_rows)


def draw_polars(page: Page, polars: Polars, box: Box) -> None:
    """Draw diagrams side by side, all to one scale, over the words for that; groups on as many sheets as they take."""
    diagrams = polars.diagrams
    outlines = [np.concatenate([*(curve.points for curve in one.curves), np.zeros((2, 1))], axis=1) for one in diagrams]
    largest = max(float(np.max(np.hypot(*outline))) for outline in outlines)
    unit = scale_for("N", largest)
    step = ring_step(largest, unit)
    words = _(
        "1 mm is {force} {unit}; rings each {step} {unit}; marks each {marks} of the crank; ringed, bold: largest load"
    )
    foot = _WORDS * (len(page.wrapped(words, box.width)) + bool(polars.notes)) + 2.0
    above = box._replace(bottom=box.bottom + foot, height=box.height - foot)
    width, height = np.max([np.ptp(outline, axis=1) for outline in outlines], axis=0).tolist()
    extent = _Extent(width, height, max(len(str(one.title)) for one in diagrams))
    if polars.n_beside is None:
        rooms = cells(above, len(diagrams), width / height if height else 1.0)
    else:
        rooms = _in_groups(page, above, len(diagrams), polars.n_beside, extent)
    scale = fitting(outlines, extent.room_in(rooms[0]), RING_SCALES, unit.one)
    rings = PolarRings(step, unit, scale)
    marked = [
        _draw(page, one, outline / scale, cell, rings)
        for one, outline, cell in zip(diagrams, outlines, rooms, strict=True)
    ]
    said = words.format(
        force=plain(float(unit.of(scale))), step=plain(step), unit=unit.label, marks=_marks_words(marked)
    )
    whole = f"{polars.notes}; {said}." if polars.notes else f"{said}."
    page.notes(box.left, rooms[-1].bottom - 4.0, page.wrapped(whole, box.width))


def _marks_words(steps: Iterable[int]) -> str:
    """Degrees of the crank from mark to mark: of the largest diagrams, and of smaller ones if these differ."""
    first, *others = sorted(set(steps))
    if not others:
        return f"{first}°"
    return _("{angle}°, in smaller diagrams {angles},", angle=first, angles=either_of([f"{one}°" for one in others]))


def _draw(page: Page, one: PolarDiagram, outline: Array, cell: Box, rings: PolarRings) -> int:
    """Draw one diagram in the middle of its room: cross, rings, curves, marks, the largest load; give `_mark_step`."""
    low, high = np.min(outline, axis=1), np.max(outline, axis=1)
    page.heading(cell.left + 1.0, cell.bottom + cell.height - 4.0, str(one.title))
    middle = np.array([cell.left + cell.width / 2, cell.bottom + (cell.height - _HEAD) / 2])
    pole = middle - (low + high) / 2
    edges = low - _EDGE, high + _EDGE
    for axis in _axes(edges):
        page.paper.plot(*(pole[:, np.newaxis] + axis), color=MUTED, linewidth=0.45, zorder=1)
    for ring in rings.drawn(edges):
        shown = pole[:, np.newaxis] + ring
        page.paper.plot(*shown, color=MUTED, linewidth=0.5, linestyle=(0, (1.0, 2.2)), zorder=1)
    size = float(np.max(high - low))
    thin = {"linewidth": _THIN} if size < _SMALL else {}
    for curve in one.curves:
        page.paper.plot(*(pole[:, np.newaxis] + curve.points / rings.scale), **(line_of_method(curve.place) | thin))
    # Marks of two turns share the room, an area, that those of one have.
    step = _least_of(_MARKED, size / sqrt(one.cycle / 360.0))
    page.draw(_marked(one, edges, size, step, rings), pair(pole))
    return step


def _axes(edges: tuple[Array, Array]) -> list[Array]:
    """The cross through the pole, each line of shape (2, 2). [mm]"""
    (left, low), (right, high) = (edge.tolist() for edge in edges)
    return [np.array([[left, right], [0.0, 0.0]]), np.array([[0.0, 0.0], [low, high]])]


def _least_of(table: Sequence[tuple[float, int]], size: float) -> int:
    """What a table has for the size of a diagram. [mm]"""
    return next(degrees for least, degrees in table if size >= least)


def _marked(one: PolarDiagram, edges: tuple[Array, Array], size: float, step: int, rings: PolarRings) -> Sketch:
    """Marks of the crank angle with numbers of some, numbers of the rings, the largest load ringed. [mm]"""
    sketch = Sketch(1.0)
    largest = one.largest / rings.scale
    is_small = size < _SMALL
    is_marked = one.marked % step == 0.0
    marks, marked = one.marks[:, is_marked] / rings.scale, one.marked[is_marked].tolist()
    radius = _SMALL_MARK if is_small else _MARK
    sketch.add(Circle(place, radius, "LINKS", "thin" if is_small else "rod", 8, "paper") for place in marks.T)
    wishes: list[Wish] = []
    if np.isfinite(one.largest_at):
        sketch.add([Circle(largest, _RINGED, "LINKS", "outline", 7)])
        wishes.append(Wish(largest, f"{round(one.largest_at) % one.cycle:.0f}°", angle_of(largest), "name"))
    every = _least_of(_NUMBERED, size) * round(one.cycle / 360.0)
    wishes += [
        Wish(place, f"{angle:g}°", angle_of(place), "number")
        for place, angle in zip(marks.T, marked, strict=True)
        if not is_small
        and angle % every == 0.0
        and abs((angle - one.largest_at + 180.0) % one.cycle - 180.0) > _BESIDE_LARGEST
    ]
    curves = [curve.points / rings.scale for curve in one.curves]
    numbers = ring_numbers(_kept_free(curves, wishes), edges, rings)
    sketch.add(numbers)
    if wishes:
        sketch.add(placed_labels(wishes, _axes(edges), 1.0, sketch.circles, numbers, curves))
    return sketch


def _kept_free(curves: Sequence[Array], wishes: Sequence[Wish]) -> Array:
    """Points that numbers of rings leave free: the curves, and where the largest load's angle would stand. [mm]"""
    names = [wish for wish in wishes if wish.manner == "name"]
    boxes = [label_outline(Label(one.point + _NAMED * unit(one.towards), "000°"), 1.0) for one in names]
    return np.concatenate([*map(dots, curves), *map(dots, boxes)], axis=1)
