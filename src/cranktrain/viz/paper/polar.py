"""Polar diagrams on paper: loads of bearings and pins side by side to one scale, with rings and the largest load."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.numerics.ties import largest_of, smallest_of
from cranktrain.panels.parts import Polars
from cranktrain.panels.shapes import PolarDiagram
from cranktrain.plans.positions import fitting
from cranktrain.plans.stroke_lines import unit
from cranktrain.plans.vectors import angle_of, pair
from cranktrain.saying.scales import Scale, scale_for
from cranktrain.saying.wording import plain
from cranktrain.viz.paper.page import Box, Page, rounded_down
from cranktrain.viz.paper.sketch import Circle, Label, Sketch, Wish, dots, label_outline, placed_labels
from cranktrain.viz.paper.style import COLOURS, INK, MUTED

_STEPS = (1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)
"""Scale factors within a power of ten: close, as diagrams are read by their rings."""
_BESIDE, _HEAD = 3.5, 7.0
"""Room about a diagram, and over it for its title. [mm]"""
_WORDS = 4.2
"""Of a line of words below the diagrams. [mm]"""
_RINGS = 3.0
"""How many rings there are at least."""
_MARK, _RINGED = 0.55, 0.9
"""Radii of a mark of the crank angle, and of the ring about the largest load. [mm]"""
_NUMBERED = ((70.0, 60.0), (40.0, 90.0), (0.0, 180.0))
"""From which size of a diagram on [mm], and each how many degrees of one turn, marks have their crank angles."""
_SMALL, _THIN = 30.0, 0.7
"""A smaller diagram [mm] has small marks, thin curves [pt], and of numbers its largest load's and the rings'."""
_NAME, _NAMED = 2.0, 4.2
"""Below a diagram for the crank angle of its largest load; how far from this that stands. [mm]"""
_DIRECTIONS = np.deg2rad(np.arange(-90.0, 270.0, 15.0))
"""In which numbers of rings may stand. [rad]"""
_MISSING = 12.0
"""What a ring without a number costs, in points hidden."""
_BESIDE_LARGEST = 15.0
"""A mark so near to the largest load has no number of its own. [deg]"""
_SEEN = 20
"""Degrees of a ring that are worth drawing."""
_ROUND = np.linspace(0.0, 2 * np.pi, 361)


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


def cells(box: Box, n: int, aspect: float = 1.0, n_columns: int | None = None) -> list[Box]:
    """Rooms for n pictures, row by row, of as many columns as make pictures of an aspect largest, unless given."""

    def size(n_columns: int) -> float:
        n_rows = -(-n // n_columns)
        return min(box.width / n_columns / aspect, box.height / n_rows)

    n_columns = n_columns or largest_of(range(1, n + 1), size)
    n_rows = -(-n // n_columns)
    width, height = box.width / n_columns, box.height / n_rows
    return [
        Box(
            box.left + (place % n_columns) * width,
            box.bottom + (n_rows - 1 - place // n_columns) * height,
            width,
            height,
        )
        for place in range(n)
    ]


def draw_polars(page: Page, polars: Polars, box: Box) -> None:
    """Draw diagrams side by side, all to one scale, over the words for that."""
    diagrams = polars.diagrams
    outlines = [np.concatenate([*(curve.points for curve in one.curves), np.zeros((2, 1))], axis=1) for one in diagrams]
    unit = scale_for("N", max(float(np.max(np.hypot(*outline))) for outline in outlines))
    words = _(
        "1 mm is {force} {unit}; rings each {step} {unit}; marks each 30° of the crank; ringed, bold: the largest load"
    )
    n_lines = len(page.wrapped(words, box.width)) + bool(polars.notes)
    above = box._replace(bottom=box.bottom + _WORDS * n_lines + 2.0, height=box.height - _WORDS * n_lines - 2.0)
    width, height = np.max([np.ptp(outline, axis=1) for outline in outlines], axis=0)
    rooms = cells(above, len(diagrams), float(width / height) if height else 1.0, polars.n_columns)
    below = _NAME if polars.n_columns is None else _WORDS
    room = (rooms[0].width - 2 * _BESIDE - 2.0, rooms[0].height - _HEAD - _BESIDE - 2.0 - below)
    scale = fitting(outlines, room, _STEPS, unit.one)
    step = ring_step(outlines, unit)
    rings = PolarRings(step, unit, scale)
    for one, outline, cell in zip(diagrams, outlines, rooms, strict=True):
        _draw(page, one, outline / scale, cell, rings)
    said = words.format(force=plain(float(unit.of(scale))), step=plain(step), unit=unit.label)
    whole = f"{polars.notes}; {said}." if polars.notes else f"{said}."
    page.notes(box.left, above.bottom - 4.0, page.wrapped(whole, box.width))


def ring_step(outlines: Sequence[Array], unit: Scale) -> float:
    """Load from ring to ring in a unit, a round one of which the largest load has three or more."""
    most = max(float(np.max(np.hypot(*outline))) for outline in outlines)
    return rounded_down(float(unit.of(most)) / _RINGS) if most > 0 else 1.0


class PolarRings(NamedTuple):
    """Rings of all diagrams: load from one to the next in its unit, and newtons in one millimetre."""

    step: float
    unit: Scale
    scale: float

    @property
    def apart(self) -> float:
        """From one to the next on paper. [mm]"""
        return self.step * self.unit.one / self.scale

    def words(self, number: int, *, has_unit: bool) -> str:
        """What stands at a ring: its load, on the outermost with the unit."""
        load = plain(number * self.step)
        return f"{load} {self.unit.label}" if has_unit else load


def _draw(page: Page, one: PolarDiagram, outline: Array, cell: Box, rings: PolarRings) -> None:
    """Draw one diagram in the middle of its room: cross, rings, curves, marks, the largest load. [mm]"""
    ring = rings.apart
    low, high = np.min(outline, axis=1), np.max(outline, axis=1)
    page.heading(cell.left + 1.0, cell.bottom + cell.height - 4.0, str(one.title))
    middle = np.array([cell.left + cell.width / 2, cell.bottom + (cell.height - _HEAD) / 2])
    pole = middle - (low + high) / 2
    edge_low, edge_high = low - 3.0, high + 3.0
    for axis in (0, 1):
        ends = np.tile(pole[:, np.newaxis], 2)
        ends[axis] = pole[axis] + np.array([edge_low[axis], edge_high[axis]])
        page.paper.plot(*ends, color=MUTED, linewidth=0.45, zorder=1)
    for number in range(1, int(np.max(np.hypot(*outline)) / ring) + 2):
        points = number * ring * np.stack([np.cos(_ROUND), np.sin(_ROUND)])
        inside = np.all((points >= edge_low[:, np.newaxis]) & (points <= edge_high[:, np.newaxis]), axis=0)
        if np.count_nonzero(inside) < _SEEN:
            continue
        shown = np.where(inside, pole[:, np.newaxis] + points, np.nan)
        page.paper.plot(*shown, color=MUTED, linewidth=0.5, linestyle=(0, (1.0, 2.2)), zorder=1)
    thin = {"linewidth": _THIN} if float(np.max(edge_high - edge_low)) < _SMALL else {}
    for curve in one.curves:
        page.paper.plot(*(pole[:, np.newaxis] + curve.points / rings.scale), **(line_of_method(curve.place) | thin))
    page.draw(_marked(one, (edge_low, edge_high), rings), pair(pole))


def _marked(one: PolarDiagram, edges: tuple[Array, Array], rings: PolarRings) -> Sketch:
    """Marks of the crank angle with numbers of some, numbers of the rings, the largest load ringed. [mm]"""
    sketch, low, high = Sketch(1.0), *edges
    largest, marks = one.largest / rings.scale, one.marks / rings.scale
    size = float(np.max(high - low))
    is_small = size < _SMALL
    mark = 0.5 * _MARK if is_small else _MARK
    sketch.add(Circle(place, mark, "LINKS", "thin" if is_small else "rod", 8, "paper") for place in marks.T)
    wishes: list[Wish] = []
    if np.isfinite(one.largest_at):
        sketch.add([Circle(largest, _RINGED, "LINKS", "outline", 7)])
        wishes.append(Wish(largest, f"{round(one.largest_at) % one.cycle:.0f}°", angle_of(largest), "name"))
    curves = [curve.points / rings.scale for curve in one.curves]
    kept_free = [dots(curve) for curve in curves]
    if np.isfinite(one.largest_at):
        name = Label(largest + _NAMED * unit(angle_of(largest)), "000°")
        kept_free += 2 * [dots(label_outline(name, 1.0))]
    numbers = ring_numbers(np.concatenate(kept_free, axis=1), edges, rings)
    sketch.add(numbers)
    every = next(step for least, step in _NUMBERED if size >= least) * round(one.cycle / 360.0)
    wishes += [
        Wish(place, f"{angle:g}°", angle_of(place), "number")
        for place, angle in zip(marks.T, one.marked.tolist(), strict=True)
        if not is_small
        and angle % every == 0.0
        and abs((angle - one.largest_at + 180.0) % one.cycle - 180.0) > _BESIDE_LARGEST
    ]
    axes = [np.array([[low[0], high[0]], [0.0, 0.0]]), np.array([[0.0, 0.0], [low[1], high[1]]])]
    if wishes:
        lines = curves if is_small else [*curves, *axes]
        sketch.add(placed_labels(wishes, lines, 1.0, sketch.circles, numbers))
    return sketch


def ring_numbers(curves: Array, edges: tuple[Array, Array], rings: PolarRings) -> list[Label]:
    """Numbers on the rings, outward in the direction in which they hide least of the curves; the last has the unit.

    Parameters
    ----------
    curves : Array, shape (2, n)
        Points of the curves. [mm]
    edges : tuple of Array
        Lower left and upper right corner of what is drawn. [mm]
    rings : PolarRings
    """
    found = [list(_numbers_along(unit(direction), edges, rings)) for direction in _DIRECTIONS]
    most = max(map(len, found))

    def hidden(numbers: Sequence[Label]) -> float:
        boxes = [label_outline(number, 1.0) for number in numbers]
        covered = [
            np.count_nonzero(
                np.all(
                    (curves > np.min(box, axis=1, keepdims=True)) & (curves < np.max(box, axis=1, keepdims=True)),
                    axis=0,
                )
            )
            for box in boxes
        ]
        return float(sum(covered)) + _MISSING * (most - len(numbers))

    return smallest_of(found, hidden)


def _numbers_along(way: Array, edges: tuple[Array, Array], rings: PolarRings) -> Iterator[Label]:
    """Numbers on the rings in one direction, the outermost within the edges first, those that it leaves room for."""
    low, high = edges
    whole = min(float((high if part > 0 else low)[axis] / part) for axis, part in enumerate(way) if abs(part) > 1e-9)
    n = int(whole / rings.apart)
    kept: list[Array] = []
    for number in range(n, 0, -1):
        label = Label(number * rings.apart * way, rings.words(number, has_unit=number == n), "number")
        box = label_outline(label, 1.0)
        if not any(_overlap(box, other) for other in kept):
            kept.append(box)
            yield label


def _overlap(one: Array, other: Array) -> bool:
    """Whether two boxes, shape (2, n), lie over each other."""
    return bool(np.all((np.min(one, axis=1) < np.max(other, axis=1)) & (np.min(other, axis=1) < np.max(one, axis=1))))
