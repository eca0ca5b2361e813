"""Counterweights and balance shafts: the table [balance] of the machine file."""

from collections.abc import Iterator, Mapping, Sequence
from math import pi
from typing import Annotated, Literal, TypeAlias

import numpy as np
from pydantic import Field

from cranktrain.allowed import Name
from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import HIGHEST_ORDER
from cranktrain.listed import OneOrMany
from cranktrain.motion import Array
from cranktrain.quantities import (
    Angle,
    Dimension,
    Given,
    Length,
    NonNegativeLength,
    PositiveDensity,
    PositiveForce,
    PositiveLength,
    PositiveMass,
    Quantity,
    ShareFromZeroToOne,
)
from cranktrain.spec import Spec

_NONE = Given(0.0, "0 mm")
Opening = Annotated[Given, Quantity(Dimension.ANGLE, above=0.0, at_most=2 * pi, example="120 deg")]
Spot = tuple[Length, Length]
Against: TypeAlias = Literal["force", "couple", "both"]
Counterweights: TypeAlias = Literal["rotating", "least_force"]
_AT_CRANK = (Given(0.0, "0 mm"), Given(0.0, "0 mm"))


class SectorSpec(Spec, frozen=True):
    """The shape of a counterweight: a sector of a ring about the axis of its shaft."""

    outer_radius: PositiveLength = Field(description=N_("From the axis of its shaft to its rim."))
    inner_radius: NonNegativeLength = Field(
        default=_NONE, description=N_("From that axis to where it begins; from the axis itself unless given.")
    )
    opening: Opening = Field(description=N_("Angle between its two sides."))
    thickness: PositiveLength = Field(description=N_("Along the shaft."))
    density: PositiveDensity = Field(
        default=Given(7850.0, "7850 kg/m³"), description=N_("Of its material; that of steel unless given.")
    )

    @property
    def moment(self) -> Array:
        """Mass times radius of its centroid; docs/theory/balance, below eq. (16.7). [kg·m]"""
        # As products: NumPy raises a number to a power otherwise than a column, by a last bit.
        rim, begin, opening = (part.array for part in (self.outer_radius, self.inner_radius, self.opening))
        return (
            self.density.array
            * self.thickness.array
            * (rim * rim * rim - begin * begin * begin)
            * (2 / 3)
            * np.sin(opening / 2)
        )

    def _problems(self) -> Iterator[Problem]:
        """Find a sector that begins beyond its rim."""
        if self.inner_radius.si >= self.outer_radius.si:
            allowed = _("must be less than outer_radius = {radius}", radius=self.outer_radius.text)
            yield Problem("inner_radius", self.inner_radius.text, allowed)


class WeightSpec(Spec, frozen=True):
    """A weight that turns: mass, radius of its centroid, and where it stands at crank angle 0, ahead of throw 1.

    A sector's shape says mass and radius. On the crankshaft it stands on a `throw`, counted from 1, and unless given
    its angle is opposite that; or at `z` from throw 1, as one on a single web does. With a ratio it is on a shaft of
    its own that turns so many times for one of the crank, less than 0 against it, and lies at `place` from the
    crankshaft's centre, to the right and up.
    """

    mass: PositiveMass | None = Field(default=None, description=N_("Mass of the weight; or give its sector."))
    radius: PositiveLength | None = Field(
        default=None, description=N_("Of its centroid from the axis of its shaft; or give its sector.")
    )
    sector: SectorSpec | None = Field(default=None, description=N_("Its shape, instead of mass and radius."))
    angle: Angle | None = Field(
        default=None,
        description=N_(
            "Where it stands at crank angle 0 of throw 1, ahead of throw 1; on a throw, opposite that unless given."
        ),
    )
    throw: int | None = Field(
        default=None, ge=1, description=N_("The throw of the crankshaft that it is on, counted from 1.")
    )
    z: Length | None = Field(
        default=None, description=N_("Its place along the shaft, from throw 1 toward the flywheel.")
    )
    ratio: int = Field(
        default=1,
        ge=-HIGHEST_ORDER,
        le=HIGHEST_ORDER,
        description=N_("Turns for one of the crank, less than 0 against it; 1 unless given."),
    )
    place: Spot = Field(
        default=_AT_CRANK, description=N_("Where its shaft lies from the crankshaft's centre: to the right, and up.")
    )

    @property
    def moment(self) -> Array:
        """Mass times radius of its centroid. [kg·m]"""
        if self.sector is not None:
            return self.sector.moment
        assert self.mass is not None
        assert self.radius is not None
        return self.mass.array * self.radius.array

    def _problems(self) -> Iterator[Problem]:
        """Find a weight of no size or of two, that stands nowhere, and on a throw what turns otherwise."""
        for name in ("mass", "radius"):
            if self.sector is not None and getattr(self, name) is not None:
                yield Problem(name, getattr(self, name).text, _("must not stand beside sector, which says it"))
            elif self.sector is None and getattr(self, name) is None:
                yield Problem(name, None, _("is missing; or give the weight's shape, its sector"))
        if self.throw is None:
            if self.z is None:
                yield Problem("z", None, _("is missing; give it, or on the crankshaft the throw"))
            if self.angle is None:
                yield Problem("angle", None, _("is missing; only on a throw it is opposite that unless given"))
        else:
            allowed = _("must not stand beside throw, which says it")
            given = self.model_fields_set
            yield from (Problem(name, None, allowed) for name in ("ratio", "place") if name in given)
        if self.ratio == 0:
            yield Problem("ratio", "0", _("must not be 0: a weight that does not turn balances nothing"))


