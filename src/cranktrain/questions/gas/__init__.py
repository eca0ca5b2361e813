"""Gas: its pressure in the chambers, its work, and the powers that come of it."""

from collections.abc import Iterator

from cranktrain.errors import Problem, judged
from cranktrain.fluids import FluidSpec, fluid_of
from cranktrain.language import N_, _
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.question import Parts, Question, ResultDimension, Stage, TableFile, Use, keys
from cranktrain.numerics.harmonics import TURN
from cranktrain.questions.cylinders.firing import Cycle, FiringOrder
from cranktrain.questions.cylinders.parts import order_of_cylinders
from cranktrain.questions.cylinders.spec import CylindersSpec
from cranktrain.questions.cylinders.volumes import Chambers, CompressionRatios
from cranktrain.questions.gas import chambers, declared, events, flows, heat, powers, pressures, rows, unlikely

PRESSING = (declared.DeclaredGas, Chambers, CompressionRatios, Cycle, FiringOrder)
"""Parts that it takes for gas to press on pistons."""


def _problems(design: Design) -> Iterator[Problem]:
    yield from judged(declared.gas_problems(design))
    cylinder = design.table(CylindersSpec)
    if cylinder is not None and (tables := declared.gas_tables(design)) and not any(map(_fires, tables.values())):
        allowed = _("is for cylinders that fire; here every turn is one cycle")
        for key in ("firing_order", "firing_angles", "cycle"):
            given = getattr(cylinder, key)
            if given is not None and given != "two-stroke":
                yield Problem(f"cylinder.{key}", None, allowed)


def _fires(spec: FluidSpec) -> bool:
    return fluid_of(spec).fires


def _parts(designs: Designs, known: Parts) -> Iterator[object | None]:
    if designs.pistons is not None:
        gas = declared.declared_gas(designs)
        yield gas
        if gas is not None and Cycle not in known:
            yield from _turns(gas, designs, known)
        yield powers.losses_of(designs)


def _turns(gas: declared.DeclaredGas, designs: Designs, known: Parts) -> Iterator[object]:
    """Of a file that says no cycle: what does not fire works once a turn, and so does steam on both sides."""
    chambers = known.get(Chambers)
    if not gas.fires:
        yield Cycle(TURN, fires=False)
    elif gas.are_cards and isinstance(chambers, Chambers) and chambers.are_double_acting:
        yield Cycle(TURN)
        if FiringOrder not in known:
            yield order_of_cylinders(designs.together)


QUESTION = Question(
    "gas",
    tables={"gas": FluidSpec},
    problems=_problems,
    parts=_parts,
    stages=(
        Stage(chambers.gas_in_chambers, applies=chambers.can_be_filled, refuses=True),
        Stage(events.gas_events),
        Stage(pressures.gas_pressures),
        Stage(pressures.peak_pressures),
        Stage(flows.compressor_capacity, applies=flows.has_compressors),
        Stage(flows.compressor_flow),
        Stage(heat.heat_balance, applies=heat.has_heat),
        Stage(powers.indicated_powers),
        Stage(flows.compressor_stages),
        Stage(powers.brake_powers),
        Stage(unlikely.unlikely_gas),
    ),
    dimensions=(ResultDimension("gas_stage", N_("stage")),),
    headline=("brake_power", "indicated_power", "indicated_mean_pressure", "peak_pressure"),
    title=N_("Gas"),
    rows=(
        rows.compressor_rows,
        rows.pressure_rows,
        rows.power_rows,
        rows.heat_rows,
    ),
    offers={
        "gas_pressure": N_("pressures and power"),
        "brake_power": N_("friction"),
    },
    uses=(Use(keys("cylinder", "mechanical_efficiency", "friction_pressure"), (powers.BrakePowers,)),),
    files=(TableFile(("gas",), "indicator", N_("an indicator diagram")),),
)
