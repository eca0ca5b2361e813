"""Drive: how the machine runs with its motor, over the cycle that repeats itself."""

from collections.abc import Iterator

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.drive.table import DriveSpec
from cranktrain.layout.question import Parts, Question, Stage, Use, inner_table
from cranktrain.layout.shaft_loads import on_shafts
from cranktrain.motors import DeclaredMotor
from cranktrain.questions.drive import rows
from cranktrain.questions.drive.driven_speed import driven_speed
from cranktrain.questions.drive.steady_drive import SteadyDrive, steady_cycles, steady_drive
from cranktrain.questions.drive.unlikely import unlikely_drive
from cranktrain.questions.evenness.spec import DrivenByMotor


def _problems(design: Design) -> Iterator[Problem]:
    """Find loads that would balance what a motor balances."""
    spec = design.table(DriveSpec)
    if spec is not None and spec.motor is not None:
        allowed = _("must not stand beside [drive.motor], which balances the machine")
        balanced = (name for name, load in on_shafts(design).items() if load.is_balanced)
        yield from (Problem(f"load.{name}.scale", "balanced", allowed) for name in balanced)


def _parts(_designs: Designs, known: Parts) -> Iterator[object]:
    if DeclaredMotor in known:
        yield DrivenByMotor()


QUESTION = Question(
    "drive",
    problems=_problems,
    parts=_parts,
    stages=(Stage(steady_cycles), Stage(steady_drive), Stage(driven_speed), Stage(unlikely_drive)),
    headline=("rms_motor_torque",),
    title=N_("Drive"),
    rows=(rows.running_rows, rows.constant_speed_rows),
    offers={"motor_torque": N_("torque of the motor")},
    curve_tables={"drive": ("drive_speed", "motor_speed", "motor_torque", "transmitted_torque")},
    uses=(Use(inner_table("drive", "motor"), (SteadyDrive,)),),
)
