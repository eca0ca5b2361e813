"""Flywheel for a wanted coefficient of fluctuation: exact, and as Mertsalov and the textbooks have it."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics import Extreme, near_roots
from cranktrain.numerics.periodic import PeriodicCurve, combined, curve_extremes, mean_samples, plus
from cranktrain.questions.evenness.excess_work import ExcessWork
from cranktrain.questions.evenness.speed_over_cycle import Mean, mean_speed_of, steady_speed


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

    (stored, carried), weight = mean_samples(excess.work, inertia)
    tried: list[Flywheel] = []

    def missing(middle: Array) -> Array:
        found = _between(excess, inertia, middle[..., 0] - half, middle[..., 0] + half)
        tried.append(found)
        energy, total = stored + found.initial_energy[..., np.newaxis], carried + found.inertia[..., np.newaxis]
        return (mean_speed_of(2 * energy / total, mean, weight) - wanted)[..., np.newaxis]

    # The smallest speed is not negative: its square would be that of another.
    low, high = np.maximum(wanted - half, half), wanted + half
    middle = near_roots(missing, wanted[..., np.newaxis], low[..., np.newaxis], high[..., np.newaxis])[..., 0]
    if np.any(np.isnan(middle)):
        return _between(excess, inertia, middle - half, middle + half)
    # The last one that was tried is the root but for rounding.
    return tried[-1]


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
    approximate = (
        mertsalov_inertia(excess, inertia, speed, fluctuation),
        textbook_inertia(excess, speed, fluctuation),
    )
    sizes = np.stack(np.broadcast_arrays(exact.inertia, *approximate))
    found = steady_speed(excess, plus(inertia, sizes), speed, mean).fluctuation(mean)
    by_method = np.moveaxis(sizes, 0, -1)
    return FlywheelByMethod(exact, by_method, by_method / by_method[..., :1] - 1, np.moveaxis(found, 0, -1))


def _between(excess: ExcessWork, inertia: PeriodicCurve, slowest: Array, fastest: Array) -> Flywheel:
    """Flywheel with which the speed runs just between two speeds."""
    low, high = curve_extremes(combined(excess.work, -(np.stack([slowest, fastest]) ** 2) / 2, inertia))
    lower, upper = (Extreme(one.angle[place], one.value[place]) for place, one in enumerate((low, high)))
    apart = (fastest - slowest) * (fastest + slowest) / 2
    size = (upper.value - lower.value)[..., 0] / apart
    return Flywheel(size, fastest**2 / 2 * size - upper.value[..., 0], fastest, slowest, upper, lower)
