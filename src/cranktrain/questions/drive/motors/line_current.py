"""Line currents over the rated one, by speed and time: of cage motors and their starters, and of direct current."""

from typing import Any, NamedTuple

import numpy as np

from cranktrain.motion import Array, chosen
from cranktrain.questions.drive.motors.cage import slip_of
from cranktrain.questions.drive.motors.circuit import Circuit
from cranktrain.questions.drive.motors.current import line_current
from cranktrain.questions.drive.motors.direct_current import SeriesMotor, shunt_torque
from cranktrain.questions.drive.motors.heat import circuit_current
from cranktrain.questions.drive.motors.servo import servo_torque
from cranktrain.questions.drive.motors.soft_start import SoftStart, voltage_part
from cranktrain.questions.drive.motors.star_delta import STAR


class CageCurrent(NamedTuple):
    """What it hangs on: speed of the field, slip at breakdown, current at standstill over the rated one.

    In [rad/s, 1, 1].
    """

    synchronous_speed: Array
    breakdown_slip: Array
    starting_current: Array


class StarDeltaCurrent(NamedTuple):
    """The same, when it is switched over [s], and how long it is without current then [s]."""

    motor: CageCurrent
    change_time: Array
    pause: Array


class OfRated(NamedTuple):
    """A motor for direct current or a servo, and its rated torque [N·m] or current [A]."""

    motor: Any
    rated: Array


class CircuitCurrent(NamedTuple):
    """A motor by its circuit, and its current at the rated point. [A]"""

    circuit: Circuit
    rated: Array


def cage_current(speed: Array, _time: Array, motor: CageCurrent) -> Array:
    """Line current direct on line. docs/theory/drive, eq. (25.11)."""
    return line_current(slip_of(speed, motor.synchronous_speed), motor.breakdown_slip, motor.starting_current)


def star_delta_current(speed: Array, time: Array, geometry: StarDeltaCurrent) -> Array:
    """Line current in star, none while switching, and in delta. docs/theory/drive, eqs. (25.11) and (25.12)."""
    since = time - geometry.change_time
    part = chosen(since < 0, STAR, chosen(since < geometry.pause, 0.0, 1.0))
    return part * cage_current(speed, time, geometry.motor)


def soft_start_current(speed: Array, time: Array, geometry: SoftStart) -> Array:
    """Line current behind a soft starter, in the unit of that at standstill. docs/theory/drive, eq. (25.13)."""
    slip = slip_of(speed, geometry.motor.synchronous_speed)
    full = line_current(slip, geometry.motor.breakdown_slip, geometry.starting_current)
    return voltage_part(slip, time, geometry) * full


def circuit_current_ratio(speed: Array, _time: Array, motor: CircuitCurrent) -> Array:
    """Current of a motor by its circuit over that at the rated point."""
    return circuit_current(motor.circuit.synchronous_speed - speed, motor.circuit) / motor.rated


def shunt_current(speed: Array, _time: Array, motor: OfRated) -> Array:
    """Armature's current over the rated one, which is in proportion to the torque."""
    return np.abs(shunt_torque(speed, motor.motor)) / motor.rated


def series_current(speed: Array, _time: Array, motor: OfRated) -> Array:
    """Current of a series motor over the rated one."""
    own: SeriesMotor = motor.motor
    return own.voltage / (own.resistance + own.constant * speed) / motor.rated


def servo_current(speed: Array, _time: Array, motor: OfRated) -> Array:
    """Current of a servo motor over the rated one, which is in proportion to the torque."""
    return np.abs(servo_torque(speed, motor.motor)) / motor.rated
