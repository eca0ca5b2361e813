"""The table [drive] of the machine file: what drives the crank, through which gearing, and how it starts."""

from collections.abc import Iterator, Mapping
from typing import Annotated, Literal, TypeAlias

import numpy as np
from pydantic import Field

from cranktrain.allowed import Name
from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.drive.duty_table import DutySpec, SizedFlywheelSpec
from cranktrain.layout.drive.grip_tables import BrakeSpec, ClutchSpec, StrokeSpec, press_problems
from cranktrain.layout.drive.shafts import OnShaft, absent_shaft
from cranktrain.motion import Array
from cranktrain.motors import AnyMotor
from cranktrain.paths import path_text
from cranktrain.quantities import (
    Angle,
    Dimension,
    FlywheelMoment,
    Given,
    NonNegativeInertia,
    NonNegativeTime,
    PositivePressure,
    PositiveRatio,
    PositiveSpeed,
    PositiveTime,
    Quantity,
    Speed,
)
from cranktrain.spec import Spec

Efficiency = Annotated[Given, Quantity(Dimension.RATIO, above=0.0, at_most=1.0)]
EfficiencyBack = Annotated[Given, Quantity(Dimension.RATIO, at_most=1.0)]
GearAngle = Annotated[Given, Quantity(Dimension.ANGLE, above=0.0)]
Drag = Annotated[Given, Quantity(Dimension.TORQUE, at_least=0.0)]
Tolerance = Annotated[Given, Quantity(Dimension.RATIO, at_least=1e-12, at_most=1e-3)]

StageKind: TypeAlias = Literal["gear", "worm", "belt", "chain", "coupling", "linkage"]

_LOSSLESS = Given(1.0, "1")
_ALIKE = ("coupling", "linkage")
"""Kinds of stages on whose both sides the shafts turn alike."""
_OF_STROKES = frozenset({"interval", "tolerance"})
"""Keys of [drive.start] that strokes have, too."""


