"""Whether a servo motor can do a motion: its torque against both its limits, over the cycle."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.drive.motors.servo import Servo, servo_limit
from cranktrain.questions.drive.sizing.torque_means import rms_torque


class ServoUses(NamedTuple):
    """What is asked over what it can do, shape (...): of the peak limit and of the one for long. Up to 1 is enough."""

    peak: Array
    rms: Array


def servo_uses(torque: Array, speed: Array, time: Array, servo: Servo, continuous_torque: Array) -> ServoUses:
    """Uses of a servo motor over a cycle.

    Parameters
    ----------
    torque, speed : Array, shape (..., n)
        At its shaft. [N·m, rad/s]
    time : Array, broadcastable to (..., n)
        [s]
    servo : Servo, fields broadcastable to (..., 1)
        Its command is not asked for.
    continuous_torque : Array, shape (...)
        That it gives for long. [N·m]

    Returns
    -------
    ServoUses

    Notes
    -----
    docs/theory/drive, eqs. (25.20) and (25.29).
    """
    peak = np.max(np.abs(torque) / servo_limit(speed, servo), axis=-1)
    return ServoUses(peak, rms_torque(torque, time) / continuous_torque)
