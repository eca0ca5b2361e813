"""Motors for direct current: shunt, or with constant magnets, and series."""

from typing import NamedTuple

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.questions.drive.motors.motor import Motor


class ShuntMotor(NamedTuple):
    """Torque at standstill [N·m] and speed without load [rad/s], of opposite sign to each other in none."""

    stall_torque: Array
    no_load_speed: Array


class SeriesMotor(NamedTuple):
    """A series motor.

    Attributes
    ----------
    voltage, resistance : Array
        Of the line; of field and armature together. [V, Ω]
    constant : Array
        Torque over the square of the current. [N·m/A²]
    """

    voltage: Array
    resistance: Array
    constant: Array


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


def series_torque(speed: Array, motor: SeriesMotor) -> Array:
    """Torque of a series motor: it never ends, so that the motor runs away without load. [N·m]

    Parameters
    ----------
    speed : Array, shape (..., n)
        Above −R/c, where it would excite itself as a generator. [rad/s]
    motor : SeriesMotor, fields broadcastable to (..., 1)

    Notes
    -----
    docs/theory/drive, eq. (25.19).
    """
    current = motor.voltage / (motor.resistance + motor.constant * speed)
    return motor.constant * current * current


def shunt_motor(rated_torque: Array, rated_speed: Array, no_load_speed: Array) -> ShuntMotor:
    """Shunt motor through its rated point.

    Examples
    --------
    >>> round(shunt_motor(50.0, 150.0, 160.0).stall_torque, 9)
    800.0
    """
    return ShuntMotor(rated_torque / (1 - rated_speed / no_load_speed), no_load_speed)


SHUNT = Motor(
    "shunt",
    N_("shunt motor"),
    shunt_torque,
    ShuntMotor,
    "docs/theory/drive, eq. (25.18)",
    N_("constant field; a start without resistance is beyond what commutators bear"),
)

SERIES = Motor(
    "series",
    N_("series motor"),
    series_torque,
    SeriesMotor,
    "docs/theory/drive, eq. (25.19)",
    N_("unsaturated field; above −R/c, and never without load"),
)
