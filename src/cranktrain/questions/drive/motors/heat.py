"""What heats motors: power that turns to heat in the rotor of an induction motor, by speed and time."""

from cranktrain.motion import Array
from cranktrain.questions.drive.motors.cage import CageMotor, cage_torque
from cranktrain.questions.drive.motors.current import rotor_heat


def cage_heat(speed: Array, _time: Array, motor: CageMotor) -> Array:
    """Power that turns to heat in a cage, direct on line. [W]

    docs/theory/drive, eq. (25.9).
    """
    return rotor_heat(cage_torque(speed, motor), speed, motor.synchronous_speed)
