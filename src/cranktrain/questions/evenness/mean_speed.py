"""Load or motor for a wanted mean speed, where the torques depend on the speed."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics import bracketed_roots
from cranktrain.numerics.harmonics import TURN
from cranktrain.questions.evenness.speed_law import (
    TorqueLaw,
    energy_under_law,
    given_torque,
    motor,
    quadratic_load,
    speed_under_law,
    together,
)
from cranktrain.questions.evenness.speed_over_cycle import Mean, grid_mean

_NO_MEAN, _NO_WORK = 1e-9, 1e-14
"""A mean torque of less than this part of the peak, or of the energy that it would change, is rounding."""
_SPREAD = 4.0
"""By how much, at most, the squares of two means of a speed are thought to differ."""


def has_mean(driving: Array, inertia: Array, mean_speed: Array) -> NDArray[np.bool_]:
    """Whether a torque has a mean, so that a load can take it.

    Parameters
    ----------
    driving, inertia : Array, shape (..., n)
        On the grid of a cycle. [N·m, kg·m²]
    mean_speed : Array, shape (...)
        [rad/s]

    Returns
    -------
    array of bool, shape (...)
        False where the mean is rounding beside the torque's peak, what moving parts hand over or the energy that turns.
    """
    square = mean_speed**2
    peak = np.maximum(np.max(np.abs(driving), axis=-1), np.ptp(inertia, axis=-1) * square)
    least = np.maximum(_NO_MEAN * peak, _NO_WORK * np.max(inertia, axis=-1) * square)
    return np.asarray(~(np.abs(np.mean(driving, axis=-1)) <= least))


def quadratic_coefficient(
    driving: Array, inertia: Array, mean_speed: Array, cycle: float = TURN, mean: Mean = "time"
) -> Array:
    """Coefficient k of a load kω² with which a driving torque gives a mean speed.

    Parameters
    ----------
    driving, inertia : Array, shape (..., n)
        On the grid of a cycle. [N·m, kg·m²]
    mean_speed : Array, shape (...)
        [rad/s]
    cycle : float
        [rad]
    mean : Mean
        Which mean is given.

    Returns
    -------
    Array, shape (...)
        [N·m·s²]; NaN where there is none: of a torque that drives nothing, and of one without a mean.

    Notes
    -----
    The mean of ω² over the angle is M̄_d/k exactly, so k lies near M̄_d/ω². docs/theory/evenness, eq. (17.11).
    """
    wanted = np.asarray(mean_speed, dtype=float)[..., np.newaxis]
    near = np.mean(driving, axis=-1, keepdims=True) / wanted**2
    near = np.where(has_mean(driving, inertia, wanted[..., 0])[..., np.newaxis] & (near > 0), near, np.nan)

    def law(coefficient: Array) -> TorqueLaw:
        return together(given_torque(driving), quadratic_load(coefficient))

    return _at_mean(law, near / _SPREAD, near * _SPREAD, inertia, wanted, cycle, mean)


def no_load_speed(
    load: Array, stiffness: Array, inertia: Array, mean_speed: Array, cycle: float = TURN, mean: Mean = "time"
) -> Array:
    """No-load speed ω_s of a linear motor M = c (ω_s − ω) that drives a load curve at a mean speed.

    Parameters
    ----------
    load, inertia : Array, shape (..., n)
        Load torque, positive where it resists, and J(φ), on the grid of a cycle. [N·m, kg·m²]
    stiffness : Array, shape (...)
        c. [N·m·s]
    mean_speed : Array, shape (...)
        [rad/s]
    cycle : float
        [rad]
    mean : Mean
        Which mean is given.

    Returns
    -------
    Array, shape (...)
        [rad/s]; NaN where there is none.

    Notes
    -----
    The mean of ω over the angle is ω_s − M̄/c exactly. docs/theory/evenness, eq. (17.11).
    """
    wanted = np.asarray(mean_speed, dtype=float)[..., np.newaxis]
    spring = np.asarray(stiffness, dtype=float)[..., np.newaxis]
    slip = np.mean(load, axis=-1, keepdims=True) / spring

    def law(speed: Array) -> TorqueLaw:
        return together(given_torque(-load), motor(speed, spring))

    return _at_mean(law, wanted / 2 + slip, 2 * wanted + slip, inertia, wanted, cycle, mean)


def _at_mean(
    law: Callable[[Array], TorqueLaw], low: Array, high: Array, inertia: Array, wanted: Array, cycle: float, mean: Mean
) -> Array:
    """Parameter of a law that gives the mean speed wanted, between two values."""

    def missing(parameter: Array) -> Array:
        if mean == "extremes":
            found = speed_under_law(law(parameter), inertia, cycle).speed.means.extremes
        else:
            found = grid_mean(2 * energy_under_law(law(parameter), inertia, cycle) / inertia, mean)
        return found[..., np.newaxis] - wanted

    return bracketed_roots(missing, *np.broadcast_arrays(low, high))[..., 0]
