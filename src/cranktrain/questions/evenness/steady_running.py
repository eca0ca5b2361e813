"""Steady running of a machine under its load: the speed over the cycle, and what balances the torque."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics import spectral_derivative
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.periodic import PeriodicCurve, combined
from cranktrain.questions.evenness.applied_torque import AppliedTorque
from cranktrain.questions.evenness.mean_speed import has_mean, quadratic_coefficient
from cranktrain.questions.evenness.shaft_work import ShaftWork
from cranktrain.questions.evenness.spec import ShaftLoad
from cranktrain.questions.evenness.speed_law import TorqueLaw, motor, speed_under_law
from cranktrain.questions.evenness.speed_over_cycle import SpeedOverCycle, chosen_speed, steady_speed


class SteadyRunning(NamedTuple):
    """Speed; the torque that balances the machine, and the work of all torques [N·m, J]; what is left of a departure.

    A load that does not depend on the speed lets a small departure stay after a cycle: 1. is_free: whether a load was
    to fix the speed and does not, shape (design,).
    """

    speed: SpeedOverCycle
    balancing: Array
    work: PeriodicCurve
    multiplier: Array
    is_free: NDArray[np.bool_]


def steady_running(
    load: ShaftLoad, applied: AppliedTorque, work: ShaftWork, inertia: PeriodicCurve, wanted: Array
) -> SteadyRunning:
    """Steady running, by the energy alone or under a law."""
    left = work.excess.mean_excess[:, np.newaxis]
    cycle = inertia.cycle
    # The slope of the work's series: what it gives back when it is integrated by orders is the work itself.
    torque = left + spectral_derivative(work.excess.work.samples) * (TURN / cycle)
    has_load = has_mean(torque, inertia.samples, wanted)
    torque = torque - np.where(has_load[:, np.newaxis], 0.0, left)
    is_free = load.is_quadratic & ~has_load
    if load.motor is None and (not load.is_quadratic or np.all(is_free)):
        steady = steady_speed(work.excess, inertia, wanted, load.mean)
        return SteadyRunning(steady, -left, work.excess.work, np.ones(1), is_free)
    law = _law(load, torque, inertia, wanted)
    whole_law = law._replace(free=torque + law.free)
    under = speed_under_law(whole_law, inertia.samples, cycle, applied.by.curve)
    speed, multiplier = under.speed, under.multiplier
    balancing = under.torque - torque
    if np.any(is_free):
        # Of several designs some may have no mean: their energy is free, as under a constant load.
        speed = chosen_speed(is_free, steady_speed(work.excess, inertia, wanted, load.mean), speed)
        balancing, multiplier = np.where(is_free[:, np.newaxis], -left, balancing), np.where(is_free, 1.0, multiplier)
    whole = combined(work.excess.work, np.ones(1), applied.by.integral(balancing, cycle))
    return SteadyRunning(speed, balancing, whole, multiplier, is_free)


def _law(load: ShaftLoad, torque: Array, inertia: PeriodicCurve, wanted: Array) -> TorqueLaw:
    """What balances the machine's own torque, as it depends on the speed."""
    if load.motor is not None:
        return motor(load.motor.no_load_speed[:, np.newaxis], load.motor.stiffness[:, np.newaxis])
    found = quadratic_coefficient(torque, inertia.samples, wanted, inertia.cycle, load.mean)
    return TorqueLaw(quadratic=-found[:, np.newaxis])
