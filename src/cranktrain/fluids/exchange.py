"""What the tables of fluids declare alike: exponents of polytropes, and the pressures of a gas exchange."""

from typing import Annotated

from pydantic import Field

from cranktrain.fluids.fluid import FluidSpec
from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.quantities import Dimension, Given, PositivePressure, Quantity

Exponent = Annotated[Given, Quantity(Dimension.RATIO, above=0.0, at_most=2.0)]


class GasExchangeSpec(FluidSpec, frozen=True):
    """Cycle with gas exchange: the pressure at the start of compression, and those of the strokes between."""

    start_pressure: PositivePressure = Field(
        description=N_("Absolute pressure at the start of compression, at the bottom dead centre.")
    )
    inlet_pressure: PositivePressure | None = Field(
        default=None,
        description=N_("Absolute pressure in the cylinder on the inlet stroke; start_pressure unless given."),
    )
    exhaust_pressure: PositivePressure | None = Field(
        default=None,
        description=N_("Absolute pressure in the cylinder on the exhaust stroke; inlet_pressure unless given."),
    )

    @property
    def exchange_pressures(self) -> tuple[Array, Array]:
        """On the inlet stroke and on the exhaust stroke. [Pa]"""
        inlet = self.inlet_pressure or self.start_pressure
        return inlet.array, (self.exhaust_pressure or inlet).array
