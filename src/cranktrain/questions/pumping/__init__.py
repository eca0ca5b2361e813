"""Pumping unit: torque of its gearbox under the card of a well, and the counterbalance that evens it out."""

from collections.abc import Iterator

from cranktrain.language import N_
from cranktrain.layout.design import Designs
from cranktrain.layout.question import Parts, Question, ResultDimension, Stage, Use, table
from cranktrain.questions.pumping import rows
from cranktrain.questions.pumping.declared import DeclaredPumping, declared_pumping, pumping_problems
from cranktrain.questions.pumping.gearbox_torque import GearboxTorque, gearbox_torque
from cranktrain.questions.pumping.spec import PumpingSpec


def _parts(designs: Designs, _known: Parts) -> Iterator[object | None]:
    yield declared_pumping(designs)


def is_pumping_unit(pumping: DeclaredPumping | None) -> bool:
    """Whether a pumping unit is declared: of no other machine anybody asks."""
    return pumping is not None


QUESTION = Question(
    "pumping",
    tables={"pumping": PumpingSpec},
    problems=pumping_problems,
    parts=_parts,
    stages=(Stage(gearbox_torque, applies=is_pumping_unit),),
    dimensions=(ResultDimension("stroke_position", N_("position of the rod"), is_number=True),),
    headline=("upstroke_peak", "downstroke_peak", "cyclic_load_factor"),
    title=N_("Pumping unit"),
    rows=(rows.pumping_rows,),
    offers={"gearbox_torque": N_("net torque of the gearbox")},
    curve_tables={
        "pumping": (
            *("rod_position", "torque_factor", "polished_rod_load", "permissible_load"),
            *("rod_torque", "counterbalance_torque", "gearbox_torque"),
        )
    },
    uses=(Use(table("pumping"), (GearboxTorque,)),),
)
