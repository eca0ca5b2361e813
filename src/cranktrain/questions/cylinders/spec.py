"""Cylinders: their table of the machine file."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from cranktrain.allowed import Name
from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.overridden import OverriddenSpec
from cranktrain.numerics.harmonics import TURN
from cranktrain.quantities import Angle, Dimension, Given, PositiveLength, Pressure, Quantity, one_of
from cranktrain.spec import Spec

_GAUGE = ("barg", "бари", "ati", "ати", "psig")
"""Spellings of units that count from ambient pressure."""


CYCLES = {"two-stroke": TURN, "four-stroke": 2 * TURN}
"""Length of a cycle by name. [rad]"""


class CylinderSpec(Spec, frozen=True):
    """One cylinder's own dimensions; what it does not give, the cylinder above it gives."""

    elsewhere: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(("d", "diameter"), "bore"),
        **dict.fromkeys(("epsilon", "eps", "ε"), "compression_ratio"),
        **dict.fromkeys(("c", "dead_space"), "clearance"),
        "double_acting": 'chambers = ["head", "crank"]',
        **dict.fromkeys(("s", "stroke"), "[mechanism] stroke"),
    }

    bore: PositiveLength | None = Field(default=None, description=N_("Diameter of the cylinder."))
    compression_ratio: Annotated[Given, Quantity(Dimension.RATIO, above=1.0, at_most=1e5)] | None = Field(
        default=None,
        description=N_(
            "Largest volume over smallest, by the true stroke; a cylinder without its own has the first one's deck."
        ),
    )
    clearance: Annotated[Given, Quantity(Dimension.RATIO, above=0.0, at_most=100.0)] | None = Field(
        default=None,
        description=N_("Smallest volume over the swept one, as compressors have it; instead of compression_ratio."),
    )
    exhaust_port: PositiveLength | None = Field(
        default=None, description=N_("Height of the exhaust ports, open where the piston is at its outer dead centre.")
    )
    scavenge_port: PositiveLength | None = Field(
        default=None, description=N_("Height of the scavenge ports, open where the piston is at its outer dead centre.")
    )
    chambers: tuple[Literal["head", "crank"], ...] | None = Field(
        default=None,
        min_length=1,
        max_length=2,
        description=N_(
            'Sides of the piston that work: ["head", "crank"] is double-acting; the head\'s alone unless given.'
        ),
    )
    piston_rod: PositiveLength | None = Field(
        default=None, description=N_("Diameter of the piston rod, which takes up room on the crank's side.")
    )
    ambient: Pressure | None = Field(
        default=None,
        description=N_(
            "Absolute pressure on the piston where no chamber is: in the crankcase, or on the piston rod; 101.325 kPa "
            "unless given."
        ),
    )

    def _problems(self) -> Iterator[Problem]:
        """Find two chambers on one side of a piston, and room that is given twice."""
        if self.clearance is not None and self.compression_ratio is not None:
            yield Problem("clearance", self.clearance.text, _("must not stand beside compression_ratio, which says it"))
        if self.chambers is not None and len(set(self.chambers)) < len(self.chambers):
            yield Problem("chambers", None, _("must name each side once"))


ROOM = ("compression_ratio", "clearance")
"""Keys that a single chamber's table may have: each says how much room is left in it."""


def ratio_of(table: CylinderSpec) -> tuple[str, Given] | None:
    """Compression ratio that a table gives, with the key by which; None where it gives none. ε = 1 + 1/c."""
    if table.compression_ratio is not None:
        return "compression_ratio", table.compression_ratio
    room = table.clearance
    if room is None:
        return None
    column = None if room.column is None else 1 + 1 / room.column
    return "clearance", replace(room, si=1 + 1 / room.si, column=column)


class CylindersSpec(CylinderSpec, OverriddenSpec, frozen=True):
    """All cylinders: their common dimensions, cycle, firing and friction, and `overrides` by bank, cylinder or chamber.

    Firing is an order, or the crank angles at which the cylinders fire, as they are shown: one for each cylinder in the
    order of the file, or by name.
    """

    elsewhere: ClassVar[Mapping[str, str]] = {
        **CylinderSpec.elsewhere,
        **dict.fromkeys(("strokes", "tact"), 'cycle = "four-stroke"'),
        "order": "firing_order",
        **dict.fromkeys(("cylinders", "number", "i"), '[shaft.main] throws = ["0 deg", "180 deg"]'),
    }

    cycle: Literal["two-stroke", "four-stroke"] | None = Field(
        default=None, description=N_("Strokes of one working cycle; the crank angle runs through one or two turns.")
    )
    firing_order: str | None = Field(
        default=None,
        description=N_('Cylinders in the order in which they fire, such as "1-3-4-2"; with the cycle: firing angles.'),
    )
    firing_angles: tuple[Angle, ...] | Mapping[Name, Angle] | None = Field(
        default=None,
        description=N_(
            "Crank angles at which the cylinders fire, as shown, instead of an order: a list, one for each cylinder in "
            'the order of the file, or by name, { 1L = "0 deg", 1R = "60 deg" }.'
        ),
    )
    numbers: Mapping[Name, str] = Field(
        default={},
        description=N_('A maker\'s own numbers of the cylinders, for use in the firing order: { 5 = "1L" }.'),
    )
    mechanical_efficiency: Annotated[Given, Quantity(Dimension.RATIO, above=0.0, at_most=1.0)] | None = Field(
        default=None,
        description=N_(
            "Brake power over indicated power; of a driven machine the other way round. Or give friction_pressure."
        ),
    )
    friction_pressure: Pressure | None = Field(
        default=None,
        description=N_("Work that friction takes in a cycle, over the displacement; it is no absolute pressure."),
    )
    overrides: Mapping[str, CylinderSpec] = Field(
        default={},
        alias="NAME (a bank, a cylinder or a chamber)",
        description=N_(
            'What one bank or one cylinder has of its own, or one side of a piston, as "1.crank": its clearance.'
        ),
    )

    @property
    def cycle_length(self) -> float | None:
        """Crank angle of a cycle; None where the file does not say. [rad]"""
        return None if self.cycle is None else CYCLES[self.cycle]

    def makers_numbers(self, cylinders: Sequence[str]) -> tuple[str, ...]:
        """Call cylinders by the maker's numbers, where these are given; no names where none is."""
        by_cylinder = {name: word for word, name in self.numbers.items()}
        return tuple(by_cylinder.get(name, name) for name in cylinders) if by_cylinder else ()

    def _problems(self) -> Iterator[Problem]:
        """Find firing or friction that is said twice, angles of an unknown cycle, and a mean gauge pressure."""
        yield from super()._problems()
        if self.firing_angles is not None and self.firing_order is not None:
            yield Problem("firing_order", None, _("must not stand beside firing_angles, which say it"))
        if self.firing_angles is not None and self.cycle is None:
            allowed = _("is missing; firing_angles count over a cycle: {expected}", expected=one_of(CYCLES))
            yield Problem("cycle", None, allowed)
        if self.friction_pressure is not None and self.mechanical_efficiency is not None:
            yield Problem("friction_pressure", None, _("must not stand beside mechanical_efficiency, which says it"))
        if self.friction_pressure is not None and self.friction_pressure.text.endswith(_GAUGE):
            allowed = _("must be in a unit that is not gauge, as bar or kPa: it is work over volume")
            yield Problem("friction_pressure", None, allowed)
