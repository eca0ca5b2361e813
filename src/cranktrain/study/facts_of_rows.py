"""Facts of designs, beside one another; of starts and of cycles, whoever finds them."""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from cranktrain.errors import Problem
from cranktrain.language import Words
from cranktrain.motion import Array
from cranktrain.saying.catalogue import Entry


class FactsOfRows(NamedTuple):
    """Facts of some designs.

    Attributes
    ----------
    entries : mapping of str to Entry
        Of those that any design has, by name.
    labels : mapping of str to tuple of str
        Members along their dimensions.
    values : mapping of str to Array, shape (row, …)
        In the unit of the entry; NaN where a design has none.
    refused : tuple of Problem or None
        What is wrong with a design, the first of it; None of one that was computed.
    failing : tuple of Words
        Which checks of a design do not hold; empty where all do.
    ended : tuple of Words
        Why the start of a design ended; empty of what is no start.
    flags : tuple of tuple of Words
        What is to be minded of a design: numbers beyond what was ever built, or beyond what digits allow.
    """

    entries: Mapping[str, Entry]
    labels: Mapping[str, tuple[str, ...]]
    values: Mapping[str, Array]
    refused: Sequence[Problem | None]
    failing: Sequence[Words]
    ended: Sequence[Words]
    flags: Sequence[tuple[Words, ...]]


def joined_rows(parts: Sequence[FactsOfRows], labels: Mapping[str, tuple[str, ...]] | None = None) -> FactsOfRows:
    """Put facts of designs behind one another; members that have a place already, `labels`, keep it."""
    together, start = Gathered(sum(len(part.refused) for part in parts), labels or {}), 0
    for part in parts:
        together.add_rows(part, range(start, start + len(part.refused)))
        start += len(part.refused)
    return together.found()


def rows_of(found: FactsOfRows, first: int, after: int) -> FactsOfRows:
    """Facts of some designs that stand one behind the other."""
    own = slice(first, after)
    values = {name: array[own] for name, array in found.values.items()}
    each = (found.refused[own], found.failing[own], found.ended[own], found.flags[own])
    return FactsOfRows(found.entries, found.labels, values, *each)


class Gathered:
    """Facts of designs that may have other members, laid beside each other."""

    def __init__(self, n_rows: int, labels: Mapping[str, tuple[str, ...]] = MappingProxyType({})) -> None:
        self.entries: dict[str, Entry] = {}
        self.labels = dict(labels)
        self.values: dict[str, Array] = {}
        self.refused: list[Problem | None] = [None] * n_rows
        self.failing: list[Words] = [""] * n_rows
        self.ended: list[Words] = [""] * n_rows
        self.flags: list[tuple[Words, ...]] = [()] * n_rows

    def found(self) -> FactsOfRows:
        """Give all that is known."""
        said = tuple(self.refused), tuple(self.failing), tuple(self.ended), tuple(self.flags)
        return FactsOfRows(self.entries, self.labels, self.values, *said)

    def add_rows(self, found: FactsOfRows, places: Sequence[int]) -> None:
        """Lay facts of designs to their places, with all that is said of them."""
        self.add(found.entries, found.labels, found.values, places)
        for row, place in enumerate(places):
            self.refused[place], self.failing[place] = found.refused[row], found.failing[row]
            self.ended[place], self.flags[place] = found.ended[row], found.flags[row]

    def add(
        self,
        entries: Mapping[str, Entry],
        labels: Mapping[str, tuple[str, ...]],
        values: Mapping[str, Any],
        places: Sequence[int],
    ) -> None:
        """Lay values to their places, with room for members that nobody had yet."""
        before = dict(self.labels)
        for dimension, own in labels.items():
            self.labels[dimension] = tuple(dict.fromkeys((*self.labels.get(dimension, ()), *own)))
        for name, entry in entries.items():
            self.entries.setdefault(name, entry)
            if name not in self.values or any(before[one] != self.labels[one] for one in entry.dimensions):
                self.values[name] = self._with_room(entry, before)
            self.values[name][np.ix_(places, *self._places(entry, labels))] = values[name]

    def _with_room(self, entry: Entry, before: Mapping[str, tuple[str, ...]]) -> Array:
        """What is known of a fact, with room for all members that there are now."""
        sizes = [len(self.labels[dimension]) for dimension in entry.dimensions]
        whole = np.full((len(self.failing), *sizes), np.nan)
        if entry.name in self.values:
            whole[np.ix_(range(len(whole)), *self._places(entry, before))] = self.values[entry.name]
        return whole

    def _places(self, entry: Entry, labels: Mapping[str, tuple[str, ...]]) -> list[list[int]]:
        """Where members of a fact stand among all, along each of its dimensions."""
        return [[self.labels[one].index(label) for label in labels[one]] for one in entry.dimensions]
