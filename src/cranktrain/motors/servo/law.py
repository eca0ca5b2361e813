"""Servo motor: any torque between two limits, and a third over time."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.motors.declared import DeclaredMotor
from cranktrain.motors.law import BriefLimits, MotorBreaks, MotorLaw, OfRated


class Servo(NamedTuple):
    """A servo motor and the torque that is asked of it.

    Attributes
    ----------
    peak_torque, peak_power : Array
        The power infinite where only the torque is limited. [N·m, W]
    command : Array
        [N·m]
    """

    peak_torque: Array
    peak_power: Array
    command: Array


def servo_limit(speed: Array, servo: Servo) -> Array:
    """Largest torque at a speed, in either sense. [N·m]

    docs/theory/drive, eq. (25.20).

    Examples
    --------
    >>> float(servo_limit(0.0, Servo(20.0, 4000.0, 0.0))), float(servo_limit(-400.0, Servo(20.0, 4000.0, 0.0)))
    (20.0, 10.0)
    """
    return servo.peak_torque / np.maximum(1, np.abs(speed) * servo.peak_torque / servo.peak_power)


def servo_torque(speed: Array, servo: Servo) -> Array:
    """Torque that is asked of it, as far as it can. [N·m]

    Parameters
    ----------
    speed : Array, shape (..., n)
        [rad/s]
    servo : Servo, fields broadcastable to (..., n)

    Notes
    -----
    docs/theory/drive, eq. (25.20).
    """
    limit = servo_limit(speed, servo)
    return np.minimum(limit, np.maximum(-limit, servo.command))


def servo_breaks(servo: Servo) -> MotorBreaks:
    """Where power begins to limit what it gives: the commanded torque, or the peak one where that is less."""
    given = np.minimum(np.abs(servo.command), servo.peak_torque)
    with np.errstate(divide="ignore"):
        speed = np.divide(servo.peak_power, given)
    speed = np.where(np.isfinite(speed), speed, np.nan)
    return MotorBreaks((speed, -speed))


def servo_current(speed: Array, _time: Array, motor: OfRated) -> Array:
    """Current of a servo motor over the rated one, which is in proportion to the torque."""
    return np.abs(servo_torque(speed, motor.motor)) / motor.rated


def servo_limits(motor: DeclaredMotor, design: int) -> BriefLimits:
    """Its peak torque, at standstill too."""
    peak = float(motor.numbers.peak_torque[design])
    return BriefLimits(peak, peak)


def _is_free(servo: Servo) -> NDArray[np.bool_]:
    """Whether it gives all that it can."""
    return servo.command >= servo.peak_torque


SERVO = MotorLaw(
    "servo",
    N_("servo motor"),
    servo_torque,
    Servo,
    "docs/theory/drive, eq. (25.20)",
    N_("torque at once as asked; what it may give for long is a third limit, of the rms torque"),
    breaks=servo_breaks,
    limits=servo_limits,
    current=servo_current,
    ceiling=servo_limit,
    is_free=_is_free,
)
