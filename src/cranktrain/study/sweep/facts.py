"""Facts of many designs of one machine, each design checked by itself; what cannot be has a sentence and no number."""

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from cranktrain.analysis import Result, run
from cranktrain.analysis.blocks import MOST_AT_ONCE
from cranktrain.errors import InputError, Problem
from cranktrain.language import Words, _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.record import record
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.checks import Flag
from cranktrain.saying.run import Run
from cranktrain.study.cycle.road import CompiledWay
from cranktrain.study.facts_of_starts import facts_of_starts
from cranktrain.study.starts import Starts
from cranktrain.study.sweep.compiled import designs_at_once, facts_compiled, way_compiled
from cranktrain.study.sweep.designs import DesignsInColumns, designs_in_columns
from cranktrain.study.sweep.varied import SweptDesigns


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


@record
class FactsOfSweep:
    """What computes facts of designs of a sweep, here or elsewhere: called with a span of them, from and up to.

    Attributes
    ----------
    machine : Machine
    designs : SweptDesigns
    wanted : tuple of str
    over_time : bool
    """

    machine: Machine
    designs: SweptDesigns
    wanted: tuple[str, ...]
    over_time: bool = False

    def __call__(self, span: tuple[int, int]) -> FactsOfRows:
        """Compute facts of the designs of a span."""
        of = (self.machine, self.designs, *span, self.wanted)
        return facts_of_designs(*of, over_time=self.over_time, n_all=len(self.designs))

    @property
    def n_together(self) -> int:
        """How many designs cost less together than one by one."""
        way = self.way
        return designs_at_once(way) if isinstance(way, CompiledWay) else MOST_AT_ONCE

    @cached_property
    def way(self) -> CompiledWay | Words:
        """How the compiled cycle of the machine gives them; or why `run` does."""
        if self.over_time:
            return _("they are of starts")
        return way_compiled(self.machine, self.wanted, len(self.designs))


def facts_of_designs(
    machine: Machine,
    designs: SweptDesigns,
    first: int,
    last: int,
    wanted: Sequence[str],
    *,
    over_time: bool = False,
    n_all: int | None = None,
) -> FactsOfRows:
    """Compute facts of some designs of a sweep, as of their rows.

    Parameters
    ----------
    machine : Machine
    designs : SweptDesigns
    first, last : int
        Which of them: from `first` up to, but not with, `last`.
    wanted : sequence of str
        Names of facts.
    over_time : bool
        Whether they are of starts, and not of the cycle.
    n_all : int, optional
        How many designs there are, of which these are some.
    """
    block = designs_in_columns(machine, designs, first, last)
    refused: list[Problem | None] = [None] * (last - first)
    for place in block.refused:
        refused[place] = block.refused.unsaid(place)
    together = _Gathered(len(refused))
    for group in block.groups:
        places, each = group.places.tolist(), group.each
        if over_time:
            runs = _starts(places, each, wanted, refused, n_all)
        else:
            left = together.take_compiled(group, wanted, n_all or 0)
            runs = _cycles([places[one] for one in left], [each[one] for one in left], wanted, refused)
        for found, of in runs:
            together.take(found, of, wanted)
    return together.found(refused)


def joined_rows(parts: Sequence[FactsOfRows], labels: Mapping[str, tuple[str, ...]] | None = None) -> FactsOfRows:
    """Put facts of designs behind one another; members that have a place already, `labels`, keep it."""
    n_rows = sum(len(part.refused) for part in parts)
    together, start = _Gathered(n_rows, labels or {}), 0
    for part in parts:
        places = list(range(start, start + len(part.refused)))
        together.add(part.entries, part.labels, part.values, places)
        together.failing[start : start + len(places)] = part.failing
        together.ended[start : start + len(places)] = part.ended
        together.flags[start : start + len(places)] = part.flags
        start += len(places)
    return together.found([problem for part in parts for problem in part.refused])


def rows_of(found: FactsOfRows, first: int, after: int) -> FactsOfRows:
    """Facts of some designs that stand one behind the other."""
    own = slice(first, after)
    values = {name: array[own] for name, array in found.values.items()}
    each = (found.refused[own], found.failing[own], found.ended[own], found.flags[own])
    return FactsOfRows(found.entries, found.labels, values, *each)


