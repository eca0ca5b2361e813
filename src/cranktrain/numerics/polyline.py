"""A periodic curve of straight lines between given points, and its integral in closed form."""

from typing import NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array, Coefficient
from cranktrain.numerics.periodic import PeriodicCurve, cycle_grid


class Polyline(NamedTuple):
    """Straight lines from point to point round a period.

    Attributes
    ----------
    angles : Array, shape (n,)
        Rising, within one period. [rad]
    values : Array, shape (n,)
    period : float
        After which the first point follows the last. [rad]
    """

    angles: Array
    values: Array
    period: float


class _Pieces(NamedTuple):
    """The piece of each angle: distance from its first point, value there, slope, and the integral up to there."""

    beyond: Array
    value: Array
    slope: Array
    integral: Array


def polyline_value(polyline: Polyline, angle: Array) -> Array:
    """Value of the curve at angles of any shape, of that shape.

    Examples
    --------
    >>> polyline_value(Polyline(np.array([0.0, 1.0]), np.array([0.0, 3.0]), 4.0), np.array([0.5, 2.0, 7.0])).tolist()
    [1.5, 2.0, 1.0]
    """
    piece = _piece(polyline, angle)
    return piece.value + piece.slope * piece.beyond


def polyline_mean(polyline: Polyline) -> float:
    """Mean of the curve over its period, exact."""
    return float(np.sum(_areas(polyline))) / polyline.period


def polyline_integral(polyline: Polyline, n_points: int, cycle: float) -> PeriodicCurve:
    """Integral of the curve less its mean, from φ = 0, exact.

    Parameters
    ----------
    polyline : Polyline
        Whose period goes into the cycle.
    n_points : int
        Of the cycle's grid, for its samples.
    cycle : float
        [rad]

    Returns
    -------
    PeriodicCurve

    Notes
    -----
    From point to point a parabola. docs/theory/evenness, eq. (17.18).
    """
    mean = polyline_mean(polyline)

    def from_first(angle: Array) -> Coefficient:
        piece = _piece(polyline, angle)
        whole = piece.integral + piece.beyond * (piece.value + piece.slope * piece.beyond / 2)
        level = mean * np.mod(angle - polyline.angles[0], polyline.period)
        return Coefficient(whole - level, piece.value + piece.slope * piece.beyond - mean, piece.slope)

    start = from_first(np.zeros(())).value

    def motion(angle: Array) -> Coefficient:
        value, first, second = from_first(angle)
        return Coefficient(value - start, first, second)

    return PeriodicCurve(cycle, motion(cycle_grid(n_points, cycle)).value, motion)


def _areas(polyline: Polyline) -> Array:
    """Integral of each piece, from its point to the next, shape (n,)."""
    steps = np.diff(polyline.angles, append=polyline.angles[0] + polyline.period)
    return steps * (polyline.values + np.roll(polyline.values, -1)) / 2


def _piece(polyline: Polyline, angle: Array) -> _Pieces:
    """Find the piece that holds each angle."""
    angles, values, period = polyline
    beyond = np.mod(angle - angles[0], period)
    starts = angles - angles[0]
    # Of an angle that is NaN any piece will do, as its distance is NaN.
    place = np.clip(cast("NDArray[np.intp]", np.searchsorted(starts, beyond, side="right")) - 1, 0, len(angles) - 1)
    slopes = np.diff(values, append=values[0]) / np.diff(angles, append=angles[0] + period)
    integrals = np.concatenate([[0.0], np.cumsum(_areas(polyline))[:-1]])
    return _Pieces(beyond - starts[place], values[place], slopes[place], integrals[place])
