"""A machine, its motor and its gearing as they turn forward."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import ONE, Array
from cranktrain.motors import DeclaredMotor
from cranktrain.questions.drive.steady_cycle import SpeedOverTurn, largest_over_turn
from cranktrain.questions.reduction.at_angles import ReducedAt, reduced_at
from cranktrain.questions.reduction.gear_train import Passed, through_stages, torque_through
from cranktrain.transient.gearing import Gearing, overall_ratio, turning_inertia
from cranktrain.transient.reduced import ReducedMachine

_NONE = np.empty(0)
NOWHERE = ReducedAt(_NONE, _NONE, _NONE, (), _NONE)

_ALIKE = 1e-6
"""Speeds and energies that differ by less, in parts of themselves, are as good as one."""


class DriveInTurn(NamedTuple):
    """One design's machine, motor and gearing, as it turns forward; `here` is the machine at some crank angles.

    The motor is that of this design alone; `design` is its place among all. `is_held`: a servo motor holds the speed
    that is declared, and gives what torque that takes.
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
        return self.motor.torque(at_motor[np.newaxis])[0]

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

    def torque_size(self, speed: Array) -> float:
        """Largest of the torques that the equation of motion is made of, by amount, at the crank. [N·m]"""
        driving, loading = self.motor_torque(speed) * overall_ratio(self.gearing), self.here.by_load(speed)
        largest = float(np.max(np.abs([driving, loading, self.here.taken(speed) - loading])))
        return max(largest, self.least_torque(speed))

    def least_torque(self, speed: Array, slip: float = _ALIKE) -> float:
        """What counts as a torque at the crank: less is a difference of speeds or energies as good as one. [N·m]

        What the motor gives for a part of the speed, and a millionth of the energy of all that turns, for 1 rad.
        """
        ratio = overall_ratio(self.gearing)
        by_speed = ratio * (self.motor_torque(speed * (1.0 - slip)) - self.motor_torque(speed))
        by_energy = _ALIKE * (self.here.inertia + turning_inertia(self.gearing)) * speed * speed / 2
        return float(np.max(np.abs([by_speed, by_energy])))

    def at(self, angle: Array) -> "DriveInTurn":
        """The same at other crank angles, shape (n,). [rad]"""
        return self._replace(here=reduced_at(self.machine, angle))
