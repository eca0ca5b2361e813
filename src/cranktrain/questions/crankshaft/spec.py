"""The tables [crankshaft] and [gear.NAME] of the machine file: sections of shafts, their bearings, pulls and gears."""

from collections.abc import Iterator, Mapping
from math import pi
from typing import Annotated, Literal

from pydantic import Field

from cranktrain.allowed import Name
from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.overridden import OverriddenSpec
from cranktrain.listed import OneOrMany
from cranktrain.quantities import (
    Angle,
    Dimension,
    Given,
    Length,
    NonNegativeLength,
    PositiveBendingStiffness,
    PositiveDensity,
    PositiveLength,
    PositivePressure,
    Quantity,
)
from cranktrain.questions.crankshaft.pulls import PullSpec
from cranktrain.spec import Spec

Poisson = Annotated[Given, Quantity(Dimension.RATIO, at_least=0.0, below=0.5)]
Clearance = Annotated[Given, Quantity(Dimension.LENGTH, above=0.0, example="0.08 mm")]
PositiveStiffness = Annotated[Given, Quantity(Dimension.STIFFNESS, above=0.0)]
ToothAngle = Annotated[Given, Quantity(Dimension.ANGLE, at_least=0.0, below=pi / 4, example="20 deg")]
HelixAngle = Annotated[Given, Quantity(Dimension.ANGLE, above=-pi / 3, below=pi / 3)]

NEEDED = ("journal_diameter", "pin_diameter", "pin_length", "web_thickness", "web_width")
"""What every crankshaft must say."""


STEEL = (Given(206e9, "206 GPa"), Given(0.3, "0.3"), Given(7850.0, "7850 kg/m³"))
"""Young's modulus, Poisson's ratio and density of what the shaft is made of unless given."""


