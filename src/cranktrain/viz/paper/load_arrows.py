"""Loads of the machine file on a drawing: a force as an arrow where it acts, a torque as an arc about its link's pin.

Sizes are in parts of the largest of the turn. A force stands on that side of its point which is clear of the links: it
pulls away from the point or presses on it.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.ties import largest_of
from cranktrain.one_line import short
from cranktrain.panels.figures import with_unit
from cranktrain.plans.acting_loads import ActingLoad
from cranktrain.plans.stroke_lines import unit
from cranktrain.plans.vectors import angle_of, turned_left
from cranktrain.saying.scales import scale_for
from cranktrain.viz.paper import shapes
from cranktrain.viz.paper.sketch import Habit, Line, Wish

_LETTERS = 16
"""Of a load's name."""

_NONE = 1e-9
"""A load of less than this part of the largest is none."""

_SHORTEST, _DASHED = 0.3, 0.6
"""Length of the smallest arrow, and of a line where there is no load, in parts of the longest."""

_SWEEP = (np.pi / 2, 1.5 * np.pi)
"""Angles of the smallest arc and of the largest about a pin. [rad]"""

_UNKNOWN = 0.5
"""How large a torque is drawn, in parts of the largest, that is found so that it balances the machine."""

_WIDER = 0.35
"""By how much the next arc about the same pin is wider, in parts of the first."""

_ASIDE, _ONE_LINE = 0.14, 0.05
"""How far arrows of one line stand apart, and how near to each other two are on one, in parts of the longest."""


class ArrowSizes(NamedTuple):
    """How large loads are drawn: the longest arrow, its head, the radius of arcs; all in mm of metal."""

    longest: float
    head: float
    radius: float


class DrawnBody(NamedTuple):
    """How far a body reaches from a force's point along the way of the force, and against it. [mm of metal]"""

    ahead: float
    behind: float


_POINT = DrawnBody(0.0, 0.0)


class LoadMark(NamedTuple):
    """A load as it is drawn.

    Its arrow or arc with its head, or a dashed line alone; where its name goes, in which direction from there [mm of
    metal, rad]; what holds its point.
    """

    load: ActingLoad
    lines: tuple[Line, ...]
    point: Array
    towards: float
    held: tuple[Line, ...] = ()


def load_marks(
    loads: Sequence[ActingLoad],
    largest: dict[bool, float],
    room: ArrowSizes,
    links: Sequence[Array],
    bodies: Mapping[tuple[str, str], DrawnBody] | None = None,
) -> Iterator[LoadMark]:
    """Draw loads at one crank angle, places in mm of metal; dashed where there is none.

    Parameters
    ----------
    loads : sequence of ActingLoad
        Of one crank angle.
    largest : dict
        Largest of a turn, of torques and of forces.
    room : ArrowSizes
    links : sequence of Array, shape (2, n)
        Lines to keep clear of.
    bodies : mapping, optional
        Bodies that are drawn about the points of forces, by mechanism and name: arrows stand outside them.
    """
    taken: list[tuple[Array, Array]] = []
    arcs: list[Array] = []
    for load in loads:
        size = abs(float(load.size[0]))
        share = min(size / (largest[load.is_torque] or 1.0), 1.0) if np.isfinite(size) else _UNKNOWN
        if load.is_torque:
            mark = _arc(load, share, room, arcs)
        else:
            body = (bodies or {}).get((load.mechanism, load.name), _POINT)
            mark = _arrow(load, share, room, links, taken, body)
        if mark is not None:
            yield mark


def load_words(load: ActingLoad, at: int = 0) -> str:
    """Name a load with its size at one of its crank angles."""
    size = abs(float(load.size[at]))
    if np.isnan(size):
        return load_name(load)
    scale = scale_for("N*m" if load.is_torque else "N", size)
    return f"{load_name(load)} {with_unit(size, scale)}"


def load_name(load: ActingLoad) -> str:
    """Name of a load, as long as there is room beside an arrow."""
    return short(load.name.replace("_", " "), _LETTERS)


def load_wishes(marks: Sequence[LoadMark], symbols: Mapping[tuple[str, str], str] | None = None) -> Iterator[Wish]:
    """Wishes for the names of loads with their sizes; or for symbols by mechanism and name."""
    for mark in marks:
        if symbols is None:
            yield Wish(mark.point, load_words(mark.load), mark.towards, "words")
        else:
            yield Wish(mark.point, symbols[mark.load.mechanism, mark.load.name], mark.towards)


def _arrow(
    load: ActingLoad,
    share: float,
    room: ArrowSizes,
    links: Sequence[Array],
    taken: list[tuple[Array, Array]],
    body: DrawnBody,
) -> LoadMark | None:
    """A force; None of one that goes nowhere."""
    way, point = load.way[:, 0], load.place[:, 0]
    if not np.any(way):
        return None
    size = float(load.size[0])
    side = pulled_side(size) if load.is_rope else clear_side(point, way, room.longest, links)
    beyond = body.ahead if side > 0 else body.behind
    start = point + side * beyond * way + _aside(point, way, room.longest, taken)
    held = tuple(held_by(load, 0, room.longest))
    if share <= _NONE:
        end = start + side * way * _DASHED * room.longest
        dashed = Line(np.stack([start, end], axis=1), "LOADS", "part", 9)
        return LoadMark(load, (dashed,), end, angle_of(end - start), held)
    far = start + side * way * room.longest * (_SHORTEST + (1 - _SHORTEST) * share)
    ends = (start, far) if side * size > 0 else (far, start)
    return LoadMark(load, arrow_of(*ends, room.head), far, angle_of(far - start), held)


