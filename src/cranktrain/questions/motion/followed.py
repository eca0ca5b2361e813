"""What has a name in a mechanism and no result of its own: links beside rod and rocker, and what slides along them."""

from collections.abc import Sequence
from typing import Any, ClassVar, TypeVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.catalogue import coefficients
from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.layout.places import PlacedMechanism
from cranktrain.motion import Coefficient, Link
from cranktrain.numerics import unwrapped
from cranktrain.record import record

_LINK = ("link", "crank_angle")
_SLIDER = ("slider", "crank_angle")
_THEORY = "docs/theory/groups-2"


@record
class Followed:
    """Parts of mechanisms that are followed.

    Attributes
    ----------
    names : tuple of str
        `1.lever`: the mechanism and the part's own name.
    mechanism : array of int, shape (part,)
        Which of all mechanisms it is of.
    parts : tuple of str
        The part's own name.
    """

    needs: ClassVar[str] = ""

    names: tuple[str, ...]
    mechanism: NDArray[np.intp]
    parts: tuple[str, ...]

    dimension: ClassVar[str]

    @property
    def labels(self) -> dict[str, tuple[str, ...]]:
        """Names of the parts."""
        return {self.dimension: self.names}


@record
class FollowedLinks(Followed):
    """Links by their names, beside the rods and rockers that have results of their own."""

    dimension: ClassVar[str] = "link"


@record
class FollowedSliders(Followed):
    """What slides: its position is a number."""

    dimension: ClassVar[str] = "slider"


FollowedLike = TypeVar("FollowedLike", bound=Followed)


def followed_of(result: type[FollowedLike], places: Sequence[PlacedMechanism]) -> FollowedLike | None:
    """Collect the links or the sliders of every mechanism; None where there are none."""
    parts = [
        (i, place, name)
        for i, place in enumerate(places)
        for name in (place.kind.followed_links if result is FollowedLinks else place.kind.sliders)
    ]
    if not parts:
        return None
    return result(
        names=tuple(f"{place.name}.{name}" for _i, place, name in parts),
        mechanism=np.array([i for i, _p, _n in parts], dtype=np.intp),
        parts=tuple(name for _i, _p, name in parts),
    )


@record
class LinkMotion:
    """Motion of links by their names."""

    link_angle: Coefficient = coefficients(
        "θ",
        "rad",
        _LINK,
        N_("Direction of the link, from its first pin to its second, from the mechanism's x"),
        N_("Link's angular velocity for each rad/s of the crank"),
        N_("Link's angular acceleration for each (rad/s)² of the crank"),
        _THEORY,
    )


def link_motion(links: FollowedLinks, mechanisms: Mechanisms, crank_angle: CrankAngle) -> LinkMotion:
    """Angles of all links, without jumps, and their derivatives."""
    angle = _followed(links, mechanisms, crank_angle)
    return LinkMotion(angle._replace(value=unwrapped(angle.value)))


@record
class SliderMotion:
    """Motion of what slides, by its name."""

    slider_position: Coefficient = coefficients(
        "t",
        "m",
        _SLIDER,
        N_("Position along the guide or slot, in the direction in which that points"),
        N_("Velocity along the guide or slot for each rad/s of the crank"),
        N_("Second derivative of the position by the crank angle"),
        _THEORY,
    )


def slider_motions(sliders: FollowedSliders, mechanisms: Mechanisms, crank_angle: CrankAngle) -> SliderMotion:
    """Positions of all sliders and blocks, and their derivatives."""
    return SliderMotion(_followed(sliders, mechanisms, crank_angle))


def _followed(followed: Followed, mechanisms: Mechanisms, crank_angle: CrankAngle) -> Coefficient:
    """Value and derivatives of every part, shape (design, part, n)."""
    curves = np.empty((3, len(crank_angle.zero), len(followed.names), crank_angle.shown.size))
    for batch in mechanisms.batches:
        chosen = np.flatnonzero(np.isin(followed.mechanism, batch.index))
        if not chosen.size:
            continue
        motion = batch.kind.motion(crank_angle.angle + batch.members.phase, batch.members.geometry)
        members = np.searchsorted(batch.index, followed.mechanism[chosen])
        for place, member in zip(chosen.tolist(), members.tolist(), strict=True):
            moving = _coefficient(batch.kind.part(motion, followed.parts[place]))
            for curve, values in zip(curves, moving, strict=True):
                curve[:, place] = values[:, member]
    return Coefficient(*curves)


def _coefficient(part: Any) -> Coefficient:
    """Take a link by its angle, a slider as it is."""
    return part.angle if isinstance(part, Link) else part
