"""What belongs together, put together."""

from collections.abc import Hashable, Iterable
from typing import TypeVar

Key = TypeVar("Key", bound=Hashable)
Member = TypeVar("Member")
Other = TypeVar("Other")


def grouped(members: Iterable[tuple[Key, Member]]) -> dict[Key, list[Member]]:
    """Put those together that have the same key; the keys stand in the order in which each comes first.

    Examples
    --------
    >>> grouped([("L", 1), ("R", 2), ("L", 3)])
    {'L': [1, 3], 'R': [2]}
    """
    groups: dict[Key, list[Member]] = {}
    for key, member in members:
        groups.setdefault(key, []).append(member)
    return groups


def without_equal(members: Iterable[Other]) -> list[Other]:
    """Leave out what is equal to one before, of members that need be no keys.

    Examples
    --------
    >>> without_equal([80.0, 90.0, 80.0])
    [80.0, 90.0]
    """
    found: list[Other] = []
    for member in members:
        if member not in found:
            found.append(member)
    return found


def places_of_equal(keys: Iterable[Key]) -> dict[Key, list[int]]:
    """Put the places of equal keys together.

    Examples
    --------
    >>> places_of_equal(["80 mm", "90 mm", "80 mm"])
    {'80 mm': [0, 2], '90 mm': [1]}
    """
    return grouped((key, place) for place, key in enumerate(keys))
