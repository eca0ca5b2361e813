"""Gas: its pressure in the chambers, its work, and the powers that come of it."""

from collections.abc import Iterator

from cranktrain.errors import Problem
from cranktrain.gas import GasSpec
from cranktrain.language import N_, _
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.question import Parts, Question, Stage, TableFile, Use
from cranktrain.layout.uses import keys
from cranktrain.questions.cylinders.firing import Cycle, FiringOrder
from cranktrain.questions.cylinders.parts import cylinders
from cranktrain.questions.cylinders.spec import CylindersSpec
from cranktrain.questions.cylinders.volumes import Chambers, CompressionRatios
from cranktrain.questions.gas import chambers, events, powers, pressures

PRESSING = (chambers.DeclaredGas, Chambers, CompressionRatios, Cycle, FiringOrder)
"""Parts that it takes for gas to press on pistons."""


def _problems(design: Design) -> Iterator[Problem]:
    if design.table(GasSpec) is not None and not design.once(cylinders):
        yield Problem("gas", None, _("is not for this machine, which has no pistons"))


def _parts(designs: Designs, _known: Parts) -> Iterator[object | None]:
    if designs.pistons is not None:
        specs = designs.tables(GasSpec)
        yield chambers.DeclaredGas(specs) if specs else None
        yield powers.losses_of(designs.tables(CylindersSpec))


QUESTION = Question(
    "gas",
    tables={"gas": GasSpec},
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
