"""Mechanisms that are alike, under one name; and what is said where there is none of which a text speaks."""

from collections.abc import Hashable, Iterator, Sequence

from cranktrain.errors import InputError, Problem
from cranktrain.grouping import places_of_equal
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.texts.comparison import FORMS
from cranktrain.wording import ranged

_SPOKEN_OF = {"crank_rocker"}.union(*FORMS.values())
"""Kinds of mechanisms on whose motion a text has something."""


def alike_places(places: Sequence[PlacedMechanism], keys: Sequence[Hashable]) -> Iterator[tuple[str, PlacedMechanism]]:
    """Give the names of those with one key, as a range, and the first of them."""
    names = [place.name for place in places]
    for members in places_of_equal(keys).values():
        yield ranged(names, members), places[members[0]]


def unspoken(places: Sequence[PlacedMechanism], allowed: str) -> InputError:
    """What is wrong with a machine of which a text does not speak, and which function has what the texts do say."""
    kinds = dict.fromkeys(place.kind.name for place in places)
    return InputError([Problem("machine", ", ".join(kinds), allowed, instead(places))])


def instead(places: Sequence[PlacedMechanism]) -> str:
    """Say which function has what the texts say of the motion of some mechanisms, or that no text speaks of it."""
    if any(place.kind.name in _SPOKEN_OF for place in places):
        return _("`cranktrain.textbook.motion` has what the texts say of it")
    return _("none of the texts speaks of its motion")
