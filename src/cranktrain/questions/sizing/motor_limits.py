"""What a declared motor can do at its shaft: for long, for a moment, and at standstill."""

from typing import NamedTuple

import numpy as np

from cranktrain.language import Words, _
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.motors.declared import curve
from cranktrain.questions.sizing.starting import StartTimeHeat, loaded_start

_END_SLIP = 2.0
"""Slip at which a start counts as over, in parts of the rated one: what is left is settling."""


class MotorLimits(NamedTuple):
    """Of one design; NaN where it is not known. [N·m]

    Attributes
    ----------
    rated : float
        For long.
    peak : float
        The largest one, at rated voltage; of a servo motor at standstill.
    start : float
        The least between standstill and the largest one, at rated voltage.
    reserve : float
        What is left of these two at the lowest voltage.
    unknown : Words
        What of peak and start is not known, and why: a sentence without its end; nothing where both are.
    """

    rated: float
    peak: float
    start: float
    reserve: float
    unknown: Words


def motor_limits(motor: DeclaredMotor, design: int, reserve: float) -> MotorLimits:
    """Limits of a motor.

    Parameters
    ----------
    motor : DeclaredMotor
    design : int
    reserve : float
        Square of the lowest voltage over the rated one: what is left of the torques of a motor on the line.

    Notes
    -----
    docs/theory/drive, eq. (25.32). With star–delta the start is in star. What a direct-current motor's commutator bears
    for a moment is not known, and engines start without load.
    """
    brief = motor.law.limits(motor, design)
    left = reserve if motor.law.is_on_line else 1.0
    rated = float(motor.rating.torque[design])
    return MotorLimits(rated, brief.peak, brief.start, left, _(brief.unknown) if brief.unknown else "")


def peak_share(motor: DeclaredMotor, design: int, limits: MotorLimits, torque: Array, speed: Array) -> Array:
    """Part of what it can give for a moment that torques at its speeds take, shape (n,). [N·m, rad/s]"""
    if motor.law.is_commanded:
        return np.abs(torque) / motor.ceiling(speed, design)
    return np.abs(torque) / (limits.reserve * limits.peak)


def line_start(motor: DeclaredMotor, design: int, limits: MotorLimits, inertia: float, load: float) -> StartTimeHeat:
    """Start at the lowest voltage against a constant torque, until the slip is twice the rated one.

    Parameters
    ----------
    motor : DeclaredMotor
    design : int
    limits : MotorLimits
    inertia : float
        Of all that turns, at the motor. [kg·m²]
    load : float
        [N·m]

    Returns
    -------
    StartTimeHeat
        NaN where it gets stuck, and of motors that are not switched onto a line at once.

    Notes
    -----
    docs/theory/drive, eq. (25.26).
    """
    top = float(motor.top_speed[design])
    if not starts_on_line(motor, design):
        return StartTimeHeat(np.asarray(np.nan), np.asarray(np.nan))
    end = top * (1 - _END_SLIP * motor.rated_slip(design))
    corners = motor.corner_speeds(design)
    inside = corners[(corners > 0) & (corners < end)]
    speeds = np.unique(np.concatenate([[0.0], inside, [end]]))
    return loaded_start(
        lambda speed: limits.reserve * curve(motor, design, speed),
        lambda speed: np.full(speed.shape, load),
        np.asarray(inertia),
        np.asarray(top),
        speeds,
    )


def starts_on_line(motor: DeclaredMotor, design: int) -> bool:
    """Whether it is switched onto a line at once, and its rated slip is known: then the time of a start is too."""
    is_rated = bool(motor.top_speed[design] > motor.rating.speed[design])
    return is_rated and motor.law.is_on_line and not motor.law.is_timed
