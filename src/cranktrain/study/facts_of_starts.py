"""Facts of starts of many designs: made ready together, run one by one or compiled, and nothing else of them kept."""

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from multiprocessing import parent_process
from time import perf_counter
from typing import NamedTuple

import numpy as np

from cranktrain.analysis.blocks import MOST_AT_ONCE
from cranktrain.errors import InputError, Problem
from cranktrain.extras import is_there
from cranktrain.how_far import say_how_far
from cranktrain.language import Words, _
from cranktrain.layout.question import Stage
from cranktrain.linkage.kept import is_kept
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.questions.start.asked import StartAsked
from cranktrain.questions.start.record import ReadyStarts, StartEvents, StartRun
from cranktrain.record import record
from cranktrain.saying.catalogue import Entry, entries
from cranktrain.study.start import over_time_of_designs
from cranktrain.transient.equation import Kernels, joined
from cranktrain.transient.runs import loop_of

_COMPILING, _LOADING = 20.0, 0.5
"""How long it takes to compile starts, and to load what was compiled before: from when on plain ones are longer. [s]"""
_compiled = set[Kernels]()
"""What this process has compiled."""


@record
class FactsOfStarts:
    """Facts of some designs.

    Attributes
    ----------
    entries : mapping of str to Entry
        Of those that any design has, by name.
    labels : mapping of str to tuple of str
        Members along their dimensions.
    values : mapping of str to Array, shape (design, …)
        NaN where a design has none.
    reasons : tuple of Words
        Why each ended; empty of one that was not computed.
    refused : mapping of int to Problem
        What is wrong with a design that was not computed, the first of it, by its place.
    """

    entries: Mapping[str, Entry]
    labels: Mapping[str, tuple[str, ...]]
    values: Mapping[str, Array]
    reasons: tuple[Words, ...]
    refused: Mapping[int, Problem]


def facts_of_starts(
    machines: Sequence[Machine], wanted: Sequence[str] | None = None, *, n_all: int | None = None
) -> FactsOfStarts:
    """Compute facts of starts; of each run nothing else is kept.

    Parameters
    ----------
    machines : sequence of Machine
        Designs of one machine with which nothing is wrong, and which differ in numbers alone.
    wanted : sequence of str, optional
        Names of facts, or of what is known of events; all unless given. What is not a fact of these starts is left out.
    n_all : int, optional
        How many designs there are, of which these are some: where that is worth its time, runs are compiled.
    """
    gathered = _Gathered(len(machines))
    n_left = len(machines) if n_all is None else n_all
    for first in range(0, len(machines), MOST_AT_ONCE):
        say_how_far(partial(_how_far, first, len(machines)))
        block = machines[first : first + MOST_AT_ONCE]
        _add_block(gathered, block, first, wanted, max(n_left - first, len(block)))
    return gathered.found()


def _how_far(done: int, n_starts: int) -> Words:
    """How many starts are done, and what would make them quicker."""
    said = _("{done} of {all} starts") if is_there("numba") else _("{done} of {all} starts, without Numba one by one")
    return said.format(done=done, all=n_starts)


def _add_block(
    gathered: "_Gathered", machines: Sequence[Machine], first: int, wanted: Sequence[str] | None, n_left: int
) -> None:
    """Compute starts of designs that are made ready together; one by one where that refuses some of them."""
    try:
        known = over_time_of_designs(machines, (ReadyStarts,))
    except InputError as error:
        if len(machines) == 1:
            gathered.refused[first] = error.problems[0]
            return
        for place, machine in enumerate(machines, start=first):
            _add_block(gathered, [machine], place, wanted, n_left)
        return
    ready: ReadyStarts = known[ReadyStarts]
    outcome = partial(_outcome, ready, _stages_of_facts(machines[0], known, wanted))
    for place, found in enumerate(_run_each(outcome, ready.kernels, len(machines), n_left), start=first):
        gathered.take(place, found)


def _stages_of_facts(machine: Machine, known: Mapping[type, object], wanted: Sequence[str] | None) -> tuple[Stage, ...]:
    """Stages that make facts of a run alone, those that are wanted."""
    each = (stage for question in machine.questions for stage in question.over_time())
    return tuple(
        stage
        for stage in each
        if list(stage.needs.values()) == [StartRun]
        and stage.results
        and stage.applies_to(known) is True
        and not any("time" in entry.dimensions for entry in entries(stage.gives))
        and (wanted is None or not set(stage.results).isdisjoint(wanted))
    )


