"""The chain's table of the machine file, part by part."""

from collections.abc import Iterator, Mapping
from math import pi
from typing import Annotated, Literal, NamedTuple

from pydantic import Field

from cranktrain.allowed import Name
from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.mechanisms.spec import MechanismSpec
from cranktrain.quantities import Angle, Given, Length, PositiveLength, Ratio
from cranktrain.spec import Spec

FixedPoint = Annotated[tuple[Length, ...], Field(min_length=2, max_length=2)]
"""x and y in the file's own axes."""


class Used(NamedTuple):
    """Marks a name of something that stands above: of a point, a link, a fixed point, or what can carry a point."""

    sort: str


class Made(NamedTuple):
    """Marks a name that a part gives: of a point, a link, a slider in a fixed guide, or a block on a swivel's pin."""

    sort: str


class ChainCrankSpec(Spec, frozen=True):
    """A crank on the shaft; every one but `main` is an eccentric, ahead of it by its angle."""

    radius: PositiveLength = Field(description=N_("From shaft centre to pin."))
    angle: Angle = Field(
        default=Given(0.0, "0 deg"), description=N_("How far the eccentric stands ahead of the crank `main`.")
    )
    ratio: Ratio = Field(
        default=Given(1.0, "1"),
        description=N_("Turns for one of the crank `main`: 1, as all cranks of a chain are on one shaft."),
    )


class ChainLinkSpec(Spec, frozen=True):
    """A rod or rocker: its name, the point that its first pin is on, its length."""

    name: Annotated[str, Made("link")] = Field(description=N_("Name of the link."))
    start: Annotated[str, Used("point")] = Field(alias="from", description=N_("Point that the first pin is on."))
    length: PositiveLength = Field(description=N_("From its first pin to its second."))


class ChainGuideSpec(Spec, frozen=True):
    """A fixed guide: a line beside a fixed point, in a direction from x."""

    through: Annotated[str, Used("fixed")] = Field(
        description=N_("Fixed point beside which the guide runs; O is the shaft's centre.")
    )
    direction: Angle = Field(
        description=N_("Direction of the guide from x toward y; the slider's position counts along it.")
    )
    offset: Length = Field(
        default=Given(0.0, "0 mm"),
        description=N_("Distance of the guide from that point, to the left of its direction."),
    )


class SwivelGuideSpec(Spec, frozen=True):
    """A guide that rocks about a point: its name, that point, the offset of its line to the left."""

    name: Annotated[str, Made("link")] = Field(description=N_("Name of the guide, which is a link."))
    start: Annotated[str, Used("point")] = Field(alias="from", description=N_("Point about which it rocks."))
    offset: Length = Field(
        default=Given(0.0, "0 mm"), description=N_("Of its line from that point, to the left of its direction.")
    )


class PinPartSpec(Spec, frozen=True):
    """Rod and rocker that meet in a joint (RRR)."""

    type: Literal["pin"] = Field(description=N_("Type of group."))
    rod: ChainLinkSpec = Field(description=N_("The rod, from the driving point to the joint."))
    rocker: ChainLinkSpec = Field(description=N_("The rocker, from its pivot to the joint."))
    joint: Annotated[str, Made("point")] = Field(description=N_("Name of the point where both meet."))
    side: Literal["left", "right"] = Field(
        description=N_("Of the line from the rod's first pin to the rocker's, on which the joint lies.")
    )
    crossed: bool = Field(
        default=False,
        description=N_(
            "Whether links of a parallelogram's lengths are the crossed ones, whose rocker turns against the crank."
        ),
    )


class SlidePartSpec(Spec, frozen=True):
    """Rod to a slider on a fixed guide (RRP)."""

    type: Literal["slide"] = Field(description=N_("Type of group."))
    rod: ChainLinkSpec = Field(description=N_("The rod, from the driving point to the slider."))
    slider: Annotated[str, Made("slider")] = Field(description=N_("Name of the slider; its pin is the point NAME.pin."))
    guide: ChainGuideSpec = Field(description=N_("The fixed guide."))
    side: Literal["ahead", "behind"] = Field(
        default="ahead",
        description=N_("Whether the slider lies ahead of or behind the foot of the rod's first pin, along the guide."),
    )


class SwivelPartSpec(Spec, frozen=True):
    """Slider on a pin, in a guide that rocks about a point (RPR)."""

    type: Literal["swivel"] = Field(description=N_("Type of group."))
    pin: Annotated[str, Used("point")] = Field(description=N_("Point that carries the slider."))
    guide: SwivelGuideSpec = Field(description=N_("The guide in which it slides."))
    slider: Annotated[str, Made("block")] = Field(
        description=N_("Name of the slider, whose position counts along the guide.")
    )
    side: Literal["ahead", "behind"] = Field(
        default="ahead", description=N_("Whether the slider lies ahead of or behind the pivot, along the guide.")
    )


