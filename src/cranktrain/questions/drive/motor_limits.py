"""What a declared motor can do at its shaft: for long, for a moment, and at standstill."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.questions.drive.motor_tables import DeclaredMotor
from cranktrain.questions.drive.motor_tables.declared import LONG_SINCE
from cranktrain.questions.drive.motors import (
    CAGE,
    CIRCUIT,
    FLUX_INVERTER,
    INVERTER,
    SERIES,
    SERVO,
    SHUNT,
    SOFT_START,
    STAR_DELTA,
    STEPPED_ROTOR,
    TABLE,
    TIMED_ROTOR,
    WOUND_ROTOR,
)
from cranktrain.questions.drive.motors.servo import servo_limit
from cranktrain.questions.drive.sizing.starting import StartTimeHeat, loaded_start

_BY_VOLTAGE = (CAGE, CIRCUIT, STAR_DELTA, SOFT_START, INVERTER, FLUX_INVERTER, WOUND_ROTOR, STEPPED_ROTOR, TIMED_ROTOR)
"""Whose torques go with the square of the line's voltage."""
_RAMPED = (INVERTER, FLUX_INVERTER)
"""Which start with their breakdown torque, as the field begins slowly."""
_N_SPEEDS = 20_001
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
    """

    rated: float
    peak: float
    start: float
    reserve: float


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
    rated = float(motor.rating.torque[design])
    if motor.motor is SERVO:
        peak = float(motor.numbers.peak_torque[design])
        return MotorLimits(rated, peak, peak, 1.0)
    left = reserve if motor.motor in _BY_VOLTAGE else 1.0
    if motor.motor not in (*_BY_VOLTAGE, TABLE, SHUNT, SERIES):
        return MotorLimits(rated, np.nan, np.nan, left)
    speeds = _speeds(motor, design)
    running = _curve(motor, design, speeds)
    starting = _curve(motor, design, speeds, 0.0) if motor.motor is STAR_DELTA else running
    start = float(np.max(starting) if motor.motor in _RAMPED else np.min(starting[: first_largest(starting) + 1]))
    peak = _breakdown(motor, design, running) if motor.motor in (*_BY_VOLTAGE, TABLE) else np.nan
    return MotorLimits(rated, peak, start, left)


def peak_share(motor: DeclaredMotor, design: int, limits: MotorLimits, torque: Array, speed: Array) -> Array:
    """Part of what it can give for a moment that torques at its speeds take, shape (n,). [N·m, rad/s]"""
    if motor.motor is SERVO:
        own = type(motor.numbers)(*(number[design] for number in motor.numbers))
        return np.abs(torque) / servo_limit(speed, own)
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
    end = top * (1 - _END_SLIP * rated_slip(motor, design))
    corners = motor.corner_speeds(design)
    inside = corners[(corners > 0) & (corners < end)]
    speeds = np.unique(np.concatenate([[0.0], inside, [end]]))
    return loaded_start(
        lambda speed: limits.reserve * _curve(motor, design, speed),
        lambda speed: np.full(speed.shape, load),
        np.asarray(inertia),
        np.asarray(top),
        speeds,
    )


def rated_slip(motor: DeclaredMotor, design: int) -> float:
    """Slip at the rated torque: with a resistance behind slip rings more than on the plate, in its proportion. [1]

    docs/theory/drive, eq. (25.14).
    """
    own = 1 - float(motor.rating.speed[design]) / float(motor.top_speed[design])
    return own * float(motor.numbers.resistance[design]) if motor.motor is WOUND_ROTOR else own


def starts_on_line(motor: DeclaredMotor, design: int) -> bool:
    """Whether it is switched onto a line at once, and its rated slip is known: then the time of a start is too."""
    is_rated = bool(motor.top_speed[design] > motor.rating.speed[design])
    return is_rated and motor.motor in _BY_VOLTAGE and not motor.motor.is_timed


def _curve(motor: DeclaredMotor, design: int, speeds: Array, time: float = LONG_SINCE) -> Array:
    """Torque of one design at speeds, shape (n,). [N·m]"""
    return motor.torque(np.broadcast_to(speeds, (motor.n_designs, speeds.size)), time)[design]


def _speeds(motor: DeclaredMotor, design: int) -> Array:
    """Speeds from standstill up to the highest one that matters. [rad/s]"""
    top = float(motor.top_speed[design])
    if not np.isfinite(top):
        top = float(motor.numbers.speeds[-1, design]) if motor.motor is TABLE else float(motor.rating.speed[design])
    return np.linspace(0.0, top, _N_SPEEDS)


def _breakdown(motor: DeclaredMotor, design: int, running: Array) -> float:
    """Largest torque: the number of the motor where its curve is made of it."""
    if motor.motor is CAGE:
        return float(motor.numbers.breakdown_torque[design])
    return float(np.max(running))
