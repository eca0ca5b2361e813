"""Cage motor behind a soft starter: a ramp of voltage, a limit of current, or both."""

from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.motors.cage.law import CageMotor, cage_breaks, torque_at_slip
from cranktrain.motors.declared import curve_limits
from cranktrain.motors.induction.current import line_current, rotor_heat
from cranktrain.motors.induction.kloss import slip_of
from cranktrain.motors.law import MotorBreaks, MotorLaw


class SoftStart(NamedTuple):
    """A cage motor and its soft starter.

    Attributes
    ----------
    motor : CageMotor
    first_voltage : Array
        With which the ramp begins, in parts of the rated one. [1]
    ramp_time : Array
        After which it is the rated one; more than 0. [s]
    starting_current, current_limit : Array
        At standstill and rated voltage, and what is allowed, in the same unit; infinite where nothing is limited.
    """

    motor: CageMotor
    first_voltage: Array
    ramp_time: Array
    starting_current: Array
    current_limit: Array


def voltage_part(slip: Array, time: Array, geometry: SoftStart) -> Array:
    """Voltage behind the soft starter, in parts of the rated one.

    docs/theory/drive, eq. (25.13).
    """
    ramp = geometry.first_voltage + (1 - geometry.first_voltage) * np.minimum(1, time / geometry.ramp_time)
    current = line_current(slip, geometry.motor.breakdown_slip, geometry.starting_current)
    return np.minimum(ramp, 1 / np.maximum(1, current / geometry.current_limit))


def soft_start_torque(speed: Array, time: Array, geometry: SoftStart) -> Array:
    """Torque behind a soft starter, with the square of the voltage. [N·m]

    Parameters
    ----------
    speed : Array, shape (..., n)
        [rad/s]
    time : Array, broadcastable
        Since it was switched on. [s]
    geometry : SoftStart, fields broadcastable to (..., 1)

    Notes
    -----
    docs/theory/drive, eqs. (25.11) and (25.13).
    """
    slip = slip_of(speed, geometry.motor.synchronous_speed)
    voltage = voltage_part(slip, time, geometry)
    return np.sign(geometry.motor.synchronous_speed) * voltage * voltage * torque_at_slip(slip, geometry.motor)


def soft_start_breaks(geometry: SoftStart) -> MotorBreaks:
    """Those of the motor's curve, the end of the ramp, and where the limit of current lets go at rated voltage."""
    slip = limit_slip(geometry)
    beside = (geometry.motor.synchronous_speed * (1 - side * slip) for side in (1.0, -1.0))
    speeds = (*cage_breaks(geometry.motor).speeds, *beside)
    return MotorBreaks(speeds, (geometry.ramp_time,))


def limit_slip(geometry: SoftStart) -> Array:
    """Slip at which the current at rated voltage is the limit; NaN where it is nowhere above. [1]"""
    breakdown_slip = geometry.motor.breakdown_slip
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = (geometry.starting_current / geometry.current_limit) ** 2 * (1 + breakdown_slip**2)
        return np.where(ratio > 1 + breakdown_slip**2, breakdown_slip / np.sqrt(ratio - 1), np.nan)


def soft_start_heat(speed: Array, time: Array, geometry: SoftStart) -> Array:
    """The same behind a soft starter. [W]"""
    return rotor_heat(soft_start_torque(speed, time, geometry), speed, geometry.motor.synchronous_speed)


def soft_start_current(speed: Array, time: Array, geometry: SoftStart) -> Array:
    """Line current behind a soft starter, in the unit of that at standstill. docs/theory/drive, eq. (25.13)."""
    slip = slip_of(speed, geometry.motor.synchronous_speed)
    full = line_current(slip, geometry.motor.breakdown_slip, geometry.starting_current)
    return voltage_part(slip, time, geometry) * full


SOFT_START = MotorLaw(
    "soft_start",
    N_("cage motor with a soft starter"),
    soft_start_torque,
    SoftStart,
    "docs/theory/drive, eqs. (25.11) and (25.13)",
    N_("current by the slip alone, in proportion to the voltage; harmonics of the starter are left out"),
    is_timed=True,
    breaks=soft_start_breaks,
    limits=curve_limits,
    heat=soft_start_heat,
    current=soft_start_current,
    is_on_line=True,
)
