"""Induction motor by its circuit."""

from cranktrain.language import N_
from cranktrain.motors.circuit.inverter import INVERTER
from cranktrain.motors.circuit.law import CIRCUIT
from cranktrain.motors.circuit.spec import CircuitSpec
from cranktrain.motors.kind import MotorKind

__all__ = ["KIND", "CircuitSpec"]

KIND = MotorKind(
    "circuit",
    N_("induction motor by its circuit"),
    CircuitSpec,
    (
        CIRCUIT,
        INVERTER,
    ),
    """\
[drive.motor]
kind = "circuit"
phase_voltage = "230 V"
stator_resistance = "0.9 Ω"
rotor_resistance = "0.7 Ω"        # referred to the stator
reactance = "2.6 Ω"               # of both together
synchronous_speed = "1500 rpm"
# power = "11 kW"                 # of the plate, with speed
# speed = "1410 rpm"
# [drive.motor.starter]
# kind = "inverter"
# ramp_time = "2 s"
# boost = 0.1
""",
)
