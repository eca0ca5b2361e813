"""Engine with a governor."""

from cranktrain.language import N_
from cranktrain.motors.kind import MotorKind
from cranktrain.motors.prime_mover.law import PRIME_MOVER
from cranktrain.motors.prime_mover.spec import PrimeMoverSpec

__all__ = ["KIND", "PrimeMoverSpec"]

KIND = MotorKind(
    "prime_mover",
    N_("engine with a governor"),
    PrimeMoverSpec,
    (PRIME_MOVER,),
    """\
[drive.motor]
kind = "prime_mover"
power = "90 kW"
speed = "1500 rpm"
no_load_speed = "1570 rpm"        # the governor's droop
# inertia = "2 kg·m²"
[drive.motor.full_load]
speeds = ["800 rpm", "1200 rpm", "1600 rpm"]
torques = ["620 N·m", "680 N·m", "640 N·m"]
""",
)
