"""The table of a cage motor: by a catalogue's values, by its size, or by Kloss's formula."""

from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.quantities import (
    Dimension,
    Given,
    PositiveCurrent,
    PositiveFrequency,
    PositivePower,
    PositiveRatio,
    PositiveSpeed,
    PositiveTorque,
    Quantity,
)
from cranktrain.questions.drive.motor_tables import cage_numbers, cage_problems
from cranktrain.questions.drive.motor_tables.declared import DeclaredMotor
from cranktrain.questions.drive.motor_tables.spec import MotorSpec, RatedSpec

AboveOne = Annotated[Given, Quantity(Dimension.RATIO, above=1.0)]
AtLeastOne = Annotated[Given, Quantity(Dimension.RATIO, at_least=1.0)]
Slip = Annotated[Given, Quantity(Dimension.RATIO, above=0.0, below=1.0)]
Asymmetry = Annotated[Given, Quantity(Dimension.RATIO, at_least=0.0, below=2.0)]
Part = Annotated[Given, Quantity(Dimension.RATIO, above=0.0, at_most=1.0)]
VoltageRatio = Annotated[Given, Quantity(Dimension.RATIO, above=0.0, at_most=1.5)]


class CageSpec(RatedSpec, frozen=True):
    """A cage motor: rated point and ratios of a catalogue, a size, or Kloss's formula."""

    kind: Literal["cage"] = Field(description=N_("Kind of motor."))
    size: PositivePower | None = Field(
        default=None,
        description=N_(
            "Rated power of a typical four-pole motor at 50 Hz, in place of a plate; what else stands holds."
        ),
    )
    synchronous_speed: PositiveSpeed | None = Field(
        default=None, description=N_("Of the field; the nearest one above the rated speed at 50 Hz unless given.")
    )
    frequency: PositiveFrequency | None = Field(default=None, description=N_("Of the line; 50 Hz unless given."))
    poles: int | None = Field(default=None, ge=2, le=100, multiple_of=2, description=N_("Number of poles."))
    curve: Literal["catalogue", "kloss", "kloss_full"] = Field(
        default="catalogue",
        description=N_("Torque by slip: through a catalogue's points, or by Kloss's formula, simplified or in full."),
    )
    breakdown_ratio: AboveOne | None = Field(default=None, description=N_("Breakdown torque over rated torque."))
    starting_ratio: PositiveRatio | None = Field(
        default=None, description=N_("Torque at standstill over rated torque.")
    )
    pull_up_ratio: PositiveRatio | None = Field(
        default=None,
        description=N_("Least torque between standstill and breakdown over rated torque; that at standstill or less."),
    )
    pull_up_slip: Slip = Field(default=Given(0.8, "0.8"), description=N_("Slip at which the pull-up torque stands."))
    breakdown_torque: PositiveTorque | None = Field(
        default=None, description=N_("Largest torque of the motor that drives; for Kloss's formula.")
    )
    breakdown_slip: PositiveRatio | None = Field(default=None, description=N_("Slip there; for Kloss's formula."))
    asymmetry: Asymmetry | None = Field(
        default=None,
        description=N_("ε of Kloss's full formula, twice the stator's resistance over the rotor's, by s_b."),
    )
    voltage_ratio: VoltageRatio = Field(
        default=Given(1.0, "1"),
        description=N_("Voltage at the motor over the rated one; the torque goes with its square."),
    )
    efficiency: Part | None = Field(default=None, description=N_("Shaft power over electric power at the rated point."))
    power_factor: Part | None = Field(default=None, description=N_("cos φ at the rated point."))
    rated_current: PositiveCurrent | None = Field(default=None, description=N_("Line current at the rated point."))
    starting_current_ratio: AtLeastOne | None = Field(
        default=None, description=N_("Line current at standstill over the rated one.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find what does not go together."""
        yield from super()._problems() if self.size is None else MotorSpec._problems(self)
        yield from cage_problems.cage_problems(self)

    @property
    def rotor_inertia(self) -> Array | None:
        """Moment of inertia of the rotor: as given, or as its size has it. [kg·m²]"""
        own = super().rotor_inertia
        return cage_numbers.of_size(self).inertia if own is None and self.size is not None else own

    def declared(self) -> DeclaredMotor:
        """Give the motor in SI."""
        return cage_numbers.declared_cage(self)