class _Outcome(NamedTuple):
    """Facts of one start, what holds them and why it ended; or why there is none."""

    facts: tuple[object, ...]
    reason: Words
    refused: Problem | None


def _outcome(ready: ReadyStarts, stages: Sequence[Stage], design: int, *, is_compiled: bool) -> _Outcome:
    """Run a design, and keep its facts."""
    try:
        # NaN stands for links that cannot close, and is no news.
        with np.errstate(all="ignore"):
            run = ready.run(design, StartAsked(), is_compiled=is_compiled)
            return _Outcome(tuple(stage.function(run) for stage in stages), run.reason, None)
    except InputError as error:
        return _Outcome((), "", error.problems[0])


def _run_each(
    outcome: Callable[..., _Outcome], kernels: Kernels | None, n_designs: int, n_left: int
) -> Iterator[_Outcome]:
    """Outcomes of all designs in their order: one by one in plain Python, or compiled by several threads."""
    first = 0
    if kernels is not None and kernels not in _compiled and is_there("numba"):
        since = perf_counter()
        yield outcome(0, is_compiled=False)
        first = 1
        if n_designs > 1 and _is_worth_compiling(kernels, (perf_counter() - since) * (n_left - 1)):
            yield outcome(1, is_compiled=True)  # which compiles or loads: threads must not do so at once
            first = 2
            _compiled.add(kernels)
    if kernels not in _compiled:
        yield from (outcome(design, is_compiled=False) for design in range(first, n_designs))
        return
    with ThreadPoolExecutor(_n_threads()) as pool:
        try:
            yield from pool.map(partial(outcome, is_compiled=True), range(first, n_designs))
        finally:
            pool.shutdown(cancel_futures=True)


def _is_worth_compiling(kernels: Kernels, seconds: float) -> bool:
    """Whether plain starts that take so long in all are better compiled; what is kept on disk is sooner there."""
    return seconds > _COMPILING or (seconds > _LOADING and is_kept(loop_of(joined(kernels, True), True)))


def _n_threads() -> int:
    """As many as there are processors; one where other processes are at the same work."""
    if parent_process() is not None:
        return 1
    # Not every system lets a process have some of them alone.
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class _Gathered:
    """Facts of starts, laid beside one another."""

    def __init__(self, n_designs: int) -> None:
        self.entries: dict[str, Entry] = {}
        self.facts: dict[str, Array] = {}
        self.events: dict[str, dict[int, tuple[tuple[str, ...], Array]]] = {}
        """Of each quantity of events, by the places of designs: names and values."""
        self.reasons: list[Words] = [""] * n_designs
        self.refused: dict[int, Problem] = {}

    def take(self, place: int, outcome: _Outcome) -> None:
        """Take what became of a design."""
        self.reasons[place] = outcome.reason
        if outcome.refused is not None:
            self.refused[place] = outcome.refused
        for home in outcome.facts:
            for entry in entries(type(home)):
                self.entries.setdefault(entry.name, entry)
                values: Array = getattr(home, entry.name)
                if isinstance(home, StartEvents):
                    self.events.setdefault(entry.name, {})[place] = home.labels["event"], values
                else:
                    of_all = self.facts.setdefault(entry.name, np.full(len(self.reasons), np.nan))
                    of_all[place] = values[0]

    def found(self) -> FactsOfStarts:
        """Give all that is known; where a design has fewer events, NaN in their places."""
        each = [labels for own in self.events.values() for labels, _values in own.values()]
        names = tuple(dict.fromkeys(name for labels in each for name in labels))
        where, values = {name: column for column, name in enumerate(names)}, dict(self.facts)
        for quantity, own in self.events.items():
            values[quantity] = np.full((len(self.reasons), len(names)), np.nan)
            for place, (labels, known) in own.items():
                values[quantity][place, [where[label] for label in labels]] = known
        labels = {"event": names} if self.events else {}
        return FactsOfStarts(self.entries, labels, values, tuple(self.reasons), self.refused)
