"""Brake: a torque against whichever way the shaft turns, after a delay."""

from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array, chosen
from cranktrain.questions.drive.motors.motor import Motor, MotorBreaks


class Brake(NamedTuple):
    """Its torque [N·m], and when it comes on after the command [s]."""

    torque: Array
    delay: Array


def brake_hold(time: Array, brake: Brake) -> Array:
    """Torque up to which it holds a shaft at rest, either way. [N·m]

    docs/theory/drive, eq. (25.23).
    """
    return chosen(time < brake.delay, 0.0, brake.torque)


def brake_torque(speed: Array, time: Array, brake: Brake) -> Array:
    """Torque against the speed; of a shaft at rest 0, where it may hold up to `brake_hold` either way. [N·m]

    Parameters
    ----------
    speed : Array, shape (..., n)
        [rad/s]
    time : Array, broadcastable
        Since the command. [s]
    brake : Brake, fields broadcastable to (..., 1)

    Notes
    -----
    docs/theory/drive, eq. (25.23).
    """
    return -np.sign(speed) * brake_hold(time, brake)


def brake_breaks(brake: Brake) -> MotorBreaks:
    """Standstill, and when it comes on."""
    return MotorBreaks((0 * brake.torque,), (brake.delay,))


BRAKE = Motor(
    "brake",
    N_("brake"),
    brake_torque,
    Brake,
    "docs/theory/drive, eq. (25.23)",
    N_("constant friction at all speeds; it comes on at once after its delay"),
    is_timed=True,
    breaks=brake_breaks,
)