class StageSpec(Spec, frozen=True):
    """A gear, belt or other stage; the first one stands at the motor, the last one at the crank."""

    kind: StageKind | None = Field(
        default=None,
        description=N_("What it is, for schemes: they draw a plain box unless given. A worm's angles say so, too."),
    )
    ratio: PositiveRatio = Field(description=N_("Turns of its input for one turn of its output."))
    efficiency: Efficiency | None = Field(
        default=None, description=N_("While power flows toward the crank; 1 unless given, or by the angles of a worm.")
    )
    efficiency_back: EfficiencyBack | None = Field(
        default=None,
        description=N_(
            "While the crank drives; as much friction both ways, 2 − 1/efficiency, unless given. Less than 0: it holds."
        ),
    )
    lead_angle: GearAngle | None = Field(default=None, description=N_("Of a worm, instead of efficiencies."))
    friction_angle: GearAngle | None = Field(default=None, description=N_("Of a worm, beside its lead_angle."))
    drag: Drag = Field(
        default=Given(0.0, "0 N·m"), description=N_("Torque that it takes at its input, whatever it passes on.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find a worm of one angle, or beside efficiencies or another kind, and a coupling that changes the speed."""
        angles = [name for name in ("lead_angle", "friction_angle") if getattr(self, name) is not None]
        if len(angles) == 1:
            missing = "friction_angle" if angles == ["lead_angle"] else "lead_angle"
            yield Problem(missing, None, _("is missing; a worm needs both its angles"))
        lead, friction = self.lead_angle, self.friction_angle
        if lead is not None and friction is not None and lead.si + friction.si >= np.pi / 2:
            allowed = _("must be, with friction_angle, less than 90 deg: beyond it the worm cannot turn its wheel")
            yield Problem("lead_angle", lead.text, allowed)
        given = [name for name in ("efficiency", "efficiency_back") if getattr(self, name) is not None]
        if angles:
            beside = _("must not stand beside the angles of a worm, which give it")
            yield from (Problem(name, getattr(self, name).text, beside) for name in given)
        yield from self._kind_problems(is_worm=bool(angles))

    def _kind_problems(self, *, is_worm: bool) -> Iterator[Problem]:
        """Find a kind that the other keys contradict."""
        if is_worm and self.kind not in (None, "worm"):
            allowed = _('must be "worm" or left out beside lead_angle and friction_angle, which only a worm has')
            yield Problem("kind", f'"{self.kind}"', allowed)
        if self.kind in _ALIKE and np.any(self.ratio.array != 1):
            allowed = _('must be 1 beside kind = "{kind}", both of whose shafts turn alike')
            yield Problem("ratio", self.ratio.text, allowed.format(kind=self.kind))

    @property
    def efficiencies(self) -> tuple[Array, Array]:
        """While power flows toward the crank, and while the crank drives. [1]"""
        from cranktrain.transient.gearing import equal_friction, worm_efficiencies

        if self.lead_angle is not None and self.friction_angle is not None:
            return worm_efficiencies(self.lead_angle.array, self.friction_angle.array)
        forward = (self.efficiency or _LOSSLESS).array
        return forward, equal_friction(forward) if self.efficiency_back is None else self.efficiency_back.array


class PartSpec(Spec, frozen=True):
    """What turns with a shaft of the drive: coupling, brake pulley, gear wheel, flywheel."""

    on: OnShaft = Field(
        default="motor", description=N_("On which shaft: the motor's, or that behind a stage, by its number.")
    )
    inertia: NonNegativeInertia | None = Field(default=None, description=N_("About its own axis."))
    flywheel_moment: FlywheelMoment | None = Field(
        default=None, description=N_("GD², four times the moment of inertia; instead of inertia.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find a part without inertia, and one with two."""
        if self.inertia is None and self.flywheel_moment is None:
            yield Problem("inertia", None, _("is missing; or give flywheel_moment, GD²"))
        elif self.inertia is not None and self.flywheel_moment is not None:
            yield Problem("flywheel_moment", None, _("must not stand beside inertia; GD² = 4 J says the same"))

    @property
    def moment(self) -> Array:
        """Moment of inertia, however it is given. [kg·m²]"""
        given = self.flywheel_moment
        return self.inertia.array if self.inertia is not None else (given.array / 4 if given is not None else 0.0)  # pyright: ignore[reportReturnType]


class StartSpec(Spec, frozen=True):
    """How a run begins, what happens in it, and when it ends."""

    angle: Angle = Field(default=Given(0.0, "0 deg"), description=N_("Crank angle, as shown, at which it begins."))
    speed: Speed = Field(default=Given(0.0, "0 rpm"), description=N_("Of the crank at the beginning."))
    duration: PositiveTime | None = Field(
        default=None,
        description=N_("The most that is computed, 60 s unless given; less if it comes to rest before."),
    )
    until_speed: PositiveSpeed | None = Field(
        default=None, description=N_("Of the crank: it ends when this is reached.")
    )
    overspeed: PositiveSpeed | None = Field(
        default=None, description=N_("Of the crank: it ends when a load drives it beyond.")
    )
    motor_off: NonNegativeTime | None = Field(
        default=None, description=N_("When the motor is switched off; then it coasts.")
    )
    motor_reversed: NonNegativeTime | None = Field(
        default=None,
        description=N_(
            "When the motor is switched to turn the other way: plugging; it ends run up that way unless told otherwise."
        ),
    )
    brake_on: NonNegativeTime | None = Field(default=None, description=N_("When the brake is commanded."))
    unloaded_until: NonNegativeTime | None = Field(
        default=None, description=N_("Until when a compressor's suction valves are held open.")
    )
    gas_pressure: PositivePressure | None = Field(
        default=None,
        description=N_("Absolute pressure in a compressor's chambers at the beginning; that of suction unless given."),
    )
    interval: PositiveTime | None = Field(default=None, description=N_("Between the times that are shown."))
    tolerance: Tolerance = Field(
        default=Given(1e-8, "1e-8"), description=N_("Of one step: of the angle in rad, of the speed in parts of it.")
    )


class DriveSpec(Spec, frozen=True):
    """What drives the crank of shaft main: a motor, stages between, what turns with their shafts, and a start."""

    motor: AnyMotor | None = Field(default=None, description=N_("The motor; all its numbers at its own shaft."))
    stage: tuple[StageSpec, ...] = Field(
        default=(), description=N_("Gear and belt stages from the motor to the crank, in their order.")
    )
    part: Mapping[Name, PartSpec] = Field(
        default={}, description=N_("What turns with a shaft of the drive, by name: couplings, pulleys, flywheels.")
    )
    clutch: ClutchSpec | None = Field(
        default=None, description=N_("Between a flywheel that turns on and the crank; locked but in strokes.")
    )
    brake: BrakeSpec | None = Field(default=None, description=N_("What stops the machine, and holds it."))
    stroke: StrokeSpec | None = Field(
        default=None, description=N_("Single strokes, from rest by the clutch and to rest by the brake.")
    )
    start: StartSpec = Field(default=StartSpec(), description=N_("How a run begins and when it ends."))
    duty: DutySpec | None = Field(default=None, description=N_("How the motor is used; on and on unless given."))
    flywheel: SizedFlywheelSpec | None = Field(default=None, description=N_("A flywheel that is to be found."))

    def _problems(self) -> Iterator[Problem]:
        """Find parts on no shaft, a flywheel to be found without a motor, what a press or a brake does not have."""
        if self.flywheel is not None:
            yield from self.flywheel.problems_with(len(self.stage), has_motor=self.motor is not None)
        yield from press_problems(self.clutch, self.brake, self.stroke, len(self.stage))
        yield from self._start_problems()
        for name, part in self.part.items():
            yield from absent_shaft(path_text(("part", name, "on")), part.on, len(self.stage))

    def _start_problems(self) -> Iterator[Problem]:
        """Find a command to no brake, or to one that only strokes know, and a start beside strokes."""
        command = self.start.brake_on
        if command is not None and self.brake is None:
            yield Problem("start.brake_on", command.text, _("needs [drive.brake] as well"))
        elif command is not None and self.brake is not None and self.brake.on == "clutch":
            allowed = _('is of a brake on the motor or the crank; one with on = "clutch" acts in [drive.stroke]')
            yield Problem("start.brake_on", command.text, allowed)
        off, back = self.start.motor_off, self.start.motor_reversed
        if off is not None and back is not None and back.si >= off.si:
            allowed = _("must be before motor_off = {off}: a motor that is off cannot brake")
            yield Problem("start.motor_reversed", back.text, allowed.format(off=off.text))
        if self.stroke is not None and self.motor is None:
            yield Problem("stroke", None, _("needs [drive.{key}] as well", key="motor"))
        if self.stroke is not None:
            allowed = _("must not stand beside [drive.stroke]: a start is a stroke then")
            for name in sorted(self.start.model_fields_set - _OF_STROKES):
                given = getattr(self.start, name)
                yield Problem(f"start.{name}", getattr(given, "text", None), allowed)
