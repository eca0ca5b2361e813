"""A periodic curve of straight lines between given points, and its integral in closed form."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.knotted import Knotted, knotted_curve, knotted_motion
from cranktrain.numerics.periodic import PeriodicCurve, plus


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


def polyline_value(polyline: Polyline, angle: Array) -> Array:
    """Value of the curve at angles of any shape, of that shape.

    Examples
    --------
    >>> polyline_value(Polyline(np.array([0.0, 1.0]), np.array([0.0, 3.0]), 4.0), np.array([0.5, 2.0, 7.0])).tolist()
    [1.5, 2.0, 1.0]
    """
    return knotted_motion(_lines(polyline), angle).value


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
    level = polyline._replace(values=polyline.values - polyline_mean(polyline))
    areas = _areas(level)
    values, slopes, zero, _ = _lines(level).powers
    parabolas = Knotted(level.angles, np.stack([np.cumsum(areas) - areas, values, slopes / 2, zero]), level.period)
    whole = knotted_curve(parabolas, n_points, cycle)
    return plus(whole, -whole.value(np.zeros(())))


def _steps(polyline: Polyline) -> Array:
    return np.diff(polyline.angles, append=polyline.angles[0] + polyline.period)


def _areas(polyline: Polyline) -> Array:
    """Integral of each piece, from its point to the next, shape (n,)."""
    return _steps(polyline) * (polyline.values + np.roll(polyline.values, -1)) / 2


def _lines(polyline: Polyline) -> Knotted:
    angles, values, period = polyline
    slopes, zero = np.diff(values, append=values[0]) / _steps(polyline), np.zeros_like(values)
    return Knotted(angles, np.stack([values, slopes, zero, zero]), period)
