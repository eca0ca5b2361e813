"""What every mechanism of a machine file may declare, and what one that hangs on another is given."""

from collections.abc import Mapping
from typing import Any, ClassVar, NamedTuple

import numpy as np
from pydantic import Field

from cranktrain.allowed import Name
from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.quantities import Angle, Given, Length, PositiveLength
from cranktrain.spec import Spec

LISTS = frozenset({"part"})
"""Fields of a mechanism that are lists by themselves, and not one value for each angle of a bank."""


class LinkPointSpec(Spec, frozen=True):
    """A point fixed on a link, to be followed: `link`, how far `along` it from its first pin, how far `across`."""

    link: str = Field(description=N_("The link that carries the point."))
    along: Length = Field(description=N_("Distance from the link's first pin toward its second."))
    across: Length = Field(
        description=N_("Distance from the line of pins, to the side turned 90° from it in the sense of rotation.")
    )
    band: PositiveLength | None = Field(
        default=None,
        description=N_("How far within the end of its path the point counts as being there, as a foot on the ground."),
    )
    toward: Angle = Field(
        default=Given(-np.pi / 2, "-90 deg"), description=N_("Direction of that end, from the mechanism's x toward y.")
    )


class MechanismSpec(Spec, frozen=True):
    """What every mechanism of a machine file may declare."""

    kind: str = Field(description=N_("Kind of mechanism."))
    points: Mapping[Name, LinkPointSpec] = Field(default={}, description=N_("Points on links to follow, by name."))

    elsewhere: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(("n", "rpm", "speed", "omega"), "[shaft.main] speed"),
        **dict.fromkeys(("d", "bore", "diameter"), "[cylinder] bore"),
        **dict.fromkeys(("epsilon", "ε", "compression_ratio"), "[cylinder] compression_ratio"),
        "mass": "[masses.piston] mass",
        "double_acting": '[cylinder] chambers = ["head", "crank"]',
    }
    kinds_elsewhere: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(("crank_slider", "slider", "piston", "engine"), 'kind = "slider_crank"'),
        **dict.fromkeys(("four_bar", "fourbar", "four-bar"), 'kind = "crank_rocker"'),
        **dict.fromkeys(("whitworth", "quick_return", "shaper"), 'kind = "slotted_lever"'),
        **dict.fromkeys(("linkage", "six_bar", "sixbar"), 'kind = "chain"'),
        **dict.fromkeys(("heusinger",), 'kind = "walschaerts"'),
    }

    master_field: ClassVar[str | None] = None
    """Field that names the bank whose slider-crank, on the same throw, this mechanism hangs on."""

    @property
    def pressure_angle_limit(self) -> Given | None:
        """Largest pressure angle that its rod is permitted; None where it has none, or no limit."""
        return None

    @property
    def load_arm(self) -> Array | None:
        """Radius at which its rocker carries a load, negative against its angle; None without one. [m]"""
        return None


class Master(NamedTuple):
    """What a slave mechanism hangs on: the master's geometry, and the slave's axis ahead of the master's. [rad]"""

    geometry: Any
    bank_angle: Array
