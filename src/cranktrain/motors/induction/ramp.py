"""Inverters: the ramp of the field's speed, and where a limit of torque holds."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.motors.law import MotorBreaks


class Ramp(NamedTuple):
    """Synchronous speed over time: from the first to the last [rad/s] in a time of more than 0 [s]."""

    first_speed: Array
    last_speed: Array
    ramp_time: Array


def ramp_speed(time: Array, ramp: Ramp) -> Array:
    """Synchronous speed at a time since it was switched on. [rad/s]"""
    return ramp.first_speed + (ramp.last_speed - ramp.first_speed) * np.minimum(1, time / ramp.ramp_time)


def limit_slips(bends: Array, half: Array, rest: Array) -> tuple[Array, Array]:
    """Slip speeds at which a limit is reached: both roots of a σ² − 2 b σ + c, NaN where there are none. [rad/s]"""
    with np.errstate(invalid="ignore", divide="ignore"):
        far = half + np.copysign(np.sqrt(half * half - bends * rest), half)
        return np.divide(far, bends), np.divide(rest, far)


def limit_breaks(ramp: Ramp, slips: list[tuple[Array, Array]]) -> MotorBreaks:
    """The end of the ramp, and the speeds behind it at which a limit of torque begins to hold."""
    speeds = tuple(ramp.last_speed - slip for both in slips for slip in both)
    return MotorBreaks(speeds, (ramp.ramp_time,))
