"""Keys of the table of a cage motor: a catalogue's values, its size, or numbers of Kloss's formula."""

from typing import Annotated, Literal

from pydantic import Field

from cranktrain.language import N_
from cranktrain.motors.cage.starters import AnyStarter
from cranktrain.motors.induction.spec import AboveOne, AtLeastOne, InductionSpec, Part
from cranktrain.quantities import (
    Dimension,
    Given,
    PositiveCurrent,
    PositivePower,
    PositiveRatio,
    PositiveTorque,
    Quantity,
)

Slip = Annotated[Given, Quantity(Dimension.RATIO, above=0.0, below=1.0)]
Asymmetry = Annotated[Given, Quantity(Dimension.RATIO, at_least=0.0, below=2.0)]
VoltageRatio = Annotated[Given, Quantity(Dimension.RATIO, above=0.0, at_most=1.5)]


class CageKeys(InductionSpec, frozen=True):
    """A cage motor: rated point and ratios of a catalogue, a size, or Kloss's formula."""

    kind: Literal["cage"] = Field(description=N_("Kind of motor."))
    size: PositivePower | None = Field(
        default=None,
        description=N_(
            "Rated power of a typical four-pole motor at 50 Hz, in place of a plate; what else stands holds."
        ),
    )
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
    starter: AnyStarter | None = Field(
        default=None, description=N_("What it is started by; direct on line without it.")
    )
