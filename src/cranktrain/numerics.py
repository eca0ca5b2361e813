"""Roots and extremes of many curves at once, to rounding: curves are kernels, so nothing is read off a grid."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array, Coefficient

Curve = Callable[[Array], Array]
"""A curve of the crank angle: takes angles of shape (..., n), gives values of the same shape."""

_BOTH = (-1.0, 1.0)
"""Signs of the smallest and of the largest value."""
_CANDIDATES = 2
"""How many of the grid's peaks are refined: of two that are nearly alike the grid may show the wrong one higher."""
_ALIKE = 1e-9
"""Peaks that differ by less, in parts of the curve's, are one height: rounding must not choose between their angles."""
_FIVE = np.array([[-2.0], [-1.0], [0.0], [1.0], [2.0]])
_CLOSE, _SMOOTH = 1e-3, 0.02
"""How far apart five points are [rad] for the top of the quartic through them to be exact to some 1e-12 rad, and by how
much, in parts of that, the top of a parabola differs from it at most where the curve is smooth enough."""
_ASIDE, _TINY = 1e-6, 1e-8
"""How far aside of a top its curvature is measured, and how far the top may be off for one step to mend it. [rad]"""
_CLOSER, _CLOSEST, _MOST_ZOOMS = 12, 1e-5, 4
"""By how much closer, at least, the points of the next parabola are, where that is not so; and how close they come
[rad]."""
_MOST_STEPS = 60
_MOST_NEWTON_STEPS = 10
_SETTLED = 1e-13
"""A step of Newton's method after which the next one is less than rounding. [rad, or in parts of the root]"""
_SERIES_LENGTHS = (720, 5760, 46080, 368640)
"""Points of a turn for a Fourier series."""


class Extreme(NamedTuple):
    """An extreme of each curve: where [rad] and how much, of shape (..., 1)."""

    angle: Array
    value: Array