class BalanceShaftsSpec(Spec, frozen=True):
    """Two shafts that turn `order` times as fast as the crank, one with it and one against it, solved for.

    They take away the force of that order, in one plane z (the throws' mid-plane unless given), or the couple, or both,
    in two planes. `forward` and `backward` are where they lie from the crankshaft's centre, to the right and up.
    """

    order: int = Field(ge=1, le=HIGHEST_ORDER, description=N_("How many times as fast as the crank both shafts turn."))
    against: Against = Field(
        default="force", description=N_("Whether they take away the force of that order, the couple, or both.")
    )
    planes: OneOrMany[Length] | None = Field(
        default=None,
        description=N_("Places of their weights along the shaft, from throw 1: one against a force, two for a couple."),
    )
    forward: Spot = Field(
        default=_AT_CRANK,
        description=N_("Where the shaft lies that turns with the crank: to the right of its centre, and up."),
    )
    backward: Spot = Field(
        default=_AT_CRANK,
        description=N_("Where the shaft lies that turns against the crank: to the right of its centre, and up."),
    )

    def _problems(self) -> Iterator[Problem]:
        """Find planes that cannot bear what the shafts are for."""
        if self.against == "force":
            if self.planes is not None and len(self.planes) > 1:
                allowed = _('must be one plane against a force; two are for against = "couple" or "both"')
                yield Problem("planes", None, allowed)
        elif self.planes is None or len(self.planes) != 2:
            yield Problem("planes", None, _("must be two, as a couple needs them"))
        else:
            yield from _together(self.planes)


class WheelSpec(Spec, frozen=True):
    """A wheel of a locomotive's driving axle, where its tread runs on the rail."""

    z: Length = Field(description=N_("Its place along the axle, from throw 1."))
    load: PositiveForce | None = Field(
        default=None, description=N_("What it carries at rest; with it, the speed at which the hammer blow lifts it.")
    )


class BalanceSpec(Spec, frozen=True):
    """What balances the machine: given weights, counterweights solved for, and balance shafts solved for after them.

    The two wheels of a driving axle bear what is left out of balance on it: the hammer blow.

    counterweights take from each throw all that rotates, and a `share` of what reciprocates ("rotating"), or so much
    that the throw's largest force is the least ("least_force"). In two `planes` of the shaft, z from throw 1, they take
    the same from the whole shaft, of force and couple.
    """

    weight: tuple[WeightSpec, ...] = Field(
        default=(), description=N_("Weights that turn: on the crankshaft, or on shafts of their own.")
    )
    counterweights: Counterweights | None = Field(
        default=None,
        description=N_(
            "Solved for: `rotating` takes all that rotates on each throw, `least_force` leaves the least largest force."
        ),
    )
    share: ShareFromZeroToOne | None = Field(
        default=None,
        description=N_("Share of what reciprocates that counterweights take besides all that rotates: 0 unless given."),
    )
    planes: Spot | None = Field(
        default=None,
        description=N_("Two places along the shaft, from throw 1, for the counterweights; unless given, every throw."),
    )
    shafts: tuple[BalanceShaftsSpec, ...] = Field(
        default=(), description=N_("Pairs of balance shafts, solved for after all other weights.")
    )

    wheel: dict[Name, WheelSpec] = Field(
        default_factory=dict, description=N_("The two wheels of a locomotive's driving axle, by their names.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find a table that balances nothing, what belongs to other counterweights, and two planes that are one."""
        if self.share is not None and self.counterweights != "rotating":
            allowed = _('is for counterweights = "rotating": the share of what reciprocates that they take as well')
            yield Problem("share", self.share.text, allowed)
        if self.planes is not None:
            if self.counterweights is None:
                yield Problem("planes", None, _("is for counterweights that are solved for; give these as well"))
            else:
                yield from _together(self.planes)
        if self.wheel:
            yield from _not_an_axle(self.wheel)
        if not any((self.weight, self.shafts, self.counterweights, self.share, self.planes, self.wheel)):
            yield Problem("", None, _("must hold weight, counterweights, shafts or wheel, or be left out"))


def _not_an_axle(wheels: Mapping[str, WheelSpec]) -> Iterator[Problem]:
    """Find wheels that are not two, or in one place."""
    if len(wheels) != 2:
        yield Problem("wheel", ", ".join(wheels), _("must be two: the wheels at both ends of the axle"))
        return
    (_first, one), (name, other) = wheels.items()
    if one.z.si == other.z.si:
        yield Problem(f"wheel.{name}.z", other.z.text, _("must be another place than the first wheel's"))


def _together(planes: Sequence[Given]) -> Iterator[Problem]:
    """Find two planes at one place."""
    if planes[0].si == planes[1].si:
        yield Problem("planes[1]", planes[1].text, _("must be another plane than the first"))
