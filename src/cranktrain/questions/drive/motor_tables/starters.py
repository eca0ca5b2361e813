"""Tables of what cage motors are started by: star and delta, a soft starter, an inverter."""

from abc import abstractmethod
from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Annotated, Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.motion import ONE, Array, single
from cranktrain.quantities import (
    Dimension,
    Given,
    NonNegativeTime,
    PositiveRatio,
    PositiveSpeed,
    PositiveTime,
    PositiveTorque,
    Quantity,
)
from cranktrain.questions.drive.motor_tables.declared import DeclaredMotor
from cranktrain.questions.drive.motor_tables.induction import Part
from cranktrain.questions.drive.motors import heat, line_current
from cranktrain.questions.drive.motors.cage import CageMotor
from cranktrain.questions.drive.motors.inverter import FLUX_INVERTER, FluxInverter, Ramp
from cranktrain.questions.drive.motors.soft_start import SOFT_START, SoftStart
from cranktrain.questions.drive.motors.star_delta import STAR_DELTA, StarDelta
from cranktrain.spec import Spec

NonNegativeSpeed = Annotated[Given, Quantity(Dimension.SPEED, at_least=0.0)]
_UNLIMITED = single(float("inf"))


class StarterSpec(Spec, frozen=True):
    """What every starter of a machine file declares."""

    kind: str

    @abstractmethod
    def started(self, direct: DeclaredMotor) -> DeclaredMotor:
        """Give the cage motor with this starter, from that direct on line."""

    def problems_with(self, *, starting_current_is_known: bool) -> Iterable[Problem]:
        """Find what does not suit the motor; paths are relative to the motor's table."""
        return ()


class StarDeltaSpec(StarterSpec, frozen=True):
    """Star, and delta after a time: a third of torque and current until then."""

    kind: Literal["star_delta"] = Field(description=N_("Kind of starter."))
    change_time: PositiveTime = Field(description=N_("Time after switching on at which star is switched off."))
    pause: NonNegativeTime = Field(
        default=Given(0.0, "0 s"), description=N_("Time without current between star and delta.")
    )

    def started(self, direct: DeclaredMotor) -> DeclaredMotor:
        """Give the cage motor with this starter."""
        times = (self.change_time.array, self.pause.array)
        return replace(
            direct,
            motor=STAR_DELTA,
            numbers=StarDelta(direct.numbers, *times),
            heat=heat.star_delta_heat,
            current=direct.current and line_current.star_delta_current,
            current_numbers=line_current.StarDeltaCurrent(direct.current_numbers, *times) if direct.current else (),
        )


class SoftStartSpec(StarterSpec, frozen=True):
    """A soft starter: a ramp of voltage, a limit of current, or both."""

    kind: Literal["soft_start"] = Field(description=N_("Kind of starter."))
    first_voltage: Part | None = Field(
        default=None, description=N_("Voltage with which the ramp begins, in parts of the rated one.")
    )
    ramp_time: PositiveTime | None = Field(
        default=None, description=N_("Time after which the voltage is the rated one.")
    )
    current_limit: PositiveRatio | None = Field(
        default=None, description=N_("Largest line current in parts of the rated one; needs starting_current_ratio.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find half a ramp, and a soft starter that does nothing."""
        if (self.first_voltage is None) != (self.ramp_time is None):
            key, other = ("ramp_time", "first_voltage")[:: 1 if self.ramp_time is None else -1]
            yield Problem(key, None, _("is missing; {other} needs it").format(other=other))
        if self.first_voltage is None and self.ramp_time is None and self.current_limit is None:
            yield Problem("current_limit", None, _("is missing; give it, or first_voltage and ramp_time"))

    def problems_with(self, *, starting_current_is_known: bool) -> Iterator[Problem]:
        """Find a limit of a current that is not known."""
        if self.current_limit is not None and not starting_current_is_known:
            yield Problem("starting_current_ratio", None, _("is missing; starter.current_limit needs it"))

    def started(self, direct: DeclaredMotor) -> DeclaredMotor:
        """Give the cage motor with this starter."""
        voltage = ONE if self.first_voltage is None else self.first_voltage.array
        time = ONE if self.ramp_time is None else self.ramp_time.array
        limit = _UNLIMITED if self.current_limit is None else self.current_limit.array
        start = direct.current_numbers.starting_current if direct.current else ONE
        numbers = SoftStart(direct.numbers, voltage, time, start, limit)
        return replace(
            direct,
            motor=SOFT_START,
            numbers=numbers,
            heat=heat.soft_start_heat,
            current=direct.current and line_current.soft_start_current,
            current_numbers=numbers if direct.current else (),
        )


class InverterSpec(StarterSpec, frozen=True):
    """An inverter with full flux: a ramp of frequency, and a limit of torque."""

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
        return _UNLIMITED if self.torque_limit is None else self.torque_limit.array

    def started(self, direct: DeclaredMotor) -> DeclaredMotor:
        """Give the cage motor on this inverter, without stator resistance."""
        own: CageMotor = direct.numbers
        ramp = self.ramp(direct)
        return replace(
            direct,
            motor=FLUX_INVERTER,
            numbers=FluxInverter(own.synchronous_speed, own.breakdown_torque, own.breakdown_slip, ramp, self.limit),
            top_speed=ramp.last_speed,
            heat=heat.flux_inverter_heat,
            current=None,
            current_numbers=(),
        )


AnyStarter = Annotated[StarDeltaSpec | SoftStartSpec | InverterSpec, Field(discriminator="kind")]