class Extremes(NamedTuple):
    """Smallest and largest value of each curve."""

    smallest: Extreme
    largest: Extreme


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
    Chandrupatla, Adv. Eng. Software 28 (1997) 145: inverse quadratic interpolation where it is safe, else bisection;
    here the first step is the secant's, as most brackets are narrow.
    """
    with np.errstate(all="ignore"):
        newest, value_newest = np.array(low, dtype=float), curve(low)
        other, value_other = np.array(high, dtype=float), curve(high)
        bracketed = np.sign(value_newest) * np.sign(value_other) <= 0
        third, value_third = other, value_other
        # Not at the ends themselves, which may be roots that the caller does not mean.
        share = np.clip(np.nan_to_num(value_newest / (value_newest - value_other), nan=0.5), 0.01, 0.99)
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


def near_roots(curve: Curve, start: Array, low: Array, high: Array) -> Array:
    """Roots of curves that are dear to compute, whose slope is near 1 and whose roots are near a start.

    Parameters
    ----------
    curve : Curve
    start, low, high : Array, shape (..., n)
        Where the root is thought to be, and between what it has to be.

    Returns
    -------
    Array, shape (..., n)
        To rounding; NaN where there is no root.

    Notes
    -----
    The secant method; what it does not settle is searched for by `bracketed_roots`.
    """
    with np.errstate(all="ignore"):
        root, value, slope = start, curve(start), np.ones_like(start)
        is_settled = np.zeros(start.shape, dtype=np.bool_)
        for _ in range(_MOST_NEWTON_STEPS):
            move = np.where(is_settled, 0.0, -value / slope)
            root, before = root + move, value
            is_settled = np.abs(move) <= _SETTLED * np.abs(root)
            if np.all(is_settled):
                break
            value = curve(root)
            slope = np.where(value == before, slope, (value - before) / move)
        is_found = is_settled & (low <= root) & (root <= high)
        return root if np.all(is_found) else bracketed_roots(curve, low, high)


def turn_grid(n_points: int = 720) -> Array:
    """One turn of the crank in equal steps, endpoint excluded. [rad]"""
    return np.arange(n_points, dtype=np.float64) * (2 * np.pi / n_points)


def extremes(
    curve: Curve,
    slope: Curve | None = None,
    *,
    grid: Array | None = None,
    samples: Array | None = None,
    kinks: Array | None = None,
) -> Extremes:
    """Smallest and largest value of each curve over a turn.

    Parameters
    ----------
    curve : Curve
        Gives (..., k) for angles (..., k) or (k,).
    slope : Curve, optional
        Its derivative, NaN where it is not known; with it the angle is exact to rounding, without it to some 1e-12
        (quartics through close points;
        at kinks that are not told 1e-5 and less), which leaves the value exact to rounding all the same.
    grid : Array, shape (n,), optional
        Where to look first: equal steps over a turn; 720 points unless given.
    samples : Array, shape (..., n), optional
        The curve on `grid`, where it is known already.
    kinks : Array, shape (..., m), optional
        Where the curve may have kinks, at which its extremes may stand; NaN for none. Of no use beside a slope. [rad]

    Returns
    -------
    Extremes, shapes (..., 1)
        An angle may lie one step beside the grid's turn. NaN where the curve is NaN all over the turn or next to the
        grid's extreme: a curve that ends there has no extreme but an end.
    """
    return Extremes(*_refined(curve, slope, grid, samples, _BOTH, kinks))


def largest(
    curve: Curve,
    slope: Curve | None = None,
    *,
    grid: Array | None = None,
    samples: Array | None = None,
    kinks: Array | None = None,
) -> Extreme:
    """Largest value of each curve over a turn; as `extremes`."""
    return _refined(curve, slope, grid, samples, (1.0,), kinks)[0]


def smallest(
    curve: Curve, slope: Curve | None = None, *, grid: Array | None = None, samples: Array | None = None
) -> Extreme:
    """Smallest value of each curve over a turn; as `extremes`."""
    return _refined(curve, slope, grid, samples, (-1.0,))[0]


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
        place, sign = _candidates(samples, _BOTH), np.repeat(_BOTH, _CANDIDATES)
        start = grid[place]
        angle = start + step * _top_of_quartic(_five(samples, place), sign).way
        found, move = motion(angle), np.full(start.shape, np.inf)
        for _ in range(_MOST_NEWTON_STEPS):
            move = np.clip(angle - found.first / found.second, start - step, start + step) - angle
            angle = angle + move
            if np.all(np.abs(move) <= _TINY):
                break
            found = motion(angle)
        turns = (np.abs(move) <= _TINY) & (sign * found.second < 0)
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
    kinks: Array | None = None,
) -> list[Extreme]:
    """Extremes of each curve, the largest value for a sign of +1, the smallest for −1."""
    grid = turn_grid() if grid is None else grid
    step = float(grid[1] - grid[0])
    with np.errstate(all="ignore"):
        known = curve(grid) if samples is None else samples
        place = _candidates(known, signs)
        top = _zoomed(curve, known, place, grid, signs, kinks)
        if slope is not None:
            polished = _polished(slope, top, np.repeat(signs, _CANDIDATES))
            is_rough = np.isnan(polished) & ~np.isnan(top.angle)
            if np.any(is_rough):
                start = grid[place]
                root = bracketed_roots(slope, start - step, start + step)
                top = _chosen(is_rough & ~np.isnan(root), Extreme(root, curve(root)), top)
            top = Extreme(np.where(np.isnan(polished), top.angle, polished), top.value)
        return _best(*top, _scale(known), signs)


def _candidates(samples: Array, signs: Sequence[float]) -> NDArray[np.intp]:
    """Places of the two highest peaks of each curve round the turn, the higher first, (..., sign · candidate).

    Of a curve with one peak, or none, the same place twice.
    """
    known = np.fmax(np.stack([sign * samples for sign in signs]), -np.inf)
    ring = np.concatenate([known[..., -1:], known, known[..., :1]], axis=-1)
    is_peak = (known > ring[..., :-2]) & (known >= ring[..., 2:])
    heights = np.where(is_peak, known, -np.inf).reshape(-1, known.shape[-1])
    row = np.arange(len(heights))
    first: NDArray[np.intp] = np.argmax(heights, axis=-1)
    heights[row, first] = -np.inf
    lower: NDArray[np.intp] = np.argmax(heights, axis=-1)
    second: NDArray[np.intp] = np.where(heights[row, lower] > -np.inf, lower, first)
    return np.concatenate([*np.stack([first, second], axis=-1).reshape(*known.shape[:-1], _CANDIDATES)], axis=-1)


def _zoomed(
    curve: Curve,
    samples: Array,
    place: NDArray[np.intp],
    grid: Array,
    signs: Sequence[float],
    kinks: Array | None = None,
) -> Extreme:
    """Tops of quartics through five close points about the top of one through five of the grid; or kinks."""
    sign = np.repeat(signs, _CANDIDATES)
    step, peak = float(grid[1] - grid[0]), grid[place]
    five = _five(samples, place)
    wide = _top_of_quartic(five, sign)
    middle = peak + step * wide.way
    points = (middle[..., np.newaxis, :] + _CLOSE * _FIVE).reshape(*place.shape[:-1], 5 * place.shape[-1])
    n_points = points.shape[-1]
    values = curve(points if kinks is None else np.concatenate([points, kinks], axis=-1))
    found = _top_of_quartic(values[..., :n_points].reshape(*values.shape[:-1], *five.shape[-2:]), sign)
    top = Extreme(middle + _CLOSE * found.way, found.value)
    is_rough = (np.abs(found.way) >= 1) | (np.abs(found.way - found.parabola) > _SMOOTH)
    if np.any(is_rough):
        # At a jump nothing beside the grid's own point may be as high.
        top = _chosen(is_rough, Extreme(peak, five[..., 2, :]), top)
        if kinks is not None:
            period = step * len(grid)
            apart = np.mod(peak[..., np.newaxis] - kinks[..., np.newaxis, :] + period / 2, period) - period / 2
            is_rough = is_rough & ~np.any(np.abs(apart) <= 2 * step, axis=-1)
    if np.any(is_rough):
        start = np.where(is_rough, peak + step * wide.parabola, top.angle)
        closest = _closest(curve, start, np.where(is_rough, step, _CLOSEST), sign)
        top = _chosen(is_rough & (sign * (closest.value - top.value) > 0), closest, top)
    return top if kinks is None else _or_kink(top, kinks, values[..., n_points:], sign)


def _five(samples: Array, place: NDArray[np.intp]) -> Array:
    """Samples about some places round the turn, from two before to two after, shape (..., 5, k)."""
    around = (place[..., np.newaxis, :] + _FIVE.astype(np.intp)) % samples.shape[-1]
    flat = around.reshape(*place.shape[:-1], 5 * place.shape[-1])
    return np.take_along_axis(samples, flat, axis=-1).reshape(around.shape)


def _polished(slope: Curve, top: Extreme, sign: Array) -> Array:
    """Angle of the top by one step of Newton's method, to rounding; NaN where that is no tiny one.

    A slope that is NaN is not known, and leaves the angle.
    """
    three = slope(np.concatenate([top.angle - _ASIDE, top.angle, top.angle + _ASIDE], axis=-1))
    before, at, after = np.split(three, 3, axis=-1)
    curvature = (after - before) / (2 * _ASIDE)
    move = -at / curvature
    is_tiny = (np.abs(move) <= _TINY) & (sign * curvature < 0)
    return np.where(np.isnan(at), top.angle, np.where(is_tiny, top.angle + move, np.nan))


def _closest(curve: Curve, middle: Array, wide: Array, sign: Array) -> Extreme:
    """Tops of parabolas through three ever closer points, where the curve is rough or a peak narrow."""
    before, half = wide, np.maximum(wide / _CLOSER, _CLOSEST)
    value = np.full_like(middle, np.nan)
    for _ in range(_MOST_ZOOMS):
        points = middle[..., np.newaxis, :] + half[..., np.newaxis, :] * _FIVE[1:4]
        found = curve(points.reshape(*middle.shape[:-1], 3 * middle.shape[-1]))
        top = _top(found.reshape(*found.shape[:-1], *points.shape[-2:]), sign)
        middle, value = middle + half * top.way, top.value
        if not np.any(half > 2 * _CLOSEST):
            break
        # What a parabola's top is off by goes with the square of its width; four times that is wide enough.
        width = np.minimum(4 * np.abs(top.way) * half * (half / before) ** 2, half / _CLOSER)
        before, half = half, np.maximum(width, _CLOSEST)
    return Extreme(middle, value)


def _or_kink(top: Extreme, kinks: Array, values: Array, sign: Array) -> Extreme:
    """Take the highest kink where it is higher than the top."""
    signed = np.fmax(sign[:, np.newaxis] * values[..., np.newaxis, :], -np.inf)
    highest = np.argmax(signed, axis=-1)
    kink = Extreme(
        *(np.take_along_axis(part, highest, axis=-1) for part in (np.broadcast_to(kinks, values.shape), values))
    )
    return _chosen(sign * (kink.value - top.value) > 0, kink, top)


def _chosen(is_one: NDArray[np.bool_], one: Extreme, other: Extreme) -> Extreme:
    """Take one extreme where so said, else the other."""
    return Extreme(*(np.where(is_one, *parts) for parts in zip(one, other, strict=True)))


class _Top(NamedTuple):
    """Top of a curve through equally spaced points: way to it from the middle one, in parts of the distance; value.

    And the way to the top of the parabola through the middle three.
    """

    way: Array
    value: Array
    parabola: Array


def _top(three: Array, sign: Array) -> _Top:
    """Top of the parabola through three points, (..., 3, k), no farther than these; NaN where one is."""
    left, centre, right = (three[..., place, :] for place in range(3))
    curvature, slope = left - 2 * centre + right, (right - left) / 2
    # A parabola that opens the wrong way has its top at an end.
    way = np.where(sign * curvature < 0, -slope / curvature, np.sign(sign * slope))
    way = np.minimum(np.maximum(way, -1.0), 1.0)
    return _Top(way, centre + (slope + curvature / 2 * way) * way, way)


def _top_of_quartic(five: Array, sign: Array) -> _Top:
    """Top of the polynomial through five points, (..., 5, k), by Newton's method from the parabola's.

    Stirling's formula. The parabola's where there are not five.
    """
    far_left, left, centre, right, far_right = (five[..., place, :] for place in range(5))
    first, second = (right - left) / 2, left - 2 * centre + right
    third, fourth = (far_right - far_left) / 2 - (right - left), far_left + far_right - 4 * (left + right) + 6 * centre
    start = _top(five[..., 1:4, :], sign)
    way = start.way
    for _ in range(2):
        square = way * way
        slope = first + way * second + (3 * square - 1) / 6 * third + (2 * square - 1) * way / 12 * fourth
        way = way - slope / (second + way * third + (6 * square - 1) / 12 * fourth)
        way = np.minimum(np.maximum(way, -1.0), 1.0)
    square = way * way
    value = centre + way * first + square / 2 * (second + (square - 1) / 12 * fourth) + (square - 1) * way / 6 * third
    is_known = ~np.isnan(way)
    return _Top(np.where(is_known, way, start.way), np.where(is_known, value, start.value), start.way)


def _scale(samples: Array) -> Array:
    """Largest absolute value of each curve, shape (..., 1)."""
    return np.fmax.reduce(np.abs(samples), axis=-1, keepdims=True, initial=0.0)


def _best(angle: Array, value: Array, scale: Array, signs: Sequence[float]) -> list[Extreme]:
    """Take the better of both candidates for each sign; NaN where the grid's best one could not be refined.

    Of two that are alike but for rounding, the first in the turn.
    """
    angles, values = (part.reshape(*part.shape[:-1], len(signs), _CANDIDATES) for part in (angle, value))
    gain = np.asarray(signs) * (values[..., 1] - values[..., 0])
    is_alike = np.abs(gain) <= _ALIKE * scale
    is_second = np.where(is_alike, angles[..., 1] < angles[..., 0], gain > 0)
    best_angle = np.where(is_second, angles[..., 1], angles[..., 0])
    best_value = np.where(gain > 0, values[..., 1], values[..., 0])
    return [Extreme(best_angle[..., [place]], best_value[..., [place]]) for place in range(len(signs))]


def unwrapped(angle: Array) -> Array:
    """Angles without jumps of a turn along the last axis, across NaN too. [rad]"""
    place: NDArray[np.intp] = np.where(np.isnan(angle), 0, np.arange(angle.shape[-1], dtype=np.intp))
    last_known: Array = np.take_along_axis(angle, np.maximum.accumulate(place, axis=-1), axis=-1)
    turns = np.cumsum(np.nan_to_num(np.rint(np.diff(last_known, axis=-1) / (2 * np.pi))), axis=-1)
    return np.concatenate([angle[..., :1], angle[..., 1:] - 2 * np.pi * turns], axis=-1)


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


DERIVATIVES_LIMIT = 1e-8
"""What rounding leaves of `derivatives_residual` for a machine within a millionth of locking; 1e-12 for most others."""


def derivatives_residual(motion: Callable[[Array], Coefficient], samples: Coefficient | None = None) -> Array:
    """Compare both derivatives of a periodic motion with those of the Fourier series of its value and its first one.

    Parameters
    ----------
    motion : callable
        From angles (n,) to a Coefficient of shape (..., n).
    samples : Coefficient, shape (..., 720), optional
        Where it is known on `turn_grid()` already.

    Returns
    -------
    Array, shape (..., 1)
        Largest difference over a turn, in parts of the derivative's own peak; NaN where the motion is NaN.

    Notes
    -----
    The nearer a machine is to locking, the sharper its curves: the series is made longer until the residual is small,
    if it can be.
    """
    residual = np.empty(())
    with np.errstate(all="ignore"):
        for n_points in _SERIES_LENGTHS:
            if samples is not None and n_points == samples.value.shape[-1]:
                value, first, second = samples
            else:
                value, first, second = motion(turn_grid(n_points))
            residual = np.maximum(
                _relative(spectral_derivative(value) - first, first),
                _relative(spectral_derivative(first) - second, second),
            )
            if not np.any(residual > DERIVATIVES_LIMIT):
                break
    return residual


def _relative(difference: Array, scale: Array) -> Array:
    """Largest |difference| over the last axis, which is kept, in parts of the scale's peak there."""
    return np.max(np.abs(difference), axis=-1, keepdims=True) / np.max(np.abs(scale), axis=-1, keepdims=True)
