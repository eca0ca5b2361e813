"""Roots of many curves at once, to rounding."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array

Curve = Callable[[Array], Array]
"""A curve of the crank angle: takes angles of shape (..., n), gives values of the same shape."""

SlopedCurve = Callable[[Array], tuple[Array, Array]]
"""A curve and its slope."""

_MOST_STEPS = 60
_MOST_NEWTON_STEPS = 10
_FALLEN = 1e-3
"""A curve that has not fallen to this part of its values at the bracket's ends jumps over its root."""
_MOST_SAFE_STEPS = 30
_NEAR = 1e-6
"""A step of Newton's method after which the next one is less than rounding, in parts of the brackets' unit."""
_SETTLED = 1e-13
"""A step, in parts of the root, after which the next one is less than rounding."""


def bracketed_roots(curve: Curve, low: Array, high: Array) -> Array:
    """Roots of many curves, each within its own bracket, by Chandrupatla's method.

    Parameters
    ----------
    curve : Curve
    low, high : Array, shape (..., n)
        Ends of each bracket. [rad]

    Returns
    -------
    Array, shape (..., n)
        To rounding; NaN where the curve has the same sign at both ends, or is NaN within.

    Notes
    -----
    Chandrupatla, Adv. Eng. Software 28 (1997) 145: inverse quadratic interpolation where it is safe, else bisection;
    here the first step is the secant's, as most brackets are narrow.
    """
    with np.errstate(all="ignore"):
        newest, value_newest = np.array(low, dtype=float), curve(low)
        other, value_other = np.array(high, dtype=float), curve(high)
        bracketed = np.sign(value_newest) * np.sign(value_other) <= 0
        is_found, fallen = ~bracketed, _FALLEN * np.maximum(np.abs(value_newest), np.abs(value_other))
        third, value_third, slope = other, value_other, np.zeros_like(newest)
        # Not at the ends themselves, which may be roots that the caller does not mean.
        share = np.clip(np.nan_to_num(value_newest / (value_newest - value_other), nan=0.5), 0.01, 0.99)
        for _ in range(_MOST_STEPS):
            trial = np.where(is_found, newest, newest + share * (other - newest))
            value = curve(trial)
            same = np.sign(value) == np.sign(value_newest)
            third, value_third = np.where(same, newest, other), np.where(same, value_newest, value_other)
            other, value_other = np.where(same, other, newest), np.where(same, value_other, value_newest)
            # By the last two trials that differ, which are close where the curve is smooth.
            move = trial - newest
            slope = np.where(value == value_newest, slope, (value - value_newest) / move)
            left = np.maximum(np.abs(move), np.abs(value / slope))
            newest, value_newest = trial, value
            best = np.where(np.abs(value_newest) < np.abs(value_other), newest, other)
            least = (np.spacing(np.abs(best)) + 1e-17) / np.abs(other - newest)
            is_settled = (left <= _SETTLED * np.abs(best)) & (np.abs(value) <= fallen)
            is_found |= (least > 0.5) | is_settled | (value_newest == 0) | (value_other == 0) | np.isnan(value_newest)
            if np.all(is_found):
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


def near_roots(curve: Curve, start: Array, low: Array, high: Array, among: NDArray[np.intp] | None = None) -> Array:
    """Roots of rising curves that are dear to compute, whose slope is near 1 and whose roots are near a start.

    Parameters
    ----------
    curve : Curve
    start, low, high : Array, shape (..., n)
        Where the root is thought to be, and between what it has to be.
    among : array of int, shape (..., n), optional
        Of curves with the same number only the least root is asked for; of each its own unless given.

    Returns
    -------
    Array, shape (..., n)
        To rounding; NaN where there is no root, or may be where another one among the same is less.

    Notes
    -----
    The secant method; what it does not settle is searched for by `bracketed_roots`. A curve that is still below 0 at
    the least root that is known among the same has its own beyond.
    """
    group = np.arange(start.size).reshape(start.shape) if among is None else among
    with np.errstate(all="ignore"):
        root, value, slope = start, curve(start), np.ones_like(start)
        is_settled, is_beyond = np.zeros((2, *start.shape), dtype=np.bool_)
        for _ in range(_MOST_NEWTON_STEPS):
            move = np.where(is_settled, 0.0, -value / slope)
            is_settled |= np.abs(move) <= _SETTLED * np.abs(root + move)
            is_root = is_settled & ~is_beyond & (low <= root + move) & (root + move <= high)
            least = _least_among(np.where(is_root, root + move, np.inf), group)
            move = np.where(is_settled, move, np.minimum(root + move, least) - root)
            root, before = root + move, value
            if np.all(is_settled):
                break
            value = curve(root)
            slope = np.where((value == before) | is_settled, slope, (value - before) / move)
            is_later = ~is_settled & (root >= least) & (value < 0)
            is_settled, is_beyond = is_settled | is_later, is_beyond | is_later
        is_found = is_beyond | (is_settled & (low <= root) & (root <= high))
        return np.where(is_beyond, np.nan, root) if np.all(is_found) else bracketed_roots(curve, low, high)


def _least_among(roots: Array, group: NDArray[np.intp]) -> Array:
    """Least root of the group of each."""
    least = np.full(int(np.max(group, initial=-1)) + 1, np.inf)
    np.minimum.at(least, group, roots)
    return least[group]


def newton_roots(curve: SlopedCurve, low: Array, high: Array, sense: Array, share: Array) -> Array:
    """Where curves that are cheap to compute, with their slopes, change sign once, each within its own bracket.

    Parameters
    ----------
    curve : SlopedCurve
    low, high : Array, shape (n,)
        Ends of each bracket, some 1 apart.
    sense : Array, shape (n,)
        1 where a curve rises through 0, −1 where it falls.
    share : Array, shape (n,)
        Where to begin, in parts of the bracket.

    Returns
    -------
    Array, shape (n,)
        To 1e-12 where the slope there is not small, else to 1e-6.

    Notes
    -----
    Newton's method, which halves what is left of the bracket where it would leave that.

    Examples
    --------
    >>> one = np.array([1.0])
    >>> np.round(newton_roots(lambda x: (x * x - 0.25, 2 * x), 0 * one, one, one, 0.4 * one), 9).tolist()
    [0.5]
    """
    low, high = np.array(low), np.array(high)
    way = low + share * (high - low)
    with np.errstate(divide="ignore", invalid="ignore"):
        for _ in range(_MOST_SAFE_STEPS):
            value, slope = curve(way)
            is_before = value * sense < 0
            low, high = np.where(is_before, way, low), np.where(is_before, high, way)
            trial = way - value / slope
            trial = np.where((low <= trial) & (trial <= high), trial, (low + high) / 2)
            is_near = np.abs(trial - way) <= _NEAR
            way = trial
            if np.all(is_near):
                break
    return way


def secant_share(before: Array, after: Array) -> Array:
    """Where the secant is 0 between two values of opposite sign, in parts of the way from one to the other."""
    size = np.abs(before)
    both = size + np.abs(after)
    return size / np.where(both > 0, both, 1.0)
