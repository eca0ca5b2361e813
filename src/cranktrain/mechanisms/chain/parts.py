"""The chain's table of the machine file, part by part."""

from collections.abc import Mapping
from math import pi
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from cranktrain.language import _
from cranktrain.mechanisms.spec import MechanismSpec
from cranktrain.quantities import Angle, Given, Length, PositiveLength, Ratio
from cranktrain.spec import Refused, Spec

FixedPoint = Annotated[tuple[Length, ...], Field(min_length=2, max_length=2)]
"""x and y in the file's own axes."""


class ChainCrankSpec(Spec, frozen=True):
    """A crank on the shaft; every one but `main` is an eccentric, ahead of it by its angle."""

    radius: PositiveLength
    angle: Angle = Given(0.0, "0 deg")
    ratio: Ratio = Given(1.0, "1")


class ChainLinkSpec(Spec, frozen=True):
    """A rod or rocker: its name, the point that its first pin is on, its length."""

    name: str
    start: str = Field(alias="from")
    length: PositiveLength


class ChainGuideSpec(Spec, frozen=True):
    """A fixed guide: a line beside a fixed point, in a direction from x."""

    through: str
    direction: Angle
    offset: Length = Given(0.0, "0 mm")


class SwivelGuideSpec(Spec, frozen=True):
    """A guide that rocks about a point: its name, that point, the offset of its line to the left."""

    name: str
    start: str = Field(alias="from")
    offset: Length = Given(0.0, "0 mm")


class PinPartSpec(Spec, frozen=True):
    """Rod and rocker that meet in a joint (RRR)."""

    type: Literal["pin"]
    rod: ChainLinkSpec
    rocker: ChainLinkSpec
    joint: str
    side: Literal["left", "right"]


class SlidePartSpec(Spec, frozen=True):
    """Rod to a slider on a fixed guide (RRP)."""

    type: Literal["slide"]
    rod: ChainLinkSpec
    slider: str
    guide: ChainGuideSpec
    side: Literal["ahead", "behind"] = "ahead"


class SwivelPartSpec(Spec, frozen=True):
    """Slider on a pin, in a guide that rocks about a point (RPR)."""

    type: Literal["swivel"]
    pin: str
    guide: SwivelGuideSpec
    slider: str
    side: Literal["ahead", "behind"] = "ahead"


class YokePartSpec(Spec, frozen=True):
    """Slotted slider on a fixed guide, driven by a block on a pin (RPP)."""

    type: Literal["yoke"]
    pin: str
    slider: str
    guide: ChainGuideSpec
    slot_angle: Angle = Given(pi / 2, "90 deg")


class TrammelPartSpec(Spec, frozen=True):
    """Slider on a fixed guide, held where a link's slot crosses it (PRP)."""

    type: Literal["trammel"]
    link: str
    slider: str
    guide: ChainGuideSpec
    shift: Length = Given(0.0, "0 mm")


class PointPartSpec(Spec, frozen=True):
    """A point fixed on a link, or on a slider in a fixed guide, on which other parts may hang."""

    type: Literal["point"]
    name: str
    link: str
    along: Length
    across: Length = Given(0.0, "0 mm")


class TriadLegSpec(Spec, frozen=True):
    """A joint of a triad's link, on a rod (`joint`, `rod`) or in a fixed guide (`slider`, `guide`)."""

    along: Length = Given(0.0, "0 mm")
    across: Length = Given(0.0, "0 mm")
    joint: str | None = None
    rod: ChainLinkSpec | None = None
    slider: str | None = None
    guide: ChainGuideSpec | None = None
    near: FixedPoint | None = None

    @model_validator(mode="after")
    def _of_one_sort(self) -> Self:
        """Refuse a leg that is neither rod nor guide, or both."""
        given = {name for name in ("joint", "rod", "slider", "guide") if getattr(self, name) is not None}
        if given not in ({"joint", "rod"}, {"slider", "guide"}):
            raise Refused(_("must have joint and rod, or slider and guide"))
        return self


class TriadPartSpec(Spec, frozen=True):
    """Link on three legs, each a rod or a guide; a circular slot is a rod to its centre."""

    type: Literal["triad"]
    link: str
    leg: Annotated[tuple[TriadLegSpec, ...], Field(min_length=3, max_length=3)]


PartSpec = Annotated[
    PinPartSpec | SlidePartSpec | SwivelPartSpec | YokePartSpec | TrammelPartSpec | PointPartSpec | TriadPartSpec,
    Field(discriminator="type"),
]


class ChainTable(MechanismSpec, frozen=True):
    """Cranks on one shaft, fixed points, and groups that each hang on what stands above them."""

    kind: Literal["chain"]
    output: str
    fixed: Mapping[str, FixedPoint] = {}
    crank: Mapping[str, ChainCrankSpec]
    part: tuple[PartSpec, ...] = Field(min_length=1)

    @property
    def rod_field(self) -> str:
        """Which part cannot close, its lengths say."""
        return "part"
