"""Rigid bodies, and guides of what slides: their tables of the machine file."""

from collections.abc import Iterator
from typing import Annotated, ClassVar

import numpy as np
from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.motion import Array
from cranktrain.quantities import (
    Angle,
    Dimension,
    Given,
    Length,
    NonNegativeInertia,
    PositiveLength,
    PositiveMass,
    Quantity,
    ShareFromZeroToOne,
)
from cranktrain.spec import Spec

Friction = Annotated[Given, Quantity(Dimension.RATIO, at_least=0.0, below=1.0)]
NonNegativeMass = Annotated[Given, Quantity(Dimension.MASS, at_least=0.0)]
NonNegativeMoment = Annotated[Given, Quantity(Dimension.FLYWHEEL_MOMENT, at_least=0.0)]
PositiveAcceleration = Annotated[Given, Quantity(Dimension.ACCELERATION, above=0.0)]


class BodySpec(Spec, frozen=True):
    """A rigid body on a link: mass, centroid from the link's first pin along it and to its left, inertia about that.

    A rod may be weighed at both ends instead: `big_end` at its first pin, `small_end` at its second. A rod's inertia
    that is not given is that of two such masses.
    """

    elsewhere: ClassVar = {
        "m": "mass",
        **dict.fromkeys(("j", "i"), "inertia"),
        **dict.fromkeys(("gd2", "gd²"), "flywheel_moment"),
    }

    in_one_word: ClassVar = "mass"

    mass: NonNegativeMass | None = Field(
        default=None, description=N_("Mass of the body, 0 of one that weighs nothing; or, of a rod, those of its ends.")
    )
    along: Length | None = Field(
        default=None, description=N_("Centroid's distance from the link's first pin, toward its second.")
    )
    across: Length = Field(
        default=Given(0.0, "0 mm"), description=N_("Centroid's distance from the link's line, to its left.")
    )
    inertia: NonNegativeInertia | None = Field(
        default=None,
        description=N_("Moment of inertia about the centroid; of a rod, that of two masses at its ends unless given."),
    )
    flywheel_moment: NonNegativeMoment | None = Field(
        default=None,
        description=N_("GD² about the centroid, as inertia is, four times that in kg·m²; instead of inertia."),
    )
    big_end: PositiveMass | None = Field(default=None, description=N_("Mass at the rod's first pin, as weighed."))
    small_end: PositiveMass | None = Field(default=None, description=N_("Mass at the rod's second pin, as weighed."))
    pin_share: ShareFromZeroToOne | None = Field(
        default=None,
        description=N_(
            "Of a crank: which part of its mass turns at its pin, in whose middle it acts on the crankshaft; the rest"
            " acts on both webs. 0 unless given."
        ),
    )

    def _problems(self) -> Iterator[Problem]:
        """Find a mass beside the ends' masses, neither, one end alone, and an inertia given twice."""
        if self.inertia is not None and self.flywheel_moment is not None:
            yield Problem("flywheel_moment", None, _("must not stand beside inertia; GD² = 4 J says the same"))
        ends = {"big_end": self.big_end, "small_end": self.small_end}
        given = [name for name, end in ends.items() if end is not None]
        if not given and self.mass is None:
            yield Problem("mass", None, _("is missing; give it, or big_end and small_end"))
        if len(given) == 1:
            missing = next(name for name in ends if name not in given)
            yield Problem(missing, None, _("is missing; a rod is weighed at both ends"))
        if given:
            allowed = _("must not stand beside the masses of both ends, which say it")
            yield from (Problem(name, None, allowed) for name in ("mass", "along") if getattr(self, name) is not None)

    @property
    def weighs_nothing(self) -> bool:
        """Whether its mass is given as 0 in all designs, and no inertia beside it: then it needs no place."""
        return self.mass is not None and not np.any(self.mass.array) and self.own_inertia is None

    @property
    def own_inertia(self) -> Array | None:
        """Moment of inertia about the centroid, however it is given; None where it is not. [kg·m²]"""
        if self.inertia is not None:
            return self.inertia.array
        return None if self.flywheel_moment is None else self.flywheel_moment.array / 4


class GravitySpec(Spec, frozen=True):
    """Gravity in the plane of the mechanism: how strong, and how far its direction is turned from straight down.

    direction counts from −Y in the normal sense of rotation, as all angles of the file; a machine that stands upright
    has 0.
    """

    acceleration: PositiveAcceleration = Field(
        default=Given(9.80665, "9.80665 m/s²"),
        description=N_("Of free fall in the mechanism's plane; 9.80665 m/s² unless given."),
    )
    direction: Angle = Field(
        default=Given(0.0, "0 deg"),
        description=N_("How far it is turned from straight down, −Y, in the normal sense of rotation."),
    )


class GuideSpec(Spec, frozen=True):
    """A guide, or a bush: the distance of its outer edges along it, and where their middle lies.

    `middle` is its distance from the slider's pin, where the edges go with the slider; `at` is its place, where
    they stand still. Both count along the guide as the slider's position does.
    """

    length: PositiveLength = Field(
        description=N_("Between the guide's outer edges, along it: a skirt's, a shoe's, a bush's.")
    )
    middle: Length | None = Field(
        default=None,
        description=N_(
            "Where its middle lies from the slider's pin, ahead as the slider's position counts; 0 unless given."
        ),
    )
    at: Length | None = Field(
        default=None,
        description=N_(
            "Instead of middle, of edges that stand still, such as a bush's: the slider's position in the middle."
        ),
    )

    def _problems(self) -> Iterator[Problem]:
        """Find a middle that goes with the slider and stands still."""
        if self.middle is not None and self.at is not None:
            yield Problem("at", None, _("must not stand beside middle: the edges go with the slider or stand still"))
