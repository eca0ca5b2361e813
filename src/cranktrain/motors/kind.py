"""What a kind of motor is: its table of the machine file, and the laws that the table may mean."""

from typing import Any

from cranktrain.motors.law import MotorLaw
from cranktrain.motors.spec import DrivingMotorSpec
from cranktrain.record import record


@record
class MotorKind:
    """A kind of motor, as data.

    Attributes
    ----------
    name, title : str
        Name in the machine file; title for people, not yet translated.
    spec : type of DrivingMotorSpec
        Its table of the machine file, `[drive.motor]`, which gives the motor.
    laws : tuple of MotorLaw
        Direct on line first, then with each of its starters.
    example : str
        A commented `[drive.motor]` table to start from.
    """

    name: str
    title: str
    spec: type[DrivingMotorSpec]
    laws: tuple[MotorLaw[Any], ...]
    example: str
