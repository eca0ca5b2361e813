"""Facts of starts of many designs: made ready together, run one by one or compiled, and nothing else of them kept."""

import os
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from multiprocessing import parent_process
from time import perf_counter
from typing import Any, NamedTuple

import numpy as np

from cranktrain.analysis.blocks import MOST_AT_ONCE
from cranktrain.columns import some_rows
from cranktrain.errors import InputError, Problem
from cranktrain.extras import is_there
from cranktrain.how_far import say_how_far
from cranktrain.language import Words, _
from cranktrain.layout.question import Stage
from cranktrain.linkage.compile import uncollected
from cranktrain.linkage.kept import is_kept
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.questions.start.asked import StartAsked
from cranktrain.questions.start.facts import StartFacts
from cranktrain.questions.start.many import FACTS_OF_ENERGY, facts_of_ran
from cranktrain.questions.start.record import RanStart, ReadyStarts, StartEvents, StartRun, numbered_events
from cranktrain.questions.start.starting import happened, reason_of
from cranktrain.saying.catalogue import entries
from cranktrain.study.facts_of_rows import FactsOfRows, Gathered
from cranktrain.study.start import is_over_time, over_time_of_columns, over_time_of_designs
from cranktrain.transient.equation import Kernels, joined
from cranktrain.transient.runs import loop_of

FACTS_SHOWN = ("start_duration", "largest_motor_torque", "effective_motor_torque", "final_motor_heat")
"""Of starts, unless others are asked for."""
_COMPILING, _LOADING = 20.0, 0.5
"""How long it takes to compile starts, and to load what was compiled before: from when on plain ones are longer. [s]"""
_HANDED_OUT = 8
"""Designs that a thread takes at once: one by one they would wait for each other."""
_compiled = set[Kernels]()
"""What this process has compiled."""


def facts_of_starts(
    machines: Sequence[Machine],
    wanted: Sequence[str] | None = None,
    *,
    n_all: int | None = None,
    columns: Machine | None = None,
) -> FactsOfRows:
    """Compute facts of starts; of each run nothing else is kept.

    Parameters
    ----------
    machines : sequence of Machine
        Designs of one machine with which nothing is wrong, and which differ in numbers alone.
    wanted : sequence of str, optional
        Names of facts, or of what is known of events; all unless given. What is not a fact of these starts is left out.
    n_all : int, optional
        How many designs there are, of which these are some: where that is worth its time, runs are compiled.
    columns : Machine, optional
        The designs together, where somebody has put them so.
    """
    gathered = Gathered(len(machines))
    n_left = len(machines) if n_all is None else n_all
    for first in range(0, len(machines), MOST_AT_ONCE):
        say_how_far(partial(_how_far, first, len(machines)))
        block = slice(first, min(first + MOST_AT_ONCE, len(machines)))
        own = None if columns is None else some_rows(columns, block)
        places = range(block.start, block.stop)
        _add_block(gathered, _Block(places, machines, own), wanted, max(n_left - first, len(places)))
    return gathered.found()


class _Block(NamedTuple):
    """Designs that are made ready together: which of all, each by itself, and in columns where these are known."""

    places: range
    machines: Sequence[Machine]
    columns: Machine | None

    def alone(self) -> Iterator["_Block"]:
        """Give each of them."""
        return (_Block(range(place, place + 1), self.machines, None) for place in self.places)

    def known(self) -> Mapping[type, object]:
        """Find what leads to their starts."""
        if self.columns is None:
            return over_time_of_designs([self.machines[place] for place in self.places], (ReadyStarts,))
        return over_time_of_columns(self.columns, len(self.places), (ReadyStarts,))


def _how_far(done: int, n_starts: int) -> Words:
    """How many starts are done, and what would make them quicker."""
    said = _("{done} of {all} starts") if is_there("numba") else _("{done} of {all} starts, without Numba one by one")
    return said.format(done=done, all=n_starts)


def _add_block(gathered: Gathered, block: _Block, wanted: Sequence[str] | None, n_left: int) -> None:
    """Compute starts of designs that are made ready together; one by one where that refuses some of them."""
    try:
        known: Mapping[type, Any] = block.known()
    except InputError as error:
        if len(block.places) == 1:
            gathered.refused[block.places[0]] = error.problems[0]
            return
        for own in block.alone():
            _add_block(gathered, own, wanted, n_left)
        return
    ready: ReadyStarts = known[ReadyStarts]
    stages = _stages_of_facts(block.machines[block.places[0]], known, wanted)
    in_short = ready.ran is not None and {stage.gives for stage in stages} <= {StartFacts, StartEvents}
    outcome = partial(_in_short, ready) if in_short else partial(_outcome, ready, stages)
    found = dict(zip(block.places, _run_each(outcome, ready.kernels, len(block.places), n_left), strict=True))
    for place, own in found.items():
        gathered.refused[place], gathered.ended[place] = own.refused, own.reason
    computed = {place: own for place, own in found.items() if own.refused is None}
    if computed:
        _add_facts(gathered, computed, stages, wanted)


