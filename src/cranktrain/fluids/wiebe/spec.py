"""The table of the machine file for heat by Wiebe's law."""

from collections.abc import Iterator
from math import pi
from typing import Annotated, Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.fluids.exchange import GasExchangeSpec
from cranktrain.fluids.wiebe.chamber import WiebeNumbers
from cranktrain.language import N_, _
from cranktrain.motion import ONE, ZERO
from cranktrain.quantities import (
    Dimension,
    Given,
    HeatTransfer,
    PositiveEnergy,
    Quantity,
    Temperature,
    TurnedAngle,
)

FormFactor = Annotated[Given, Quantity(Dimension.RATIO, at_least=0.0, at_most=20.0)]
EfficiencyFactor = Annotated[Given, Quantity(Dimension.RATIO, above=0.0, at_most=50.0)]
HeatRatio = Annotated[Given, Quantity(Dimension.RATIO, above=1.0, at_most=5 / 3)]
Duration = Annotated[Given, Quantity(Dimension.ANGLE, above=0.0, at_most=pi)]

_WALLS = ("start_temperature", "wall_temperature")


class WiebeSpec(GasExchangeSpec, frozen=True):
    """Heat by Wiebe's law in one zone, between the bottom dead centres, and gas exchange at constant pressures."""

    kind: Literal["wiebe"] = Field(description=N_("Kind of gas model."))
    heat: PositiveEnergy = Field(description=N_("That one cylinder gets in a cycle, if all burns."))
    heat_start: TurnedAngle = Field(description=N_("Where it begins to burn, from the firing dead centre."))
    heat_duration: Duration = Field(description=N_("Through which angle it burns."))
    form_factor: FormFactor = Field(description=N_("m of Wiebe's law: 0 burns fastest at once, 2 in the middle."))
    efficiency_factor: EfficiencyFactor = Field(
        default=Given(6.907755278982137, "6.907755278982137"),
        description=N_("a of Wiebe's law: 6.908 burns 99.9 % of the heat, 5 only 99.3 %."),
    )
    heat_capacity_ratio: HeatRatio = Field(description=N_("γ of the gas, constant over the cycle."))
    heat_transfer: HeatTransfer | None = Field(
        default=None, description=N_("Coefficient h of the walls; they take nothing unless it is given.")
    )
    start_temperature: Temperature | None = Field(
        default=None, description=N_("Of the gas at the start of compression; for heat_transfer.")
    )
    wall_temperature: Temperature | None = Field(default=None, description=N_("Of the walls; for heat_transfer."))

    def _problems(self) -> Iterator[Problem]:
        """Find a heat transfer without its temperatures, temperatures without it, and heat beyond the turn."""
        missing, lost = _("is missing; heat_transfer needs it"), _("is for heat_transfer, which is missing")
        for name in _WALLS:
            if (getattr(self, name) is None) != (self.heat_transfer is None):
                yield Problem(name, None, lost if self.heat_transfer is None else missing)
        if not -pi < self.heat_start.si < pi or self.heat_start.si + self.heat_duration.si > pi:
            allowed = _("must leave the heat between the bottom dead centres, -180 deg to 180 deg, with heat_duration")
            yield Problem("heat_start", self.heat_start.text, allowed)


def wiebe_numbers(spec: WiebeSpec) -> WiebeNumbers:
    """Give the numbers in SI; without heat transfer any temperature will do."""
    inlet, exhaust = spec.exchange_pressures
    walls = (spec.start_temperature, spec.wall_temperature)
    return WiebeNumbers(
        start_pressure=spec.start_pressure.array,
        heat=spec.heat.array,
        start=spec.heat_start.array,
        duration=spec.heat_duration.array,
        shape=spec.form_factor.array,
        completeness=spec.efficiency_factor.array,
        heat_ratio=spec.heat_capacity_ratio.array,
        transfer=ZERO if spec.heat_transfer is None else spec.heat_transfer.array,
        start_temperature=ONE if walls[0] is None else walls[0].array,
        wall_temperature=ONE if walls[1] is None else walls[1].array,
        inlet_pressure=inlet,
        exhaust_pressure=exhaust,
    )
