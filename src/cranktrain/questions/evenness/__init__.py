"""Evenness: the speed over the cycle, and the flywheel that keeps it even."""

from collections.abc import Iterator

from cranktrain.language import N_
from cranktrain.layout.design import Designs
from cranktrain.layout.masses import bodies_given
from cranktrain.layout.question import Dimension, Parts, Question, Stage, TableFile, Use
from cranktrain.layout.uses import inner_table, keys, table
from cranktrain.questions.evenness.applied_torque import applied_torque, of_steady_running
from cranktrain.questions.evenness.flywheel import FlywheelSize, RimSize, flywheel_size, rim_size
from cranktrain.questions.evenness.load_curve import LoadTorque, load_torque
from cranktrain.questions.evenness.running_speed import (
    RunningSpeed,
    ShaftWork,
    flywheel_moment,
    running_speed,
    shaft_work,
)
from cranktrain.questions.evenness.spec import EvennessSpec, evenness_parts


def _parts(designs: Designs, _known: Parts) -> Iterator[object]:
    specs = designs.tables(EvennessSpec)
    if specs:
        yield from evenness_parts(specs)


_TABLE = "evenness"

QUESTION = Question(
    "evenness",
    tables={_TABLE: EvennessSpec},
    parts=_parts,
    stages=(
        Stage(flywheel_moment, applies=bodies_given),
        Stage(applied_torque, applies=of_steady_running),
        Stage(load_torque),
        Stage(shaft_work),
        Stage(running_speed),
        Stage(flywheel_size),
        Stage(rim_size),
    ),
    dimensions=(Dimension("flywheel_method", N_("method")),),
    headline=("coefficient_of_fluctuation", "largest_excess_work", "wanted_flywheel_moment"),
    uses=(
        Use(table(_TABLE), (ShaftWork,)),
        Use(keys(_TABLE, "load", "flywheel", "flywheel_moment"), (RunningSpeed,)),
        Use(inner_table(_TABLE, "motor"), (RunningSpeed,)),
        Use(inner_table(_TABLE, "load_curve"), (LoadTorque,)),
        Use(keys(_TABLE, "coefficient"), (FlywheelSize,)),
        Use(inner_table(_TABLE, "rim"), (RimSize,)),
    ),
    files=(TableFile((_TABLE, "load_curve"), None, N_("a load curve")),),
)
