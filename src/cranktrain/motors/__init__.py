"""What drives: one folder for each kind of motor, with its table, laws and README; a new one is a line here.

A table gives its motor in SI, of all designs at a time:

    motor = motor_of(table, n_designs)
    torque = motor.torque(speed, time)
"""

from typing import TYPE_CHECKING

from cranktrain.folders import Folders
from cranktrain.motors.declared import DeclaredMotor, Rating
from cranktrain.motors.kind import MotorKind
from cranktrain.motors.spec import DrivingMotorSpec, motor_of
from cranktrain.when_given import by_kind

__all__ = ["KINDS", "AnyMotor", "DeclaredMotor", "DrivingMotorSpec", "MotorKind", "Rating", "motor_of"]

KINDS: Folders[MotorKind] = Folders(
    "cranktrain.motors",
    "KIND",
    ("cage", "circuit", "wound_rotor", "shunt", "series", "servo", "prime_mover", "table"),
)

if TYPE_CHECKING:
    AnyMotor = DrivingMotorSpec
else:
    AnyMotor = by_kind(KINDS)
