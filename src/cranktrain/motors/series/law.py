"""Series motor: field and armature have one current."""

from functools import partial
from typing import NamedTuple

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.motors.declared import start_limits
from cranktrain.motors.law import MotorLaw, OfRated


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


def series_heat(speed: Array, _time: Array, motor: SeriesMotor) -> Array:
    """Power that turns to heat in field and armature, I²R with M = cI². [W]"""
    return series_torque(speed, motor) * motor.resistance / motor.constant


def series_current(speed: Array, _time: Array, motor: OfRated) -> Array:
    """Current of a series motor over the rated one."""
    own: SeriesMotor = motor.motor
    return own.voltage / (own.resistance + own.constant * speed) / motor.rated


SERIES = MotorLaw(
    "series",
    N_("series motor"),
    series_torque,
    SeriesMotor,
    "docs/theory/drive, eq. (25.19)",
    N_("unsaturated field; above −R/c, and never without load"),
    limits=partial(start_limits, unknown=N_("largest torque: what its commutator bears for a moment is not known")),
    heat=series_heat,
    current=series_current,
)
