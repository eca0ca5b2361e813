"""Counterweights and balance shafts: the table [balance] of the machine file."""

from collections.abc import Sequence
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.layout.crank_angle import HIGHEST_ORDER
from cranktrain.layout.specs import OneOrMany
from cranktrain.quantities import Angle, Dimension, Given, Length, PositiveLength, PositiveMass, Quantity
from cranktrain.spec import Spec

Share = Annotated[Given, Quantity(Dimension.RATIO, at_least=0.0, at_most=1.0)]
Spot = tuple[Length, Length]
_AT_CRANK = (Given(0.0, "0 mm"), Given(0.0, "0 mm"))


class WeightSpec(Spec, frozen=True):
    """A weight that turns: mass, radius of its centroid, and where it stands at crank angle 0, ahead of throw 1.

    On the crankshaft it stands on a `throw`, counted from 1, and unless given its angle is opposite that; or at `z`
    from throw 1. With a ratio it is on a shaft of its own that turns so many times for one of the crank, less than 0
    against it, and lies at `place` from the crankshaft's centre, to the right and up.
    """

    mass: PositiveMass
    radius: PositiveLength
    angle: Angle | None = None
    throw: int | None = Field(default=None, ge=1)
    z: Length | None = None
    ratio: int = Field(default=1, ge=-HIGHEST_ORDER, le=HIGHEST_ORDER)
    place: Spot = _AT_CRANK

    @model_validator(mode="after")
    def _stands_somewhere(self) -> Self:
        """Refuse a weight that stands nowhere or at two places, and on a throw what turns otherwise."""
        found: list[Problem] = []
        if self.throw is None:
            if self.z is None:
                found.append(Problem("z", None, _("is missing; give it, or on the crankshaft the throw")))
            if self.angle is None:
                found.append(Problem("angle", None, _("is missing; only on a throw it is opposite that unless given")))
        else:
            allowed = _("must not stand beside throw, which says it")
            found += [Problem(name, None, allowed) for name in ("z", "ratio", "place") if name in self.model_fields_set]
        if self.ratio == 0:
            found.append(Problem("ratio", "0", _("must not be 0: a weight that does not turn balances nothing")))
        if found:
            raise InputError(found)
        return self


class BalanceShaftsSpec(Spec, frozen=True):
    """Two shafts that turn `order` times as fast as the crank, one with it and one against it, solved for.

    They take away the force of that order, in one plane z (the throws' mid-plane unless given), or the couple, or both,
    in two planes. `forward` and `backward` are where they lie from the crankshaft's centre, to the right and up.
    """

    order: int = Field(ge=1, le=HIGHEST_ORDER)
    against: Literal["force", "couple", "both"] = "force"
    planes: OneOrMany[Length] | None = None
    forward: Spot = _AT_CRANK
    backward: Spot = _AT_CRANK

    @model_validator(mode="after")
    def _in_planes(self) -> Self:
        """Refuse planes that cannot bear what the shafts are for."""
        if self.against == "force":
            if self.planes is not None and len(self.planes) > 1:
                allowed = _('must be one plane against a force; two are for against = "couple" or "both"')
                raise InputError([Problem("planes", None, allowed)])
        elif self.planes is None or len(self.planes) != 2:
            raise InputError([Problem("planes", None, _("must be two, as a couple needs them"))])
        elif (problem := _together(self.planes)) is not None:
            raise InputError([problem])
        return self


class BalanceSpec(Spec, frozen=True):
    """What balances the machine: given weights, counterweights solved for, and balance shafts solved for after them.

    counterweights take from each throw all that rotates, and a `share` of what reciprocates ("rotating"), or so much
    that the throw's largest force is the least ("least_force"). In two `planes` of the shaft, z from throw 1, they take
    the same from the whole shaft, of force and couple.
    """

    weight: tuple[WeightSpec, ...] = ()
    counterweights: Literal["rotating", "least_force"] | None = None
    share: Share | None = None
    planes: Spot | None = None
    shafts: tuple[BalanceShaftsSpec, ...] = ()

    @model_validator(mode="after")
    def _solved_for(self) -> Self:
        """Refuse a table that balances nothing, what belongs to other counterweights, and two planes that are one."""
        found: list[Problem] = []
        if self.share is not None and self.counterweights != "rotating":
            allowed = _('is for counterweights = "rotating": the share of what reciprocates that they take as well')
            found.append(Problem("share", self.share.text, allowed))
        if self.planes is not None:
            if self.counterweights is None:
                found.append(
                    Problem("planes", None, _("is for counterweights that are solved for; give these as well"))
                )
            elif (problem := _together(self.planes)) is not None:
                found.append(problem)
        if not found and not self.weight and not self.shafts and self.counterweights is None:
            found.append(Problem("", None, _("must hold weight, counterweights or shafts, or be left out")))
        if found:
            raise InputError(found)
        return self


def _together(planes: Sequence[Given]) -> Problem | None:
    """Refuse two planes at one place."""
    if planes[0].si != planes[1].si:
        return None
    return Problem("planes[1]", planes[1].text, _("must be another plane than the first"))
