"""A turn of the crank cut where torques have kinks, with torques as polynomials between: peaks, means, best weights."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics import Subintervals, bracketed_roots, subintervals
from cranktrain.numerics.subintervals import interpolation
from cranktrain.numerics.ties import first_largest

_WIDEST = np.pi / 18
"""Of a piece. [rad]"""
_MORE = 4
"""Points of a piece beyond those that its integral needs."""
_FIRST, _NEXT, _TIMES = 17, 9, 9
"""Points at which a piece is looked at; and how often again, nine points between the neighbours of the best."""


class TurnTop(NamedTuple):
    """A largest value, and the angle at which it stands. [rad]"""

    angle: float
    value: float


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

    def largest(self, values: Array, low: float = -np.inf, high: float = np.inf) -> TurnTop:
        """Largest value between the points; only of pieces from `low` to `high`, which are edges of such. [rad]"""
        angles, tops = list[Array](), list[Array]()
        middles = low + np.mod(self.cut.start + self.cut.width / 2 - low, self.cycle) if np.isfinite(low) else None
        for size in np.unique(self.cut.size).tolist():
            chosen = self.cut.size == size
            if middles is not None:
                chosen = chosen & (middles < high)
            own = np.flatnonzero(chosen)
            if own.size == 0:
                continue
            at_points = values[self.cut.first[own, np.newaxis] + np.arange(size)]
            way, value = _tops(at_points, size)
            angles.append(np.mod(self.cut.start[own] + self.cut.width[own] * (1 + way) / 2, self.cycle))
            tops.append(value)
        if not tops:
            return TurnTop(np.nan, -np.inf)
        order = np.argsort(np.concatenate(angles), kind="stable")
        angle, top = (np.concatenate(parts)[order] for parts in (angles, tops))
        return TurnTop(float(angle[first_largest(top)]), float(np.max(top)))


def turn_pieces(breaks: Array, cycle: float) -> TurnPieces:
    """Cut a turn at breaks, shape (n,), NaN for none. [rad]"""
    return TurnPieces(subintervals(breaks, _WIDEST, cycle, _MORE), cycle)


def _tops(values: Array, size: int) -> tuple[Array, Array]:
    """Where, in (−1, 1), and how large polynomials through Gauss's points are at most, shape (piece,)."""
    rows = np.arange(len(values))
    low, high = -np.ones(len(values)), np.ones(len(values))
    way, top = low, np.full(len(values), -np.inf)
    for n_points in (_FIRST, *(_NEXT,) * _TIMES):
        ways = low[:, np.newaxis] + (high - low)[:, np.newaxis] * np.linspace(0.0, 1.0, n_points)
        found = np.sum(interpolation(ways, size) * values[:, np.newaxis], axis=-1)
        best = np.argmax(found, axis=-1)
        is_more = found[rows, best] > top
        way, top = np.where(is_more, ways[rows, best], way), np.maximum(found[rows, best], top)
        step = (high - low) / (n_points - 1)
        low, high = np.maximum(way - step, -1.0), np.minimum(way + step, 1.0)
    return way, top


class BalancedUnit(NamedTuple):
    """How much of the declared counterbalance is best: for equal peaks of up- and downstroke, and for the least rms."""

    equal_peaks: float
    least_rms: float


def balanced(pieces: TurnPieces, of_rod: Array, of_weights: Array, ends: tuple[float, float]) -> BalancedUnit:
    """Find the best counterbalances, in parts of the declared one; NaN where none makes both peaks equal.

    Parameters
    ----------
    pieces : TurnPieces
    of_rod, of_weights : Array, shape (point,)
        Torques that the crank must be given for the rod with what hangs beside it, and for the weights. [N·m]
    ends : (float, float)
        Where the upstroke begins and ends. [rad]

    Notes
    -----
    docs/theory/pumping-unit, eqs. (28.9) and (28.10).
    """
    bottom, top = ends
    squares = pieces.mean(of_weights**2)
    if not squares > 0:
        return BalancedUnit(np.nan, np.nan)

    def higher(shares: Array) -> Array:
        torques = [of_rod + share * of_weights for share in shares]
        up = [pieces.largest(torque, bottom, top).value for torque in torques]
        down = [pieces.largest(torque, top, bottom + pieces.cycle).value for torque in torques]
        return np.array(up) - np.array(down)

    most = 4 * float(np.max(np.abs(of_rod)) / np.max(np.abs(of_weights)))
    found = bracketed_roots(higher, np.zeros(1), np.full(1, most))
    return BalancedUnit(float(found[0]), -pieces.mean(of_rod * of_weights) / squares)
