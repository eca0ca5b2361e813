"""Motor with slip rings."""

from cranktrain.language import N_
from cranktrain.motors.kind import MotorKind
from cranktrain.motors.wound_rotor.law import WOUND_ROTOR
from cranktrain.motors.wound_rotor.rheostat import STEPPED_ROTOR, TIMED_ROTOR
from cranktrain.motors.wound_rotor.spec import WoundRotorSpec

__all__ = ["KIND", "WoundRotorSpec"]

KIND = MotorKind(
    "wound_rotor",
    N_("motor with slip rings"),
    WoundRotorSpec,
    (
        WOUND_ROTOR,
        STEPPED_ROTOR,
        TIMED_ROTOR,
    ),
    """\
[drive.motor]
kind = "wound_rotor"
power = "45 kW"
speed = "1460 rpm"
breakdown_ratio = 2.8             # over the rated torque
# resistance_ratio = 2            # all of the rotor's circuit over the rotor's own
# inertia = "0.6 kg·m²"
# [drive.motor.rheostat]          # instead of resistance_ratio
# steps = 3
# peak_ratio = 2
""",
)
