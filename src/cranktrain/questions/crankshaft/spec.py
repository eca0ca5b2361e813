"""The table [crankshaft] of the machine file: sections of a shaft of like throws, and the bearings that it rests on."""

from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.quantities import Dimension, Given, NonNegativeLength, PositiveLength, PositivePressure, Quantity
from cranktrain.spec import Spec

Poisson = Annotated[Given, Quantity(Dimension.RATIO, at_least=0.0, below=0.5)]
PositiveStiffness = Annotated[Given, Quantity(Dimension.STIFFNESS, above=0.0)]


class CrankshaftSpec(Spec, frozen=True):
    """A crankshaft with a main bearing on either side of every throw; all throws are alike but in angle and radius."""

    journal_diameter: PositiveLength = Field(description=N_("Diameter of the main journals."))
    journal_bore: NonNegativeLength = Field(
        default=Given(0.0, "0 mm"), description=N_("Bore of the main journals; none unless given.")
    )
    pin_diameter: PositiveLength = Field(description=N_("Diameter of the crank pins."))
    pin_bore: NonNegativeLength = Field(
        default=Given(0.0, "0 mm"), description=N_("Bore of the crank pins; none unless given.")
    )
    pin_length: PositiveLength = Field(description=N_("Length of a crank pin, from web to web."))
    web_thickness: PositiveLength = Field(description=N_("Thickness of a web, along the shaft."))
    web_width: PositiveLength = Field(description=N_("Width of a web, across the line from journal to pin."))
    web_length: Literal["whole", "ker_wilson"] = Field(
        default="ker_wilson",
        description=N_(
            "How much of a web gives: from axis to axis, or less a fifth of both diameters, as it is stiff within them."
        ),
    )
    bearing_distance: PositiveLength | None = Field(
        default=None,
        description=N_("From the first and the last throw to the bearing beyond it; half the first gap unless given."),
    )
    bearing_stiffness: PositiveStiffness | None = Field(
        default=None, description=N_("Stiffness of a main bearing in its housing, alike all round; rigid unless given.")
    )
    bearing_clearance: PositiveLength | None = Field(
        default=None, description=N_("Difference of the diameters of bearing and journal; with it that method, too.")
    )
    young_modulus: PositivePressure = Field(
        default=Given(206e9, "206 GPa"), description=N_("Young's modulus of the shaft; that of steel unless given.")
    )
    poisson_ratio: Poisson = Field(
        default=Given(0.3, "0.3"), description=N_("Poisson's ratio of the shaft; that of steel unless given.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find bores that leave nothing."""
        for name in ("journal", "pin"):
            bore, diameter = getattr(self, f"{name}_bore"), getattr(self, f"{name}_diameter")
            if bore.si >= diameter.si:
                allowed = _("must be less than {name}_diameter = {diameter}")
                yield Problem(f"{name}_bore", bore.text, allowed.format(name=name, diameter=diameter.text))
