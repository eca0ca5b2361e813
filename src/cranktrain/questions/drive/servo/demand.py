"""Torque at crank and motor over the time of a wanted motion."""

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from cranktrain.layout.wish.following import CrankMotion, Following, crank_at, crank_by_angle
from cranktrain.layout.wish.rocking import Rocking, rocking_crank
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.questions.drive.at_angles import ReducedAt, reduced_at
from cranktrain.questions.drive.motors.servo import Servo, servo_limit
from cranktrain.questions.drive.running.gearing import Gearing, input_torque, overall_ratio
from cranktrain.questions.drive.running.reduced import ReducedMachine, in_one_row, reduced_machine
from cranktrain.questions.drive.sizing.servo_uses import ServoUses

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)
_N_PARTS = 24
"""Of each piece of a wanted motion, besides those between jumps of the load."""
_SAME = 1e-12
"""Of the period: times that are nearer are one."""


class ServoDemand(NamedTuple):
    """What a motor must do over the period of a wanted motion.

    Attributes
    ----------
    crank : CrankMotion
        At the times of a rule of quadrature, shape (n,).
    weight : Array, shape (n,)
        Of each time; together the period. [s]
    crank_torque, motor_torque, motor_speed : Array, shape (n,)
        [N·m, N·m, rad/s]
    """

    crank: CrankMotion
    weight: Array
    crank_torque: Array
    motor_torque: Array
    motor_speed: Array

    @property
    def power(self) -> Array:
        """That the motor gives at its shaft; below 0 where it brakes. [W]"""
        return self.motor_torque * self.motor_speed

    def mean(self, values: Array) -> float:
        """Mean over time, rests counted."""
        return float(np.sum(values * self.weight) / np.sum(self.weight))

    @property
    def rms(self) -> float:
        """Root mean square of the motor's torque over time: what heats a servo's winding. [N·m]"""
        return float(np.sqrt(self.mean(self.motor_torque**2)))

    @property
    def returned(self) -> float:
        """Energy that the motor takes back in a period. [J]"""
        return float(-np.sum(np.minimum(self.power, 0.0) * self.weight))

    def behind(self, gearing: Gearing) -> "ServoDemand":
        """The same motion and crank torque behind another gearing."""
        return _demand(self.crank, self.weight, self.crank_torque, gearing)

    def uses(self, servo: Servo, continuous_torque: float) -> ServoUses:
        """Share of a servo motor's limits that is asked for: torque and power at once, torque for long [N·m]."""
        at_once = np.max(np.abs(self.motor_torque) / servo_limit(self.motor_speed, servo))
        return ServoUses(np.asarray(at_once), np.asarray(self.rms / continuous_torque))


def servo_demand(made: Following, machine: ReducedMachine, gearing: Gearing, corners: Array) -> ServoDemand:
    """What the motor must do so that the crank follows, at times between which nothing jumps.

    Parameters
    ----------
    made : Following
    machine : ReducedMachine
    gearing : Gearing
    corners : Array, shape (corner,)
        φ where loads jump; NaN is none. [rad]

    Notes
    -----
    docs/theory/servo, eq. (29.8).
    """
    angles = np.mod(corners[np.isfinite(corners)], TURN)
    at_corners = np.mod(crank_by_angle(made, angles).time, made.wanted.period)
    time, weight = _rule(made.wanted.period, [piece.start for piece in made.wanted.pieces], at_corners)
    crank = crank_at(made, time)
    return _demand(crank, weight, crank_torque(crank, reduced_at(machine, crank.angle)), gearing)


def rocking_demand(made: Rocking, machine: ReducedMachine, gearing: Gearing) -> ServoDemand:
    """What the motor must do so that a rocking crank follows.

    Loads are as on the way that it then goes: what resists does so both ways.
    """
    time, weight = _rule(made.wanted.period, [piece.start for piece in made.wanted.pieces], np.empty(0))
    crank = rocking_crank(made, time)
    ways = zip(crank.angle.tolist(), crank.speed.tolist(), crank.acceleration.tolist(), strict=True)
    numbers = in_one_row(machine).tolist()
    torque = np.array([_torque_either_way(*way, numbers) for way in ways])
    return _demand(crank, weight, torque, gearing)


def _torque_either_way(angle: float, speed: float, acceleration: float, numbers: list[float]) -> float:
    """Torque that the crank takes at one angle, whichever way it goes. [N·m]"""
    inertia, slope, load, _output = reduced_machine(angle, speed, -1.0 if speed < 0 else 1.0, numbers)
    return float(inertia * acceleration + 0.5 * slope * speed * speed + load)


def _rule(period: float, starts: list[float], corners: Array) -> tuple[Array, Array]:
    """Times and weights of Gauss's rule between the ends of pieces and the corners."""
    fine = [corners, *(np.linspace(low, high, _N_PARTS + 1) for low, high in pairwise([*starts, period]))]
    ends: Array = np.unique(np.concatenate(fine))
    ends = ends[np.append(True, np.diff(ends) > _SAME * period)]
    half = np.diff(ends)[:, np.newaxis] / 2
    return np.ravel(ends[:-1, np.newaxis] + half * (1 + _NODES)), np.ravel(half * _WEIGHTS)


def _demand(crank: CrankMotion, weight: Array, torque: Array, gearing: Gearing) -> ServoDemand:
    """Torques at the times of a crank's motion."""
    at_motor = motor_torque(torque, crank, gearing)
    return ServoDemand(crank, weight, torque, at_motor, crank.speed * overall_ratio(gearing))


def crank_torque(crank: CrankMotion, machine: ReducedAt) -> Array:
    """Torque that the crank of a machine takes: Jε + ½J′ω² and loads. [N·m]"""
    return machine.inertia * crank.acceleration + machine.taken(crank.speed)


def motor_torque(torque: Array, crank: CrankMotion, gearing: Gearing) -> Array:
    """Torque of the motor for one at the crank, with what turns in the gearing.

    Parameters
    ----------
    torque : Array, shape (n,)
        Load and inertia of the machine. [N·m]
    crank : CrankMotion
    gearing : Gearing

    Returns
    -------
    Array, shape (n,)
        [N·m] At rest the least that holds: losses help to hold.

    Notes
    -----
    docs/theory/transient, eqs. (26.1) and (26.5); docs/theory/servo, eq. (29.8).
    """
    passed, turned = torque, 1.0
    for stage in reversed(range(len(gearing.ratio))):
        passed = passed + gearing.inertia[stage] * turned * crank.acceleration
        turned *= float(gearing.ratio[stage])
        rests = crank.speed == 0
        sense = np.where(rests, -np.sign(passed), np.sign(crank.speed))
        own = float(gearing.backward[stage])
        backward = np.where(rests, max(own, 0.0), own)
        at_input = input_torque(passed, sense, gearing.ratio[stage], gearing.forward[stage], backward)
        passed = at_input + gearing.drag[stage] * np.sign(crank.speed)
    return passed + gearing.motor_inertia * turned * crank.acceleration
