"""Tables of the machine file that stand by the names of parts, for all mechanisms or a bank's; guides among them."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple, TypeVar

from cranktrain.errors import Problem
from cranktrain.language import Message, _
from cranktrain.layout.bodies import GuideSpec
from cranktrain.layout.places import PlacedMechanism
from cranktrain.mechanisms.dynamics import AnyDynamics
from cranktrain.motion import ZERO, Array, single
from cranktrain.quantities import Given

Item = TypeVar("Item")

PISTON, SLIDER = "piston", "slider"
"""Name in the file of an engine's slider: the piston set, or a crosshead with piston and rod; its name elsewhere."""


def part_name(moving: str) -> str:
    """Name in the file of what a mechanism calls by another: its slider is a piston."""
    return PISTON if moving == SLIDER else moving


def table_paths(place: PlacedMechanism, table: str) -> tuple[str, ...]:
    """Paths of the tables of a name that speak of a mechanism, the nearest first."""
    home = place.path.rpartition(".")[0]
    return (f"{home}.{table}", table) if home else (table,)


def nearest_item(place: PlacedMechanism, part: str, table: str, given: Mapping[str, Mapping[str, Item]]) -> Item | None:
    """Find what the nearest table that speaks of a part gives it; None where none does."""
    found = (given.get(path, {}).get(part_name(part)) for path in table_paths(place, table))
    return next((item for item in found if item is not None), None)


def unknown_parts(
    places: Sequence[PlacedMechanism],
    table: str,
    given: Mapping[str, Mapping[str, object]],
    known: Callable[[AnyDynamics], Iterable[str]],
    allowed: Message,
) -> Iterator[Problem]:
    """Find items of tables, by path, that no mechanism of which they speak has; `known` says which parts one has."""
    for path, items in given.items():
        own = [place.kind.dynamics for place in places if path in table_paths(place, table)]
        parts = dict.fromkeys(part_name(name) for dynamics in own for name in known(dynamics))
        said = allowed.format(parts=", ".join(parts) or _("nothing does"))
        for name, item in items.items():
            if name not in parts:
                yield Problem(f"{path}.{name}", item.text if isinstance(item, Given) else None, said)


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
