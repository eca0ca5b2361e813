"""The table [rod_load] of the machine file: what the frame may bear, and what counts as a reversal."""

from collections.abc import Mapping
from typing import Annotated

from pydantic import Field

from cranktrain.language import N_
from cranktrain.layout.overridden import OverriddenSpec
from cranktrain.numerics.harmonics import TURN
from cranktrain.quantities import Dimension, Given, PositiveForce, PositiveMass, Quantity, ShareFromZeroToOne
from cranktrain.spec import Spec

Arc = Annotated[Given, Quantity(Dimension.ANGLE, at_least=0.0, at_most=TURN / 2)]


class RodTable(Spec, frozen=True):
    """Rod loads of one bank or cylinder; what it does not give, the table above it gives."""

    gas_compression: PositiveForce | None = Field(
        default=None, description=N_("The frame's limit of the gas load alone that presses the piston rod.")
    )
    gas_tension: PositiveForce | None = Field(
        default=None, description=N_("The frame's limit of the gas load alone that pulls the piston rod.")
    )
    compression: PositiveForce | None = Field(
        default=None, description=N_("The frame's limit of the load of gas and inertia at the crosshead pin, pressing.")
    )
    tension: PositiveForce | None = Field(
        default=None, description=N_("The frame's limit of the load of gas and inertia at the crosshead pin, pulling.")
    )
    crosshead: PositiveMass | None = Field(
        default=None,
        description=N_("What of the mass of the piston is the crosshead, which the piston rod does not carry."),
    )


class RodSpec(RodTable, OverriddenSpec, frozen=True):
    """Rod loads of all cylinders, what counts as a reversal, and `overrides` by bank or cylinder."""

    least_arc: Arc = Field(
        default=Given(TURN / 24, "15 deg"),
        description=N_("Degrees that the load at the crosshead pin must be of either sense; 15° as by API 618."),
    )
    least_share: ShareFromZeroToOne = Field(
        default=Given(0.03, "3 %"),
        description=N_("What the smaller of both peaks must be of the larger; 3 % as by API 618."),
    )
    overrides: Mapping[str, RodTable] = Field(
        default={},
        alias="NAME (a bank or cylinder)",
        description=N_("What one bank or one cylinder has of its own."),
    )
