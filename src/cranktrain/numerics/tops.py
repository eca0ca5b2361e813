"""Tops of curves between the points of a grid: by quartics and parabolas through close points."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.roots import Curve
from cranktrain.numerics.ties import first_largest_along

CANDIDATES = 2
"""How many of the grid's peaks are refined: of two that are nearly alike the grid may show the wrong one higher."""
_FIVE = np.array([[-2.0], [-1.0], [0.0], [1.0], [2.0]])
_QUARTIC_SLOPE = np.array([[1, -8, 0, 8, -1], [-1, 16, -30, 16, -1], [-1, 2, 0, -2, 1], [1, -4, 6, -4, 1]]) / np.array(
    [[12.0], [12.0], [4.0], [6.0]]
)
"""From five points at equal distances to their quartic's slope by powers of the way from the middle one."""
_CLOSE, _SMOOTH = 1e-3, 0.02
"""How far apart five points are [rad] for the top of the quartic through them to be exact to some 1e-12 rad, and by how
much, in parts of that, the top of a parabola differs from it at most where the curve is smooth enough."""
_ASIDE, TINY = 1e-6, 1e-8
"""How far aside of a top its curvature is measured, and how far the top may be off for one step to mend it. [rad]"""
_CLOSER, _CLOSEST, _MOST_ZOOMS = 12, 1e-5, 4
"""By how much closer, at least, the points of the next parabola are, where that is not so; and how close they come
[rad]."""


class Extreme(NamedTuple):
    """An extreme of each curve: where [rad] and how much, of shape (..., 1)."""

    angle: Array
    value: Array


def highest_peaks(samples: Array, signs: Sequence[float]) -> NDArray[np.intp]:
    """Places of the two highest peaks of each curve round the turn, the higher first, (..., sign · candidate).

    Of a curve with one peak, or none, the same place twice.
    """
    known = np.fmax(samples[..., np.newaxis, :] * np.array(signs)[:, np.newaxis], -np.inf)
    ring = np.concatenate([known[..., -1:], known, known[..., :1]], axis=-1)
    is_peak = (known > ring[..., :-2]) & (known >= ring[..., 2:])
    heights = np.where(is_peak, known, -np.inf).reshape(-1, known.shape[-1])
    row = np.arange(len(heights))
    first = first_largest_along(heights)
    heights[row, first] = -np.inf
    lower = first_largest_along(heights)
    second: NDArray[np.intp] = np.where(heights[row, lower] > -np.inf, lower, first)
    return np.stack([first, second], axis=-1).reshape(*samples.shape[:-1], len(signs) * CANDIDATES)


def tops(
    curve: Curve,
    samples: Array,
    place: NDArray[np.intp],
    grid: Array,
    signs: Sequence[float],
) -> Extreme:
    """Refine the grid's peaks: tops of quartics through five close points about that of one through five of the grid.

    Parameters
    ----------
    curve : Curve
    samples : Array, shape (..., n)
        The curve on the grid.
    place : array of int, shape (..., k)
        Of `highest_peaks`, with the same signs.
    grid : Array, shape (n,)
        Equal steps over a turn or cycle. [rad]
    signs : sequence of float
        +1 for largest values, −1 for smallest.

    Returns
    -------
    Extreme, shape (..., k)
        Where the curve is rough, of parabolas through ever closer points; NaN where it ends.
    """
    sign = np.repeat(signs, CANDIDATES)
    step, peak = float(grid[1] - grid[0]), grid[place]
    five = five_about(samples, place)
    wide = top_of_quartic(five, sign)
    middle = peak + step * wide.way
    points = (middle[..., np.newaxis, :] + _CLOSE * _FIVE).reshape(*place.shape[:-1], 5 * place.shape[-1])
    values = curve(points)
    found = top_of_quartic(values.reshape(*values.shape[:-1], *five.shape[-2:]), sign)
    top = Extreme(middle + _CLOSE * found.way, found.value)
    is_rough = (np.abs(found.way) >= 1) | (np.abs(found.way - found.parabola) > _SMOOTH)
    if np.any(is_rough):
        # At a jump nothing beside the grid's own point may be as high.
        top = chosen(is_rough, Extreme(peak, five[..., 2, :]), top)
        start = np.where(is_rough, peak + step * wide.parabola, top.angle)
        closest = _closest(curve, start, np.where(is_rough, step, _CLOSEST), sign)
        top = chosen(is_rough & (sign * (closest.value - top.value) > 0), closest, top)
    return top


