"""Shaft, banks and cylinders: their tables of the machine file."""

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Literal, cast

from pydantic import Field

from cranktrain.allowed import Name
from cranktrain.errors import Problem, refuse
from cranktrain.language import N_, _
from cranktrain.layout.bodies import BodySpec, GuideSpec
from cranktrain.layout.load_tables import LoadSpec
from cranktrain.listed import OneOrMany
from cranktrain.mechanisms import AnyMechanism, MechanismSpec
from cranktrain.mechanisms.spec import LISTS
from cranktrain.numerics.harmonics import TURN
from cranktrain.quantities import (
    Angle,
    AngularAcceleration,
    Given,
    Length,
    NonNegativeLength,
    PositiveSpeed,
)
from cranktrain.spec import Refused, Spec
from cranktrain.when_given import when_given

if TYPE_CHECKING:
    from cranktrain.layout.speed_table import SpeedCurveSpec
    from cranktrain.layout.wish.tables import WantedMotionSpec
else:
    SpeedCurveSpec = when_given("cranktrain.layout.speed_table", "SpeedCurveSpec")
    WantedMotionSpec = when_given("cranktrain.layout.wish.tables", "WantedMotionSpec")

ENDS = ("exhaust", "scavenge")
"""The exhaust piston first: its crank is the one that leads."""

MOST_MECHANISMS = 1000
"""Throws of a shaft, and mechanisms of a machine: more than anybody has built, and as many as memory holds."""


TURNING = ("speed", "acceleration", "speed_curve", "motion")
"""What of a shaft says how it turns, and nothing of where anything stands on it."""


class ShaftSpec(Spec, frozen=True):
    """A crankshaft: throw angles ahead of throw 1, gaps between throws along it; of `main` how it turns.

    An acceleration beside the speed makes all results those of one moment, at whatever crank angle it is; a speed curve
    says how the shaft turns over the cycle.

    Another shaft turns by ratio·φ + phase: its throw 1 stands that far ahead of where throw 1 of `main` stood at φ = 0;
    unless given, the lead of opposed pistons that work on it says so, or it is 0. Its place is where its centre lies
    from that of `main`, to the right and up.
    """

    elsewhere: ClassVar = {
        **dict.fromkeys(("n", "rpm", "omega", "ω"), "speed"),
        **dict.fromkeys(("cranks", "angles", "throw_angles"), "throws"),
        "firing_order": "[cylinder] firing_order",
        "inertia": "[evenness] flywheel",
    }

    throws: tuple[Angle, ...] = Field(
        default=(Given(0.0, "0 deg"),),
        min_length=1,
        max_length=MOST_MECHANISMS,
        description=N_("How far each throw stands ahead of throw 1; one that is to fire later stands behind."),
    )
    spacing: OneOrMany[NonNegativeLength] | None = Field(
        default=None,
        description=N_("Distance between neighbouring throws along the shaft, or a list of all; 0 for a split pin."),
    )
    speed: PositiveSpeed | None = Field(
        default=None, description=N_("Mean speed of the shaft; with it, velocities and accelerations.")
    )
    acceleration: AngularAcceleration | None = Field(
        default=None,
        description=N_(
            "Angular acceleration beside the speed, in the sense of running: all results are then of one moment."
        ),
    )
    speed_curve: SpeedCurveSpec | None = Field(
        default=None, description=N_("Speed over the crank angle in a file: at it everything is computed.")
    )
    motion: WantedMotionSpec | None = Field(
        default=None,
        description=N_("How what the crank drives is to move: the crank's speed follows, and all is computed at it."),
    )
    ratio: Literal[1, -1] = Field(
        default=1,
        description=N_("Of a shaft geared to `main`: 1 where it turns with it, -1 where it turns against it."),
    )
    phase: Angle | None = Field(
        default=None,
        description=N_(
            "Of a shaft geared to `main`: where its throw 1 stands at crank angle 0, ahead of throw 1 of `main`;"
            " unless given, the lead of opposed pistons says so."
        ),
    )
    place: tuple[Length, Length] | None = Field(
        default=None,
        description=N_(
            "Where the shaft's centre lies from that of `main`: to the right, and up; with it, it is drawn."
        ),
    )

    @property
    def turns_unevenly(self) -> bool:
        """Whether there is more to say of how it turns than one speed."""
        return self.acceleration is not None or self.speed_curve is not None or self.makes_motion

    @property
    def speed_cycle(self) -> float:
        """Crank angle after which the speed repeats: a turn, or two where the file of its curve says so. [rad]"""
        return TURN if self.speed_curve is None else self.speed_curve.cycle

    @property
    def makes_motion(self) -> bool:
        """Whether it turns as a wanted motion says, all round."""
        return self.motion is not None and self.motion.mode == "turning"

    def _problems(self) -> Iterator[Problem]:
        """Find gaps that are not as many as the throws have, an acceleration of nothing, and one beside a curve."""
        gaps = len(self.throws) - 1
        if self.spacing is not None and len(self.spacing) not in (1, gaps):
            allowed = _("must be one length, or a list of them, one for each gap between throws: {gaps}")
            yield Problem("spacing", None, allowed.format(gaps=gaps))
        if self.acceleration is not None and self.speed_curve is not None:
            allowed = _("must not stand beside speed_curve, which has its own at every angle")
            yield Problem("acceleration", None, allowed)
        elif self.acceleration is not None and self.speed is None:
            yield Problem("speed", None, _("is missing; a moment has a speed and an acceleration"))
        if self.makes_motion:
            beside = _("must not stand beside motion, from which the speed of the crank follows")
            given = ("speed", "acceleration", "speed_curve")
            yield from (Problem(name, None, beside) for name in given if getattr(self, name) is not None)


