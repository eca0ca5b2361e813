"""Which members of a fact share a row of a table: those that are equal, or the extremes."""

from collections.abc import Iterator, Mapping, Sequence
from string import digits
from typing import Any, NamedTuple

import numpy as np

from cranktrain.analysis.dimensions import dimension_named, rivals
from cranktrain.analysis.figures import ABSENT, shown_in, text_in
from cranktrain.grouping import grouped
from cranktrain.language import N_, _
from cranktrain.motion import Array
from cranktrain.numerics.ties import falling
from cranktrain.saying.catalogue import Entry, Worst
from cranktrain.saying.wording import ranged

_MOST_GROUPS = 3
"""Members that differ among themselves have a row each up to here; of more the smallest and the largest has."""

_MOST_NUMBERED = 3
"""Of members that are numbers, as modes or orders, so many have rows."""

_MOST_OF_EACH = 2
"""Of the orders of each of several machines."""

_EXACT = "exact"
"""The first of several methods, beside which the others are approximations."""

_SAID: Mapping[Worst, str] = {"smallest": N_("min"), "largest": N_("max")}

_MOST_LETTERS = 16
"""Of the names of members; of more the smallest and the largest stands."""


class Labelled(NamedTuple):
    """Values with the names along their dimensions."""

    values: Array
    labels: Mapping[str, Sequence[str]]


def rows_of(entry: Entry, found: Sequence[Labelled | None]) -> Iterator[tuple[str, tuple[float, ...]]]:
    """Give the rows of one quantity.

    Parameters
    ----------
    entry : Entry
    found : sequence of Labelled or None
        Its values in each of several machines; None where one has it not.

    Yields
    ------
    of : str
        Whose of the members, or which: `L`, `mode 1`, `max`; empty where all are equal.
    values : tuple of float
        Of each machine; NaN where it has none.
    """
    outer = _outer_labels(found)
    for label in outer:
        flat = [None if one is None else _at(one, label) for one in found]
        words = "" if len(outer) == 1 or label == _EXACT else label
        for of, values in _flat_rows(entry, flat):
            yield ", ".join(filter(None, (words, of))), values


def _outer_labels(found: Sequence[Labelled | None]) -> list[str]:
    """Labels of the first of two dimensions, or of methods, of which the exact one alone; else one without words.

    Where exact is what errors are counted from, those of the other methods.
    """
    there = [one for one in found if one is not None]
    firsts = [list(next(iter(one.labels.values()), ())) for one in there]
    if any(labels[:1] == [_EXACT] for labels in firsts):
        is_error = all(not np.any(np.nan_to_num(one.values[0])) for one in there)
        others = dict.fromkeys(label for labels in firsts for label in labels[1:])
        return list(others) if is_error and others else [_EXACT]
    several = [labels for one, labels in zip(there, firsts, strict=True) if len(one.labels) > 1]
    return list(dict.fromkeys(label for labels in several for label in labels)) or [""]


def _at(one: Labelled, label: str) -> Labelled | None:
    """Values at a label of the first dimension, where it has that."""
    if not label:
        return one
    (_dimension, labels), *rest = one.labels.items()
    return Labelled(one.values[list(labels).index(label)], dict(rest)) if label in labels else None


def _flat_rows(entry: Entry, found: Sequence[Labelled | None]) -> Iterator[tuple[str, tuple[float, ...]]]:
    """Rows of a quantity that has members along one dimension, or none."""
    there = [one for one in found if one is not None]
    members = [_members(one) for one in there]
    if not entry.is_fact:
        sides: Sequence[Worst] = tuple(_SAID)
    elif all(len({*_texts(entry, one.values)} - {ABSENT}) <= 1 for one in there):
        yield "", tuple(_first(one) for one in found)
        return
    elif rows := list(_same_members(entry, found, members)):
        yield from rows
        return
    else:
        sides = tuple(_SAID) if entry.worst is None else (entry.worst,)
    for side in sides:
        said = "" if len(sides) == 1 else str(_(_SAID[side]))
        yield said, tuple(_extreme(_meant(one), side) for one in found)


