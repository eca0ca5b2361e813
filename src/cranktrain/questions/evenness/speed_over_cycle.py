"""Speed over a cycle from energy and inertia, its three means and its fluctuation."""

from typing import Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import Extreme, near_roots, turning_points
from cranktrain.numerics.periodic import PeriodicCurve, plus
from cranktrain.numerics.tops import chosen
from cranktrain.questions.evenness.excess_work import ExcessWork
from cranktrain.record import record

Mean: TypeAlias = Literal["time", "angle", "extremes"]
"""Over time (what a counter of revolutions shows), over the crank angle, or half the sum of the extremes."""

_ASIDE = 1e-6
"""How much wider than the grid's extremes ask a bracket is, in parts of the energies."""


class MeanSpeeds(NamedTuple):
    """Three means of one speed, shape (...). [rad/s]"""

    time: Array
    angle: Array
    extremes: Array


@record
class SpeedOverCycle:
    """Speed over one cycle of steady running.

    Attributes
    ----------
    angle : Array, shape (n,)
        Crank angle. [rad]
    speed : Array, shape (..., n)
        NaN where the shaft would stop within the cycle. [rad/s]
    smallest, largest : Extreme, shapes (..., 1)
        Refined. [rad, rad/s]
    means : MeanSpeeds
    """

    angle: Array
    speed: Array
    smallest: Extreme
    largest: Extreme
    means: MeanSpeeds

    def fluctuation(self, mean: Mean = "time") -> Array:
        """Coefficient δ = (largest − smallest)/mean, shape (...): twice the ± value. [1]"""
        return (self.largest.value - self.smallest.value)[..., 0] / getattr(self.means, mean)


def chosen_speed(which: NDArray[np.bool_], one: SpeedOverCycle, other: SpeedOverCycle) -> SpeedOverCycle:
    """Take one speed for some designs and the other for the rest, which shape (design,) says."""
    curve = which[:, np.newaxis]
    return SpeedOverCycle(
        angle=one.angle,
        speed=np.where(curve, one.speed, other.speed),
        smallest=chosen(curve, one.smallest, other.smallest),
        largest=chosen(curve, one.largest, other.largest),
        means=MeanSpeeds(*(np.where(which, *parts) for parts in zip(one.means, other.means, strict=True))),
    )


def speed_from_energy(energy: PeriodicCurve, inertia: PeriodicCurve) -> SpeedOverCycle:
    """Speed from kinetic energy and reduced inertia.

    Parameters
    ----------
    energy : PeriodicCurve
        T(φ) = E₀ + A(φ). [J]
    inertia : PeriodicCurve
        J(φ), flywheel and moving parts together, on the same grid. [kg·m²]

    Returns
    -------
    SpeedOverCycle

    Notes
    -----
    ω² = 2T/J. docs/theory/evenness, eqs. (17.4) and (17.5). The time is summed over the grid, which converges faster
    than any power of the step where the curves are smooth.
    """
    angle = energy.angle

    def square(phi: Array) -> Coefficient:
        stored, carried = energy.motion(phi), inertia.motion(phi)
        value = 2 * stored.value / carried.value
        first = (2 * stored.first - value * carried.first) / carried.value
        second = (2 * stored.second - 2 * first * carried.first - value * carried.second) / carried.value
        return Coefficient(value, first, second)

    samples = 2 * energy.samples / inertia.samples
    found = turning_points(square, samples, angle)
    with np.errstate(invalid="ignore", divide="ignore"):
        speed = np.sqrt(samples)
        smallest, largest = (Extreme(one.angle, np.sqrt(one.value)) for one in found)
        means = MeanSpeeds(
            1 / np.mean(1 / speed, axis=-1), np.mean(speed, axis=-1), (smallest.value + largest.value)[..., 0] / 2
        )
    return SpeedOverCycle(angle, speed, smallest, largest, means)


def steady_speed(excess: ExcessWork, inertia: PeriodicCurve, mean_speed: Array, mean: Mean = "time") -> SpeedOverCycle:
    """Speed over a cycle whose torques do not depend on the speed, at a given mean.

    Parameters
    ----------
    excess : ExcessWork
        With A(φ). [J]
    inertia : PeriodicCurve
        J(φ), flywheel and moving parts. [kg·m²]
    mean_speed : Array, shape (...)
        [rad/s]
    mean : Mean
        Which mean is given.

    Returns
    -------
    SpeedOverCycle
        NaN where no speed has that mean: the inertia is too small to carry the shaft through the cycle.

    Notes
    -----
    E₀ is free; the mean fixes it. docs/theory/evenness, eqs. (17.4) and (17.5).
    """
    wanted = np.asarray(mean_speed, dtype=float)[..., np.newaxis]
    stored, carried = excess.work.samples, inertia.samples
    stops = -excess.smallest.value
    slow = wanted**2 / 2 * np.min(carried, axis=-1, keepdims=True) - excess.largest.value
    fast = wanted**2 / 2 * np.max(carried, axis=-1, keepdims=True) + stops
    aside = _ASIDE * (np.abs(fast) + np.abs(slow))

    # The slope of the mean speed by the energy is near 1/(Jω).
    scale = wanted * np.mean(carried, axis=-1, keepdims=True)

    def missing(energy: Array) -> Array:
        if mean == "extremes":
            found = speed_from_energy(plus(excess.work, energy[..., 0]), inertia).means.extremes
        else:
            found = grid_mean(2 * (stored + energy) / carried, mean)
        return scale * (found[..., np.newaxis] - wanted)

    start = wanted * scale / 2 - np.mean(stored, axis=-1, keepdims=True)
    ends = np.maximum(slow - aside, stops + _ASIDE * aside), fast + aside
    energy = near_roots(missing, *np.broadcast_arrays(start, *ends))[..., 0]
    return speed_from_energy(plus(excess.work, energy), inertia)


def grid_mean(square: Array, mean: Literal["time", "angle"]) -> Array:
    """Mean of a speed whose square is known on the grid, shape (..., n) [rad²/s²]."""
    with np.errstate(invalid="ignore", divide="ignore"):
        speed = np.sqrt(square)
        return 1 / np.mean(1 / speed, axis=-1) if mean == "time" else np.mean(speed, axis=-1)
