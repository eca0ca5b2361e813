"""Evenness: the speed over the cycle, and the flywheel that keeps it even."""

from collections.abc import Iterator, Sequence

from cranktrain.language import N_
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.masses import bodies_given
from cranktrain.layout.question import Parts, Question, ResultDimension, Stage, Use, inner_table, keys, table
from cranktrain.layout.shaft_loads import on_shafts
from cranktrain.questions.evenness import (
    flywheel,
    flywheel_moment,
    rows,
    running_speed,
    shaft_balance,
    shaft_torque,
    shaft_work,
    spec,
    unlikely,
)


def _parts(designs: Designs, _known: Parts) -> Iterator[object]:
    table = designs.together.table(spec.EvennessSpec)
    if table is not None:
        yield from spec.evenness_parts(table, designs)


def _balanced_loads(design: Design) -> Sequence[str]:
    return [f"[load.{name}]" for name, spec in on_shafts(design).items() if spec.is_balanced]


QUESTION = Question(
    "evenness",
    tables={"evenness": spec.EvennessSpec},
    parts=_parts,
    stages=(
        Stage(flywheel_moment.flywheel_moment, applies=bodies_given),
        Stage(shaft_torque.applied_torque, applies=shaft_torque.of_steady_running),
        Stage(shaft_balance.shaft_balance, applies=shaft_balance.are_balanced),
        Stage(shaft_torque.load_torque, applies=shaft_torque.are_on_shafts),
        Stage(shaft_work.shaft_work),
        Stage(running_speed.running_speed, applies=running_speed.runs_steadily),
        Stage(running_speed.for_second_run),
        Stage(flywheel.flywheel_size),
        Stage(flywheel.rim_size),
        Stage(unlikely.unlikely_evenness),
    ),
    dimensions=(ResultDimension("flywheel_method", N_("method"), own=0),),
    headline=("coefficient_of_fluctuation", "largest_excess_work", "flywheel_inertia"),
    title=N_("Evenness"),
    rows=(
        rows.running_rows,
        rows.load_rows,
        rows.balance_rows,
        rows.flywheel_rows,
    ),
    offers={
        "excess_work": N_("excess work"),
        "crank_speed": N_("the speed over the cycle"),
        "flywheel_inertia": N_("the flywheel"),
        "rim_height": N_("its rim"),
    },
    uses=(
        Use(table("evenness"), (shaft_work.ShaftWork,)),
        Use(keys("evenness", "flywheel", "flywheel_moment"), (running_speed.RunningSpeed,)),
        Use(_balanced_loads, (shaft_torque.LoadTorque,)),
        Use(keys("evenness", "coefficient"), (flywheel.FlywheelSize,)),
        Use(inner_table("evenness", "rim"), (flywheel.RimSize,)),
    ),
)
