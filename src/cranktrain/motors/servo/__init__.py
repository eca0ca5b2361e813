"""Servo motor."""

from cranktrain.language import N_
from cranktrain.motors.kind import MotorKind
from cranktrain.motors.servo.law import SERVO
from cranktrain.motors.servo.spec import ServoSpec

__all__ = ["KIND", "ServoSpec"]

KIND = MotorKind(
    "servo",
    N_("servo motor"),
    ServoSpec,
    (SERVO,),
    """\
[drive.motor]
kind = "servo"
torque = "12 N·m"                 # for long
speed = "3000 rpm"
peak_torque = "36 N·m"
# peak_power = "8 kW"             # for a short time
# top_speed = "4500 rpm"
# inertia = "0.002 kg·m²"
""",
)
