"""Load for a wanted mean speed, where it rises with the speed squared."""

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics import bracketed_roots
from cranktrain.numerics.harmonics import TURN
from cranktrain.questions.evenness.speed_law import TorqueLaw, energy_under_law, speed_under_law
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

    def missing(coefficient: Array) -> Array:
        law = TorqueLaw(driving, quadratic=-coefficient)
        if mean == "extremes":
            found = speed_under_law(law, inertia, cycle).speed.means.extremes
        else:
            found = grid_mean(2 * energy_under_law(law, inertia, cycle) / inertia, mean)
        return found[..., np.newaxis] - wanted

    return bracketed_roots(missing, *np.broadcast_arrays(near / _SPREAD, near * _SPREAD))[..., 0]