def _starts(
    places: Sequence[int],
    machines: Sequence[Machine],
    wanted: Sequence[str],
    refused: list[Problem | None],
    n_all: int | None,
) -> Iterator[tuple[Run, Sequence[int]]]:
    """Starts of designs that differ in numbers alone."""
    found = facts_of_starts(machines, wanted, n_all=n_all)
    for design, problem in found.refused.items():
        refused[places[design]] = problem
    yield Starts(tuple(machines), found), places


def _cycles(
    places: Sequence[int], machines: Sequence[Machine], wanted: Sequence[str], refused: list[Problem | None]
) -> Iterator[tuple[Run, Sequence[int]]]:
    """Results of designs that differ in numbers alone; one by one where the computation refuses some of them."""
    for first in range(0, len(places), MOST_AT_ONCE):
        own, block = places[first : first + MOST_AT_ONCE], machines[first : first + MOST_AT_ONCE]
        try:
            run(block)  # which refuses what no quantity may show, and computes nothing else
            found = run(block, quantities=wanted)
            found.find_all()
        except InputError as error:
            if len(own) == 1:
                refused[own[0]] = error.problems[0]
                continue
            for one, design in zip(own, block, strict=True):
                yield from _cycles([one], [design], wanted, refused)
            continue
        yield found, own


class _Gathered:
    """Facts of designs that may have other members, laid beside each other."""

    def __init__(self, n_rows: int, labels: Mapping[str, tuple[str, ...]] = MappingProxyType({})) -> None:
        self.entries: dict[str, Entry] = {}
        self.labels = dict(labels)
        self.values: dict[str, Array] = {}
        self.failing: list[Words] = [""] * n_rows
        self.ended: list[Words] = [""] * n_rows
        self.flags: list[tuple[Words, ...]] = [()] * n_rows

    def found(self, refused: Sequence[Problem | None]) -> FactsOfRows:
        """Give all that is known."""
        said = tuple(self.failing), tuple(self.ended), tuple(self.flags)
        return FactsOfRows(self.entries, self.labels, self.values, tuple(refused), *said)

    def take(self, run: Run, places: Sequence[int], wanted: Sequence[str]) -> None:
        """Take what was asked for of a run of some designs."""
        entries = {name: run.catalogue[name] for name in wanted if name in run.catalogue}
        used = {dimension for entry in entries.values() for dimension in entry.dimensions}
        labels = {dimension: tuple(run.labels[dimension]) for dimension in sorted(used)}
        values = {name: np.asarray(getattr(run, name)) for name in entries}
        if run.n_designs is None:
            values = {name: value[np.newaxis] for name, value in values.items()}
        self.add(entries, labels, values, places)
        for place, reason in zip(places, run.reasons if isinstance(run, Starts) else (), strict=False):
            self.ended[place] = reason
        for check in run.checks if isinstance(run, Result) else ():
            for place in np.flatnonzero(check.judged & ~check.passed).tolist():
                self.failing[places[place]] = check.sentence
        for flag in run.flag_words if isinstance(run, Result) else ():
            for place, words in flag.own.items() if isinstance(flag, Flag) else ():
                self.flags[places[place]] += (words,)

    def take_compiled(self, group: DesignsInColumns, wanted: Sequence[str], n_all: int) -> Sequence[int]:
        """Take what the compiled cycle gives of designs; give which of them are left to `run`."""
        every = range(len(group.places))
        way = way_compiled(group.each[0], wanted, n_all)
        if not isinstance(way, CompiledWay):
            return every
        found = facts_compiled(group, way)
        if found is None:
            return every
        used = {dimension for entry in found.entries.values() for dimension in entry.dimensions}
        labels = {dimension: found.labels[dimension] for dimension in sorted(used)}
        known = np.flatnonzero(found.is_known)
        values = {name: own[known] for name, own in found.values.items()}
        self.add(found.entries, labels, values, group.places[known].tolist())
        return np.flatnonzero(~found.is_known).tolist()

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
