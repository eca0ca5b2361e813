"""Induction motor on an inverter: voltage in proportion to frequency, a ramp, and a limit of torque."""

from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.questions.drive.motors.circuit import Circuit, torque_by_slip_speed
from cranktrain.questions.drive.motors.motor import Motor, MotorBreaks


class Ramp(NamedTuple):
    """Synchronous speed over time: from the first to the last [rad/s] in a time of more than 0 [s]."""

    first_speed: Array
    last_speed: Array
    ramp_time: Array


class Inverter(NamedTuple):
    """A motor by its circuit at rated frequency, and the inverter.

    Attributes
    ----------
    circuit : Circuit
        Its synchronous speed is that of rated frequency, up to which the voltage rises.
    ramp : Ramp
    boost : Array
        Voltage at frequency 0, in parts of the rated one. [1]
    torque_limit : Array
        To which the inverter limits the torque both ways; infinite where it does not. [N·m]
    """

    circuit: Circuit
    ramp: Ramp
    boost: Array
    torque_limit: Array


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


def ramp_speed(time: Array, ramp: Ramp) -> Array:
    """Synchronous speed at a time since it was switched on. [rad/s]"""
    return ramp.first_speed + (ramp.last_speed - ramp.first_speed) * np.minimum(1, time / ramp.ramp_time)


def at_frequency(circuit: Circuit, synchronous_speed: Array, boost: Array) -> Circuit:
    """Circuit at another frequency, with the voltage that the inverter gives there.

    docs/theory/drive, eq. (25.14).
    """
    part = np.abs(synchronous_speed / circuit.synchronous_speed)
    voltage = circuit.voltage * np.minimum(1, boost + (1 - boost) * part)
    reactance = circuit.reactance * part
    return Circuit(voltage, circuit.stator_resistance, circuit.rotor_resistance, reactance, synchronous_speed)


def inverter_torque(speed: Array, time: Array, geometry: Inverter) -> Array:
    """Torque of a motor on an inverter. [N·m]

    Parameters
    ----------
    speed : Array, shape (..., n)
        [rad/s]
    time : Array, broadcastable
        Since it was switched on. [s]
    geometry : Inverter, fields broadcastable to (..., 1)

    Notes
    -----
    docs/theory/drive, eqs. (25.3) and (25.14).
    """
    synchronous = ramp_speed(time, geometry.ramp)
    torque = torque_by_slip_speed(synchronous - speed, at_frequency(geometry.circuit, synchronous, geometry.boost))
    return np.minimum(geometry.torque_limit, np.maximum(-geometry.torque_limit, torque))


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


def inverter_breaks(geometry: Inverter) -> MotorBreaks:
    """The end of the ramp, and where the limit of torque lets go behind it; on the ramp that hangs on the time too."""
    circuit, limit = at_frequency(geometry.circuit, geometry.ramp.last_speed, geometry.boost), geometry.torque_limit
    reaches = 1.5 * circuit.voltage * circuit.voltage * circuit.rotor_resistance
    leans = limit * circuit.stator_resistance * circuit.rotor_resistance * circuit.synchronous_speed
    bends = limit * (circuit.stator_resistance * circuit.stator_resistance + circuit.reactance * circuit.reactance)
    rest = limit * (circuit.rotor_resistance * circuit.synchronous_speed) ** 2
    return _limit_breaks(geometry.ramp, [_limit_slips(bends, side * reaches - leans, rest) for side in (1.0, -1.0)])


def flux_inverter_breaks(geometry: FluxInverter) -> MotorBreaks:
    """The same without stator resistance."""
    breakdown = geometry.breakdown_slip * geometry.base_speed
    flux = 1 / np.maximum(1, np.abs(geometry.ramp.last_speed / geometry.base_speed))
    reaches, limit = geometry.breakdown_torque * flux * flux * breakdown, geometry.torque_limit
    slips = [_limit_slips(limit, side * reaches, limit * breakdown * breakdown) for side in (1.0, -1.0)]
    return _limit_breaks(geometry.ramp, slips)


def _limit_slips(bends: Array, half: Array, rest: Array) -> tuple[Array, Array]:
    """Slip speeds at which a limit is reached: both roots of a σ² − 2 b σ + c, NaN where there are none. [rad/s]"""
    with np.errstate(invalid="ignore", divide="ignore"):
        far = half + np.copysign(np.sqrt(half * half - bends * rest), half)
        return np.divide(far, bends), np.divide(rest, far)


def _limit_breaks(ramp: Ramp, slips: list[tuple[Array, Array]]) -> MotorBreaks:
    speeds = tuple(ramp.last_speed - slip for both in slips for slip in both)
    return MotorBreaks(speeds, (ramp.ramp_time,))


INVERTER = Motor(
    "inverter",
    N_("motor on an inverter, by its circuit"),
    inverter_torque,
    Inverter,
    "docs/theory/drive, eq. (25.14)",
    N_("steady torque at every frequency; the limit of torque holds for a short time only, often a minute"),
    is_timed=True,
    breaks=inverter_breaks,
)

FLUX_INVERTER = Motor(
    "flux_inverter",
    N_("motor on an inverter, without stator resistance"),
    flux_inverter_torque,
    FluxInverter,
    "docs/theory/drive, eq. (25.15)",
    N_("full flux at all speeds up to the rated one, as by a good boost or field-oriented control"),
    is_timed=True,
    breaks=flux_inverter_breaks,
)