class BearingSpec(Spec, frozen=True):
    """One main bearing, where it is not as all others: that of a journal, by its number, or one more, by its name.

    A stiffness is alike all round, or two: to the right and up, or as far turned from there as `stiffness_direction`
    says. Settlement is how far the bearing stands from the line of the others.
    """

    z: Length | None = Field(
        default=None,
        description=N_("Its middle, from throw 1 toward the flywheel; between throws halfway unless given."),
    )
    stiffness: OneOrMany[PositiveStiffness] | None = Field(
        default=None, description=N_("Stiffness of the bearing in its housing: all round, or to the right and up.")
    )
    stiffness_direction: Angle | None = Field(
        default=None,
        description=N_("How far both directions of a stiffness are turned in the normal sense of rotation."),
    )
    clearance: Clearance | None = Field(
        default=None, description=N_("Difference of the diameters of bearing and journal.")
    )
    width: PositiveLength | None = Field(default=None, description=N_("Width that bears, for its specific pressure."))
    settlement: tuple[Length, Length] | None = Field(
        default=None, description=N_("How far it stands from the line of the others: to the right, and up.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find more stiffnesses than there are directions."""
        if self.stiffness is not None and len(self.stiffness) > 2:
            yield Problem("stiffness", None, _("must be one, all round, or two: to the right, and up"))


class ShoulderSpec(Spec, frozen=True):
    """A shoulder: from z on, toward the flywheel, the journal has another section, to its next shoulder or its end."""

    z: Length = Field(description=N_("From where on, from throw 1 toward the flywheel."))
    diameter: PositiveLength = Field(description=N_("Diameter from there on."))
    bore: NonNegativeLength | None = Field(
        default=None, description=N_("Bore from there on; as before the shoulder unless given.")
    )


class CrankshaftTable(Spec, frozen=True):
    """A crankshaft: its pins, webs and journals as one value for all or one for each, and what it rests on.

    Journals are counted from 1, before the first pin, to one more than there are pins. Where `journals` leaves one out
    between pins, one web leads from pin to pin; at an end, the pin hangs over.
    """

    journal_diameter: OneOrMany[PositiveLength] | None = Field(
        default=None, description=N_("Diameter of the main journals: one for all, or one for each.")
    )
    journal_bore: OneOrMany[NonNegativeLength] | None = Field(
        default=None, description=N_("Bore of the main journals; none unless given.")
    )
    pin_diameter: OneOrMany[PositiveLength] | None = Field(
        default=None, description=N_("Diameter of the crank pins: one for all, or one for each.")
    )
    pin_bore: OneOrMany[NonNegativeLength] | None = Field(
        default=None, description=N_("Bore of the crank pins; none unless given.")
    )
    pin_length: OneOrMany[PositiveLength] | None = Field(
        default=None, description=N_("Length of a crank pin, from web to web: one for all, or one for each.")
    )
    web_thickness: OneOrMany[PositiveLength] | None = Field(
        default=None,
        description=N_("Thickness of a web, along the shaft: one for all, one for each pin, or one for each web."),
    )
    web_width: OneOrMany[PositiveLength] | None = Field(
        default=None, description=N_("Width of a web, across the line from journal to pin, as web_thickness.")
    )
    web_length: Literal["whole", "ker_wilson"] | None = Field(
        default=None,
        description=N_(
            "How much of a web gives: from axis to axis, or, unless given, less a fifth of both diameters (ker_wilson),"
            " as it is stiff within them."
        ),
    )
    web_height: PositiveLength | None = Field(
        default=None,
        description=N_(
            "Of a web, along the crank, for its mass; unless given, from the journal's far side to the pin's."
        ),
    )
    density: PositiveDensity | None = Field(
        default=None, description=N_("Of the shaft, for the masses of its pins and webs; that of steel unless given.")
    )
    side_rod_distance: PositiveLength | None = Field(
        default=None,
        description=N_("Between the two pins of a far piston's side rods, on either side of the near piston's pin."),
    )
    journals: tuple[int, ...] | None = Field(
        default=None,
        description=N_("Which journals there are, counted from 1; all unless given: one more than there are pins."),
    )
    bearings: tuple[int, ...] | None = Field(
        default=None, description=N_("Which journals rest in a main bearing; all that there are unless given.")
    )
    bearing_distance: PositiveLength | None = Field(
        default=None,
        description=N_("From the first and the last pin to the bearing beyond it; half the first gap unless given."),
    )
    bearing_stiffness: OneOrMany[PositiveStiffness] | None = Field(
        default=None,
        description=N_(
            "Stiffness of a main bearing in its housing: all round, or to the right and up; rigid unless given."
        ),
    )
    bearing_stiffness_direction: Angle | None = Field(
        default=None,
        description=N_("How far both directions of a stiffness are turned in the normal sense of rotation."),
    )
    bearing_clearance: PositiveLength | None = Field(
        default=None, description=N_("Difference of the diameters of bearing and journal; with it that method, too.")
    )
    bearing_width: PositiveLength | None = Field(
        default=None, description=N_("Width that bears of a main bearing, for its specific pressure.")
    )
    rod_bearing_width: PositiveLength | None = Field(
        default=None, description=N_("Width that bears of a rod's bearing on its crank pin, for its specific pressure.")
    )
    thrust_bearing: str | Annotated[int, Field(ge=1)] | None = Field(
        default=None,
        description=N_("Which bearing takes axial forces, as those of helical gears; the last unless given."),
    )
    bearing: Mapping[Name, BearingSpec] = Field(
        default={}, description=N_("Bearings that are not as all others, by the number of the journal, or by name.")
    )
    pull: Mapping[Name, PullSpec] = Field(
        default={}, description=N_("Forces on the shaft by name: a belt's pull, the weight of a flywheel.")
    )
    shoulder: Mapping[Name, ShoulderSpec] = Field(
        default={}, description=N_("Shoulders of journals by name: where their diameter changes.")
    )
    span_bending_stiffness: OneOrMany[PositiveBendingStiffness] | None = Field(
        default=None,
        description=N_(
            "EI of the straight beam from each bearing to the next, for three and five moments: one for all, or one for"
            " each; by the shaft's sections unless given."
        ),
    )
    young_modulus: PositivePressure | None = Field(
        default=None, description=N_("Young's modulus of the shaft; that of steel unless given.")
    )
    poisson_ratio: Poisson | None = Field(
        default=None, description=N_("Poisson's ratio of the shaft; that of steel unless given.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find journals and bearings that are named twice or are not there, and too many stiffnesses."""
        for name in ("journals", "bearings"):
            numbers = getattr(self, name)
            if numbers is not None and (len(set(numbers)) < len(numbers) or not numbers):
                yield Problem(name, None, _("must name each journal once, and one at least"))
        if self.bearing_stiffness is not None and len(self.bearing_stiffness) > 2:
            yield Problem("bearing_stiffness", None, _("must be one, all round, or two: to the right, and up"))


class CrankshaftSpec(CrankshaftTable, OverriddenSpec, frozen=True):
    """The crankshaft, or what all of them have in common, and `overrides` by the names of their shafts."""

    overrides: Mapping[str, CrankshaftTable] = Field(
        default={}, alias="NAME (a shaft)", description=N_("What the crankshaft of one shaft has of its own.")
    )

    @property
    def pulls(self) -> tuple[PullSpec, ...]:
        """All that pulls on any shaft, with what files hold as lists."""
        return tuple(pull.listed for table in (self, *self.overrides.values()) for pull in table.pull.values())


class GearSpec(Spec, frozen=True):
    """A gear through which a shaft hands on its torque: to another shaft, or off where it is the only one named.

    The last shaft of all hands its torque on at its last end, or through a gear of its own. All shafts turn alike fast,
    so both gears are alike; between them there may be others.
    """

    shafts: OneOrMany[str] = Field(
        description=N_("Which shaft hands its torque on, and to which; with one name the torque leaves the machine.")
    )
    z: OneOrMany[Length] = Field(
        description=N_("Where the gear sits, from throw 1 toward the flywheel: one place, or one on each shaft.")
    )
    radius: PositiveLength = Field(description=N_("Radius of the pitch circle."))
    direction: OneOrMany[Angle] | None = Field(
        default=None,
        description=N_(
            "Where the teeth mesh, from the shaft's centre, counted from straight up in the normal sense of rotation:"
            " one for each shaft; unless given, on the line of both centres."
        ),
    )
    pressure_angle: ToothAngle = Field(
        default=Given(pi / 9, "20 deg"),
        description=N_("Pressure angle of the teeth, normal to them; 20° unless given."),
    )
    helix_angle: HelixAngle = Field(
        default=Given(0.0, "0 deg"),
        description=N_(
            "Helix angle of the first gear: more than 0 where its driving teeth are pushed toward the flywheel."
        ),
    )

    def _problems(self) -> Iterator[Problem]:
        """Find more shafts than a mesh has, and lists that are not as long as theirs."""
        n = len(self.shafts)
        if n > 2 or len(set(self.shafts)) < n:
            yield Problem("shafts", None, _("must be one shaft, or two different ones: from the first to the second"))
        for name in ("z", "direction"):
            values = getattr(self, name)
            if values is not None and len(values) not in (1, n):
                yield Problem(name, None, _("must be one, or one for each of the shafts: {n}", n=n))
        if n == 1 and self.direction is None:
            yield Problem(
                "direction", None, _("is missing: only between two shafts is it on the line of their centres")
            )
