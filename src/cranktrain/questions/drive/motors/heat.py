"""What heats motors: power that turns to heat in their windings, by speed and time, at their own shaft."""

import numpy as np

from cranktrain.motion import Array, chosen
from cranktrain.questions.drive.motors.cage import CageMotor, cage_torque
from cranktrain.questions.drive.motors.circuit import Circuit
from cranktrain.questions.drive.motors.current import rotor_heat
from cranktrain.questions.drive.motors.direct_current import SeriesMotor, ShuntMotor, series_torque, shunt_torque
from cranktrain.questions.drive.motors.inverter import (
    FluxInverter,
    Inverter,
    at_frequency,
    flux_inverter_torque,
    ramp_speed,
)
from cranktrain.questions.drive.motors.rheostat import SteppedRotor, TimedRotor, stepped_rotor, timed_rotor
from cranktrain.questions.drive.motors.soft_start import SoftStart, soft_start_torque
from cranktrain.questions.drive.motors.star_delta import StarDelta, star_delta_torque
from cranktrain.questions.drive.motors.wound_rotor import WoundRotor, wound_rotor_torque


def cage_heat(speed: Array, _time: Array, motor: CageMotor) -> Array:
    """Power that turns to heat in a cage, direct on line. [W]

    docs/theory/drive, eq. (25.9).
    """
    return rotor_heat(cage_torque(speed, motor), speed, motor.synchronous_speed)


def star_delta_heat(speed: Array, time: Array, geometry: StarDelta) -> Array:
    """The same in star and in delta. [W]"""
    return rotor_heat(star_delta_torque(speed, time, geometry), speed, geometry.motor.synchronous_speed)


def soft_start_heat(speed: Array, time: Array, geometry: SoftStart) -> Array:
    """The same behind a soft starter. [W]"""
    return rotor_heat(soft_start_torque(speed, time, geometry), speed, geometry.motor.synchronous_speed)


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


def inverter_heat(speed: Array, time: Array, geometry: Inverter) -> Array:
    """The same on an inverter that does not limit the torque. [W]"""
    synchronous = ramp_speed(time, geometry.ramp)
    return circuit_heat(speed, time, at_frequency(geometry.circuit, synchronous, geometry.boost))


def wound_rotor_heat(speed: Array, _time: Array, rotor: WoundRotor) -> Array:
    """Power that turns to heat in the rotor itself; the rest of it does in the resistance. [W]

    docs/theory/drive, eqs. (25.9) and (25.16).
    """
    return rotor_heat(wound_rotor_torque(speed, rotor), speed, rotor.synchronous_speed) / rotor.resistance


def stepped_rotor_heat(speed: Array, time: Array, geometry: SteppedRotor) -> Array:
    """The same with steps that go out as the slip falls. [W]"""
    return wound_rotor_heat(speed, time, stepped_rotor(speed, geometry))


def timed_rotor_heat(speed: Array, time: Array, geometry: TimedRotor) -> Array:
    """The same with steps that go out by time. [W]"""
    return wound_rotor_heat(speed, time, timed_rotor(time, geometry))


def shunt_heat(speed: Array, _time: Array, motor: ShuntMotor) -> Array:
    """Power that turns to heat in the armature's circuit: what the line gives, M ω₀, less what the shaft takes. [W]"""
    return shunt_torque(speed, motor) * (motor.no_load_speed - speed)


def series_heat(speed: Array, _time: Array, motor: SeriesMotor) -> Array:
    """Power that turns to heat in field and armature, I²R with M = cI². [W]"""
    return series_torque(speed, motor) * motor.resistance / motor.constant
