"""Flywheel for a wanted coefficient of fluctuation: exact, and as Mertsalov and the textbooks have it."""

from typing import NamedTuple

import numpy as np

from cranktrain.loads.excess_work import ExcessWork
from cranktrain.loads.periodic import PeriodicCurve, combined, curve_extremes, plus
from cranktrain.loads.speed import Mean, grid_mean, speed_from_energy, steady_speed
from cranktrain.motion import Array
from cranktrain.numerics import Extreme, corrected_roots, largest, smallest


class Flywheel(NamedTuple):
    """Flywheel that gives the wanted fluctuation.

    Attributes
    ----------
    inertia : Array, shape (...)
        J_f beside the moving parts' own; negative where these alone run more evenly than is asked. [kg·m²]
    initial_energy : Array, shape (...)
        E₀, kinetic energy at φ = 0 with it. [J]
    largest_speed, smallest_speed : Array, shape (...)
        [rad/s]
    upper, lower : Extreme, shapes (..., 1)
        Largest value of A − ½ω_M² J_v and smallest of A − ½ω_m² J_v: where the speed has its extremes. [rad, J]
    """

    inertia: Array
    initial_energy: Array
    largest_speed: Array
    smallest_speed: Array
    upper: Extreme
    lower: Extreme

    @property
    def flywheel_moment(self) -> Array:
        """GD² = 4 J. [kg·m²]"""
        return 4 * self.inertia


class FlywheelByMethod(NamedTuple):
    """Flywheels by each method; arrays of shape (..., 3): exact, Mertsalov, textbook.

    Attributes
    ----------
    exact : Flywheel
    inertia : Array
        [kg·m²]
    error : Array
        In parts of the exact one. [1]
    fluctuation : Array
        What each flywheel really gives at the same mean speed. [1]
    """

    exact: Flywheel
    inertia: Array
    error: Array
    fluctuation: Array


METHODS = ("exact", "mertsalov", "textbook")


def exact_flywheel(
    excess: ExcessWork, inertia: PeriodicCurve, mean_speed: Array, fluctuation: Array, mean: Mean = "time"
) -> Flywheel:
    """Flywheel for a coefficient of fluctuation δ = (ω_M − ω_m)/mean, exact for any variable inertia.

    Parameters
    ----------
    excess : ExcessWork
        With A(φ). [J]
    inertia : PeriodicCurve
        J_v(φ) of the moving parts, without the flywheel. [kg·m²]
    mean_speed : Array, shape (...)
        [rad/s]
    fluctuation : Array, shape (...)
        δ, below 2. [1]
    mean : Mean
        Which mean is given, for the speed and for δ. For "extremes" the answer is explicit.

    Returns
    -------
    Flywheel

    Notes
    -----
    J_f = 2 [max(A − ½ω_M² J_v) − min(A − ½ω_m² J_v)] / (ω_M² − ω_m²): Wittenbauer's tangents in algebra.
    docs/theory/evenness, eqs. (17.7) and (17.8).
    """
    wanted, delta = np.broadcast_arrays(np.asarray(mean_speed, dtype=float), np.asarray(fluctuation, dtype=float))
    half = wanted * delta / 2
    if mean == "extremes":
        return _between(excess, inertia, wanted - half, wanted + half)

    stored, carried = excess.work.samples, inertia.samples

    def off(size: Array, energy: Array) -> Array:
        square = 2 * (stored + energy[..., np.newaxis]) / (carried + size[..., np.newaxis])
        return (grid_mean(square, mean) - wanted)[..., np.newaxis]

    def missing(middle: Array) -> Array:
        found = _between(excess, inertia, middle[..., 0] - half, middle[..., 0] + half)
        return off(found.inertia, found.initial_energy)

    def missing_on_grid(middle: Array) -> Array:
        slow, fast = (middle - half[..., np.newaxis]) ** 2 / 2, (middle + half[..., np.newaxis]) ** 2 / 2
        upper = np.max(stored - fast * carried, axis=-1)
        size = (upper - np.min(stored - slow * carried, axis=-1)) / (fast - slow)[..., 0]
        return off(size, fast[..., 0] * size - upper)

    # The smallest speed is not negative: its square would be that of another.
    ends = np.maximum(wanted - half, half)[..., np.newaxis], (wanted + half)[..., np.newaxis]
    middle = corrected_roots(missing, missing_on_grid, *ends)[..., 0]
    return _between(excess, inertia, middle - half, middle + half)


