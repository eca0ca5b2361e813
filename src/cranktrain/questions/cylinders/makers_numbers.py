"""A maker's numbers in a firing order whose cylinders have other names: the line that says which cylinders they are."""

import itertools
from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.motion import Array
from cranktrain.numerics.ties import smallest_of
from cranktrain.questions.cylinders.firing import firing_angles


def are_makers_numbers(order: Sequence[str], names: Sequence[str]) -> bool:
    """Whether an order counts the cylinders from 1, and they have other names."""
    counted = {str(number) for number in range(1, len(names) + 1)}
    return set(order) == counted and counted != set(names)


def numbers_line(order: Sequence[str], leading: Sequence[PlacedMechanism], tops: Array, cycle: float | None) -> str:
    """Give the line for the table of the cylinders: counted in the way in which the order fires most evenly.

    Of ways that fire as evenly, that along one bank after the other comes first, in the order of the file.
    """
    ways = [{str(n): name for n, name in enumerate(names, 1)} for names in _ways_to_count(leading)]
    places = [place.cylinder for place in leading]

    def unevenness(numbers: dict[str, str]) -> float:
        """Sum of squared intervals; infinite where the pins do not allow the order."""
        if cycle is None:
            return 0.0
        fired = firing_angles(tops[[places.index(numbers[word]) for word in order]], cycle)
        return np.inf if fired is None else float(np.sum(np.diff(fired, append=fired[0] + cycle) ** 2).round(6))

    numbers = smallest_of(ways, unevenness)
    pairs = ", ".join(f'{word} = "{name}"' for word, name in numbers.items())
    return _("where these are the maker's numbers, write in [cylinder]: {line}").format(line=f"numbers = {{ {pairs} }}")


def _ways_to_count(leading: Sequence[PlacedMechanism]) -> Iterator[list[str]]:
    """Count along one bank after the other, or throw by throw, from either bank."""
    banks = list(dict.fromkeys(place.bank for place in leading))
    of_bank = {bank: [place.cylinder for place in leading if place.bank == bank] for bank in banks}
    for ordered in (banks, banks[::-1]):
        yield [name for bank in ordered for name in of_bank[bank]]
    for ordered in (banks, banks[::-1]):
        rows = itertools.zip_longest(*(of_bank[bank] for bank in ordered))
        yield [name for row in rows for name in row if name is not None]
