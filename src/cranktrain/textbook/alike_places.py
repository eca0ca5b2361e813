"""Mechanisms that are alike, under one name; and what is said where there is none of which a text speaks."""

from collections.abc import Hashable, Iterator, Sequence

from cranktrain.errors import InputError, Problem
from cranktrain.grouping import places_of_equal
from cranktrain.layout.places import PlacedMechanism
from cranktrain.wording import ranged


def alike_places(places: Sequence[PlacedMechanism], keys: Sequence[Hashable]) -> Iterator[tuple[str, PlacedMechanism]]:
    """Give the names of those with one key, as a range, and the first of them."""
    names = [place.name for place in places]
    for members in places_of_equal(keys).values():
        yield ranged(names, members), places[members[0]]


def unspoken(places: Sequence[PlacedMechanism], allowed: str) -> InputError:
    """What is wrong with a machine of which a text does not speak."""
    kinds = ", ".join(dict.fromkeys(place.kind.name for place in places))
    return InputError([Problem("machine", kinds, allowed)])
