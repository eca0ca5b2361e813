"""Polar diagrams on paper: loads of bearings and pins side by side to one scale, with rings and the largest load."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.numerics.ties import largest_of
from cranktrain.panels.parts import Polars
from cranktrain.panels.shapes import PolarDiagram
from cranktrain.plans.positions import fitting
from cranktrain.saying.scales import Scale, scale_for
from cranktrain.saying.wording import plain
from cranktrain.viz.paper.page import Box, Page, rounded_down
from cranktrain.viz.paper.style import COLOURS, INK, MUTED

_STEPS = (1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)
"""Scale factors within a power of ten: close, as diagrams are read by their rings."""
_BESIDE, _HEAD = 3.5, 7.0
"""Room about a diagram, and over it for its title. [mm]"""
_WORDS = 4.2
"""Of a line of words below the diagrams. [mm]"""
_RINGS = 3.0
"""How many rings there are at least."""
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


def cells(box: Box, n: int, aspect: float = 1.0) -> list[Box]:
    """Rooms for n pictures, row by row, of as many columns as make pictures of an aspect largest."""

    def size(n_columns: int) -> float:
        n_rows = -(-n // n_columns)
        return min(box.width / n_columns / aspect, box.height / n_rows)

    n_columns = largest_of(range(1, n + 1), size)
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
    words = _("1 mm is {force} {unit}; rings each {step} {unit}; ringed is the largest load, with its crank angle")
    n_lines = len(page.wrapped(words, box.width)) + bool(polars.notes)
    above = box._replace(bottom=box.bottom + _WORDS * n_lines + 2.0, height=box.height - _WORDS * n_lines - 2.0)
    width, height = np.max([np.ptp(outline, axis=1) for outline in outlines], axis=0)
    rooms = cells(above, len(diagrams), float(width / height) if height else 1.0)
    room = (rooms[0].width - 2 * _BESIDE - 2.0, rooms[0].height - _HEAD - _BESIDE - 2.0)
    scale = fitting(outlines, room, _STEPS, unit.one)
    step = ring_step(outlines, unit)
    for one, outline, cell in zip(diagrams, outlines, rooms, strict=True):
        _draw(page, one, outline / scale, cell, step * unit.one / scale)
    said = words.format(force=plain(float(unit.of(scale))), step=plain(step), unit=unit.label)
    whole = f"{polars.notes}; {said}." if polars.notes else f"{said}."
    page.notes(box.left, above.bottom - 4.0, page.wrapped(whole, box.width))


def ring_step(outlines: Sequence[Array], unit: Scale) -> float:
    """Load from ring to ring in a unit, a round one of which the largest load has three or more."""
    most = max(float(np.max(np.hypot(*outline))) for outline in outlines)
    return rounded_down(float(unit.of(most)) / _RINGS) if most > 0 else 1.0


def _draw(page: Page, one: PolarDiagram, outline: Array, cell: Box, ring: float) -> None:
    """Draw one diagram in the middle of its room: cross, rings, curves, the largest load. [mm]"""
    low, high = np.min(outline, axis=1), np.max(outline, axis=1)
    page.heading(cell.left + 1.0, cell.bottom + cell.height - 4.0, str(one.title))
    middle = np.array([cell.left + cell.width / 2, cell.bottom + (cell.height - _HEAD) / 2])
    pole = middle - (low + high) / 2
    scale = float(np.max(np.abs(outline))) / max(float(np.max(np.abs(_every(one)))), 1e-300)
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
    for curve in one.curves:
        page.paper.plot(*(pole[:, np.newaxis] + scale * curve.points), **line_of_method(curve.place))
    _mark_largest(page, one, pole, pole + scale * one.largest)


def _every(one: PolarDiagram) -> Array:
    return np.concatenate([curve.points for curve in one.curves], axis=1)


def _mark_largest(page: Page, one: PolarDiagram, pole: Array, at: Array) -> None:
    """Ring the first curve's largest load and write its crank angle beside it, away from the pole."""
    if not np.isfinite(one.largest_at):
        return
    page.paper.plot(*at, "o", ms=5.0, mfc="none", mec=INK, mew=0.8, zorder=7)
    is_right = at[0] >= pole[0]
    page.text(
        float(at[0]) + (1.8 if is_right else -1.8),
        float(at[1]) - 1.0,
        f"{round(one.largest_at) % one.cycle:.0f}°",
        ha="left" if is_right else "right",
        zorder=8,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.4},
    )
