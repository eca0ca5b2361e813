"""A turn of the crank cut where torques have kinks, with torques as polynomials between: peaks and means."""

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import Subintervals, subintervals
from cranktrain.numerics.subintervals import interpolation, series_of_motion
from cranktrain.numerics.ties import first_largest_along

_WIDEST = np.pi / 18
"""Of a piece. [rad]"""
_MORE = 4
"""Points of a piece beyond those that its integral needs."""
_TRIED = np.linspace(-1.0, 1.0, 17)
_NEWTON_STEPS = 4
_LEVEL = 1e-12
"""A curve that changes by less within a piece, in parts of its largest size, is level there: its top is the start."""


class TurnTops(NamedTuple):
    """Largest values of curves, and the angles at which they stand, of shape (curve,) or (curve, piece). [rad]"""

    angle: Array
    value: Array


class TurnPieces(NamedTuple):
    """A turn in pieces, within each of which torques are smooth.

    Attributes
    ----------
    cut : Subintervals
    cycle : float
        [rad]
    """

    cut: Subintervals
    cycle: float

    def mean(self, values: Array) -> float:
        """Mean over the crank angle of values at the points of the pieces, exact as far as these are polynomials."""
        return float(np.sum(values * self.cut.weight) / self.cycle)

    def within(self, low: float, high: float) -> NDArray[np.bool_]:
        """Which pieces lie from `low` to `high`, which are edges of such. [rad]"""
        middles = self.cut.start + self.cut.width / 2
        return np.mod(middles - low, self.cycle) < high - low

    def tops(self, curves: Array) -> TurnTops:
        """Largest value of each curve in each piece, between the points; curves of shape (curve, point)."""
        shape = len(curves), self.cut.width.size
        way, value = np.empty(shape), np.empty(shape)
        scale = np.max(np.abs(curves), axis=-1)[:, np.newaxis]
        for size in np.unique(self.cut.size).tolist():
            own = np.flatnonzero(self.cut.size == size)
            at_points = curves[:, self.cut.first[own, np.newaxis] + np.arange(size)]
            way[:, own], value[:, own] = _tops(at_points, scale)
        return TurnTops(np.mod(self.cut.start + self.cut.width * (1 + way) / 2, self.cycle), value)


def turn_pieces(breaks: Array, cycle: float) -> TurnPieces:
    """Cut a turn at breaks, shape (n,), NaN for none. [rad]"""
    return TurnPieces(subintervals(breaks, _WIDEST, cycle, _MORE), cycle)


def highest(tops: TurnTops, chosen: NDArray[np.bool_]) -> TurnTops:
    """Largest value of each curve in the chosen pieces; of alike ones the first round the turn."""
    angle, value = tops.angle[:, chosen], tops.value[:, chosen]
    row, order = np.arange(len(angle)), np.argsort(angle, axis=-1, kind="stable")
    first = order[row, first_largest_along(np.take_along_axis(value, order, axis=-1))]
    return TurnTops(angle[row, first], np.max(value, axis=-1))


@cache
def _to_tried(size: int) -> Array:
    """From values at Gauss's points of a piece to those at the ways that are tried."""
    return interpolation(_TRIED, size)


def _tops(values: Array, scale: Array) -> tuple[Array, Array]:
    """Where, in [−1, 1], and how large polynomials through Gauss's points are at most, shape (curve, piece)."""
    size = values.shape[-1]
    tried = np.sum(values[..., np.newaxis, :] * _to_tried(size), axis=-1)
    start, apart = _TRIED[np.argmax(tried, axis=-1)], float(_TRIED[1] - _TRIED[0])
    low, high = np.maximum(start - apart, -1.0), np.minimum(start + apart, 1.0)
    series = series_of_motion(values)[1:, ..., :-1]

    def motion(way: Array) -> Coefficient:
        """Curves with their derivatives by the way, shape (curve, piece)."""
        legendre = np.polynomial.legendre.legvander(way, size - 1)
        return Coefficient(*np.sum(series * legendre, axis=-1))

    way, found = start, motion(start)
    with np.errstate(all="ignore"):
        for _step in range(_NEWTON_STEPS):
            # Where the curve bends the other way its top is at an end.
            move = np.where(found.second < 0, -found.first / found.second, np.sign(found.first) * apart)
            way = np.clip(way + move, low, high)
            found = motion(way)
    is_level = np.ptp(tried, axis=-1) <= _LEVEL * scale
    return np.where(is_level, -1.0, way), np.where(is_level, np.max(tried, axis=-1), found.value)
