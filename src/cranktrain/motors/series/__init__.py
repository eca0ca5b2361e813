"""Series motor."""

from cranktrain.language import N_
from cranktrain.motors.kind import MotorKind
from cranktrain.motors.series.law import SERIES
from cranktrain.motors.series.spec import SeriesSpec

__all__ = ["KIND", "SeriesSpec"]

KIND = MotorKind(
    "series",
    N_("series motor"),
    SeriesSpec,
    (SERIES,),
    """\
[drive.motor]
kind = "series"
power = "7.5 kW"
speed = "1000 rpm"
voltage = "220 V"
rated_current = "40 A"
# inertia = "0.3 kg·m²"
""",
)
