"""Induction motor on an inverter: voltage in proportion to frequency, a ramp, and a limit of torque."""

from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.motors.circuit.law import Circuit, circuit_heat, torque_by_slip_speed
from cranktrain.motors.declared import ramped_limits
from cranktrain.motors.induction.ramp import Ramp, limit_breaks, limit_slips, ramp_speed
from cranktrain.motors.law import MotorBreaks, MotorLaw


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


def inverter_breaks(geometry: Inverter) -> MotorBreaks:
    """The end of the ramp, and where the limit of torque lets go behind it; on the ramp that hangs on the time too."""
    circuit, limit = at_frequency(geometry.circuit, geometry.ramp.last_speed, geometry.boost), geometry.torque_limit
    reaches = 1.5 * circuit.voltage * circuit.voltage * circuit.rotor_resistance
    leans = limit * circuit.stator_resistance * circuit.rotor_resistance * circuit.synchronous_speed
    bends = limit * (circuit.stator_resistance * circuit.stator_resistance + circuit.reactance * circuit.reactance)
    rest = limit * (circuit.rotor_resistance * circuit.synchronous_speed) ** 2
    return limit_breaks(geometry.ramp, [limit_slips(bends, side * reaches - leans, rest) for side in (1.0, -1.0)])


def inverter_heat(speed: Array, time: Array, geometry: Inverter) -> Array:
    """The same on an inverter that does not limit the torque. [W]"""
    synchronous = ramp_speed(time, geometry.ramp)
    return circuit_heat(speed, time, at_frequency(geometry.circuit, synchronous, geometry.boost))


INVERTER = MotorLaw(
    "inverter",
    N_("motor on an inverter, by its circuit"),
    inverter_torque,
    Inverter,
    "docs/theory/drive, eq. (25.14)",
    N_("steady torque at every frequency; the limit of torque holds for a short time only, often a minute"),
    is_timed=True,
    breaks=inverter_breaks,
    limits=ramped_limits,
    heat=inverter_heat,
    is_on_line=True,
)
