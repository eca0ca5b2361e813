"""Loads of the machine file on plans: in one position with their names and sizes, in several each position's own."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np

from cranktrain.mechanisms.drawing import Drawing
from cranktrain.motion import Array
from cranktrain.plans.acting_loads import ActingLoad
from cranktrain.plans.shown_loads import ShownLoads
from cranktrain.plans.vectors import angle_of, turned_left
from cranktrain.viz.paper.load_arrows import (
    ArrowSizes,
    LoadMark,
    arc_of,
    arrow_of,
    clear_side,
    held_by,
    load_marks,
    load_name,
    load_wishes,
    on_one_line,
    pulled_side,
)
from cranktrain.viz.paper.sketch import Line, Wish

_FIRST, _STEP, _LAST = 8.0, 2.2, 32.0
"""How far beside its point the first arrow stands, by how much the next ones farther, all within. [mm of paper]"""

_NEAR, _APART = 13.0, 1.0
"""Lines so near to each other, in a small part of it, are one; arrows nearer than the other cover each other. [mm]"""

_LONGEST, _HEAD, _RADIUS = 13.0, 2.6, 5.5
"""Longest arrow, its head, radius of an arc about a pin. [mm of paper]"""

_SMALL_HEAD, _LEAST = 2.0, 3.0
"""In several positions: heads, and the shortest arrow. [mm of paper]"""

_ARCS, _ARC = (7.0, 18.0), 9.0
"""In several positions: radii of the first arc and of the last, and length of the longest. [mm of paper]"""

_NONE = 1e-9
"""A load of less than this part of the largest is not drawn."""

Wording: TypeAlias = Mapping[tuple[str, str], str]
"""Symbols of loads by mechanism and name, where these and not their names and sizes stand beside them."""


class LoadLine(NamedTuple):
    """A line that has arrows beside it: a point on it, its direction, and to which side they stand, unit vectors."""

    point: Array
    way: Array
    beside: Array


class Lanes(NamedTuple):
    """Where arrows go, in mm of metal; `taken` are lines that have arrows beside them already."""

    scale: float
    taken: list[LoadLine]

    def steps(self, load: ActingLoad, there: Sequence[int], arrows: Array, links: Sequence[Sequence[Array]]) -> Array:
        """Steps by which arrows stand beside their points, shape (n, 2); 0 where none covers another.

        Parameters
        ----------
        load : ActingLoad
        there : sequence of int
            Its positions that have arrows.
        arrows : Array, shape (n, 2, 2)
            X and Y of their starts and ends.
        links : sequence of sequences of Array, shape (2, 2)
            Of each position.
        """
        if not _overlap(arrows, self.scale):
            return np.zeros((len(there), 2))
        beside = self._sides(load, there, links)
        before = 0
        if _is_still(load):
            line = LoadLine(load.place[:, there[0]], load.way[:, there[0]], np.sum(beside, axis=0))
            same = [
                one for one in self.taken if on_one_line(line.point - one.point, line.way, one.way, _NEAR * self.scale)
            ]
            before = len(same)
            towards = same[0].beside if same else line.beside
            side = 1.0 if float(towards @ beside[0]) >= 0 else -1.0
            beside[:] = side * beside[0] * (-1.0 if before % 2 else 1.0)
            self.taken.append(line._replace(beside=side * beside[0]) if not same else line)
        own = min(_STEP, (_LAST - _FIRST) / len(there)) * np.arange(len(there))
        away = _FIRST + (_LAST - _FIRST) * (before // 2) + own
        return self.scale * away[:, np.newaxis] * beside

    def _sides(self, load: ActingLoad, there: Sequence[int], links: Sequence[Sequence[Array]]) -> Array:
        """Unit vectors across a force at some positions, away from the links there, shape (n, 2)."""
        across = [turned_left(load.way[:, i]) for i in there]
        reach = _LAST * self.scale
        sides = [clear_side(load.place[:, i], one, reach, links[i]) for i, one in zip(there, across, strict=True)]
        return np.stack([side * one for side, one in zip(sides, across, strict=True)])


def _is_still(load: ActingLoad) -> bool:
    """Whether a force keeps its direction in all positions."""
    return bool(np.allclose(load.way, load.way[:, :1], atol=1e-9))


def _overlap(arrows: Array, scale: float) -> bool:
    """Whether any two of some arrows, shape (n, 2, 2), come near to each other."""
    shares = np.linspace(0.0, 1.0, 7)
    points = arrows[:, :, :1] + shares * (arrows[:, :, 1:] - arrows[:, :, :1])
    return any(
        np.min(np.hypot(*(points[i][:, :, np.newaxis] - other[:, np.newaxis]))) < _APART * scale
        for i in range(len(points))
        for other in points[i + 1 :]
    )


class DrawnLoads(NamedTuple):
    """Lines of loads, and wishes for their words. [mm of metal]"""

    lines: tuple[Line, ...] = ()
    wishes: tuple[Wish, ...] = ()


def drawn_loads(
    loads: ShownLoads | None,
    angles: Array,
    drawing: Drawing,
    pins: dict[str, Array],
    scale: float,
    said: Wording | None,
) -> DrawnLoads:
    """Draw loads in the positions of a plan.

    Parameters
    ----------
    loads : ShownLoads or None
    angles : Array, shape (n,)
        Crank angles as the machine shows them. [deg]
    drawing : Drawing
    pins : dict of str to Array, shape (2, n)
        [mm of metal]
    scale : float
        Millimetres of metal in one of paper.
    said : Wording or None
        In one position symbols instead of names and sizes.
    """
    if loads is None:
        return DrawnLoads()
    acting = [load.moved(np.zeros((2, 1)), 1e3) for load in loads.at(angles)]
    bars = [(link.pins[0], name) for link in drawing.links for name in link.pins[1:]]
    links = [[np.stack([pins[name][:, i] for name in ends], axis=1) for ends in bars] for i in range(len(angles))]
    if len(angles) == 1:
        room = ArrowSizes(_LONGEST * scale, _HEAD * scale, _RADIUS * scale)
        marks = list(load_marks(acting, loads.largest, room, links[0]))
        return DrawnLoads(_lines(marks), tuple(load_wishes(marks, said)))
    lanes = Lanes(scale, [])
    found = [_in_positions(load, loads.largest[load.is_torque], links, lanes) for load in acting]
    return DrawnLoads(
        tuple(line for one in found for line in one.lines), tuple(wish for one in found for wish in one.wishes)
    )


def _lines(marks: Sequence[LoadMark]) -> tuple[Line, ...]:
    return tuple(line for mark in marks for line in (*mark.held, *mark.lines))


def _in_positions(load: ActingLoad, largest: float, links: Sequence[Sequence[Array]], lanes: Lanes) -> DrawnLoads:
    """One load in every position in which there is any, with its name at the first."""
    shares = np.minimum(np.abs(load.size) / (largest or 1.0), 1.0)
    there = [i for i in range(load.size.size) if shares[i] > _NONE and (load.is_torque or np.any(load.way[:, i]))]
    if not there:
        return DrawnLoads()
    if load.is_torque:
        lines = tuple(_arcs(load, shares, there, lanes.scale))
        return DrawnLoads(lines, (_name(load, lines[0].points[:, -1], load.pin[:, there[0]]),))
    arrows = _arrows(load, shares, there, links, lanes.scale)
    steps = lanes.steps(load, there, arrows, links)
    lines = [*held_by(load, there[0], _LONGEST * lanes.scale)]
    for i, ends, step in zip(there, arrows, steps, strict=True):
        start, end = (ends + step[:, np.newaxis]).T
        point = load.place[:, i]
        if np.any(step):
            lines.append(Line(np.stack([point, point + step], axis=1), "LOADS", "construction", 3))
        lines += arrow_of(start, end, _SMALL_HEAD * lanes.scale, "vector")
    first = arrows[0] + steps[0][:, np.newaxis]
    return DrawnLoads(tuple(lines), (_name(load, np.mean(first, axis=1), load.place[:, there[0]]),))


def _name(load: ActingLoad, point: Array, pin: Array) -> Wish:
    """Name of a load at a point, away from its pin."""
    return Wish(point, load_name(load), angle_of(point - pin), "words")


def _arrows(
    load: ActingLoad, shares: Array, there: Sequence[int], links: Sequence[Sequence[Array]], scale: float
) -> Array:
    """Starts and ends of a force's arrows, shape (n, 2, 2), on that side of its way which is clear of most links."""
    sides = np.array([clear_side(load.place[:, i], load.way[:, i], _LONGEST * scale, links[i]) for i in there])
    if _is_still(load):
        sides[:] = np.sign(np.sum(sides)) or 1.0
    if load.is_rope:
        sides = np.array([pulled_side(float(load.size[i])) for i in there])
    found: list[Array] = []
    for i, side in zip(there, sides.tolist(), strict=True):
        near = load.place[:, i]
        far = near + side * load.way[:, i] * scale * (_LEAST + (_LONGEST - _LEAST) * shares[i])
        found.append(np.stack([near, far] if side * load.size[i] > 0 else [far, near], axis=1))
    return np.stack(found)


def _arcs(load: ActingLoad, shares: Array, there: Sequence[int], scale: float) -> Iterator[Line]:
    """Arcs of a torque from its link onward, each position's farther out than the last one's."""
    step = (_ARCS[1] - _ARCS[0]) / max(load.size.size - 1, 1)
    for i in there:
        radius = _ARCS[0] + step * i
        start = angle_of(load.along[:, i])
        sweep = (_LEAST + (_ARC - _LEAST) * float(shares[i])) / radius
        end = start + float(np.sign(load.size[i])) * sweep
        yield from arc_of(load.pin[:, i], radius * scale, (start, end), _SMALL_HEAD * scale, "vector")
