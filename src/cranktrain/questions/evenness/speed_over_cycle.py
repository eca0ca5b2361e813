"""Speed over a cycle from energy and inertia, its three means and its fluctuation."""

from functools import partial
from typing import Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import Extreme, near_roots, turning_points
from cranktrain.numerics.periodic import PeriodicCurve, mean_samples, plus
from cranktrain.numerics.piecewise import ByShare, piece_extremes
from cranktrain.numerics.tops import chosen
from cranktrain.questions.evenness.excess_work import ExcessWork
from cranktrain.record import record

Mean: TypeAlias = Literal["time", "angle", "extremes"]
"""Over time (what a counter of revolutions shows), over the crank angle, or half the sum of the extremes."""

_ASIDE = 1e-6
"""How much wider than the grid's extremes ask a bracket is, in parts of the energies."""
_RESTS = 1e-3
"""Of the mean speed: a shaft that slows down to less all but stops, for as long as no step shows."""


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
    ω² = 2T/J. docs/theory/evenness, eqs. (17.4) and (17.5). Where the curves are smooth the time is summed over the
    grid, which converges faster than any power of the step; between events by Gauss's points.
    """
    angle = energy.angle

    samples = 2 * energy.samples / inertia.samples
    if energy.between is not None and energy.between is inertia.between:
        found = piece_extremes(partial(_squares, energy, inertia), energy.between)
    else:
        found = turning_points(lambda phi: _square(energy.motion(phi), inertia.motion(phi)), samples, angle)
    (stored, carried), weight = mean_samples(energy, inertia)
    with np.errstate(invalid="ignore", divide="ignore"):
        speed = np.sqrt(samples)
        smallest, largest = (Extreme(one.angle, np.sqrt(one.value)) for one in found)
    time, over_angle = (mean_speed_of(2 * stored / carried, mean, weight) for mean in ("time", "angle"))
    means = MeanSpeeds(time, over_angle, (smallest.value + largest.value)[..., 0] / 2)
    return SpeedOverCycle(angle, speed, smallest, largest, means)


def _squares(energy: PeriodicCurve, inertia: PeriodicCurve, which: NDArray[np.bool_] | None) -> ByShare:
    """Square of the speed at shares of chosen pieces."""
    stored, carried = energy.among(which), inertia.among(which)
    return lambda share: _square(stored(share), carried(share))


def _square(stored: Coefficient, carried: Coefficient) -> Coefficient:
    """Square of the speed, 2T/J, with its derivatives."""
    with np.errstate(invalid="ignore", divide="ignore"):
        value = 2 * stored.value / carried.value
        first = (2 * stored.first - value * carried.first) / carried.value
        second = (2 * stored.second - 2 * first * carried.first - value * carried.second) / carried.value
    return Coefficient(value, first, second)


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
    (stored, carried), weight = mean_samples(excess.work, inertia)
    stops = -excess.smallest.value
    slowest = wanted**2 / 2 * np.min(carried, axis=-1, keepdims=True)
    slow = slowest - excess.largest.value
    fast = wanted**2 / 2 * np.max(carried, axis=-1, keepdims=True) + stops
    aside = _ASIDE * (np.abs(fast) + np.abs(slow))

    # The slope of the mean speed by the energy is near 1/(Jω).
    scale = wanted * np.mean(carried, axis=-1, keepdims=True)

    def missing(energy: Array) -> Array:
        if mean == "extremes":
            found = speed_from_energy(plus(excess.work, energy[..., 0]), inertia).means.extremes
        else:
            found = mean_speed_of(2 * (stored + energy) / carried, mean, weight)
        return scale * (found[..., np.newaxis] - wanted)

    start = wanted * scale / 2 - np.mean(stored, axis=-1, keepdims=True)
    least = _ASIDE * aside if weight is None else np.maximum(_ASIDE * aside, _RESTS**2 * slowest)
    ends = np.maximum(slow - aside, stops + least), fast + aside
    energy = near_roots(missing, *np.broadcast_arrays(start, *ends))[..., 0]
    return speed_from_energy(plus(excess.work, energy), inertia)


def mean_speed_of(square: Array, mean: Literal["time", "angle"], weight: Array | None = None) -> Array:
    """Mean of a speed whose square is known at points of some weights, of the grid unless given, shape (..., n)."""
    with np.errstate(invalid="ignore", divide="ignore"):
        speed = np.sqrt(square)
        values = 1 / speed if mean == "time" else speed
        found = np.mean(values, axis=-1) if weight is None else np.sum(values * weight, axis=-1)
        return 1 / found if mean == "time" else found
