"""A machine, its motor and its gearing as they turn forward."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.motion import ONE, Array
from cranktrain.motors import DeclaredMotor
from cranktrain.motors.declared import motors_together
from cranktrain.questions.drive.steady_cycle import SpeedOverTurn, largest_over_turn
from cranktrain.questions.reduction.at_angles import (
    ReducedAt,
    reduced_at,
    reduced_of_each,
    reduced_together,
)
from cranktrain.questions.reduction.gear_train import Passed, gearings_together, through_stages, torque_through
from cranktrain.transient.gearing import Gearing, overall_ratio, turning_inertia
from cranktrain.transient.reduced import ReducedMachine

_NONE = np.empty(0)
NOWHERE = ReducedAt(_NONE, _NONE, _NONE, (), _NONE)

_ALIKE = 1e-6
"""Speeds and energies that differ by less, in parts of themselves, are as good as one."""


class DriveInTurn(NamedTuple):
    """One design's machine, motor and gearing, as it turns forward; `here` is the machine at some crank angles.

    The motor is that of this design alone; `design` is its place among all. `is_held`: a servo motor holds the speed
    that is declared, and gives what torque that takes. Of designs `together` angles, speeds and torques have the shape
    (design, n), and the machine is that of the first, which is asked at no other angles.
    """

    machine: ReducedMachine
    motor: DeclaredMotor
    design: int
    gearing: Gearing
    here: ReducedAt = NOWHERE
    is_held: bool = False

    def motor_torque(self, speed: Array) -> Array:
        """At the motor, by speeds of the crank, shape (n,). [N·m]"""
        if self.is_held:
            return torque_through(self.here.taken(speed), ONE, self.gearing)[0]
        at_motor = speed * overall_ratio(self.gearing)
        return self.motor.torque(np.atleast_2d(at_motor)).reshape(at_motor.shape)

    def largest_torque(self, found: SpeedOverTurn, sign: float = 1.0) -> float:
        """Largest torque of the motor over a cycle; of the other sign the smallest, by amount below 0. [N·m]"""
        return largest_over_turn(found, lambda angle, speed: sign * self.torque_at(angle, speed))

    def torque_at(self, angle: Array, speed: Array) -> Array:
        """At the motor, by crank angles and speeds of the crank, shape (n,); angles count where it is held. [N·m]"""
        return (self.at(angle) if self.is_held else self).motor_torque(speed)

    def heat(self, speed: Array) -> Array:
        """Power that heats the motor, by speeds of the crank, shape (n,). [W]"""
        at_motor = speed * overall_ratio(self.gearing)
        return self.motor.heating(at_motor[np.newaxis])[0]

    def passed(self, speed: Array) -> Passed:
        """Acceleration of the crank, none where its speed is held, and torque at the output of every stage."""
        taken = self.here.taken(speed)
        if self.is_held:
            return Passed(np.zeros(taken.shape), torque_through(taken, ONE, self.gearing)[1:])
        return through_stages(self.motor_torque(speed), self.here.inertia, taken, self.gearing)

    def left_over(self, speed: Array, acceleration: Array) -> Array:
        """Torque at the crank that an acceleration takes beyond what the law gives, shape (n,). [N·m]"""
        whole = self.here.inertia + turning_inertia(self.gearing)
        return whole * (acceleration - self.passed(speed).acceleration)

    def torque_size(self, speed: Array) -> Array:
        """Largest of the torques that the equation of motion is made of, by amount, at the crank, (n,) → (). [N·m]"""
        driving, loading = self.motor_torque(speed) * overall_ratio(self.gearing), self.here.by_load(speed)
        largest = _largest(driving, loading, self.here.taken(speed) - loading)
        least = self.least_torque(speed)
        return np.where(least > largest, least, largest)

    def least_torque(self, speed: Array, slip: float = _ALIKE) -> Array:
        """What counts as a torque at the crank: less is a difference of speeds or energies as good as one. [N·m]

        What the motor gives for a part of the speed, and a millionth of the energy of all that turns, for 1 rad.
        """
        ratio = overall_ratio(self.gearing)
        by_speed = ratio * (self.motor_torque(speed * (1.0 - slip)) - self.motor_torque(speed))
        by_energy = _ALIKE * (self.here.inertia + turning_inertia(self.gearing)) * speed * speed / 2
        return _largest(by_speed, by_energy)

    def at(self, angle: Array) -> "DriveInTurn":
        """The same at other crank angles, shape (n,). [rad]"""
        return self._replace(here=reduced_at(self.machine, angle))

    @property
    def structure(self) -> tuple[int, bool, bool]:
        """What designs have in common that can stand together, of motors of one law and machines of one structure."""
        return len(self.gearing.ratio), bool(np.all(self.gearing.backward > 0)), self.is_held


def together(each: Sequence[DriveInTurn], angle: Array | None = None) -> DriveInTurn:
    """Designs of one `structure` as one, each at as many angles, or at others, shape (design, n). [rad]

    Every number of a design is to the last bit as that of the design alone.
    """
    first = each[0]
    return first._replace(
        motor=motors_together([one.motor for one in each]),
        gearing=gearings_together([one.gearing for one in each]),
        here=(
            reduced_together([one.here for one in each])
            if angle is None
            else reduced_of_each([one.machine for one in each], angle)
        ),
    )


def _largest(*torques: Array) -> Array:
    """Largest of some torques by amount, each of shape (..., n) → (...)."""
    return np.max(np.abs(np.stack(torques, axis=-2)), axis=(-2, -1))
