"""Grids of a turn, and curves by their Fourier series."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array, Coefficient

_SERIES_LENGTHS = (720, 5760, 46080, 368640)
"""Points of a turn for a Fourier series."""
_LAST_DIGITS = 1e-4
"""Of a curve's peak: a derivative is shown to 10⁻¹² of what is derived, however small it is itself."""


def turn_grid(n_points: int = 720) -> Array:
    """One turn of the crank in equal steps, endpoint excluded. [rad]"""
    return np.arange(n_points, dtype=np.float64) * (2 * np.pi / n_points)


def around_zero(angle: Array, period: float = 2 * np.pi) -> Array:
    """Bring angles into the period whose middle is 0: into [−π, π) unless said. [rad]"""
    return np.mod(angle + period / 2, period) - period / 2


def slower_over_faster(travel: Array) -> Array:
    """Way of the slower part of a turn over that of the faster one, where one part is a travel of any sense. [rad]"""
    there = np.mod(travel, 2 * np.pi)
    slower = np.maximum(there, 2 * np.pi - there)
    return slower / (2 * np.pi - slower)


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


_FEW_DIGITS = 1e-6
"""What rounding may leave of a motion that is sharper than a turn's 720 points show."""


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
        Largest difference over a turn, in parts of the derivative's own peak, or of 10⁻⁴ of the peak of what is
        derived; NaN where the motion is NaN, infinite where it is beyond the digits of the longest series.

    Notes
    -----
    The nearer a machine is to locking, the sharper its curves: the series is made longer until the residual is small,
    if it can be.
    """
    residual = second = np.array(np.nan)
    is_sharp: NDArray[np.bool_] = np.zeros((), dtype=bool)
    with np.errstate(all="ignore"):
        for n_points in _SERIES_LENGTHS:
            if samples is not None and n_points == samples.value.shape[-1]:
                value, first, second = samples
            else:
                value, first, second = motion(turn_grid(n_points))
            found = np.maximum(
                _relative(spectral_derivative(value) - first, first, value),
                _relative(spectral_derivative(first) - second, second, first),
            )
            # A longer series shows sharper curves, and more of the rounding of those that are smooth.
            residual = np.where(np.isnan(found), np.nan, np.fmin(residual, found))
            if not np.any(residual > DERIVATIVES_LIMIT):
                return residual
            if n_points == _SERIES_LENGTHS[0]:
                is_sharp = ~has_ended(second, DERIVATIVES_LIMIT)
        # What only a longer series shows has fewer digits itself, the nearer to locking the fewer.
        is_beyond = ~has_ended(second, DERIVATIVES_LIMIT) | (is_sharp & (residual < _FEW_DIGITS))
        return np.where((residual > DERIVATIVES_LIMIT) & is_beyond, np.inf, residual)


def has_ended(samples: Array | NDArray[np.complex128], least: float) -> NDArray[np.bool_]:
    """Whether the highest orders that a grid shows of a curve are nothing beside the others.

    Parameters
    ----------
    samples : array of float or complex, shape (..., n)
        Over one turn, endpoint excluded; a curve that has gaps has no orders, and its last ones are nothing.
    least : float
        What is nothing, in parts of the largest order.

    Returns
    -------
    array of bool, shape (..., 1)
    """
    n_points = samples.shape[-1]
    size = np.abs(np.fft.fft(samples, axis=-1))
    tail = np.max(size[..., 7 * n_points // 16 : 9 * n_points // 16], axis=-1, keepdims=True)
    return ~(tail > least * np.max(size, axis=-1, keepdims=True))


def _relative(difference: Array, derivative: Array, derived: Array) -> Array:
    """Largest |difference| over the last axis, which is kept, in parts of the derivative's peak there."""
    peak, slope, value = (np.abs(curve).max(axis=-1, keepdims=True) for curve in (difference, derivative, derived))
    scale = np.maximum(slope, _LAST_DIGITS * value)
    return peak / np.where(scale == 0, 1.0, scale)
