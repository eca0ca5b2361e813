"""Cage motor on an inverter with full flux: torque by slip speed alone up to rated frequency."""

from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array, chosen
from cranktrain.motors.declared import ramped_limits
from cranktrain.motors.induction.ramp import Ramp, limit_breaks, limit_slips, ramp_speed
from cranktrain.motors.law import MotorBreaks, MotorLaw


class FluxInverter(NamedTuple):
    """The same without stator resistance: torque by slip speed alone up to rated frequency.

    Attributes
    ----------
    base_speed : Array
        Synchronous speed of rated frequency. [rad/s]
    breakdown_torque, breakdown_slip : Array
        At rated frequency. [N·m, 1]
    ramp : Ramp
    torque_limit : Array
        [N·m]
    """

    base_speed: Array
    breakdown_torque: Array
    breakdown_slip: Array
    ramp: Ramp
    torque_limit: Array


def flux_inverter_torque(speed: Array, time: Array, geometry: FluxInverter) -> Array:
    """Torque of a motor without stator resistance on an inverter. [N·m]

    Parameters
    ----------
    speed : Array, shape (..., n)
        [rad/s]
    time : Array, broadcastable
        Since it was switched on. [s]
    geometry : FluxInverter, fields broadcastable to (..., 1)

    Notes
    -----
    docs/theory/drive, eq. (25.15).
    """
    synchronous = ramp_speed(time, geometry.ramp)
    slip_speed = synchronous - speed
    breakdown = geometry.breakdown_slip * geometry.base_speed
    flux = 1 / np.maximum(1, np.abs(synchronous / geometry.base_speed))
    torque = 2 * geometry.breakdown_torque * flux * flux * slip_speed * breakdown
    torque = torque / (slip_speed * slip_speed + breakdown * breakdown)
    return np.minimum(geometry.torque_limit, np.maximum(-geometry.torque_limit, torque))


def flux_inverter_breaks(geometry: FluxInverter) -> MotorBreaks:
    """The same without stator resistance."""
    breakdown = geometry.breakdown_slip * geometry.base_speed
    flux = 1 / np.maximum(1, np.abs(geometry.ramp.last_speed / geometry.base_speed))
    reaches, limit = geometry.breakdown_torque * flux * flux * breakdown, geometry.torque_limit
    slips = [limit_slips(limit, side * reaches, limit * breakdown * breakdown) for side in (1.0, -1.0)]
    return limit_breaks(geometry.ramp, slips)


def flux_inverter_heat(speed: Array, time: Array, geometry: FluxInverter) -> Array:
    """The same on an inverter, which at its limit of torque keeps the slip as small as this torque needs. [W]

    docs/theory/drive, eqs. (25.9) and (25.15).
    """
    torque = flux_inverter_torque(speed, time, geometry)
    synchronous = ramp_speed(time, geometry.ramp)
    breakdown = geometry.breakdown_slip * geometry.base_speed
    flux = 1 / np.maximum(1, np.abs(synchronous / geometry.base_speed))
    part = np.minimum(1, np.abs(torque) / (geometry.breakdown_torque * flux * flux))
    needed = breakdown * part / (1 + np.sqrt((1 - part) * (1 + part)))
    slip_speed = np.abs(synchronous - speed)
    at_limit = np.abs(torque) >= geometry.torque_limit
    return np.abs(torque) * chosen(at_limit, np.minimum(needed, slip_speed), slip_speed)


FLUX_INVERTER = MotorLaw(
    "flux_inverter",
    N_("motor on an inverter, without stator resistance"),
    flux_inverter_torque,
    FluxInverter,
    "docs/theory/drive, eq. (25.15)",
    N_("full flux at all speeds up to the rated one, as by a good boost or field-oriented control"),
    is_timed=True,
    breaks=flux_inverter_breaks,
    limits=ramped_limits,
    heat=flux_inverter_heat,
    is_on_line=True,
)