MAIN = "main"
"""Name of the shaft whose angle is the crank angle."""


class OpposedPistonSpec(Spec, frozen=True):
    """One of the two pistons of a bank of opposed-piston cylinders: its mechanism, and where that works.

    shaft is the one that it works on; throws are those of that shaft, counted from 1 (all unless given), the first for
    the bank's first cylinder; side_rods says that on a shaft that both pistons share this one is the far one.
    """

    mechanism: AnyMechanism = Field(description=N_("The mechanism of the piston."))
    shaft: str = Field(default=MAIN, description=N_("The shaft that the piston works on."))
    throws: tuple[int, ...] | None = Field(
        default=None,
        min_length=1,
        description=N_("Throws on which the bank's pistons work, counted from 1; all unless given."),
    )
    side_rods: bool = Field(
        default=False,
        description=N_("On a shaft that both pistons share: whether this one is the far one, driven by side rods."),
    )
    masses: Mapping[Name, BodySpec] = Field(
        default={}, description=N_("Bodies of this piston's mechanism, where they are not those of all.")
    )
    guide: Mapping[Name, GuideSpec] = Field(
        default={}, description=N_("Guides of this piston's mechanism, where they are not those of all.")
    )
    load: Mapping[Name, LoadSpec] = Field(default={}, description=N_("Loads on this piston's mechanism alone."))


