"""The tables [drive.clutch], [drive.brake] and [drive.stroke] of the machine file."""

from collections.abc import Iterator
from typing import Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.drive.shafts import OnShaft, absent_shaft
from cranktrain.numerics.harmonics import TURN
from cranktrain.quantities import (
    Given,
    NonNegativeInertia,
    NonNegativeTime,
    PositivePower,
    PositiveRatio,
    PositiveTorque,
    TurnedAngle,
)
from cranktrain.spec import Spec

_AT_ONCE = Given(0.0, "0 s")
_NOTHING = Given(0.0, "0 kg·m²")


class GripSpec(Spec, frozen=True):
    """What a clutch and a brake have in common: torques, and how long they take to come on and to let go."""

    torque: PositiveTorque = Field(description=N_("While it slips, pressed on fully, at its own shaft."))
    static_torque: PositiveTorque | None = Field(
        default=None, description=N_("Up to which it holds without slip; as while it slips unless given.")
    )
    delay: NonNegativeTime = Field(
        default=_AT_ONCE, description=N_("From the command to come on until its torque begins; none unless given.")
    )
    rise_time: NonNegativeTime = Field(
        default=_AT_ONCE, description=N_("From there until its full torque, in a line; none unless given.")
    )
    release_delay: NonNegativeTime = Field(
        default=_AT_ONCE, description=N_("From the command to let go until its torque falls; none unless given.")
    )
    fall_time: NonNegativeTime = Field(
        default=_AT_ONCE, description=N_("In which a full torque falls to none, in a line; none unless given.")
    )
    mean_power: PositivePower | None = Field(
        default=None, description=N_("Heat that it gives off in the mean, and so may take up; limits strokes.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find a grip that holds less than it gives while it slips."""
        if self.static_torque is not None and self.static_torque.si < self.torque.si:
            allowed = _("must not be less than the torque while it slips, {torque}", torque=self.torque.text)
            yield Problem("static_torque", self.static_torque.text, allowed, _("leave it out if it is not known"))


class ClutchSpec(GripSpec, frozen=True):
    """A clutch between the flywheel, which turns on, and the crank."""

    on: OnShaft = Field(
        description=N_(
            "Which shaft it divides: the motor's, or that behind a stage, by its number. What [drive.part] has on that "
            "shaft turns with its driving side."
        )
    )
    driven_inertia: NonNegativeInertia = Field(
        default=_NOTHING, description=N_("Of what turns with its driven side alone; none unless given.")
    )


class BrakeSpec(GripSpec, frozen=True):
    """A brake: it slows whichever way its shaft turns, and holds it at rest."""

    on: Literal["motor", "clutch", "crank"] = Field(
        default="motor",
        description=N_("On whose shaft it sits, the motor's unless given; of a clutch, on its driven side."),
    )


class StrokeSpec(Spec, frozen=True):
    """Single strokes: from rest by the clutch, and to rest by the brake."""

    start_angle: TurnedAngle = Field(
        description=N_("Shown crank angle at which the crank rests, with the ram up: 180 deg of one below the shaft.")
    )
    command_angle: TurnedAngle | None = Field(
        default=None,
        description=N_(
            "At which the clutch is let go and the brake comes on, counted on from start_angle; unless given that "
            "with which the stroke ends a turn behind its start."
        ),
    )
    strokes_per_minute: PositiveRatio | None = Field(
        default=None, description=N_("How many are required, which the flywheel and the heat must allow.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find a command that comes before the start, or a turn behind it."""
        if self.command_angle is not None and self.command_angle.si <= self.start_angle.si:
            allowed = _("must be more than start_angle = {angle}: it comes on the way from there")
            yield Problem("command_angle", self.command_angle.text, allowed.format(angle=self.start_angle.text))
        elif self.command_angle is not None and self.command_angle.si > self.start_angle.si + TURN:
            allowed = _("must be within a turn of start_angle = {angle}: a stroke is one")
            yield Problem("command_angle", self.command_angle.text, allowed.format(angle=self.start_angle.text))


def press_problems(
    clutch: ClutchSpec | None, brake: BrakeSpec | None, stroke: StrokeSpec | None, n_stages: int
) -> Iterator[Problem]:
    """Find what the three tables show only together, or with the stages, to be wrong; paths are relative to [drive]."""
    if clutch is not None:
        yield from absent_shaft("clutch.on", clutch.on, n_stages)
    if stroke is not None:
        for key, table in (("clutch", clutch), ("brake", brake)):
            if table is None:
                yield Problem("stroke", None, _("needs [drive.{key}] as well", key=key))
    if clutch is None and brake is not None and brake.on == "clutch":
        yield Problem("brake.on", '"clutch"', _("needs [drive.clutch] as well"), _('write "motor" or "crank"'))
    elif clutch is not None and brake is not None and brake.on == "motor":
        allowed = _("leaves the crank free as soon as the clutch is let go: the brake must be behind the clutch")
        yield Problem("brake.on", '"motor"', allowed, _('write "crank" or "clutch"'))
