"""What balances a machine at a wanted mean speed, where torques depend on the speed."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import ONE, ZERO, Array
from cranktrain.numerics import bracketed_roots
from cranktrain.numerics.harmonics import TURN
from cranktrain.questions.evenness.speed_law import Power, SpeedUnderLaw, TorqueLaw, energy_under_law, speed_under_law
from cranktrain.questions.evenness.speed_over_cycle import Mean, mean_speed_of

_NO_MEAN, _NO_WORK = 1e-9, 1e-14
"""A mean torque of less than this part of the peak, or of the energy that it would change, is rounding."""
_SPREADS = (1.02, 1.3, 4.0)
"""By how much a torque at the mean speed may differ from its mean: first as little as in most machines, as too light a
shaft stops where that is much."""
_NOTHING = 1e-12
"""Of the largest load that may be: a load of less is none."""


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


def balancing_coefficient(
    law: TorqueLaw,
    shape: Power | None,
    inertia: Array,
    mean_speed: Array,
    cycle: float = TURN,
    mean: Mean = "time",
    *,
    under: Callable[[TorqueLaw], SpeedUnderLaw] | None = None,
) -> Array:
    """Coefficient k with which a load of a shape balances all other torques, at a mean speed.

    Parameters
    ----------
    law : TorqueLaw
        Of all other torques, on the grid of a cycle; it, or the shape, has to depend on the speed.
    shape : Power or None
        Torque that resists, for k = 1; None for a constant one, 1 N·m.
    inertia : Array, shape (..., n)
        [kg·m²]
    mean_speed : Array, shape (...)
        [rad/s]
    cycle : float
        [rad]
    mean : Mean
        Which mean is given.
    under : callable, optional
        Gives the speed under a law, where it is not by series on the grid.

    Returns
    -------
    Array, shape (...)
        NaN where there is none: where a load that rises with the speed would have to drive, or nothing has a mean.

    Notes
    -----
    The mean of kωᵖ over the angle is that of the other torques exactly, so k lies near what it is at an even speed.
    docs/theory/evenness, eq. (17.11).
    """
    wanted = np.asarray(mean_speed, dtype=float)[..., np.newaxis]
    free = np.mean(law.free, axis=-1, keepdims=True) + 0.0 * wanted
    braked = -(law._replace(free=ZERO)).torque(wanted)
    unit = ONE if shape is None else shape.torque(wanted)

    def within(spread: float) -> tuple[Array, Array]:
        """The least and the largest that it may be."""
        each = (1 / spread, spread)
        of_shape = (1.0,) if shape is None else each
        ends = np.stack([(free - part * braked) / (unit * own) for part in each for own in of_shape])
        low, high = np.min(ends, axis=0), np.max(ends, axis=0)
        return (low, high) if shape is None else (np.where(high > 0, np.maximum(low, _NOTHING * high), np.nan), high)

    def missing(coefficient: Array) -> Array:
        whole = with_load(law, shape, coefficient)
        if under is not None:
            found = getattr(under(whole).speed.means, mean)
        elif mean == "extremes":
            found = speed_under_law(whole, inertia, cycle).speed.means.extremes
        else:
            found = mean_speed_of(2 * energy_under_law(whole, inertia, cycle) / inertia, mean)
        return found[..., np.newaxis] - wanted

    found = np.full_like(free, np.nan)
    for spread in _SPREADS:
        if np.any(np.isnan(found)):
            beyond = bracketed_roots(missing, *np.broadcast_arrays(*within(spread)))
            found = np.where(np.isnan(found), beyond, found)
    return found[..., 0]


def with_load(law: TorqueLaw, shape: Power | None, coefficient: Array) -> TorqueLaw:
    """A law with a load of a shape, shape (..., 1) of the coefficient."""
    if shape is None:
        return law._replace(free=law.free - coefficient)
    return law._replace(powers=(*law.powers, Power(-coefficient * shape.coefficient, shape.exponent)))
