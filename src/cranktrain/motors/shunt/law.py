"""Shunt motor, or one with constant magnets: its torque falls with the speed in a line."""

from functools import partial
from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.motors.declared import start_limits
from cranktrain.motors.law import MotorLaw, OfRated


class ShuntMotor(NamedTuple):
    """Torque at standstill [N·m] and speed without load [rad/s], of opposite sign to each other in none."""

    stall_torque: Array
    no_load_speed: Array


def shunt_torque(speed: Array, motor: ShuntMotor) -> Array:
    """Torque of a shunt motor: it falls in a line, and brakes above the speed without load. [N·m]

    Parameters
    ----------
    speed : Array, shape (..., n)
        [rad/s]
    motor : ShuntMotor, fields broadcastable to (..., 1)

    Notes
    -----
    docs/theory/drive, eq. (25.18).
    """
    return motor.stall_torque * (1 - speed / motor.no_load_speed)


def shunt_motor(rated_torque: Array, rated_speed: Array, no_load_speed: Array) -> ShuntMotor:
    """Shunt motor through its rated point.

    Examples
    --------
    >>> round(shunt_motor(50.0, 150.0, 160.0).stall_torque, 9)
    800.0
    """
    return ShuntMotor(rated_torque / (1 - rated_speed / no_load_speed), no_load_speed)


def shunt_heat(speed: Array, _time: Array, motor: ShuntMotor) -> Array:
    """Power that turns to heat in the armature's circuit: what the line gives, M ω₀, less what the shaft takes. [W]"""
    return shunt_torque(speed, motor) * (motor.no_load_speed - speed)


def shunt_current(speed: Array, _time: Array, motor: OfRated) -> Array:
    """Armature's current over the rated one, which is in proportion to the torque."""
    return np.abs(shunt_torque(speed, motor.motor)) / motor.rated


SHUNT = MotorLaw(
    "shunt",
    N_("shunt motor"),
    shunt_torque,
    ShuntMotor,
    "docs/theory/drive, eq. (25.18)",
    N_("constant field; a start without resistance is beyond what commutators bear"),
    limits=partial(start_limits, unknown=N_("largest torque: what its commutator bears for a moment is not known")),
    heat=shunt_heat,
    current=shunt_current,
)
