"""Induction motor by its circuit without magnetising branch: what Kloss's full formula is equal to."""

from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.motors.cage.law import CageMotor, kloss_curve
from cranktrain.motors.declared import curve_limits
from cranktrain.motors.law import MotorLaw


class Circuit(NamedTuple):
    """Circuit of one phase; rotor quantities referred to the stator.

    Attributes
    ----------
    voltage : Array
        Of a phase. [V]
    stator_resistance, rotor_resistance, reactance : Array
        The reactance is that of stator and rotor together, at the frequency of the synchronous speed. [Ω]
    synchronous_speed : Array
        [rad/s]
    """

    voltage: Array
    stator_resistance: Array
    rotor_resistance: Array
    reactance: Array
    synchronous_speed: Array


def circuit_torque(speed: Array, circuit: Circuit) -> Array:
    """Torque by the circuit. [N·m]

    Parameters
    ----------
    speed : Array, shape (..., n)
        [rad/s]
    circuit : Circuit, fields broadcastable to (..., 1)

    Notes
    -----
    docs/theory/drive, eq. (25.3), by the slip speed, which is 0 where s is.
    """
    return torque_by_slip_speed(circuit.synchronous_speed - speed, circuit)


def torque_by_slip_speed(slip_speed: Array, circuit: Circuit) -> Array:
    """Torque by the speed of the field over the shaft; a field at rest is no exception, as an inverter starts with it.

    docs/theory/drive, eq. (25.3).
    """
    resistive = circuit.stator_resistance * slip_speed + circuit.rotor_resistance * circuit.synchronous_speed
    reactive = circuit.reactance * slip_speed
    impedance = np.maximum(resistive * resistive + reactive * reactive, 1e-300)
    return 3 * circuit.voltage * circuit.voltage * circuit.rotor_resistance * slip_speed / impedance


def kloss_of_circuit(circuit: Circuit) -> CageMotor:
    """The same by Kloss's full formula.

    Notes
    -----
    docs/theory/drive, eq. (25.4).

    Examples
    --------
    >>> motor = kloss_of_circuit(Circuit(230.0, 0.9, 0.7, 2.6, 157.07963267948966))
    >>> round(float(motor.breakdown_torque), 6), round(float(motor.breakdown_slip), 8)
    (138.347721, 0.25441933)
    """
    impedance = np.hypot(circuit.stator_resistance, circuit.reactance)
    slip = circuit.rotor_resistance / impedance
    torque = 3 * circuit.voltage**2 / (2 * np.abs(circuit.synchronous_speed) * (circuit.stator_resistance + impedance))
    return kloss_curve(circuit.synchronous_speed, torque, slip, 2 * circuit.stator_resistance / impedance)


def generating_peak(motor: CageMotor) -> Array:
    """Largest braking torque of Kloss's full formula, where the shaft is faster than the field: negative. [N·m]

    Infinite where the formula has a pole. docs/theory/drive, eq. (25.4).
    """
    below = 2 - motor.asymmetry
    with np.errstate(divide="ignore"):
        peak = -motor.breakdown_torque * (2 + motor.asymmetry) / below
    return np.where(below > 0, peak, -np.inf)


def circuit_heat(speed: Array, _time: Array, circuit: Circuit) -> Array:
    """Power that turns to heat in stator and rotor of a motor by its circuit. [W]

    docs/theory/drive, eqs. (25.3) and (25.9).
    """
    current = circuit_current(circuit.synchronous_speed - speed, circuit)
    return 3 * current * current * (circuit.stator_resistance + circuit.rotor_resistance)


def circuit_current(slip_speed: Array, circuit: Circuit) -> Array:
    """Current of a phase by the speed of the field over the shaft. [A]

    docs/theory/drive, eq. (25.3).
    """
    resistive = circuit.stator_resistance * slip_speed + circuit.rotor_resistance * circuit.synchronous_speed
    impedance = np.sqrt(resistive * resistive + (circuit.reactance * slip_speed) * (circuit.reactance * slip_speed))
    return circuit.voltage * np.abs(slip_speed) / np.maximum(impedance, 1e-300)


class CircuitCurrent(NamedTuple):
    """A motor by its circuit, and its current at the rated point. [A]"""

    circuit: Circuit
    rated: Array


def circuit_current_ratio(speed: Array, _time: Array, motor: CircuitCurrent) -> Array:
    """Current of a motor by its circuit over that at the rated point."""
    return circuit_current(motor.circuit.synchronous_speed - speed, motor.circuit) / motor.rated


CIRCUIT = MotorLaw(
    "circuit",
    N_("induction motor by its circuit"),
    circuit_torque,
    Circuit,
    "docs/theory/drive, eqs. (25.3) and (25.4)",
    N_("constant resistances and reactance: no deep bars, no saturation, no magnetising current"),
    limits=curve_limits,
    heat=circuit_heat,
    current=circuit_current_ratio,
    is_on_line=True,
)
