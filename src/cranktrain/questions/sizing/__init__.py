"""Sizing: which motor is enough, and which flywheel it needs."""

from collections.abc import Iterator

from cranktrain.language import N_
from cranktrain.layout.design import Designs
from cranktrain.layout.drive.table import DriveSpec
from cranktrain.layout.question import Parts, Question, ResultDimension, Stage, Use, inner_table
from cranktrain.questions.reduction.constant_speed import turns_evenly
from cranktrain.questions.sizing import rows
from cranktrain.questions.sizing.constant_speed import constant_speed_use
from cranktrain.questions.sizing.flywheel_sizing import DriveFlywheel, drive_flywheel
from cranktrain.questions.sizing.motor_checks import CHECK_TITLES
from cranktrain.questions.sizing.motor_sizing import SIZED_MOTORS, MotorSizing, motor_sizing
from cranktrain.questions.sizing.parts import WantedFlywheel, declared_duty, wanted_flywheel


def _parts(designs: Designs, _known: Parts) -> Iterator[object]:
    spec = designs.together.table(DriveSpec)
    if spec is None:
        return
    yield declared_duty(spec.duty, designs, holds_valves_open=spec.start.unloaded_until is not None)
    if spec.flywheel is not None:
        yield wanted_flywheel(spec.flywheel, designs)


def is_flywheel_wanted(wanted: WantedFlywheel | None) -> bool:
    """Whether a flywheel is to be found."""
    return wanted is not None


QUESTION = Question(
    "sizing",
    parts=_parts,
    stages=(
        Stage(motor_sizing),
        Stage(drive_flywheel, applies=is_flywheel_wanted),
        Stage(constant_speed_use, applies=turns_evenly),
    ),
    dimensions=(
        ResultDimension("sized_motor", N_("motor"), titles=SIZED_MOTORS),
        ResultDimension("sizing_check", N_("check"), titles=CHECK_TITLES),
    ),
    title=N_("Drive"),
    rows=(rows.sizing_rows, rows.flywheel_rows),
    uses=(
        Use(inner_table("drive", "duty"), (MotorSizing,)),
        Use(inner_table("drive", "flywheel"), (DriveFlywheel,)),
    ),
)