def _add_facts(
    gathered: Gathered, found: Mapping[int, "_Outcome"], stages: Sequence[Stage], wanted: Sequence[str] | None
) -> None:
    """Lay facts of designs beside one another."""
    places, starts = list(found), [own.ran for own in found.values() if own.ran is not None]
    for at, stage in enumerate(stages):
        told = {entry.name: entry for entry in entries(stage.gives) if wanted is None or entry.name in wanted}
        if stage.gives is StartEvents:
            each = [numbered_events(*happened(one)) for one in starts] or [own.facts[at] for own in found.values()]
            labels, values = _beside(each, told)
        else:
            labels = dict[str, tuple[str, ...]]()
            homes = _facts_in_short(starts, told) if starts else [own.facts[at] for own in found.values()]
            values = {name: np.concatenate([getattr(home, name) for home in homes]) for name in told}
        gathered.add(told, labels, values, places)


def _facts_in_short(starts: Sequence[RanStart], told: Collection[str]) -> list[StartFacts]:
    """Facts of starts that have run, those of energy if they are wanted."""
    return [facts_of_ran(starts, with_energy=not FACTS_OF_ENERGY.isdisjoint(told))]


def _beside(each: Sequence[StartEvents], told: Collection[str]) -> tuple[dict[str, tuple[str, ...]], dict[str, Array]]:
    """Events of designs by name, NaN where a design has not had one."""
    labels = [one.labels["event"] for one in each]
    names = tuple(dict.fromkeys(name for own in labels for name in own))
    where = {name: column for column, name in enumerate(names)}
    values = {name: np.full((len(each), len(names)), np.nan) for name in told}
    for row, (own, events) in enumerate(zip(labels, each, strict=True)):
        for name, of_all in values.items():
            of_all[row, [where[label] for label in own]] = getattr(events, name)
    return {"event": names}, values


def _stages_of_facts(machine: Machine, known: Mapping[type, object], wanted: Sequence[str] | None) -> tuple[Stage, ...]:
    """Stages that make facts of a run alone, those that are wanted."""
    each = (stage for question in machine.questions for stage in question.over_time())
    return tuple(
        stage
        for stage in each
        if list(stage.needs.values()) == [StartRun]
        and stage.results
        and stage.applies_to(known) is True
        and not any(map(is_over_time, entries(stage.gives)))
        and (wanted is None or not set(stage.results).isdisjoint(wanted))
    )


class _Outcome(NamedTuple):
    """What became of one start: its facts, or the run that they are taken from; why it ended; why there is none."""

    facts: tuple[Any, ...] = ()
    ran: RanStart | None = None
    reason: Words = ""
    refused: Problem | None = None


def _outcome(ready: ReadyStarts, stages: Sequence[Stage], design: int, *, is_compiled: bool) -> _Outcome:
    """Run a design, and keep its facts."""
    try:
        # NaN stands for links that cannot close, and is no news.
        with np.errstate(all="ignore"):
            run = ready.run(design, StartAsked(), is_compiled=is_compiled)
            return _Outcome(tuple(stage.function(run) for stage in stages), reason=run.reason)
    except InputError as error:
        return _Outcome(refused=error.problems[0])


def _in_short(ready: ReadyStarts, design: int, *, is_compiled: bool) -> _Outcome:
    """Run a design, without curves."""
    assert ready.ran is not None  # by whom it is asked
    try:
        with np.errstate(all="ignore"):
            ran = ready.ran(design, is_compiled)
            return _Outcome(ran=ran, reason=reason_of(ran))
    except InputError as error:
        return _Outcome(refused=error.problems[0])


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
            with uncollected():  # it compiles or loads: threads must not do so at once
                second = outcome(1, is_compiled=True)
            yield second
            first = 2
            _compiled.add(kernels)
    if kernels not in _compiled:
        yield from (outcome(design, is_compiled=False) for design in range(first, n_designs))
        return

    def some(begin: int) -> list[_Outcome]:
        return [outcome(design, is_compiled=True) for design in range(begin, min(begin + _HANDED_OUT, n_designs))]

    with ThreadPoolExecutor(_n_threads()) as pool:
        try:
            for found in pool.map(some, range(first, n_designs, _HANDED_OUT)):
                yield from found
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
