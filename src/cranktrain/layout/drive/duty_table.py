"""The tables [drive.duty] and [drive.flywheel]: what is asked of the motor besides a cycle, and of a flywheel."""

from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.drive.shafts import OnShaft, absent_shaft
from cranktrain.motors.spec import out_of_place
from cranktrain.quantities import (
    Dimension,
    Given,
    PositiveRatio,
    PositiveTime,
    PositiveTorque,
    Quantity,
    ShareBetween,
    ShareFromZero,
    ShareToOne,
)
from cranktrain.spec import Spec

PerHour = Annotated[Given, Quantity(Dimension.FREQUENCY, above=0.0, example="30 1/h")]
_SHARE = Given(0.4, "40 %")


class DutySpec(Spec, frozen=True):
    """How a motor is used: on and on, or with pauses; how often and how quickly it must start."""

    kind: Literal["S1", "S3", "S6"] = Field(
        default="S1", description=N_("Running on (S1), with pauses at rest (S3), or without load in their place (S6).")
    )
    duty_factor: ShareBetween | None = Field(
        default=None, description=N_("Share of a period under load, of S3 and S6; 40 % unless given.")
    )
    cycle_time: PositiveTime | None = Field(
        default=None, description=N_("Period of load and pause, of S3 and S6; 10 min unless given.")
    )
    thermal_time_constant: PositiveTime = Field(
        default=Given(1800.0, "30 min"), description=N_("In which the motor warms up at speed, as one body.")
    )
    pause_cooling: ShareToOne | None = Field(
        default=None,
        description=N_("How well it cools at rest, in parts of how well at speed, of S3; 0.5 unless given."),
    )
    constant_losses: ShareFromZero = Field(
        default=Given(0.0, "0"),
        description=N_("Share of its losses at rated load that do not hang on the load, of S3 and S6."),
    )
    start: Literal["loaded", "unloaded"] = Field(
        default="loaded",
        description=N_(
            "Against its loads at the worst crank angle, or before they act: against weights and drags alone."
        ),
    )
    starts_per_hour: PerHour | None = Field(default=None, description=N_("How often it has to start."))
    unloaded_starts: PerHour | None = Field(
        default=None, description=N_("How often the motor alone may start, of its maker; starts_per_hour needs it.")
    )
    start_load_factor: ShareToOne = Field(
        default=Given(1.0, "1"), description=N_("What the load leaves of these starts, besides its inertia.")
    )
    allowed_start_time: PositiveTime | None = Field(
        default=None, description=N_("How long a start may take; any time unless given.")
    )
    lowest_voltage: ShareToOne = Field(
        default=Given(0.9, "0.9"),
        description=N_(
            "Of the rated one, at which it must still start and carry its peaks; torques go with its square."
        ),
    )
    largest_inertia_ratio: PositiveRatio | None = Field(
        default=None,
        description=N_("Of what is driven to the rotor, at the motor; 10 for a servo motor, any for others."),
    )

    def _problems(self) -> Iterator[Problem]:
        """Find keys of pauses where there are none, and starts that nothing allows."""
        if self.kind == "S1":
            said = _('says nothing of kind = "S1", which runs on; give kind = "S3" or "S6"')
            yield from out_of_place(self, ("duty_factor", "cycle_time", "pause_cooling"), said)
        if self.kind == "S6":
            yield from out_of_place(self, ("pause_cooling",), _('says nothing of kind = "S6", which has no rest'))
        if self.starts_per_hour is not None and self.unloaded_starts is None:
            yield Problem("unloaded_starts", None, _("is missing; starts_per_hour needs it"))

    @property
    def share(self) -> Given:
        """Of a period, under load."""
        return self.duty_factor or _SHARE

    @property
    def period(self) -> Given:
        """Of load and pause. [s]"""
        return self.cycle_time or Given(600.0, "10 min")

    @property
    def cooling(self) -> Given:
        """At rest, in parts of that at speed."""
        return self.pause_cooling or Given(0.5, "0.5")


class SizedFlywheelSpec(Spec, frozen=True):
    """A flywheel to be found: with it the motor gives no more, or the crank runs as evenly as is wanted."""

    on: OnShaft = Field(
        default="motor", description=N_("On which shaft: the motor's, or that behind a stage, by its number.")
    )
    largest_torque: PositiveTorque | None = Field(
        default=None, description=N_("Of the motor, which it is not to exceed in steady running.")
    )
    fluctuation: ShareBetween | None = Field(
        default=None, description=N_("Coefficient of fluctuation of the crank's speed; instead of largest_torque.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find a flywheel for nothing, and one for two things."""
        if self.largest_torque is None and self.fluctuation is None:
            yield Problem("largest_torque", None, _("is missing; or give fluctuation"))
        if self.largest_torque is not None and self.fluctuation is not None:
            yield Problem("fluctuation", None, _("must not stand beside largest_torque: each asks for a flywheel"))

    def problems_with(self, n_stages: int, *, has_motor: bool) -> Iterator[Problem]:
        """Find a shaft that is not there, and no motor."""
        yield from absent_shaft("flywheel.on", self.on, n_stages)
        if not has_motor:
            yield Problem("motor", None, _("is missing; the flywheel helps a motor"))
