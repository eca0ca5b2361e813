"""Gas: its pressure in the chambers, its work, and the powers that come of it."""

from collections.abc import Iterator
from typing import cast

from cranktrain.errors import Problem
from cranktrain.fluids import FluidSpec
from cranktrain.language import N_, _
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.question import Parts, Question, Stage, TableFile, Use
from cranktrain.layout.uses import keys
from cranktrain.questions.cylinders.firing import Cycle, FiringOrder
from cranktrain.questions.cylinders.parts import cylinders
from cranktrain.questions.cylinders.spec import CylindersSpec
from cranktrain.questions.cylinders.volumes import Chambers, CompressionRatios
from cranktrain.questions.gas import chambers, declared, events, powers, pressures

PRESSING = (declared.DeclaredGas, Chambers, CompressionRatios, Cycle, FiringOrder)
"""Parts that it takes for gas to press on pistons."""


def _problems(design: Design) -> Iterator[Problem]:
    if design.table(FluidSpec) is not None and not design.once(cylinders):
        yield Problem("gas", None, _("is not for this machine, which has no pistons"))


def _parts(designs: Designs, known: Parts) -> Iterator[object | None]:
    if designs.pistons is not None:
        specs = designs.tables(FluidSpec)
        yield declared.declared_gas(specs, cast("Chambers | None", known.get(Chambers))) if specs else None
        yield powers.losses_of(designs.tables(CylindersSpec))


QUESTION = Question(
    "gas",
    tables={"gas": FluidSpec},
    problems=_problems,
    parts=_parts,
    stages=(
        Stage(chambers.gas_in_chambers),
        Stage(events.gas_events),
        Stage(pressures.gas_pressures),
        Stage(powers.indicated_powers),
        Stage(powers.brake_powers),
    ),
    headline=("brake_power", "indicated_power", "indicated_mean_pressure", "peak_pressure"),
    uses=(Use(keys("cylinder", "mechanical_efficiency", "friction_pressure"), (powers.BrakePowers,)),),
    files=(TableFile(("gas",), "indicator", N_("an indicator diagram")),),
)
