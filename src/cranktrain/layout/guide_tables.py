"""Guides of a machine file: put to what slides in every mechanism, and which mechanism has what they speak of."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from cranktrain.errors import Problem
from cranktrain.language import _
from cranktrain.layout.bodies import GuideSpec
from cranktrain.layout.part_tables import nearest_item, part_name, table_paths
from cranktrain.layout.places import PlacedMechanism
from cranktrain.mechanisms.dynamics import AnyDynamics
from cranktrain.motion import ZERO, Array, single

_TABLE = "guide"


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
    spec = nearest_item(place, sliding, _TABLE, guides)
    if spec is None:
        return NO_EDGES
    middle = spec.middle if spec.at is None else spec.at
    return Edges(
        single(1.0 / spec.length.si),
        single(0.0 if middle is None else middle.si),
        single(0.0 if spec.at is None else 1.0),
    )


def bearing_moments(dynamics: AnyDynamics) -> tuple[str, ...]:
    """What slides in a guide that bears moments; a block does not turn against its slot."""
    return tuple(
        name for name, contact in zip(dynamics.sliding, dynamics.contacts, strict=True) if contact.bears_moment
    )


def guide_problems(places: Sequence[PlacedMechanism], guides: Guides) -> list[Problem]:
    """Find guides of what no mechanism has, and of what bears no moment in its guide."""
    found: list[Problem] = []
    for path, specs in guides.items():
        own = [place for place in places if path in table_paths(place, _TABLE)]
        known = list(dict.fromkeys(part_name(name) for place in own for name in bearing_moments(place.kind.dynamics)))
        allowed = _("must be what slides in a guide, which can bear a moment: {parts}").format(
            parts=", ".join(known) or _("nothing does")
        )
        found += [Problem(f"{path}.{name}", None, allowed) for name in specs if name not in known]
    return found