class BankSpec(Spec, frozen=True):
    """Cylinders in one direction, or a star of them where `angle` is a list: one mechanism for each angle.

    angle counts from Y; throws are the throws that the bank works on, counted from 1 (all unless given); stagger moves
    the bank along Z toward the flywheel; shaft is the one that it works on. With opposed pistons there are, instead of
    mechanism, throws and shaft, tables for the `exhaust` and the `scavenge` piston; angle is the direction from the
    exhaust piston's shaft to the cylinder, and lead the angle by which the exhaust crank is ahead.
    """

    angle: OneOrMany[Angle] = Field(
        default=(Given(0.0, "0 deg"),),
        description=N_("From straight up to the bank's line of stroke, in the sense of rotation; a list makes a star."),
    )
    mechanism: tuple[AnyMechanism, ...] = Field(
        default=(),
        description=N_(
            "The mechanism of each cylinder; with a list of angles, a field may be a list, one value for each."
        ),
    )
    throws: tuple[int, ...] | None = Field(
        default=None, min_length=1, description=N_("Throws on which the bank works, counted from 1; all unless given.")
    )
    stagger: Length = Field(
        default=Given(0.0, "0 mm"), description=N_("By how much the bank is moved along the shaft toward the flywheel.")
    )
    shaft: str = Field(default=MAIN, description=N_("The shaft that the bank works on."))
    exhaust: OpposedPistonSpec | None = Field(
        default=None,
        description=N_("With opposed pistons: the piston of each cylinder that uncovers the exhaust ports."),
    )
    scavenge: OpposedPistonSpec | None = Field(
        default=None,
        description=N_("With opposed pistons: the piston of each cylinder that uncovers the scavenge ports."),
    )
    lead: Angle | None = Field(
        default=None,
        description=N_("By how much the exhaust crank is ahead of the scavenge crank; it phases their shafts."),
    )
    masses: Mapping[Name, BodySpec] = Field(
        default={}, description=N_("Bodies of this bank's mechanisms, where they are not those of all.")
    )
    guide: Mapping[Name, GuideSpec] = Field(
        default={}, description=N_("Guides of this bank's mechanisms, where they are not those of all.")
    )
    load: Mapping[Name, LoadSpec] = Field(default={}, description=N_("Loads on this bank's mechanisms alone."))

    @property
    def opposed(self) -> "Mapping[str, OpposedPistonSpec]":
        """The exhaust and the scavenge piston by these names; none of a bank with one piston in a cylinder."""
        return {name: piston for name in ENDS if (piston := getattr(self, name)) is not None}

    @property
    def sides(self) -> "Mapping[str, BankSpec | OpposedPistonSpec]":
        """What works on a shaft: the exhaust and the scavenge piston, or else the bank itself, by no name."""
        return self.opposed or {"": self}

    @property
    def shafts(self) -> tuple[str, ...]:
        """Names of the shafts that the bank works on."""
        return tuple(side.shaft for side in self.sides.values())

    def n_mechanisms(self, shafts: Mapping[str, ShaftSpec]) -> int:
        """Count its mechanisms: one for each throw that it works on, angle and piston; none on an unknown shaft."""
        return len(self.angle) * sum(
            len(throws_of(side, shafts)) for side in self.sides.values() if side.shaft in shafts
        )

    @classmethod
    def as_fields(cls, data: object) -> object:
        """Give each angle its own table: a field of the mechanism that is a list gives one item to each."""
        data = super().as_fields(data)
        if not isinstance(data, Mapping):
            return data
        table = cast(Mapping[str, Any], data)
        if "mechanism" not in table:
            return table
        mechanism, angles = table["mechanism"], _items(table.get("angle"))
        n_angles = 1 if angles is None else len(angles)
        if isinstance(mechanism, MechanismSpec):
            return {**table, "mechanism": (mechanism,) * n_angles}
        if not isinstance(mechanism, Mapping):
            raise Refused(_("must be one table; for several angles, a field in it may be a list"), path="mechanism")
        fields = cast(Mapping[str, Any], mechanism)
        lists = {
            name: items for name, value in fields.items() if name not in LISTS and (items := _items(value)) is not None
        }
        allowed = _("must be one value, or a list with one for each angle of the bank: {n}", n=n_angles)
        refuse(
            Problem(f"mechanism.{name}", _("a list of {n}", n=len(items)), allowed)
            for name, items in lists.items()
            if len(items) != n_angles
        )
        return {
            **table,
            "mechanism": tuple(
                {name: lists[name][i] if name in lists else value for name, value in fields.items()}
                for i in range(n_angles)
            ),
        }

    def _problems(self) -> Iterator[Problem]:
        """Find a bank without mechanism, one of two opposed pistons alone, and what belongs to the other way."""
        given = self.model_fields_set
        if self.opposed:
            missing = _("is missing; opposed pistons are two, exhaust and scavenge")
            yield from (Problem(name, None, missing) for name in ENDS if name not in self.opposed)
            allowed = _("must not stand beside opposed pistons, each of which has its own")
            yield from (Problem(name, None, allowed) for name in ("mechanism", "throws", "shaft") if name in given)
            if len(self.angle) > 1:
                yield Problem("angle", None, _("must be one angle for opposed pistons"))
            if len(self.opposed) == 2:
                yield from self._side_rod_problems()
            return
        if not self.mechanism:
            yield Problem("mechanism", None, _("is missing; or, with opposed pistons, exhaust and scavenge"))
        if self.lead is not None:
            yield Problem("lead", None, _("is for opposed pistons: give exhaust and scavenge"))

    def _side_rod_problems(self) -> Iterator[Problem]:
        """Find pistons of which it cannot be told which one is the far one, or on two shafts need not be told."""
        far = [name for name, piston in self.opposed.items() if piston.side_rods]
        if len(set(self.shafts)) == 2:
            allowed = _("is for two pistons on one shaft; on two shafts they face each other")
            yield from (Problem(f"{name}.side_rods", "true", allowed) for name in far)
            return
        if len(far) != 1:
            allowed = _(
                "must be true for just one of the two, the far piston on their shaft; or give one another shaft"
            )
            yield Problem(f"{ENDS[1]}.side_rods", None, allowed)
        if self.lead is not None:
            allowed = _("is for pistons on two shafts; on one shaft its throws say how far one is ahead")
            yield Problem("lead", None, allowed)


def throws_of(side: BankSpec | OpposedPistonSpec, shafts: Mapping[str, ShaftSpec]) -> Sequence[int]:
    """Throws that a bank or one of its opposed pistons works on, counted from 1: those given, or all of the shaft."""
    return side.throws or range(1, len(shafts[side.shaft].throws) + 1)


def _items(value: object) -> Sequence[Any] | None:
    """Items of a list, which by now may be a tuple; None for anything else."""
    return cast(Sequence[Any], value) if isinstance(value, list | tuple) else None
