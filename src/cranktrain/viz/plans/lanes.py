"""Lanes for a force's arrows in several positions: those that would cover each other stand beside their line."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.plans.acting_loads import ActingLoad
from cranktrain.plans.vectors import turned_left
from cranktrain.viz.paper.load_arrows import clear_side, on_one_line

_FIRST, _STEP, _LAST = 8.0, 2.2, 32.0
"""How far beside its point the first arrow stands, by how much the next ones farther, all within. [mm of paper]"""

_NEAR, _APART = 13.0, 1.0
"""Lines so near to each other, in a small part of it, are one; arrows nearer than the other cover each other. [mm]"""


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
        if is_still(load):
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


def is_still(load: ActingLoad) -> bool:
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