class YokePartSpec(Spec, frozen=True):
    """Slotted slider on a fixed guide, driven by a block on a pin (RPP)."""

    type: Literal["yoke"] = Field(description=N_("Type of group."))
    pin: Annotated[str, Used("point")] = Field(description=N_("Point that carries the block in the slot."))
    slider: Annotated[str, Made("slider")] = Field(
        description=N_("Name of the slotted slider; where its slot meets the guide is the point NAME.pin.")
    )
    guide: ChainGuideSpec = Field(description=N_("The fixed guide."))
    slot_angle: Angle = Field(
        default=Given(pi / 2, "90 deg"), description=N_("From the guide's direction to the slot.")
    )


class TrammelPartSpec(Spec, frozen=True):
    """Slider on a fixed guide, held where a link's slot crosses it (PRP)."""

    type: Literal["trammel"] = Field(description=N_("Type of group."))
    link: Annotated[str, Used("link")] = Field(description=N_("Link that carries the slot."))
    slider: Annotated[str, Made("slider")] = Field(description=N_("Name of the slider; its pin is the point NAME.pin."))
    guide: ChainGuideSpec = Field(description=N_("The fixed guide."))
    shift: Length = Field(default=Given(0.0, "0 mm"), description=N_("Of the slot from the link's line, to the left."))


class PointPartSpec(Spec, frozen=True):
    """A point fixed on a link, or on a slider in a fixed guide, on which other parts may hang."""

    type: Literal["point"] = Field(description=N_("Type of group."))
    name: Annotated[str, Made("point")] = Field(description=N_("Name of the point."))
    link: Annotated[str, Used("carrier")] = Field(
        description=N_("The link that carries it, or the slider in a fixed guide.")
    )
    along: Length = Field(
        description=N_("Distance from the link's first pin toward its second; from a slider's pin along its guide.")
    )
    across: Length = Field(
        default=Given(0.0, "0 mm"), description=N_("Distance from the line of pins, or from the guide, to its left.")
    )


class TriadLegSpec(Spec, frozen=True):
    """A joint of a triad's link, on a rod (`joint`, `rod`) or in a fixed guide (`slider`, `guide`)."""

    along: Length = Field(
        default=Given(0.0, "0 mm"),
        description=N_("Joint's distance along the link, from a point of it that is the same for all legs."),
    )
    across: Length = Field(
        default=Given(0.0, "0 mm"),
        description=N_("Joint's distance from the link's line through that point, to its left."),
    )
    joint: Annotated[str, Made("point")] | None = Field(
        default=None, description=N_("Name of the joint, of a leg that is a rod.")
    )
    rod: ChainLinkSpec | None = Field(
        default=None,
        description=N_("The rod, from a point above to the joint; for a circular slot, from the slot's centre."),
    )
    slider: Annotated[str, Made("slider")] | None = Field(
        default=None, description=N_("Name of the slider, of a leg that is a guide; its pin, NAME.pin, is the joint.")
    )
    guide: ChainGuideSpec | None = Field(default=None, description=N_("The fixed guide."))
    near: FixedPoint | None = Field(
        default=None,
        description=N_("Where about the joint lies when the crank lies along x: chooses the assembly mode."),
    )

    def _problems(self) -> Iterator[Problem]:
        """Find a leg that is neither rod nor guide, or both."""
        given = {name for name in ("joint", "rod", "slider", "guide") if getattr(self, name) is not None}
        if given not in ({"joint", "rod"}, {"slider", "guide"}):
            yield Problem("", None, _("must have joint and rod, or slider and guide"))


class TriadPartSpec(Spec, frozen=True):
    """Link on three legs, each a rod or a guide; a circular slot is a rod to its centre."""

    type: Literal["triad"] = Field(description=N_("Type of group."))
    link: Annotated[str, Made("link")] = Field(description=N_("Name of the link that the three legs hold."))
    leg: Annotated[tuple[TriadLegSpec, ...], Field(min_length=3, max_length=3)] = Field(
        description=N_("The three legs, each with its joint on the link.")
    )


PartSpec = Annotated[
    PinPartSpec | SlidePartSpec | SwivelPartSpec | YokePartSpec | TrammelPartSpec | PointPartSpec | TriadPartSpec,
    Field(discriminator="type"),
]


class ChainTable(MechanismSpec, frozen=True):
    """Cranks on one shaft, fixed points, and groups that each hang on what stands above them."""

    kind: Literal["chain"]
    output: str = Field(description=N_("Name of the slider or link that load and gas act on."))
    fixed: Mapping[Name, FixedPoint] = Field(
        default={}, description=N_("Fixed points by name: x and y in the file's own axes, from the shaft's centre.")
    )
    crank: Mapping[Name, ChainCrankSpec] = Field(
        description=N_("Cranks on the shaft: `main`, whose angle is the crank angle, and eccentrics.")
    )
    part: tuple[PartSpec, ...] = Field(min_length=1, description=N_("Groups, each on what stands above it."))
