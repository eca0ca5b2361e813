"""The periodic cubic spline: smooth through all points of a cycle, wherever they stand."""

import numpy as np

from cranktrain.motion import Array


def periodic_slopes(places: Array, values: Array, period: float) -> Array:
    """Slopes of the periodic cubic spline at its points.

    Parameters
    ----------
    places : Array, shape (n,)
        Rising, within one period; at least three. [rad]
    values : Array, shape (n,)
    period : float
        [rad]

    Returns
    -------
    Array, shape (n,). [unit/rad]

    Notes
    -----
    Continuous curvature at each point: s₋/h₋ + 2(1/h₋ + 1/h)s + s₊/h = 3(δ₋/h₋ + δ/h), with δ the slope of the chord
    over the step h. The two corners of the cyclic system are taken out by Sherman's and Morrison's formula. Written
    out, as importing SciPy's takes longer than all the rest of a run.
    """
    steps = np.diff(places, append=places[0] + period)
    chords = np.diff(values, append=values[0]) / steps
    after = 1 / steps
    before = np.roll(after, 1)
    middle = 2 * (before + after)
    right = 3 * (np.roll(chords, 1) * before + chords * after)
    corner = float(before[0])  # joins the last point to the first, and the first to the last
    first = float(middle[0])
    middle[0] += first
    middle[-1] += corner**2 / first
    ends = np.zeros_like(right)
    ends[0], ends[-1] = -first, corner
    plain, bent = tridiagonal(after[:-1], middle, np.stack([right, ends], axis=-1)).T
    share = (plain[0] - corner / first * plain[-1]) / (1 + bent[0] - corner / first * bent[-1])
    return plain - share * bent


def periodic_powers(places: Array, values: Array, period: float) -> Array:
    """Coefficients of its pieces by what is gone from their points on, shape (4, n); parameters as of the slopes."""
    slopes = periodic_slopes(places, values, period)
    steps = np.diff(places, append=places[0] + period)
    rise, after = np.roll(values, -1) - values, np.roll(slopes, -1)
    second = (3 * rise / steps - 2 * slopes - after) / steps
    third = (slopes + after - 2 * rise / steps) / steps**2
    return np.stack([values, slopes, second, third])


def tridiagonal(beside: Array, middle: Array, right: Array) -> Array:
    """Solve a symmetric tridiagonal system with diagonal dominance, for several right sides (n, k)."""
    pivots, sides = middle.tolist(), right.copy()
    for row, off in enumerate(beside.tolist(), start=1):
        factor = off / pivots[row - 1]
        pivots[row] -= factor * off
        sides[row] -= factor * sides[row - 1]
    sides[-1] /= pivots[-1]
    for row in range(len(pivots) - 2, -1, -1):
        sides[row] = (sides[row] - beside[row] * sides[row + 1]) / pivots[row]
    return sides
