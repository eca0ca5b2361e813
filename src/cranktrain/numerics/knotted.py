"""A periodic cubic spline through points wherever they stand, as a curve."""

from typing import cast

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array, Coefficient
from cranktrain.numerics.periodic import PeriodicCurve, cycle_grid
from cranktrain.numerics.spline import periodic_slopes


def knotted_curve(places: Array, values: Array, period: float, n_points: int, cycle: float) -> PeriodicCurve:
    """Lay the spline through points, with samples at equal steps over a cycle.

    Parameters
    ----------
    places : Array, shape (n,)
        Rising, within one period; at least three. [rad]
    values : Array, shape (n,)
    period : float
        Which goes into the cycle. [rad]
    n_points : int
        Of the samples.
    cycle : float
        [rad]

    Returns
    -------
    PeriodicCurve

    Examples
    --------
    >>> places = np.radians([0.0, 90.0, 200.0, 300.0])
    >>> curve = knotted_curve(places, np.array([1.0, 2.0, 4.0, 3.0]), 2 * np.pi, 4, 2 * np.pi)
    >>> np.round(curve.value(places + 4 * np.pi), 12).tolist()
    [1.0, 2.0, 4.0, 3.0]
    """
    slopes = periodic_slopes(places, values, period)
    steps = np.diff(places, append=places[0] + period)
    rise, after = np.roll(values, -1) - values, np.roll(slopes, -1)
    second = (3 * rise / steps - 2 * slopes - after) / steps
    third = (slopes + after - 2 * rise / steps) / steps**2
    starts = places - places[0]

    def motion(angle: Array) -> Coefficient:
        beyond = np.mod(angle - places[0], period)
        # Of an angle that is NaN any piece will do, as its distance is NaN.
        found = cast("NDArray[np.intp]", np.searchsorted(starts, beyond, side="right")) - 1
        piece: NDArray[np.intp] = np.clip(found, 0, len(places) - 1)
        x = beyond - starts[piece]
        a, b, c, d = values[piece], slopes[piece], second[piece], third[piece]
        return Coefficient(a + x * (b + x * (c + x * d)), b + x * (2 * c + 3 * x * d), 2 * c + 6 * x * d)

    return PeriodicCurve(cycle, motion(cycle_grid(n_points, cycle)).value, motion)
