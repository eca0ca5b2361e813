"""Tables of what cage motors are started by: star and delta, a soft starter, an inverter."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Annotated, Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.motion import ONE
from cranktrain.motors.cage.inverter import FLUX_INVERTER, FluxInverter
from cranktrain.motors.cage.law import CageMotor
from cranktrain.motors.cage.soft_start import SOFT_START, SoftStart
from cranktrain.motors.cage.star_delta import STAR_DELTA, StarDelta, StarDeltaCurrent
from cranktrain.motors.declared import UNLIMITED, DeclaredMotor
from cranktrain.motors.induction.spec import Part, RampSpec, StarterSpec
from cranktrain.quantities import (
    Given,
    NonNegativeTime,
    PositiveRatio,
    PositiveTime,
)


class StarDeltaSpec(StarterSpec, frozen=True):
    """Star, and delta after a time: a third of torque and current until then."""

    kind: Literal["star_delta"] = Field(description=N_("Kind of starter."))
    change_time: PositiveTime = Field(description=N_("Time after switching on at which star is switched off."))
    pause: NonNegativeTime = Field(
        default=Given(0.0, "0 s"), description=N_("Time without current between star and delta.")
    )

    def started(self, direct: DeclaredMotor) -> DeclaredMotor:
        """Give the cage motor with this starter."""
        times, of_current = (self.change_time.array, self.pause.array), direct.current_numbers
        return replace(
            direct,
            law=STAR_DELTA,
            numbers=StarDelta(direct.numbers, *times),
            current_numbers=None if of_current is None else StarDeltaCurrent(of_current, *times),
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
            yield Problem(key, None, _("is missing; {other} needs it", other=other))
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
        limit = UNLIMITED if self.current_limit is None else self.current_limit.array
        start = ONE if direct.current_numbers is None else direct.current_numbers.starting_current
        numbers = SoftStart(direct.numbers, voltage, time, start, limit)
        return replace(
            direct,
            law=SOFT_START,
            numbers=numbers,
            current_numbers=None if direct.current_numbers is None else numbers,
        )


class InverterSpec(RampSpec, frozen=True):
    """An inverter with full flux: a ramp of frequency, and a limit of torque."""

    def started(self, direct: DeclaredMotor) -> DeclaredMotor:
        """Give the cage motor on this inverter, without stator resistance."""
        own: CageMotor = direct.numbers
        ramp = self.ramp(direct)
        return replace(
            direct,
            law=FLUX_INVERTER,
            numbers=FluxInverter(own.synchronous_speed, own.breakdown_torque, own.breakdown_slip, ramp, self.limit),
            top_speed=ramp.last_speed,
            current_numbers=None,
        )


AnyStarter = Annotated[StarDeltaSpec | SoftStartSpec | InverterSpec, Field(discriminator="kind")]
