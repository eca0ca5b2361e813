"""Drive: what the motor must give through its gearing, and how the machine runs with it."""

from collections.abc import Iterator, Mapping
from typing import cast

from cranktrain.errors import Problem
from cranktrain.fluids.compressor import CompressorSpec
from cranktrain.language import N_, _
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.question import Parts, Question, ResultDimension, Stage, Use
from cranktrain.layout.shaft_loads import on_shafts
from cranktrain.layout.uses import inner_table, table
from cranktrain.questions.drive import rows
from cranktrain.questions.drive.clutched.declared import DeclaredStroke
from cranktrain.questions.drive.declared import DeclaredDrive, drive_parts
from cranktrain.questions.drive.declared_duty import WantedFlywheel
from cranktrain.questions.drive.driven_speed import driven_speed
from cranktrain.questions.drive.flywheel_sizing import DriveFlywheel, drive_flywheel
from cranktrain.questions.drive.half_periods import half_periods
from cranktrain.questions.drive.motor_sizing import MotorSizing, motor_sizing
from cranktrain.questions.drive.press_strokes import PressStrokes, press_strokes
from cranktrain.questions.drive.reduction import reduced_machines
from cranktrain.questions.drive.servo.rocking import is_rocking, rocking_course, rocking_drive
from cranktrain.questions.drive.servo.stages import is_wanted, servo_drive, wanted_crank
from cranktrain.questions.drive.spec import DriveSpec
from cranktrain.questions.drive.static_torques import StaticTorques, static_torques
from cranktrain.questions.drive.steady_drive import SteadyDrive, steady_drive
from cranktrain.questions.drive.unlikely import unlikely_drive


def _problems(design: Design) -> Iterator[Problem]:
    """Find loads that would balance what a motor balances, and valves held open where there are none."""
    spec = design.table(DriveSpec)
    open_until = None if spec is None else spec.start.unloaded_until
    if open_until is not None and not _is_compressor(design):
        allowed = _('holds the suction valves of [gas] kind = "compressor" open, which is not there')
        repair = _('for a start that is checked without loads write [drive.duty] start = "unloaded"')
        yield Problem("drive.start.unloaded_until", open_until.text, allowed, repair)
    if spec is not None and spec.motor is not None:
        allowed = _("must not stand beside [drive.motor], which balances the machine")
        balanced = (name for name, load in on_shafts(design).items() if load.is_balanced)
        yield from (Problem(f"load.{name}.scale", "balanced", allowed) for name in balanced)


def _is_compressor(design: Design) -> bool:
    """Whether any chamber is a compressor's."""
    gas: object = design.tables.get("gas")
    each = tuple(cast("Mapping[str, object]", gas).values()) if isinstance(gas, Mapping) else (gas,)
    return any(isinstance(one, CompressorSpec) for one in each)


def _parts(designs: Designs, _known: Parts) -> Iterator[object | None]:
    yield from drive_parts(designs)


def is_driven(drive: DeclaredDrive | None) -> bool:
    """Whether a drive is declared: only then anybody asks for the reduced machine."""
    return drive is not None


def is_flywheel_wanted(wanted: WantedFlywheel | None) -> bool:
    """Whether a flywheel is to be found."""
    return wanted is not None


def are_strokes_wanted(stroke: DeclaredStroke | None) -> bool:
    """Whether single strokes are asked for."""
    return stroke is not None


QUESTION = Question(
    "drive",
    tables={"drive": DriveSpec},
    problems=_problems,
    parts=_parts,
    stages=(
        Stage(reduced_machines, applies=is_driven),
        Stage(static_torques),
        Stage(half_periods),
        Stage(steady_drive),
        Stage(wanted_crank, applies=is_wanted),
        Stage(servo_drive, applies=is_wanted),
        Stage(rocking_course, applies=is_rocking),
        Stage(rocking_drive, applies=is_rocking),
        Stage(driven_speed),
        Stage(motor_sizing),
        Stage(drive_flywheel, applies=is_flywheel_wanted),
        Stage(press_strokes, applies=are_strokes_wanted),
        Stage(unlikely_drive),
    ),
    dimensions=(
        ResultDimension("drive_shaft", N_("shaft of the drive")),
        ResultDimension("loss_rule", N_("losses"), own=0),
        ResultDimension("sized_motor", N_("motor")),
        ResultDimension("sizing_check", N_("check")),
        ResultDimension("half_period", N_("half-period"), is_number=True),
    ),
    headline=("rms_motor_torque",),
    title=N_("Drive"),
    rows=(
        rows.static_rows,
        rows.running_rows,
        rows.wanted_rows,
        rows.servo_rows,
        rows.rocking_rows,
        rows.rocking_drive_rows,
        rows.sizing_rows,
        rows.flywheel_rows,
        rows.stroke_rows,
    ),
    offers={"motor_torque": N_("torque of the motor")},
    uses=(
        Use(table("drive"), (StaticTorques,)),
        Use(inner_table("drive", "motor"), (SteadyDrive,)),
        Use(inner_table("drive", "duty"), (MotorSizing,)),
        Use(inner_table("drive", "flywheel"), (DriveFlywheel,)),
        Use(inner_table("drive", "stroke"), (PressStrokes,)),
    ),
)