def mertsalov_inertia(excess: ExcessWork, inertia: PeriodicCurve, mean_speed: Array, fluctuation: Array) -> Array:
    """Flywheel by Mertsalov's method: the moving parts' energy at the mean speed. [kg·m²], shape (...)

    Notes
    -----
    docs/theory/evenness, eq. (17.9).
    """
    low, high = curve_extremes(combined(excess.work, -(mean_speed**2) / 2, inertia))
    return (high.value - low.value)[..., 0] / (fluctuation * mean_speed**2)


def textbook_inertia(excess: ExcessWork, mean_speed: Array, fluctuation: Array) -> Array:
    """J = ΔA/(δω²), all inertia that must turn evenly, the moving parts' being neglected. [kg·m²], shape (...)

    Notes
    -----
    Exact where no inertia varies and the speed is the extremes' mean. docs/theory/evenness, eq. (17.10).
    """
    return excess.difference / (fluctuation * mean_speed**2)


def flywheels_by_method(
    excess: ExcessWork,
    inertia: PeriodicCurve,
    mean_speed: Array,
    fluctuation: Array,
    mean: Mean = "extremes",
) -> FlywheelByMethod:
    """Exact, Mertsalov's and the textbooks' flywheel for the same δ, all at the same mean speed.

    Parameters
    ----------
    excess : ExcessWork
    inertia : PeriodicCurve
        J_v(φ) of the moving parts. [kg·m²]
    mean_speed : Array, shape (...)
        [rad/s]
    fluctuation : Array, shape (...)
        δ. [1]
    mean : Mean
        Which mean is given; the two approximations mean that of the extremes, and take any for it.

    Returns
    -------
    FlywheelByMethod, shape (..., 3)
    """
    speed = np.asarray(mean_speed, dtype=float)
    exact = exact_flywheel(excess, inertia, speed, fluctuation, mean)
    sizes = (
        exact.inertia,
        mertsalov_inertia(excess, inertia, speed, fluctuation),
        textbook_inertia(excess, speed, fluctuation),
    )
    found = [
        speed_from_energy(plus(excess.work, exact.initial_energy), plus(inertia, exact.inertia)),
        *(steady_speed(excess, plus(inertia, size), speed, mean).speed for size in sizes[1:]),
    ]
    stacked = np.stack(np.broadcast_arrays(*sizes), axis=-1)
    return FlywheelByMethod(
        exact,
        stacked,
        stacked / stacked[..., :1] - 1,
        np.stack([speed.fluctuation(mean) for speed in found], axis=-1),
    )


def _between(excess: ExcessWork, inertia: PeriodicCurve, slowest: Array, fastest: Array) -> Flywheel:
    """Flywheel with which the speed runs just between two speeds."""
    over = combined(excess.work, -(fastest**2) / 2, inertia)
    under = combined(excess.work, -(slowest**2) / 2, inertia)
    upper = largest(over.value, over.slope, grid=over.angle, samples=over.samples)
    lower = smallest(under.value, under.slope, grid=under.angle, samples=under.samples)
    apart = (fastest - slowest) * (fastest + slowest) / 2
    size = (upper.value - lower.value)[..., 0] / apart
    return Flywheel(size, fastest**2 / 2 * size - upper.value[..., 0], fastest, slowest, upper, lower)
