"""Smallest and largest values of many curves at once: curves are kernels, so nothing is read off a grid."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array, Coefficient
from cranktrain.numerics.roots import Curve, bracketed_roots
from cranktrain.numerics.series import turn_grid
from cranktrain.numerics.ties import ALIKE
from cranktrain.numerics.tops import (
    CANDIDATES,
    TINY,
    Extreme,
    chosen,
    five_about,
    highest_peaks,
    polished,
    top_of_quartic,
    tops,
)

_BOTH = (-1.0, 1.0)
"""Signs of the smallest and of the largest value."""
_MOST_NEWTON_STEPS = 10


class Extremes(NamedTuple):
    """Smallest and largest value of each curve."""

    smallest: Extreme
    largest: Extreme


def extremes(
    curve: Curve,
    slope: Curve | None = None,
    *,
    grid: Array | None = None,
    samples: Array | None = None,
) -> Extremes:
    """Smallest and largest value of each curve over a turn.

    Parameters
    ----------
    curve : Curve
        Gives (..., k) for angles (..., k) or (k,).
    slope : Curve, optional
        Its derivative, NaN where it is not known; with it the angle is exact to rounding, without it to some 1e-12
        (quartics through close points; at kinks 1e-5 and less), which leaves the value exact to rounding all the same.
    grid : Array, shape (n,), optional
        Where to look first: equal steps over a turn; 720 points unless given.
    samples : Array, shape (..., n), optional
        The curve on `grid`, where it is known already.

    Returns
    -------
    Extremes, shapes (..., 1)
        An angle may lie one step beside the grid's turn. NaN where the curve is NaN all over the turn or next to the
        grid's extreme: a curve that ends there has no extreme but an end.
    """
    return Extremes(*_refined(curve, slope, grid, samples, _BOTH))


def largest(curve: Curve, *, grid: Array | None = None, samples: Array | None = None) -> Extreme:
    """Largest value of each curve over a turn; as `extremes`."""
    return _refined(curve, None, grid, samples, (1.0,))[0]


def smallest(curve: Curve, *, grid: Array | None = None, samples: Array | None = None) -> Extreme:
    """Smallest value of each curve over a turn; as `extremes`."""
    return _refined(curve, None, grid, samples, (-1.0,))[0]


def turning_points(motion: Callable[[Array], Coefficient], samples: Array, grid: Array | None = None) -> Extremes:
    """Smallest and largest value of a motion whose derivatives are known, by Newton's method.

    Parameters
    ----------
    motion : callable
        From angles (..., k) to a Coefficient of that shape.
    samples : Array, shape (..., n)
        Its value on the grid.
    grid : Array, shape (n,), optional
        Equal steps over a turn or cycle; `turn_grid(n)` unless given.

    Returns
    -------
    Extremes, shapes (..., 1)
        Angles exact to rounding; an angle may lie one step beside the grid's turn. NaN where the motion is NaN all over
        the turn, or has no turning point at the grid's extreme but an end.
    """
    grid = turn_grid(samples.shape[-1]) if grid is None else grid
    step = float(grid[1] - grid[0])
    with np.errstate(all="ignore"):
        place, sign = highest_peaks(samples, _BOTH), np.repeat(_BOTH, CANDIDATES)
        start = grid[place]
        angle = start + step * top_of_quartic(five_about(samples, place), sign).way
        found, move = motion(angle), np.full(start.shape, np.inf)
        for _ in range(_MOST_NEWTON_STEPS):
            move = np.clip(angle - found.first / found.second, start - step, start + step) - angle
            angle = angle + move
            if np.all(np.abs(move) <= TINY):
                break
            found = motion(angle)
        turns = (np.abs(move) <= TINY) & (sign * found.second < 0)
        if not np.all(turns | np.any(np.isnan(samples), axis=-1, keepdims=True)):
            return extremes(lambda phi: motion(phi).value, lambda phi: motion(phi).first, grid=grid, samples=samples)
        # The last move is too small to be felt in the value.
        return Extremes(
            *_best(np.where(turns, angle, np.nan), np.where(turns, found.value, np.nan), _scale(samples), _BOTH)
        )


def _refined(
    curve: Curve,
    slope: Curve | None,
    grid: Array | None,
    samples: Array | None,
    signs: Sequence[float],
) -> list[Extreme]:
    """Extremes of each curve, the largest value for a sign of +1, the smallest for −1."""
    grid = turn_grid() if grid is None else grid
    step = float(grid[1] - grid[0])
    with np.errstate(all="ignore"):
        known = curve(grid) if samples is None else samples
        place = highest_peaks(known, signs)
        top = tops(curve, known, place, grid, signs)
        if slope is not None:
            angle = polished(slope, top, np.repeat(signs, CANDIDATES))
            is_rough = np.isnan(angle) & ~np.isnan(top.angle)
            if np.any(is_rough):
                start = grid[place]
                root = bracketed_roots(slope, start - step, start + step)
                top = chosen(is_rough & ~np.isnan(root), Extreme(root, curve(root)), top)
            top = Extreme(np.where(np.isnan(angle), top.angle, angle), top.value)
        return _best(*top, _scale(known), signs)


def _scale(samples: Array) -> Array:
    """Largest absolute value of each curve, shape (..., 1)."""
    return np.fmax.reduce(np.abs(samples), axis=-1, keepdims=True, initial=0.0)


def _best(angle: Array, value: Array, scale: Array, signs: Sequence[float]) -> list[Extreme]:
    """Take the better of both candidates for each sign; NaN where the grid's best one could not be refined.

    Of two that are alike but for rounding, the first in the turn.
    """
    angles, values = (part.reshape(*part.shape[:-1], len(signs), CANDIDATES) for part in (angle, value))
    gain = np.asarray(signs) * (values[..., 1] - values[..., 0])
    is_alike = np.abs(gain) <= ALIKE * scale
    is_second = np.where(is_alike, angles[..., 1] < angles[..., 0], gain > 0)
    best_angle = np.where(is_second, angles[..., 1], angles[..., 0])
    best_value = np.where(gain > 0, values[..., 1], values[..., 0])
    return [Extreme(best_angle[..., [place]], best_value[..., [place]]) for place in range(len(signs))]
