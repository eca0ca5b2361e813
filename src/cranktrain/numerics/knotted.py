"""Curves of cubics between points wherever they stand round a period; of them the periodic cubic spline."""

from functools import partial
from typing import NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array, Coefficient
from cranktrain.numerics.periodic import PeriodicCurve, cycle_grid
from cranktrain.numerics.spline import periodic_powers


class Knotted(NamedTuple):
    """Cubics from point to point round a period.

    Attributes
    ----------
    places : Array, shape (n,)
        Of the points, rising within one period. [rad]
    powers : Array, shape (4, n)
        Coefficients of the cubic behind each point, by powers of the distance from there.
    period : float
        After which the first point follows the last. [rad]
    """

    places: Array
    powers: Array
    period: float


def knotted_motion(knotted: Knotted, angle: Array) -> Coefficient:
    """Value and first two derivatives at angles of any shape, of that shape."""
    places, powers, period = knotted
    beyond = np.mod(angle - places[0], period)
    starts = places - places[0]
    # Of an angle that is NaN any piece will do, as its distance is NaN.
    found = cast("NDArray[np.intp]", np.searchsorted(starts, beyond, side="right")) - 1
    piece: NDArray[np.intp] = np.clip(found, 0, len(places) - 1)
    x = beyond - starts[piece]
    a, b, c, d = powers[:, piece]
    return Coefficient(a + x * (b + x * (c + x * d)), b + x * (2 * c + 3 * x * d), 2 * c + 6 * x * d)


def knotted_curve(knotted: Knotted, n_points: int, cycle: float) -> PeriodicCurve:
    """Curve with samples at equal steps over a cycle [rad], into which the period goes."""
    motion = partial(knotted_motion, knotted)
    return PeriodicCurve(cycle, motion(cycle_grid(n_points, cycle)).value, motion)


def spline_through(places: Array, values: Array, period: float) -> Knotted:
    """Lay the periodic cubic spline through points.

    Parameters
    ----------
    places : Array, shape (n,)
        Rising, within one period; at least three. [rad]
    values : Array, shape (n,)
    period : float
        [rad]

    Returns
    -------
    Knotted

    Examples
    --------
    >>> places = np.radians([0.0, 90.0, 200.0, 300.0])
    >>> spline = spline_through(places, np.array([1.0, 2.0, 4.0, 3.0]), 2 * np.pi)
    >>> np.round(knotted_motion(spline, places + 4 * np.pi).value, 12).tolist()
    [1.0, 2.0, 4.0, 3.0]
    """
    return Knotted(places, periodic_powers(places, values, period), period)
