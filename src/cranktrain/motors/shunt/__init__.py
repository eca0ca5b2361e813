"""Shunt motor, or one with constant magnets."""

from cranktrain.language import N_
from cranktrain.motors.kind import MotorKind
from cranktrain.motors.shunt.law import SHUNT
from cranktrain.motors.shunt.spec import ShuntSpec

__all__ = ["KIND", "ShuntSpec"]

KIND = MotorKind(
    "shunt",
    N_("shunt motor, or one with constant magnets"),
    ShuntSpec,
    (SHUNT,),
    """\
[drive.motor]
kind = "shunt"
torque = "50 N·m"
speed = "1430 rpm"
no_load_speed = "1530 rpm"
# inertia = "0.2 kg·m²"
""",
)
