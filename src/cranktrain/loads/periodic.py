"""Periodic curves between the points of their grid, by Fourier series or periodic spline, with slope and integral."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from cranktrain.loads.harmonics import TURN, curve, from_vectors, harmonics
from cranktrain.motion import Array
from cranktrain.numerics import Curve, Extremes, extremes


class PeriodicCurve(NamedTuple):
    """A periodic curve, known at equal steps and to be asked anywhere.

    A kernel's own value and first derivative make one as well.

    Attributes
    ----------
    cycle : float
        Its period. [rad]
    samples : Array, shape (..., n)
        Values at 0, cycle/n, …
    value, slope : callable
        Value and slope at angles (k,) or (..., k).
    """

    cycle: float
    samples: Array
    value: Curve
    slope: Curve

    @property
    def angle(self) -> Array:
        """Angles of the samples, shape (n,). [rad]"""
        return cycle_grid(self.samples.shape[-1], self.cycle)


Interpolation = Callable[[Array, float], PeriodicCurve]
"""From samples at equal steps over a cycle, endpoint excluded, and the cycle, to a curve."""


def cycle_grid(n_points: int, cycle: float = TURN) -> Array:
    """One cycle in equal steps, endpoint excluded. [rad]"""
    return np.arange(n_points, dtype=np.float64) * (cycle / n_points)


def fourier_curve(samples: Array, cycle: float = TURN) -> PeriodicCurve:
    """Curve through samples (..., n) by their Fourier series: exact for a smooth one."""
    series = harmonics(samples, cycle)
    derivative = from_vectors(series.order, 1j * series.order * series.vectors)

    def value(angle: Array) -> Array:
        return curve(series, angle)

    def slope(angle: Array) -> Array:
        return curve(derivative, angle)

    return PeriodicCurve(cycle, samples, value, slope)


def fourier_integral(samples: Array, cycle: float = TURN) -> PeriodicCurve:
    """Integral of samples (..., n) less their mean, from φ = 0, by their Fourier series.

    Notes
    -----
    Each order divided by ik: no rule of quadrature has a part in it. docs/theory/evenness, eq. (17.3).
    """
    n_points = samples.shape[-1]
    order = np.arange(n_points // 2 + 1, dtype=float) * (TURN / cycle)
    moving = order > 0
    if n_points % 2 == 0:
        moving[-1] = False  # the highest cosine's integral is seen only at its zeros
    factor = np.where(moving, -1j / np.where(moving, order, 1.0), 0.0)
    integral = np.fft.irfft(np.fft.rfft(samples, axis=-1) * factor, n_points, axis=-1)
    return fourier_curve(integral - integral[..., :1], cycle)


def spline_curve(samples: Array, cycle: float = TURN) -> PeriodicCurve:
    """Periodic cubic spline through samples (..., n): for a curve with kinks, which a series would ring at.

    Notes
    -----
    The slopes at the nodes solve s₋ + 4s + s₊ = 3(y₊ − y₋)/h, a circulant system, through its Fourier transform.
    """
    return hermite_curve(samples, _spline_slopes(samples, cycle / samples.shape[-1]), cycle)


def hermite_curve(samples: Array, slopes: Array, cycle: float = TURN) -> PeriodicCurve:
    """Cubics through samples (..., n) with given slopes (..., n) there: continuous with its slope."""
    step = cycle / samples.shape[-1]
    nodes = np.stack([samples, slopes])

    def value(angle: Array) -> Array:
        (y0, s0), (y1, s1), t = _piece(nodes, angle, step)
        return y0 * (1 + 2 * t) * (1 - t) ** 2 + y1 * t**2 * (3 - 2 * t) + step * t * (1 - t) * (s0 * (1 - t) - s1 * t)

    def slope(angle: Array) -> Array:
        (y0, s0), (y1, s1), t = _piece(nodes, angle, step)
        return 6 * t * (1 - t) * (y1 - y0) / step + s0 * (1 - t) * (1 - 3 * t) + s1 * t * (3 * t - 2)

    return PeriodicCurve(cycle, samples, value, slope)


def spline_integral(samples: Array, cycle: float = TURN) -> PeriodicCurve:
    """Integral of samples (..., n) less their mean, from φ = 0, exact for their periodic cubic spline."""
    step = cycle / samples.shape[-1]
    centred = samples - np.mean(samples, axis=-1, keepdims=True)
    slopes = _spline_slopes(centred, step)
    after, slopes_after = np.roll(centred, -1, axis=-1), np.roll(slopes, -1, axis=-1)
    pieces = step * (centred + after) / 2 + step**2 * (slopes - slopes_after) / 12
    starts = np.concatenate([np.zeros_like(pieces[..., :1]), np.cumsum(pieces, axis=-1)[..., :-1]], axis=-1)
    nodes = np.stack([centred, slopes, starts])
    spline = spline_curve(centred, cycle)

    def value(angle: Array) -> Array:
        (y0, s0, start), (y1, s1, _), t = _piece(nodes, angle, step)
        rise = y1 - y0
        square = t**2
        inside = y0 * t + s0 * step * square / 2
        inside = inside + (3 * rise - step * (2 * s0 + s1)) * square * t / 3
        inside = inside + (step * (s0 + s1) - 2 * rise) * square**2 / 4
        return start + step * inside

    return PeriodicCurve(cycle, starts, value, spline.value)


def plus(one: PeriodicCurve, constant: Array) -> PeriodicCurve:
    """The curve raised by a constant of shape (...)."""
    raised = np.asarray(constant)[..., np.newaxis]

    def value(angle: Array) -> Array:
        return one.value(angle) + raised

    return PeriodicCurve(one.cycle, one.samples + raised, value, one.slope)


def combined(one: PeriodicCurve, factor: Array, other: PeriodicCurve) -> PeriodicCurve:
    """The first curve plus a factor, shape (...), times the second; both on one grid."""
    times = np.asarray(factor)[..., np.newaxis]

    def value(angle: Array) -> Array:
        return one.value(angle) + times * other.value(angle)

    def slope(angle: Array) -> Array:
        return one.slope(angle) + times * other.slope(angle)

    return PeriodicCurve(one.cycle, one.samples + times * other.samples, value, slope)


def curve_extremes(one: PeriodicCurve) -> Extremes:
    """Smallest and largest value over the cycle, refined between the samples; shapes (..., 1)."""
    return extremes(one.value, one.slope, grid=one.angle, samples=one.samples)


def _spline_slopes(samples: Array, step: float) -> Array:
    """Slopes of the periodic cubic spline at its nodes."""
    n_points = samples.shape[-1]
    turn = np.arange(n_points // 2 + 1, dtype=float) * (TURN / n_points)
    transfer = 3j * np.sin(turn) / (step * (2 + np.cos(turn)))
    return np.fft.irfft(transfer * np.fft.rfft(samples, axis=-1), n_points, axis=-1)


def _piece(nodes: Array, angle: Array, step: float) -> tuple[Array, Array, Array]:
    """What is known of the nodes, (k, ..., n), at both ends of the piece that holds an angle, and its share of it."""
    lead, n_points = nodes.shape[1:-1], nodes.shape[-1]
    place = np.floor(angle / step)
    # Of an angle that is NaN any piece will do, as its share is NaN.
    before = np.fmax(np.mod(place, n_points), 0.0).astype(np.intp)
    rows = np.reshape(np.arange(nodes[0, ..., 0].size) * n_points, (*lead, 1))
    flat = np.reshape(nodes, (nodes.shape[0], -1))
    return flat[:, before + rows], flat[:, np.mod(before + 1, n_points) + rows], angle / step - place
