"""Roots and extremes of many curves at once, to rounding: curves are kernels, so nothing is read off a grid."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array

Curve = Callable[[Array], Array]
"""A curve of the crank angle: takes angles of shape (..., n), gives values of the same shape."""

_MOST_STEPS = 60


class Extreme(NamedTuple):
    """An extreme of each curve: where [rad] and how much, of shape (..., 1)."""

    angle: Array
    value: Array


def bracketed_roots(curve: Curve, low: Array, high: Array, *, precision: float = 0.0) -> Array:
    """Roots of many curves, each within its own bracket, by Chandrupatla's method.

    Parameters
    ----------
    curve : Curve
    low, high : Array, shape (..., n)
        Ends of each bracket. [rad]
    precision : float
        Relative precision at which to stop; 0 goes on to rounding.

    Returns
    -------
    Array, shape (..., n)
        To rounding, or the precision asked for; NaN where the curve has the same sign at both ends, or is NaN within.

    Notes
    -----
    Chandrupatla, Adv. Eng. Software 28 (1997) 145: inverse quadratic interpolation where it is safe, else bisection.
    """
    with np.errstate(all="ignore"):
        newest, value_newest = np.array(low, dtype=float), curve(low)
        other, value_other = np.array(high, dtype=float), curve(high)
        bracketed = np.sign(value_newest) * np.sign(value_other) <= 0
        third, value_third = other, value_other
        share = np.full(newest.shape, 0.5)
        for _ in range(_MOST_STEPS):
            trial = newest + share * (other - newest)
            value = curve(trial)
            same = np.sign(value) == np.sign(value_newest)
            third, value_third = np.where(same, newest, other), np.where(same, value_newest, value_other)
            other, value_other = np.where(same, other, newest), np.where(same, value_other, value_newest)
            newest, value_newest = trial, value
            best = np.where(np.abs(value_newest) < np.abs(value_other), newest, other)
            tolerance = np.maximum(np.spacing(np.abs(best)), precision * np.abs(best)) + 1e-17
            least = tolerance / np.abs(other - newest)
            if np.all((least > 0.5) | (value_newest == 0) | (value_other == 0) | ~bracketed | np.isnan(value_newest)):
                break
            xi = (newest - other) / (third - other)
            phi = (value_newest - value_other) / (value_third - value_other)
            safe = (phi**2 < xi) & ((1 - phi) ** 2 < 1 - xi)
            inverse = value_newest / (value_other - value_newest) * value_third / (value_other - value_third) + (
                third - newest
            ) / (other - newest) * value_newest / (value_third - value_newest) * value_other / (
                value_third - value_other
            )
            share = np.clip(np.where(safe, inverse, 0.5), least, 1 - least)
        best = np.where(np.abs(value_newest) <= np.abs(value_other), newest, other)
        return np.where(bracketed & ~np.isnan(value_newest), best, np.nan)


def turn_grid(n_points: int = 720) -> Array:
    """One turn of the crank in equal steps, endpoint excluded. [rad]"""
    return np.arange(n_points, dtype=np.float64) * (2 * np.pi / n_points)


def largest(
    curve: Curve, slope: Curve | None = None, *, grid: Array | None = None, samples: Array | None = None
) -> Extreme:
    """Largest value of each curve over a turn.

    Parameters
    ----------
    curve : Curve
        Gives (..., n) for angles (..., n) or (n,).
    slope : Curve, optional
        Its derivative; with it the angle is exact to rounding, without it to the square root of rounding (a parabola
        through ever closer points), which leaves the value exact to rounding all the same.
    grid : Array, shape (n,) or (..., n), optional
        Where to look first: equal steps over a turn; 720 points unless given.
    samples : Array, shape (..., n), optional
        The curve on `grid`, where it is known already.

    Returns
    -------
    Extreme, shapes (..., 1)
        NaN where the curve is NaN all over the turn or next to its largest value.
    """
    grid = turn_grid() if grid is None else grid
    with np.errstate(invalid="ignore"):
        known = curve(grid) if samples is None else samples
        index = np.argmax(np.where(np.isnan(known), -np.inf, known), axis=-1)[..., np.newaxis]
        middle = np.take_along_axis(np.broadcast_to(grid, known.shape), index, axis=-1)
        step = grid[..., 1:2] - grid[..., :1]
        bracket = middle - step, middle + step
        angle = _zoomed(curve, middle, step) if slope is None else bracketed_roots(slope, *bracket)
        value = curve(angle)
    return Extreme(angle, value)


def smallest(
    curve: Curve, slope: Curve | None = None, *, grid: Array | None = None, samples: Array | None = None
) -> Extreme:
    """Smallest value of each curve over a turn; as `largest`."""
    negative = None if samples is None else -samples
    found = largest(lambda angle: -curve(angle), slope, grid=grid, samples=negative)
    return Extreme(found.angle, -found.value)


def _zoomed(curve: Curve, middle: Array, half: Array) -> Array:
    """Angle of the top of the parabola through three points, again and again at a thirtieth of the distance."""
    for _ in range(3):
        left, centre, right = curve(middle - half), curve(middle), curve(middle + half)
        curvature = left - 2 * centre + right
        step = np.where(curvature < 0, 0.5 * half * (left - right) / np.where(curvature < 0, curvature, -1.0), 0.0)
        step = np.where(np.isnan(centre), np.nan, np.clip(step, -half, half))
        middle = middle + step
        half = half / 30
    return middle


def spectral_derivative(samples: Array) -> Array:
    """Derivative by the angle of a periodic curve sampled at equal steps over one turn, by its Fourier series.

    Parameters
    ----------
    samples : Array, shape (..., n)

    Returns
    -------
    Array, shape (..., n). [unit/rad]
    """
    n_points = samples.shape[-1]
    order = np.arange(n_points // 2 + 1, dtype=float)
    if n_points % 2 == 0:
        order[-1] = 0.0  # the highest cosine is seen only at its zeros of slope
    return np.fft.irfft(1j * order * np.fft.rfft(samples, axis=-1), n_points, axis=-1)
