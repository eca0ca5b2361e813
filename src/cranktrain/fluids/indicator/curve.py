"""A periodic curve of cubics through samples: smooth between them, and with a jump where an angle has two values."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.spline import periodic_slopes
from cranktrain.numerics.ties import first_largest

_AT_PLACE = 1e-13
"""What is so little before a place stands at it: places come back from a count of other zero with rounding. [rad]"""


class CubicCurve(NamedTuple):
    """A periodic curve, one cubic from each place to the next.

    Attributes
    ----------
    period : float
        [rad]
    places : Array, shape (n,)
        Where cubics begin: rising, within one period. [rad]
    starts, ends : Array, shape (n,)
        Value where each cubic begins and where it ends: the next one's start, unless the curve jumps there.
    start_slopes, end_slopes : Array, shape (n,)
        Derivatives there. [unit/rad]
    """

    period: float
    places: Array
    starts: Array
    ends: Array
    start_slopes: Array
    end_slopes: Array

    @property
    def steps(self) -> Array:
        """Length of each cubic. [rad]"""
        return np.diff(self.places, append=self.places[0] + self.period)

    @property
    def jumps(self) -> Array:
        """Places at which the value jumps, shape (k,). [rad]"""
        return self.places[self.starts != np.roll(self.ends, 1)]


class Steps(NamedTuple):
    """The steps between samples of one period, without those of no length, which are jumps.

    Where each begins, its length, the values at both ends, and whether a jump stands at its beginning.
    """

    places: Array
    lengths: Array
    starts: Array
    ends: Array
    after_jump: NDArray[np.bool_]


def steps_between(places: Array, values: Array, period: float) -> Steps:
    """Steps from sample to sample round the period; a place given twice, before and after, is a jump.

    Parameters
    ----------
    places : Array, shape (m,)
        Never falling, within one period. [rad]
    values : Array, shape (m,)
    period : float
        [rad]

    Returns
    -------
    Steps, shape (n,) each
    """
    lengths = np.diff(places, append=places[0] + period)
    is_step = lengths > 0
    after_jump = ~np.roll(is_step, 1)
    ends = np.roll(values, -1)
    return Steps(places[is_step], lengths[is_step], values[is_step], ends[is_step], after_jump[is_step])


def curve_at(curve: CubicCurve, at: Array) -> Array:
    """Value of a periodic curve.

    Parameters
    ----------
    curve : CubicCurve
    at : Array, any shape
        Any multiple of the period may be added. [rad]

    Returns
    -------
    Array, of the shape of `at`
        At a jump the value just after it.
    """
    return along(curve, *_piece(curve, at))


def slope_at(curve: CubicCurve, at: Array) -> Array:
    """Derivative of a periodic curve, of the shape of `at`; where two cubics meet that of the second. [unit/rad]"""
    index, share = _piece(curve, at)
    step = curve.steps[index]
    chord = curve.ends[index] - curve.starts[index]
    first, last = (slopes[index] * step - chord for slopes in (curve.start_slopes, curve.end_slopes))
    rest = 1 - share
    return (chord + (rest - share) * (rest * first - share * last) - share * rest * (first + last)) / step


def _piece(curve: CubicCurve, at: Array) -> tuple[NDArray[np.intp], Array]:
    """Which cubic a place is on, and at what part of its length."""
    first = curve.places[0]
    turned: Array = np.mod(at - first, curve.period)
    since: Array = np.where(turned > curve.period - _AT_PLACE, turned - curve.period, turned)
    index = np.searchsorted(curve.places - first, since + _AT_PLACE, side="right") - 1
    return index, (since - (curve.places[index] - first)) / curve.steps[index]


def along(curve: CubicCurve, index: NDArray[np.intp], share: Array) -> Array:
    """Value of some of a curve's cubics, each at a part of its length, of the broadcast shape."""
    step, rest = curve.steps[index], 1 - share
    start, end = curve.starts[index], curve.ends[index]
    chord = end - start
    bend = rest * (curve.start_slopes[index] * step - chord) - share * (curve.end_slopes[index] * step - chord)
    return rest * start + share * end + share * rest * bend


def crest(curve: CubicCurve) -> tuple[float, float]:
    """Place and value of the highest point of a curve. [rad, unit]"""
    step = curve.steps
    chord = curve.ends - curve.starts
    one, last = curve.start_slopes * step, curve.end_slopes * step
    two, three = 3 * chord - 2 * one - last, one + last - 2 * chord
    # Where one + 2 two u + 3 three u² = 0, in the form that loses no digits.
    both = -two - np.copysign(np.sqrt(np.maximum(two**2 - 3 * one * three, 0.0)), two)
    found = [_share(both, 3 * three), _share(one, both)]
    shares = np.stack([np.zeros_like(step), *found, np.ones_like(step)])
    values = along(curve, np.arange(len(step)), shares)
    piece, which = np.unravel_index(first_largest(values.T), values.T.shape)
    return float(curve.places[piece] + shares[which, piece] * step[piece]), float(np.max(values))


def _share(above: Array, below: Array) -> Array:
    """A quotient within 0 to 1; 0 where there is none."""
    return np.clip(above / np.where(below == 0.0, np.inf, below), 0.0, 1.0)


def spline_curve(places: Array, values: Array, period: float) -> CubicCurve:
    """Periodic cubic spline through points of one period; of a place given twice the second counts, as if no jump."""
    kept = np.diff(places, append=places[0] + period) > 0
    own, starts = places[kept], values[kept]
    slopes = periodic_slopes(own, starts, period)
    return CubicCurve(period, own, starts, np.roll(starts, -1), slopes, np.roll(slopes, -1))
