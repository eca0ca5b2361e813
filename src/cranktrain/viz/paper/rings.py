"""Rings of polar diagrams: how far apart they are, what of each is drawn, and where their numbers hide no curve."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.ties import largest_of
from cranktrain.plans.stroke_lines import unit
from cranktrain.saying.scales import Scale
from cranktrain.saying.wording import plain
from cranktrain.viz.paper.page import rounded_down
from cranktrain.viz.paper.sketch import Label, hides, label_outline

RING_SCALES = (1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)
"""Scale factors within a power of ten: close, as diagrams are read by their rings."""
_RINGS = 3.0
"""How many rings there are at least."""
_DIRECTIONS = np.deg2rad(np.arange(-82.5, 277.5, 15.0))
"""In which numbers of rings may stand: beside the axes, on none. [rad]"""
_ASIDE = 5.0
"""Beside the end of a ring, for the middle of its number. [mm]"""
_SEEN = 20
"""Degrees of a ring that are worth drawing."""
_ROUND = np.linspace(0.0, 2 * np.pi, 361)


class PolarRings(NamedTuple):
    """Rings of diagrams of one scale: load from one to the next in its unit, and newtons in one millimetre."""

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

    def drawn(self, edges: tuple[Array, Array]) -> Iterator[Array]:
        """Give each ring of which more than a bit lies within edges about the pole, NaN outside, shape (2, n). [mm]"""
        low, high = (edge[:, np.newaxis] for edge in edges)
        farthest = float(np.max(np.hypot(*np.maximum(np.abs(low), np.abs(high)))))
        for number in range(1, int(farthest / self.apart) + 1):
            points = number * self.apart * np.stack([np.cos(_ROUND), np.sin(_ROUND)])
            is_inside = np.all((points >= low) & (points <= high), axis=0)
            if np.count_nonzero(is_inside) >= _SEEN:
                yield np.where(is_inside, points, np.nan)


def ring_step(largest: float, unit: Scale) -> float:
    """Load from ring to ring in a unit, a round one of which the largest load [N] has three or more."""
    return rounded_down(float(unit.of(largest)) / _RINGS) if largest > 0.0 else 1.0


def ring_numbers(curves: Array, edges: tuple[Array, Array], rings: PolarRings) -> list[Label]:
    """Numbers on the rings, outward in the direction in which most of them hide nothing; the last has the unit.

    Where each would hide something, as in a narrow diagram, they stand beside the ends of the rings.

    Parameters
    ----------
    curves : Array, shape (2, n)
        Points over which no number stands. [mm]
    edges : tuple of Array
        Lower left and upper right corner of what is drawn. [mm]
    rings : PolarRings

    Returns
    -------
    list of Label
        From the outermost inward.
    """
    low, high = edges
    along = [list(_free(_along(unit(direction), edges, rings.apart), curves, rings)) for direction in _DIRECTIONS]
    sides = [(low[0], low[1]), (low[0], high[1]), (high[0], low[1]), (high[0], high[1])]
    beside = [list(_free(_beside(side, end, rings.apart), curves, rings)) for side, end in sides]
    return largest_of(along, len) or largest_of(beside, len)


def _along(way: Array, edges: tuple[Array, Array], apart: float) -> Iterator[tuple[int, Array]]:
    """Rings by their number from the outermost, each with where it crosses a direction within the edges. [mm]"""
    low, high = edges
    whole = min(float((high if part > 0 else low)[axis] / part) for axis, part in enumerate(way) if abs(part) > 1e-9)
    for number in range(int(whole / apart), 0, -1):
        yield number, number * apart * way


def _beside(side: float, end: float, apart: float) -> Iterator[tuple[int, Array]]:
    """Rings by their number from the outermost, each with a place beside its end on a side, toward an end. [mm]"""
    for number in range(int(np.hypot(side, end) / apart), int(abs(side) / apart), -1):
        height = np.sqrt((number * apart) ** 2 - side**2)
        yield number, np.array([side + np.copysign(_ASIDE, side), np.copysign(height, end)])


def _free(places: Iterable[tuple[int, Array]], curves: Array, rings: PolarRings) -> Iterator[Label]:
    """Numbers of rings at their places, those that hide nothing."""
    kept: list[Array] = []
    for number, place in places:
        label = Label(place, rings.words(number, has_unit=not kept), "number")
        box = label_outline(label, 1.0)
        if not hides(box, curves) and not any(_overlap(box, other) for other in kept):
            kept.append(box)
            yield label


def _overlap(one: Array, other: Array) -> bool:
    """Whether two boxes, shape (2, n), lie over each other."""
    return bool(np.all((np.min(one, axis=1) < np.max(other, axis=1)) & (np.min(other, axis=1) < np.max(one, axis=1))))
