"""The compressor's table of the machine file."""

from collections.abc import Iterator, Mapping
from typing import Annotated, ClassVar, Literal

import numpy as np
from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.fluids.compressor.chamber import CompressorNumbers
from cranktrain.fluids.compressor.stages import chain_to
from cranktrain.fluids.exchange import Exponent
from cranktrain.fluids.fluid import FluidSpec, table_path
from cranktrain.language import N_, _
from cranktrain.motion import single
from cranktrain.paths import quantity_path
from cranktrain.quantities import Dimension, Given, PositiveMolarMass, PositivePressure, Quantity, Temperature
from cranktrain.spec import missing

Loss = Annotated[Given, Quantity(Dimension.RATIO, at_least=0.0, below=1.0)]

_NONE = Given(0.0, "0")


class CompressorSpec(FluidSpec, frozen=True):
    """Compressor with clearance: pressures of the lines, exponents, and what the valves lose."""

    elsewhere: ClassVar = {
        **FluidSpec.elsewhere,
        **dict.fromkeys(("k", "n", "n1", "gamma", "polytropic_index", "exponent"), "compression_exponent"),
        **dict.fromkeys(("n2", "m"), "expansion_exponent"),
        **dict.fromkeys(("ps", "p_s", "p1", "inlet_pressure"), "suction_pressure"),
        **dict.fromkeys(("pd", "p_d", "p2", "outlet_pressure"), "discharge_pressure"),
        **dict.fromkeys(("inlet_temperature", "t1"), "suction_temperature"),
    }

    kind: Literal["compressor"] = Field(description=N_("Kind of gas model."))
    suction_pressure: PositivePressure | None = Field(
        default=None, description=N_("Absolute pressure of the line that it takes from; of a later stage found.")
    )
    discharge_pressure: PositivePressure | None = Field(
        default=None,
        description=N_("Absolute pressure of the line that it delivers into; of all stages but the last found."),
    )
    takes_from: str | None = Field(
        default=None, min_length=1, description=N_("The table [gas.NAME] of the stage before, if it is not the first.")
    )
    compression_exponent: Exponent = Field(description=N_("Exponent n of the compression, p·Vⁿ = const."))
    expansion_exponent: Exponent | None = Field(
        default=None,
        description=N_("Exponent n of the re-expansion of what is left; compression_exponent unless given."),
    )
    suction_loss: Loss = Field(
        default=_NONE, description=N_("By which part of the line's the pressure is less while suction valves are open.")
    )
    discharge_loss: Loss = Field(
        default=_NONE,
        description=N_("By which part of the line's the pressure is more while discharge valves are open."),
    )
    suction_temperature: Temperature = Field(
        default=Given(293.15, "20 °C"), description=N_("Of what it takes in; behind a cooler, that of the cooled gas.")
    )
    molar_mass: PositiveMolarMass = Field(
        default=Given(0.0289647, "28.9647 g/mol"), description=N_("Of the gas, an ideal one; dry air unless given.")
    )
    standard_pressure: PositivePressure = Field(
        default=Given(101325.0, "1.01325 bar"),
        description=N_("Of the standard state at which flow is counted as well."),
    )
    standard_temperature: Temperature = Field(
        default=Given(273.15, "0 °C"),
        description=N_("Of the standard state: 0 °C of a normal cubic metre, 60 °F of a standard cubic foot."),
    )


def compressor_numbers(spec: CompressorSpec) -> CompressorNumbers:
    """Give the numbers in SI; pressures that are to be found are NaN."""
    suction, discharge = (
        single(np.nan) if given is None else given.array for given in (spec.suction_pressure, spec.discharge_pressure)
    )
    expansion = spec.expansion_exponent or spec.compression_exponent
    return CompressorNumbers(
        suction,
        discharge,
        spec.compression_exponent.array,
        expansion.array,
        spec.suction_loss.array,
        spec.discharge_loss.array,
        spec.suction_temperature.array,
        spec.takes_from,
        spec.molar_mass.array,
        spec.standard_pressure.array,
        spec.standard_temperature.array,
    )


def stage_problems(tables: Mapping[str, CompressorSpec]) -> Iterator[Problem]:
    """Find stages that are none, and pressures that are given where the stages find them, or not given where not."""
    after: dict[str, str] = {}
    for path, spec in tables.items():
        before = table_path(spec.takes_from or "")
        if spec.takes_from is None:
            if spec.suction_pressure is None:
                yield Problem(f"{path}.suction_pressure", None, missing(PositivePressure))
        elif before not in tables or before == path:
            known = [str(quantity_path(other)[-1]) for other in tables if other != path]
            allowed = _("must be another compressor's name among the tables [gas.NAME]: {known}")
            said = allowed.format(known=", ".join(known) or _("there is none"))
            yield Problem(f"{path}.takes_from", spec.takes_from, said)
        elif before in after:
            allowed = _("is the stage before {other} already; a stage delivers to one other", other=after[before])
            yield Problem(f"{path}.takes_from", spec.takes_from, allowed)
        else:
            after[before] = path
            if spec.suction_pressure is not None:
                allowed = _("is found from the common flow; leave it out, or takes_from")
                yield Problem(f"{path}.suction_pressure", spec.suction_pressure.text, allowed)
    yield from _last_problems(tables, after)


def _last_problems(tables: Mapping[str, CompressorSpec], after: Mapping[str, str]) -> Iterator[Problem]:
    """Find stages that go round, and ends without a pressure to deliver into, or too low a one."""
    taken = {path: table_path(spec.takes_from) for path, spec in tables.items() if spec.takes_from is not None}
    before = {path: other for path, other in taken.items() if other in tables}
    for path, spec in tables.items():
        if path in after:
            if spec.discharge_pressure is not None:
                allowed = _("is found from the flow that it shares with {other}; leave it out", other=after[path])
                yield Problem(f"{path}.discharge_pressure", spec.discharge_pressure.text, allowed)
        elif spec.discharge_pressure is None:
            yield Problem(f"{path}.discharge_pressure", None, missing(PositivePressure))
        else:
            suction = tables[chain_to(path, before)[0]].suction_pressure
            if suction is not None and suction.si >= spec.discharge_pressure.si:
                allowed = _("must be more than suction_pressure, {suction}", suction=suction.text)
                yield Problem(f"{path}.discharge_pressure", spec.discharge_pressure.text, allowed)
    reached = {path for end in tables if end not in after for path in chain_to(end, before)}
    going = next((path for path in after if path not in reached), None)
    if going is not None:
        yield Problem(f"{going}.takes_from", tables[going].takes_from, _("goes round: one stage must be the first"))
