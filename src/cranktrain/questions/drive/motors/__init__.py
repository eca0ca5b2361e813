"""Kinds of motors; each is a file of data: its numbers, and its torque by speed."""

from typing import Any

from cranktrain.questions.drive.motors.brake import BRAKE
from cranktrain.questions.drive.motors.cage import CAGE
from cranktrain.questions.drive.motors.circuit import CIRCUIT
from cranktrain.questions.drive.motors.direct_current import SERIES, SHUNT
from cranktrain.questions.drive.motors.inverter import FLUX_INVERTER, INVERTER
from cranktrain.questions.drive.motors.motor import Motor
from cranktrain.questions.drive.motors.prime_mover import PRIME_MOVER
from cranktrain.questions.drive.motors.rheostat import STEPPED_ROTOR, TIMED_ROTOR
from cranktrain.questions.drive.motors.servo import SERVO
from cranktrain.questions.drive.motors.soft_start import SOFT_START
from cranktrain.questions.drive.motors.star_delta import STAR_DELTA
from cranktrain.questions.drive.motors.table import TABLE
from cranktrain.questions.drive.motors.wound_rotor import WOUND_ROTOR

MOTORS: tuple[Motor[Any], ...] = (
    CAGE,
    CIRCUIT,
    STAR_DELTA,
    SOFT_START,
    INVERTER,
    FLUX_INVERTER,
    WOUND_ROTOR,
    STEPPED_ROTOR,
    TIMED_ROTOR,
    SHUNT,
    SERIES,
    SERVO,
    TABLE,
    PRIME_MOVER,
    BRAKE,
)
