"""Tables of the machine file for motors: one module for each kind; a new one is a line here.

A table gives its motor in SI, of all designs at a time:

    motor = declared_motor(table, designs)
    torque = motor.torque(speed, time)
"""

from typing import Annotated

from pydantic import Field

from cranktrain.questions.drive.motor_tables import cage, circuit, prime_mover, series, servo, shunt, table, wound_rotor
from cranktrain.questions.drive.motor_tables.declared import DeclaredMotor
from cranktrain.questions.drive.motor_tables.of_designs import declared_motor, motor_of
from cranktrain.questions.drive.motor_tables.spec import DrivingMotorSpec

__all__ = ["AnyMotor", "DeclaredMotor", "DrivingMotorSpec", "declared_motor", "motor_of"]

AnyMotor = Annotated[
    cage.CageSpec  # a kind of motor is a line here, and a module beside this one
    | circuit.CircuitSpec
    | wound_rotor.WoundRotorSpec
    | shunt.ShuntSpec
    | series.SeriesSpec
    | servo.ServoSpec
    | prime_mover.PrimeMoverSpec
    | table.TableSpec,
    Field(discriminator="kind"),
]
