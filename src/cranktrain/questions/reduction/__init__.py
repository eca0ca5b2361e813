"""Reduction: any machine as one inertia and one torque at its crank, and what they are at every shaft of its drive."""

from collections.abc import Iterator

from cranktrain.language import N_
from cranktrain.layout.design import Designs
from cranktrain.layout.drive.declared import SHAFT_TITLES, DeclaredDrive, declared_drive, declared_grips
from cranktrain.layout.drive.table import DriveSpec
from cranktrain.layout.question import Parts, Question, ResultDimension, Stage, Use, table
from cranktrain.motors import motor_of
from cranktrain.questions.reduction import rows
from cranktrain.questions.reduction.constant_speed import constant_speed_drive, turns_evenly
from cranktrain.questions.reduction.half_periods import half_periods
from cranktrain.questions.reduction.machines import reduced_machines
from cranktrain.questions.reduction.static_torques import RULES, StaticTorques, static_torques


def _parts(designs: Designs, _known: Parts) -> Iterator[object]:
    spec = designs.together.table(DriveSpec)
    if spec is None:
        return
    motor = None if spec.motor is None else motor_of(spec.motor, designs.n_designs)
    yield declared_drive(spec, motor, designs)
    yield from declared_grips(spec.clutch, spec.brake, spec.stroke, lambda *numbers: designs.by_design(list(numbers)))
    if motor is not None:
        yield motor


def is_driven(drive: DeclaredDrive | None) -> bool:
    """Whether a drive is declared: only then anybody asks for the reduced machine."""
    return drive is not None


QUESTION = Question(
    "reduction",
    tables={"drive": DriveSpec},
    parts=_parts,
    stages=(
        Stage(reduced_machines, applies=is_driven),
        Stage(static_torques),
        Stage(half_periods),
        Stage(constant_speed_drive, applies=turns_evenly),
    ),
    dimensions=(
        ResultDimension("drive_shaft", N_("shaft of the drive"), titles=SHAFT_TITLES),
        ResultDimension("loss_rule", N_("losses"), own=0, titles=RULES),
        ResultDimension("half_period", N_("half-period"), is_number=True),
    ),
    title=N_("Drive"),
    rows=(rows.static_rows,),
    curve_tables={"drive": ("static_torque", "static_motor_torque", "driven_inertia", "constant_speed_torque")},
    uses=(Use(table("drive"), (StaticTorques,)),),
)
