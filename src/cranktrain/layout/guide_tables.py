"""Guides of a machine file, put to what slides in every mechanism."""

from collections.abc import Mapping
from typing import NamedTuple

from cranktrain.layout.bodies import GuideSpec
from cranktrain.layout.part_tables import nearest_item
from cranktrain.layout.places import PlacedMechanism
from cranktrain.mechanisms.dynamics import AnyDynamics
from cranktrain.motion import ZERO, Array, single


class Edges(NamedTuple):
    """Edges of a guide: 1/length, 0 if none is given [1/m]; middle from the pin, its place if `stays` is 1 [m]."""

    per_length: Array
    middle: Array
    stays: Array


NO_EDGES = Edges(ZERO, ZERO, ZERO)
"""A guide whose length is not given."""

Guides = Mapping[str, Mapping[str, GuideSpec]]
"""Guides by path of their table and by name of what slides."""


def edges_of(place: PlacedMechanism, sliding: str, guides: Guides) -> Edges:
    """Edges of the guide of what slides in a mechanism."""
    spec = nearest_item(place, sliding, "guide", guides)
    if spec is None:
        return NO_EDGES
    middle = spec.middle if spec.at is None else spec.at
    return Edges(
        1.0 / spec.length.array,
        ZERO if middle is None else middle.array,
        single(0.0 if spec.at is None else 1.0),
    )


def bearing_moments(dynamics: AnyDynamics) -> tuple[str, ...]:
    """What slides in a guide that bears moments; a block does not turn against its slot."""
    return tuple(
        name for name, contact in zip(dynamics.sliding, dynamics.contacts, strict=True) if contact.bears_moment
    )