def _meant(one: Labelled | None) -> Labelled | None:
    """Values without rivals, as methods are: of the one that is meant where none is named."""
    if one is None:
        return None
    place, _words = next(rivals(one.labels))
    return one._replace(values=one.values[place])


def _members(one: Labelled) -> tuple[str, ...]:
    """Names along the last dimension."""
    return tuple(list(one.labels.values())[-1]) if one.labels else ()


def _same_members(
    entry: Entry, found: Sequence[Labelled | None], members: Sequence[tuple[str, ...]]
) -> Iterator[tuple[str, tuple[float, ...]]]:
    """Rows of members that all machines have: of numbers the first few, of others those together that are equal."""
    there = [one for one in found if one is not None]
    dimension = entry.dimensions[-1]
    if dimension_named(dimension).is_number and entry.worst is None:
        for member in _counted(there):
            title = _(dimension_named(dimension).title)
            yield f"{title} {member}", tuple(_of_member(one, member) for one in found)
        return
    is_alike = all(one == members[0] for one in members) and all(one.values.ndim == 1 for one in there)
    if not is_alike or dimension_named(dimension).is_number:
        return
    texts = zip(*(_texts(entry, one.values) for one in there), strict=True)
    groups = grouped((text, place) for place, text in enumerate(texts))
    whose = [whose_of(members[0], places) for places in groups.values()]
    if len(groups) <= _MOST_GROUPS and len(set(whose)) == len(whose) and max(map(len, whose)) <= _MOST_LETTERS:
        for of, places in zip(whose, groups.values(), strict=True):
            yield of, tuple(np.nan if one is None else float(one.values[places[0]]) for one in found)


def _counted(there: Sequence[Labelled]) -> Sequence[str]:
    """Which of many members that are numbers have rows: of modes, whose values rise, the first, else the largest."""
    largest: list[str] = []
    for one in there:
        members = _members(one)
        sizes = np.nan_to_num(np.abs(one.values.reshape(-1, len(members))[0]))
        if np.all(np.diff(sizes) >= 0.0):
            return members[:_MOST_NUMBERED]
        most = _MOST_NUMBERED if len(there) == 1 else _MOST_OF_EACH
        largest += [members[place] for place in falling(sizes)[:most]]
    return list(dict.fromkeys(largest))


def whose_of(members: Sequence[str], places: Sequence[int]) -> str:
    """Name some of many members: all of a bank by it, joints of one sort by that, `wrist_pin` for `1.wrist_pin`."""
    parts = [members[place].partition(".") for place in places]
    if all(dot for _mechanism, dot, _part in parts):
        return ", ".join(dict.fromkeys(part for _mechanism, _dot, part in parts))
    banks = {members[place].lstrip(digits) for place in places}
    bank = next(iter(banks))
    of_bank = [place for place, member in enumerate(members) if member.lstrip(digits) == bank]
    return bank if len(banks) == 1 and bank and of_bank == list(places) else ranged(members, places)


def _texts(entry: Entry, values: Array) -> tuple[str, ...]:
    """Values as they are shown, by which they are one or differ."""
    shown = shown_in(entry.shown, values)
    return tuple(text_in(shown, float(value)) for value in np.ravel(values))


def _first(one: Labelled | None) -> float:
    """The first value that there is."""
    known = np.array([]) if one is None else one.values[np.isfinite(one.values)]
    return float(known[0]) if known.size else np.nan


def _of_member(one: Labelled | None, member: str) -> float:
    """Value of a member, where there is one."""
    if one is None or member not in _members(one):
        return np.nan
    return float(one.values[..., _members(one).index(member)].ravel()[0])


def _extreme(one: Labelled | None, side: Worst) -> float:
    """Smallest or largest of all members; NaN where none has a value."""
    if one is None or not np.any(np.isfinite(one.values)):
        return np.nan
    return float(ends(one.values, side))


def ends(values: Array, side: Worst, axis: int | None = None) -> Array:
    """Smallest or largest of values that there are; all along an axis, which stays, unless there is none."""
    least: Any = np.nanmin if side == "smallest" else np.nanmax
    return least(values, axis=axis, keepdims=axis is not None)
