"""What has a name in a mechanism and no result of its own: links beside rod and rocker, and what slides along them."""

from collections.abc import Callable, Sequence
from typing import Any, ClassVar, TypeVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.layout.places import PlacedMechanism
from cranktrain.motion import Coefficient
from cranktrain.numerics import unwrapped
from cranktrain.numerics.nested import Nested, each_changed, side_by_side
from cranktrain.questions.motion.grid_motion import GridMotion
from cranktrain.record import record
from cranktrain.saying.catalogue import coefficients

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

    names: tuple[str, ...]
    mechanism: NDArray[np.intp]
    parts: tuple[str, ...]

    dimension: ClassVar[str]
    reads: ClassVar[tuple[str, ...]] = ("[mechanism]",)

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
Moving = TypeVar("Moving", bound=tuple[object, ...])


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
        ("link", "crank_angle"),
        N_("Direction of the link, from its first pin to its second, from the mechanism's x"),
        N_("Link's angular velocity for each rad/s of the crank"),
        N_("Link's angular acceleration for each (rad/s)² of the crank"),
        _THEORY,
        "7.1 to 7.3, 7.10 to 7.16",
    )


def link_motion(links: FollowedLinks, motion: GridMotion) -> LinkMotion:
    """Angles of all links, without jumps, and their derivatives."""
    angle = followed_parts(links, motion, lambda link, _place: link.angle)
    return LinkMotion(angle._replace(value=unwrapped(angle.value)))


@record
class SliderMotion:
    """Motion of what slides, by its name."""

    slider_position: Coefficient = coefficients(
        "t",
        "m",
        ("slider", "crank_angle"),
        N_("Position along the guide or slot, in the direction in which that points"),
        N_("Velocity along the guide or slot for each rad/s of the crank"),
        N_("Second derivative of the position by the crank angle"),
        _THEORY,
        "7.1, 7.4, 7.6 to 7.9, 7.17",
    )


def slider_motions(sliders: FollowedSliders, motion: GridMotion) -> SliderMotion:
    """Positions of all sliders and blocks, and their derivatives."""
    return SliderMotion(followed_parts(sliders, motion, lambda slider, _place: slider))


def followed_parts(followed: Followed, motion: GridMotion, pick: Callable[[Any, int], Moving]) -> Moving:
    """Motion of every part, shape (design, part, n): what `pick` takes of each, by its place, shape (design, 1, n)."""
    picked: list[tuple[NDArray[np.intp], Moving]] = []
    for batch, own in zip(motion.mechanisms.batches, motion.batches, strict=True):
        for place in np.flatnonzero(np.isin(followed.mechanism, batch.index)).tolist():
            member = np.flatnonzero(batch.index == followed.mechanism[place])
            part = _members(batch.kind.named(own, followed.parts[place]), member)
            picked.append((np.array([place]), pick(part, place)))
    return side_by_side(picked, (len(motion.mechanisms.nominal_top), len(followed.names), motion.n_angles))


def _members(motion: Nested, index: NDArray[np.intp]) -> Nested:
    """Take some members of a part: nested NamedTuples of arrays, shape (design, member, n)."""
    return each_changed(lambda values: values[:, index], motion)
