"""What the tables of starters of induction motors have in common."""

from abc import abstractmethod
from collections.abc import Iterable
from typing import Annotated, Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.motors.declared import UNLIMITED, DeclaredMotor
from cranktrain.motors.induction.ramp import Ramp
from cranktrain.quantities import Dimension, Given, PositiveSpeed, PositiveTime, PositiveTorque, Quantity
from cranktrain.spec import Spec

NonNegativeSpeed = Annotated[Given, Quantity(Dimension.SPEED, at_least=0.0)]


class StarterSpec(Spec, frozen=True):
    """What every starter of a machine file declares."""

    kind: str

    @abstractmethod
    def started(self, direct: DeclaredMotor) -> DeclaredMotor:
        """Give the motor with this starter, from that direct on line."""

    def problems_with(self, *, starting_current_is_known: bool) -> Iterable[Problem]:
        """Find what does not suit the motor; paths are relative to the motor's table."""
        return ()


class RampSpec(StarterSpec, frozen=True):
    """What every inverter declares: a ramp of frequency, and a limit of torque."""

    kind: Literal["inverter"] = Field(description=N_("Kind of starter."))
    ramp_time: PositiveTime = Field(description=N_("Time in which the field comes to its last speed."))
    first_speed: NonNegativeSpeed = Field(
        default=Given(0.0, "0 rpm"), description=N_("Synchronous speed with which the ramp begins.")
    )
    last_speed: PositiveSpeed | None = Field(
        default=None, description=N_("Synchronous speed with which it ends; that of rated frequency unless given.")
    )
    torque_limit: PositiveTorque | None = Field(
        default=None, description=N_("To which the inverter limits the torque both ways; not at all unless given.")
    )

    def ramp(self, direct: DeclaredMotor) -> Ramp:
        """Give the ramp of the field's speed."""
        last = direct.top_speed if self.last_speed is None else self.last_speed.array
        return Ramp(self.first_speed.array, last, self.ramp_time.array)

    @property
    def limit(self) -> Array:
        """Limit of torque, infinite where there is none. [N·m]"""
        return UNLIMITED if self.torque_limit is None else self.torque_limit.array
