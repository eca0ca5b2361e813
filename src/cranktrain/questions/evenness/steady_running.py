"""Steady running of a machine under its load: the speed over the cycle, and what balances the torque."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics import spectral_derivative
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.periodic import PeriodicCurve, combined, fourier_integral, spline_integral
from cranktrain.questions.evenness.law_between_events import speed_between_events
from cranktrain.questions.evenness.mean_speed import balancing_coefficient, has_mean, with_load
from cranktrain.questions.evenness.shaft_torque import LoadTorque
from cranktrain.questions.evenness.shaft_work import ShaftWork
from cranktrain.questions.evenness.spec import Balancing
from cranktrain.questions.evenness.speed_law import Power, SpeedUnderLaw, TorqueLaw, speed_under_law
from cranktrain.questions.evenness.speed_over_cycle import SpeedOverCycle, chosen_speed, steady_speed


class SteadyRunning(NamedTuple):
    """Steady running of a machine.

    Attributes
    ----------
    speed : SpeedOverCycle
    besides : Array, broadcastable to (design, n)
        Torque of all but the machine and the loads that do not depend on the speed. [N·m]
    work : PeriodicCurve
        Of all torques. [J]
    multiplier : Array, shape (design,)
        What is left of a small departure after a cycle: 1 where no torque depends on the speed.
    is_free : array of bool, shape (design,)
        Whether a load was to fix the speed and does not.
    """

    speed: SpeedOverCycle
    besides: Array
    work: PeriodicCurve
    multiplier: Array
    is_free: NDArray[np.bool_]


def steady_running(
    balancing: Balancing,
    given: LoadTorque | None,
    work: ShaftWork,
    inertia: PeriodicCurve,
    wanted: Array,
) -> SteadyRunning:
    """Steady running, by the energy alone or under a law."""
    left = work.excess.mean_excess[:, np.newaxis]
    cycle = inertia.cycle
    # The slope of the work's series: what it gives back when it is integrated by orders is the work itself.
    torque = left + spectral_derivative(work.excess.work.samples) * (TURN / cycle)
    has_load = has_mean(torque, inertia.samples, wanted)
    torque = torque - np.where(has_load[:, np.newaxis], 0.0, left)
    powers, shape = ((), None) if given is None else (given.powers, given.shape)
    brakes, rises = _of_speed(powers, has_load), _of_speed(() if shape is None else (shape,), has_load)
    is_free = rises & ~brakes & ~has_load
    by_energy = is_free | ~(brakes | rises)
    if np.all(by_energy):
        steady = steady_speed(work.excess, inertia, wanted, balancing.mean)
        return SteadyRunning(steady, -left, work.excess.work, np.ones(1), is_free)

    def between_events(law: TorqueLaw) -> SpeedUnderLaw:
        """Speed under what is left of a law without the torques whose work is known."""
        return speed_between_events(law, work.excess.work, inertia)

    is_broken = work.excess.work.between is not None
    if is_broken:
        torque = np.where(has_load[:, np.newaxis], left, 0.0)
    law = TorqueLaw(torque, tuple(one._replace(coefficient=-one.coefficient) for one in powers))
    solver = between_events if is_broken else None
    size = balancing_coefficient(law, shape, inertia.samples, wanted, cycle, balancing.mean, under=solver)
    law = with_load(law, shape, size[:, np.newaxis])
    under = speed_under_law(law, inertia.samples, cycle) if solver is None else solver(law)
    speed, multiplier = under.speed, under.multiplier
    taken = under.torque - torque
    if np.any(by_energy):
        # Of several designs some may have no such load: their energy is free, as under a constant load.
        speed = chosen_speed(by_energy, steady_speed(work.excess, inertia, wanted, balancing.mean), speed)
        taken, multiplier = np.where(by_energy[:, np.newaxis], -left, taken), np.where(by_energy, 1.0, multiplier)
    integral = spline_integral if is_broken else fourier_integral
    whole = combined(work.excess.work, np.ones(1), integral(taken, cycle))
    return SteadyRunning(speed, taken, whole, multiplier, is_free)


def _of_speed(powers: Sequence[Power], designs: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """In which designs one of these depends on the speed, shape (design,)."""
    depend = (((one.coefficient != 0) & (one.exponent != 0))[:, 0] for one in powers)
    return np.any([np.zeros_like(designs), *depend], axis=0)
