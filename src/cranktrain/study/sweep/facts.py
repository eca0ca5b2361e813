"""Facts of many designs of one machine, each design checked by itself; what cannot be has a sentence and no number."""

from collections.abc import Iterator, Sequence
from functools import cached_property

import numpy as np

from cranktrain.analysis import Result, run
from cranktrain.analysis.blocks import MOST_AT_ONCE
from cranktrain.errors import InputError, Problem
from cranktrain.language import Words, _
from cranktrain.machine import Machine
from cranktrain.record import record
from cranktrain.saying.checks import Flag
from cranktrain.saying.run import Run
from cranktrain.study.cycle.road import CompiledWay
from cranktrain.study.facts_of_rows import FactsOfRows, Gathered
from cranktrain.study.facts_of_starts import facts_of_starts
from cranktrain.study.sweep.compiled import designs_at_once, facts_compiled, way_compiled
from cranktrain.study.sweep.designs import DesignsInColumns, designs_in_columns
from cranktrain.study.sweep.varied import SweptDesigns

_STARTS_AT_ONCE = 4 * MOST_AT_ONCE
"""Designs that are judged together before they start."""


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
        if self.over_time:
            return _STARTS_AT_ONCE
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
    together = Gathered(last - first)
    for place in block.refused:
        together.refused[place] = block.refused.unsaid(place)
    for group in block.groups:
        places = group.places.tolist()
        if over_time:
            together.add_rows(facts_of_starts(group.each, wanted, n_all=n_all, columns=group.machine), places)
            continue
        left = _take_compiled(together, group, wanted, n_all or 0)
        own = [places[one] for one in left], [group.each[one] for one in left]
        for found, of in _cycles(*own, wanted, together.refused):
            _take(together, found, of, wanted)
    return together.found()


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


def _take(together: Gathered, run: Run, places: Sequence[int], wanted: Sequence[str]) -> None:
    """Take what was asked for of a run over the cycle of some designs."""
    entries = {name: run.catalogue[name] for name in wanted if name in run.catalogue}
    used = {dimension for entry in entries.values() for dimension in entry.dimensions}
    labels = {dimension: tuple(run.labels[dimension]) for dimension in sorted(used)}
    values = {name: np.asarray(getattr(run, name)) for name in entries}
    if run.n_designs is None:
        values = {name: value[np.newaxis] for name, value in values.items()}
    together.add(entries, labels, values, places)
    for check in run.checks if isinstance(run, Result) else ():
        for place in np.flatnonzero(check.judged & ~check.passed).tolist():
            together.failing[places[place]] = check.sentence
    for flag in run.flag_words if isinstance(run, Result) else ():
        for place, words in flag.own.items() if isinstance(flag, Flag) else ():
            together.flags[places[place]] += (words,)


def _take_compiled(together: Gathered, group: DesignsInColumns, wanted: Sequence[str], n_all: int) -> Sequence[int]:
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
    together.add(found.entries, labels, values, group.places[known].tolist())
    return np.flatnonzero(~found.is_known).tolist()
