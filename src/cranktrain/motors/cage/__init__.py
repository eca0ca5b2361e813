"""Cage motor."""

from cranktrain.language import N_
from cranktrain.motors.cage.inverter import FLUX_INVERTER
from cranktrain.motors.cage.law import CAGE
from cranktrain.motors.cage.soft_start import SOFT_START
from cranktrain.motors.cage.spec import CageSpec
from cranktrain.motors.cage.star_delta import STAR_DELTA
from cranktrain.motors.kind import MotorKind

__all__ = ["KIND", "CageSpec"]

KIND = MotorKind(
    "cage",
    N_("cage motor"),
    CageSpec,
    (
        CAGE,
        STAR_DELTA,
        SOFT_START,
        FLUX_INVERTER,
    ),
    """\
[drive.motor]
kind = "cage"
power = "7.5 kW"                  # of the plate; or size = "7.5 kW" alone, of a typical four-pole motor
speed = "1465 rpm"
breakdown_ratio = 3.0             # torques over the rated one
starting_ratio = 2.3
# pull_up_ratio = 1.8
# starting_current_ratio = 7.2
# inertia = "0.03 kg·m²"          # of the rotor
# [drive.motor.starter]
# kind = "star_delta"             # or "soft_start", "inverter"
# change_time = "3 s"
""",
)