def five_about(samples: Array, place: NDArray[np.intp]) -> Array:
    """Samples about some places round the turn, from two before to two after, shape (..., 5, k)."""
    n_points = samples.shape[-1]
    around = (place[..., np.newaxis, :] + _FIVE.astype(np.intp)) % n_points
    starts = np.arange(0, samples.size, n_points, dtype=np.intp)
    return samples.ravel()[around + starts.reshape(*samples.shape[:-1], 1, 1)]


def polished(slope: Curve, top: Extreme, sign: Array) -> Array:
    """Angle of the top by one step of Newton's method, to rounding; NaN where that is no tiny one.

    A slope that is NaN is not known, and leaves the angle.
    """
    three = slope(np.concatenate([top.angle - _ASIDE, top.angle, top.angle + _ASIDE], axis=-1))
    before, at, after = np.split(three, 3, axis=-1)
    curvature = (after - before) / (2 * _ASIDE)
    move = -at / curvature
    is_tiny = (np.abs(move) <= TINY) & (sign * curvature < 0)
    return np.where(np.isnan(at), top.angle, np.where(is_tiny, top.angle + move, np.nan))


def _closest(curve: Curve, middle: Array, wide: Array, sign: Array) -> Extreme:
    """Tops of parabolas through three ever closer points, where the curve is rough or a peak narrow."""
    before, half = wide, np.maximum(wide / _CLOSER, _CLOSEST)
    value = np.full_like(middle, np.nan)
    for _ in range(_MOST_ZOOMS):
        points = middle[..., np.newaxis, :] + half[..., np.newaxis, :] * _FIVE[1:4]
        found = curve(points.reshape(*middle.shape[:-1], 3 * middle.shape[-1]))
        way, value = _parabola(found.reshape(*found.shape[:-1], *points.shape[-2:]), sign)
        middle = middle + half * way
        if not np.any(half > 2 * _CLOSEST):
            break
        # What a parabola's top is off by goes with the square of its width; four times that is wide enough.
        width = np.minimum(4 * np.abs(way) * half * (half / before) ** 2, half / _CLOSER)
        before, half = half, np.maximum(width, _CLOSEST)
    return Extreme(middle, value)


def chosen(is_one: NDArray[np.bool_], one: Extreme, other: Extreme) -> Extreme:
    """Take one extreme where so said, else the other."""
    return Extreme(*(np.where(is_one, *parts) for parts in zip(one, other, strict=True)))


class Top(NamedTuple):
    """Top of a curve through equally spaced points: way to it from the middle one, in parts of the distance; value.

    And the way to the top of the parabola through the middle three.
    """

    way: Array
    value: Array
    parabola: Array


def _parabola(three: Array, sign: Array) -> tuple[Array, Array]:
    """Way to the top of the parabola through three points, (..., 3, k), no farther than these, and its value.

    NaN where one of them is.
    """
    centre = three[..., 1, :]
    before, after = three[..., 0, :] - centre, three[..., 2, :] - centre
    slope, curvature = (after - before) / 2, before + after
    # A parabola that opens the wrong way has its top at an end.
    way = np.clip(np.where(sign * curvature < 0, -slope / curvature, np.sign(sign * slope)), -1.0, 1.0)
    return way, centre + (slope + curvature / 2 * way) * way


def top_of_quartic(five: Array, sign: Array) -> Top:
    """Top of the polynomial through five points, (..., 5, k), by a step of Newton's method from the parabola's.

    It squares what the parabola's is off by. The parabola's where there are not five.
    """
    start, parabola = _parabola(five[..., 1:4, :], sign)
    centre = five[..., 2, :]
    # The differences of close points are exact, which their sums are not.
    slope = _QUARTIC_SLOPE @ (five - centre[..., np.newaxis, :])
    a, b, c, d = (slope[..., power, :] for power in range(4))
    move = (a + start * (b + start * (c + start * d))) / (b + start * (2 * c + start * 3 * d))
    way = np.clip(start - move, -1.0, 1.0)
    value = centre + way * (a + way * (b / 2 + way * (c / 3 + way * d / 4)))
    is_known = ~np.isnan(way)
    return Top(np.where(is_known, way, start), np.where(is_known, value, parabola), start)
