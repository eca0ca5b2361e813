"""Torque at crank and motor over the time of a wanted motion."""

from collections.abc import Callable
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from cranktrain.layout.wish.following import CrankMotion, Following, Rocking, crank_at, crank_by_angle, rocking_crank
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.products import product
from cranktrain.questions.reduction.at_angles import ReducedAt, reduced_at
from cranktrain.transient.gearing import Gearing, input_torque, overall_ratio
from cranktrain.transient.reduced import ReducedMachine, in_one_row, reduced_machine

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)
_TRIED = np.linspace(-1.0, 1.0, 257)
_TO_TRIED = np.vander(_TRIED, _NODES.size) @ np.linalg.inv(np.vander(_NODES, _NODES.size))
"""From values at a part's nodes to those at even places from its beginning to its end."""
_FEWER = 32
"""Of these places one in so many suffices for pictures; both ends are among them."""
_N_PARTS = 24
"""Of each piece of a wanted motion, besides those between jumps of the load."""
_SAME = 1e-12
"""Of the period: times that are nearer are one."""
_MOST_RULES = 5
"""Until parts end where torques change their sign: each time some hundred times as closely."""


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

    def along(self, values: Array) -> Array:
        """Values in the order of time, at even places of each part of the rule, its ends among them."""
        return np.ravel(product(values.reshape(-1, _NODES.size), _TO_TRIED[::_FEWER].T))

    def largest(self, values: Array) -> float:
        """Largest value over time of what is smooth within each part of the rule, its ends among them."""
        return float(np.max(product(values.reshape(-1, _NODES.size), _TO_TRIED.T)))

    @property
    def peak_torque(self) -> float:
        """Largest size of the motor's torque. [N·m]"""
        return max(self.largest(self.motor_torque), self.largest(-self.motor_torque))

    @property
    def peak_power(self) -> float:
        """Largest size of the motor's power, driving or braking. [W]"""
        return max(self.largest(self.power), self.largest(-self.power))

    @property
    def top_speed(self) -> float:
        """Largest size of the motor's speed. [rad/s]"""
        return max(self.largest(self.motor_speed), self.largest(-self.motor_speed))

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

    def peak_share(self, ceiling: Array) -> float:
        """Largest part of what a motor can give at its speeds, shape (n,), that is asked for. [N·m]"""
        share = self.motor_torque / ceiling
        return max(self.largest(share), self.largest(-share))


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

    def at(time: Array) -> tuple[CrankMotion, Array]:
        crank = crank_at(made, time)
        return crank, crank_torque(crank, reduced_at(machine, crank.angle))

    ends = _ends(made.wanted.period, [piece.start for piece in made.wanted.pieces], at_corners)
    return _over_period(at, ends, gearing, np.empty(0))


def rocking_demand(made: Rocking, machine: ReducedMachine, gearing: Gearing, corners: Array) -> ServoDemand:
    """What the motor must do so that a rocking crank follows.

    Loads are as on the way that it then goes: what resists does so both ways. Parameters as of `servo_demand`.
    """
    numbers = in_one_row(machine).tolist()

    def at(time: Array) -> tuple[CrankMotion, Array]:
        crank = rocking_crank(made, time)
        ways = zip(crank.angle.tolist(), crank.speed.tolist(), crank.acceleration.tolist(), strict=True)
        return crank, np.array([_torque_either_way(*way, numbers) for way in ways])

    ends = _ends(made.wanted.period, [piece.start for piece in made.wanted.pieces], np.empty(0))
    return _over_period(at, ends, gearing, corners[np.isfinite(corners)])


def _torque_either_way(angle: float, speed: float, acceleration: float, numbers: list[float]) -> float:
    """Torque that the crank takes at one angle, whichever way it goes. [N·m]"""
    inertia, slope, load, _output = reduced_machine(angle, speed, -1.0 if speed < 0 else 1.0, numbers)
    return float(inertia * acceleration + 0.5 * slope * speed * speed + load)


def _ends(period: float, starts: list[float], corners: Array) -> Array:
    """Times at which parts of the rule begin and end. [s]"""
    fine = [corners, *(np.linspace(low, high, _N_PARTS + 1) for low, high in pairwise([*starts, period]))]
    return np.unique(np.concatenate(fine))


def _over_period(
    at: Callable[[Array], tuple[CrankMotion, Array]], ends: Array, gearing: Gearing, corners: Array
) -> ServoDemand:
    """Torques over a period, with a rule whose parts end where loads, losses and power have corners.

    `at` gives the crank's motion and its torque at times; `corners` are crank angles that the crank may pass.
    """
    found, more = _by_rule(at, ends, gearing, corners)
    for _again in range(_MOST_RULES - 1):
        if more.size == 0:
            break
        ends = np.unique(np.concatenate([ends, more]))
        found, more = _by_rule(at, ends, gearing, corners)
    return found


def _by_rule(
    at: Callable[[Array], tuple[CrankMotion, Array]], ends: Array, gearing: Gearing, corners: Array
) -> tuple[ServoDemand, Array]:
    """Torques at the nodes of a rule, and the times at which it must be cut too. [s]"""
    period = float(ends[-1])
    ends = ends[np.append(True, np.diff(ends) > _SAME * period)]
    half = np.diff(ends)[:, np.newaxis] / 2
    time = np.ravel(ends[:-1, np.newaxis] + half * (1 + _NODES))
    crank, torque = at(time)
    passed = torques_on_the_way(torque, crank, gearing)
    angles = [np.sin(0.5 * (crank.angle - corner)) for corner in corners.tolist()]
    more = _sign_changes(time, np.stack([*passed, *angles]))
    is_new = np.min(np.abs(more[:, np.newaxis] - ends), axis=1, initial=period) > _SAME * period
    return _demand(crank, np.ravel(half * _WEIGHTS), torque, gearing), more[is_new]


def _sign_changes(time: Array, values: Array) -> Array:
    """Times at which any row of values, shape (row, n), changes its sign within a part of the rule. [s]"""
    own, times = values.reshape(len(values), -1, _NODES.size), time.reshape(-1, _NODES.size)
    row, part, place = np.nonzero(own[..., :-1] * own[..., 1:] < 0)
    low, high = own[row, part, place], own[row, part, place + 1]
    begin, end = times[part, place], times[part, place + 1]
    return begin + (end - begin) * low / (low - high)


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
    return torques_on_the_way(torque, crank, gearing)[-1]


def torques_on_the_way(torque: Array, crank: CrankMotion, gearing: Gearing) -> list[Array]:
    """At the output of every stage, the last stage first, and of the motor; see `motor_torque`. [N·m]"""
    passed, turned = torque, 1.0
    outputs = list[Array]()
    for stage in reversed(range(len(gearing.ratio))):
        passed = passed + gearing.inertia[stage] * turned * crank.acceleration
        outputs.append(passed)
        turned *= float(gearing.ratio[stage])
        rests = crank.speed == 0
        sense = np.where(rests, -np.sign(passed), np.sign(crank.speed))
        own = float(gearing.backward[stage])
        backward = np.where(rests, max(own, 0.0), own)
        at_input = input_torque(passed, sense, gearing.ratio[stage], gearing.forward[stage], backward)
        passed = at_input + gearing.drag[stage] * np.sign(crank.speed)
    return [*outputs, passed + gearing.motor_inertia * turned * crank.acceleration]
