"""Motor by a table of torques at speeds."""

from cranktrain.language import N_
from cranktrain.motors.kind import MotorKind
from cranktrain.motors.table.law import TABLE
from cranktrain.motors.table.spec import TableSpec

__all__ = ["KIND", "TableSpec"]

KIND = MotorKind(
    "table",
    N_("motor by a table of torques at speeds"),
    TableSpec,
    (TABLE,),
    """\
[drive.motor]
kind = "table"
speeds = ["0 rpm", "1000 rpm", "1400 rpm", "1500 rpm"]
torques = ["110 N·m", "150 N·m", "60 N·m", "0 N·m"]
# power = "8 kW"                  # of the plate, with speed
# speed = "1430 rpm"
# inertia = "0.05 kg·m²"
""",
)