def pulled_side(size: float) -> float:
    """To which side of its point a rope's force is drawn: it pulls, +1 along its way."""
    return float(np.sign(size)) or 1.0


def held_by(load: ActingLoad, i: int, longest: float) -> Iterator[Line]:
    """What holds a force's point at one of its crank angles: a line from the link's pin, of a rope the arc too."""
    pin, point = load.pin[:, i], load.place[:, i]
    radius = float(np.hypot(*(point - pin)))
    if radius <= _ONE_LINE * longest:
        return
    yield Line(np.stack([pin, point], axis=1), "LOADS", "construction", 3)
    if load.is_rope:
        middle, half = angle_of(point - pin), min(1.5 * longest / radius, 0.5 * np.pi)
        yield Line(shapes.arc(pin, radius, middle - half, middle + half), "LOADS", "thin", 3)


def arrow_of(start: Array, end: Array, head: float, habit: Habit = "load") -> tuple[Line, Line]:
    """A line with its head; it ends within the head, whose point would be blunt else."""
    direction = angle_of(end - start)
    within = end - 0.7 * head * unit(direction)
    tip = shapes.arrowhead(end, direction, head)._replace(layer="LOADS", order=9)
    return Line(np.stack([start, within], axis=1), "LOADS", habit, 9), tip


def clear_side(point: Array, way: Array, longest: float, links: Sequence[Array]) -> float:
    """On which side of a point along a way a line is farther from the links: +1 or −1."""
    steps = longest * np.array([0.35, 0.7, 1.0])
    tried = {side: point[:, np.newaxis] + side * way[:, np.newaxis] * steps for side in (1.0, -1.0)}
    return largest_of(tried, lambda side: round(float(np.sum(_distances(tried[side], links))) / longest, 6))


def _distances(points: Array, links: Sequence[Array]) -> Array:
    """How far points, shape (2, n), are from the nearest of some lines."""
    found = np.full(points.shape[1], np.inf)
    for line in links:
        start, end = line[:, :1], line[:, -1:]
        along = end - start
        share = np.clip(np.sum(along * (points - start), axis=0) / max(float(np.sum(along**2)), 1e-12), 0.0, 1.0)
        found = np.fmin(found, np.hypot(*(start + share * along - points)))
    return np.where(np.isfinite(found), found, 0.0)


def _aside(point: Array, way: Array, longest: float, taken: list[tuple[Array, Array]]) -> Array:
    """Step across a way by which an arrow stands clear of those on the same line."""
    near = [one for one, other in taken if on_one_line(point - one, way, other, longest)]
    taken.append((point, way))
    n = len(near)
    return _ASIDE * longest * (n + 1) // 2 * (1.0 if n % 2 else -1.0) * turned_left(way) if n else np.zeros(2)


def on_one_line(away: Array, way: Array, other: Array, longest: float) -> bool:
    """Whether two lines through points that lie so far apart are one."""
    across = turned_left(way)
    return bool(abs(across @ other) < _ONE_LINE and abs(across @ away) < _ONE_LINE * longest)


def _arc(load: ActingLoad, share: float, room: ArrowSizes, taken: list[Array]) -> LoadMark:
    """A torque about its link's pin, on the side away from the link; a further one about the same pin is wider."""
    centre, middle = load.place[:, 0], angle_of(load.along[:, 0]) + np.pi
    within = sum(bool(np.hypot(*(centre - other)) < _ONE_LINE * room.longest) for other in taken)
    taken.append(centre)
    radius = room.radius * (1.0 + _WIDER * within)
    point, towards = centre + radius * unit(middle), middle
    if share <= _NONE:
        dashed = shapes.arc(centre, radius, middle - np.pi / 2, middle + np.pi / 2)
        return LoadMark(load, (Line(dashed, "LOADS", "part", 9),), point, towards)
    half = 0.5 * (_SWEEP[0] + (_SWEEP[1] - _SWEEP[0]) * share)
    size = float(load.size[0])
    sense = float(np.sign(size if np.isfinite(size) else -load.turning[0]))
    return LoadMark(
        load, arc_of(centre, radius, (middle - sense * half, middle + sense * half), room.head), point, towards
    )


def arc_of(
    centre: Array, radius: float, ends: tuple[float, float], head: float, habit: Habit = "load"
) -> tuple[Line, Line]:
    """An arc with its head from one direction to another. [rad]"""
    start, end = ends
    sense = float(np.sign(end - start))
    lean = 0.5 * head / radius
    tip = shapes.arrowhead(centre + radius * unit(end), end + sense * (np.pi / 2 - lean), head)
    line = shapes.arc(centre, radius, start, end - sense * 0.7 * head / radius)
    return Line(line, "LOADS", habit, 9), tip._replace(layer="LOADS", order=9)
