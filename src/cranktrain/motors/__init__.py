"""What drives: one folder for each kind of motor, with its table, laws and README; a new one is a line here.

A table gives its motor in SI, of all designs at a time:

    motor = motor_of(table, n_designs)
    torque = motor.torque(speed, time)
"""

from typing import TYPE_CHECKING

from cranktrain.motors import cage, circuit, prime_mover, series, servo, shunt, table, wound_rotor
from cranktrain.motors.declared import DeclaredMotor, Rating
from cranktrain.motors.kind import MotorKind
from cranktrain.motors.spec import DrivingMotorSpec, motor_of
from cranktrain.spec_class import by_kind

__all__ = ["KINDS", "AnyMotor", "DeclaredMotor", "DrivingMotorSpec", "MotorKind", "Rating", "motor_of"]

KINDS: tuple[MotorKind, ...] = (
    cage.KIND,
    circuit.KIND,
    wound_rotor.KIND,
    shunt.KIND,
    series.KIND,
    servo.KIND,
    prime_mover.KIND,
    table.KIND,
)

if TYPE_CHECKING:
    AnyMotor = DrivingMotorSpec
else:
    AnyMotor = by_kind(kind.spec for kind in KINDS)
