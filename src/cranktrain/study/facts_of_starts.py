"""Facts of starts of many designs: made ready together, run one by one or compiled, and nothing else of them kept."""

import os
from collections.abc import Callable, Collection, Generator, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from functools import partial
from itertools import chain
from multiprocessing import parent_process
from time import perf_counter
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from cranktrain.analysis.blocks import MOST_AT_ONCE
from cranktrain.analysis.kept_outcomes import KeptOutcomes
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
from cranktrain.questions.start.in_row import row_of_starts
from cranktrain.questions.start.many import facts_of_rows, happened_in
from cranktrain.questions.start.record import (
    RanFacts,
    RanRows,
    ReadyStarts,
    StartEvents,
    StartRun,
    StartsInShort,
    numbered_events,
    start_events,
)
from cranktrain.questions.start.starting import why_ended
from cranktrain.questions.start.together import AT_ONCE
from cranktrain.saying.catalogue import entries
from cranktrain.study.facts_of_rows import FactsOfRows, Gathered
from cranktrain.study.start import is_over_time, over_time_of_columns, over_time_of_designs
from cranktrain.transient.equation import Kernels

FACTS_SHOWN = ("start_duration", "largest_motor_torque", "effective_motor_torque", "final_motor_heat")
"""Of starts, unless others are asked for."""
_COMPILING, _LOADING = 20.0, 0.5
"""How long it takes to compile starts, and to load what was compiled before: from when on plain ones are longer. [s]"""
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
    gathered, kept = Gathered(len(machines)), KeptOutcomes()
    n_left = len(machines) if n_all is None else n_all
    under_way: Iterable[_Begun] = ()
    with _threads() as pool:
        for first in range(0, len(machines), MOST_AT_ONCE):
            say_how_far(partial(_how_far, first, len(machines)))
            block = slice(first, min(first + MOST_AT_ONCE, len(machines)))
            own = None if columns is None else some_rows(columns, block)
            places = range(block.start, block.stop)
            begun = _begun(_Block(places, machines, own, kept), wanted, max(n_left - first, len(places)), pool)
            _add(gathered, under_way, wanted)
            under_way = begun
        _add(gathered, under_way, wanted)
    return gathered.found()


class _Block(NamedTuple):
    """Designs that are made ready together: which of all, each by itself, and in columns where these are known.

    `kept`: what stages gave of designs of the same machine before.
    """

    places: range
    machines: Sequence[Machine]
    columns: Machine | None
    kept: KeptOutcomes

    def alone(self) -> Iterator["_Block"]:
        """Give each of them."""
        return (_Block(range(place, place + 1), self.machines, None, self.kept) for place in self.places)

    def known(self) -> Mapping[type, object]:
        """Find what leads to their starts."""
        if self.columns is None:
            own = [self.machines[place] for place in self.places]
            return over_time_of_designs(own, (ReadyStarts,), kept=self.kept)
        return over_time_of_columns(self.columns, len(self.places), (ReadyStarts,), self.kept)


def _how_far(done: int, n_starts: int) -> Words:
    """How many starts are done, and what would make them quicker."""
    said = _("{done} of {all} starts") if is_there("numba") else _("{done} of {all} starts, without Numba one by one")
    return said.format(done=done, all=n_starts)


class _Begun(NamedTuple):
    """Starts that are under way, or what is wrong with the only one: those that have ended, some at a time."""

    places: range
    stages: Sequence[Stage]
    made: "Iterable[_Ended]"
    refused: Problem | None = None


def _begun(block: _Block, wanted: Sequence[str] | None, n_left: int, pool: ThreadPoolExecutor) -> list[_Begun]:
    """Make designs ready together, one by one where that refuses some of them, and begin what threads run."""
    try:
        known: Mapping[type, Any] = block.known()
    except InputError as error:
        if len(block.places) == 1:
            return [_Begun(block.places, (), (), error.problems[0])]
        return [begun for own in block.alone() for begun in _begun(own, wanted, n_left, pool)]
    ready: ReadyStarts = known[ReadyStarts]
    stages = _stages_of_facts(block.machines[block.places[0]], known, wanted)
    in_short = ready.in_short if {stage.gives for stage in stages} <= {StartFacts, StartEvents} else None
    return [_Begun(block.places, stages, _each_made(ready, stages, len(block.places), n_left, in_short, pool))]


def _add(gathered: Gathered, begun: Iterable[_Begun], wanted: Sequence[str] | None) -> None:
    """Lay what becomes of starts to their places."""
    for one in begun:
        if one.refused is not None:
            gathered.refused[one.places[0]] = one.refused
        for designs, made in one.made:
            places = [one.places[design] for design in designs]
            for place, reason in zip(places, made.reasons, strict=True):
                gathered.refused[place], gathered.ended[place] = made.refused, reason
            if made.refused is None:
                _add_facts(gathered, places, made.given, one.stages, wanted)


def _add_facts(
    gathered: Gathered,
    places: Sequence[int],
    given: Mapping[type, Any],
    stages: Sequence[Stage],
    wanted: Sequence[str] | None,
) -> None:
    """Lay facts of designs to their places."""
    for stage in stages:
        told = {entry.name: entry for entry in entries(stage.gives) if wanted is None or entry.name in wanted}
        home, labels = given[stage.gives], dict[str, tuple[str, ...]]()
        if stage.gives is StartEvents:
            labels, values = _beside(home, told)
        else:
            values = {name: getattr(home, name) for name in told}
        gathered.add(told, labels, values, places)


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


class _Made(NamedTuple):
    """What became of starts: what stages give of them, of events those of each; why they ended; why there are none."""

    given: Mapping[type, Any]
    reasons: Sequence[Words]
    refused: Problem | None = None


_Ended: TypeAlias = tuple[Sequence[int], _Made]
"""Designs of a block, and what became of them."""


def _each_made(
    ready: ReadyStarts,
    stages: Sequence[Stage],
    n_designs: int,
    n_left: int,
    in_short: StartsInShort | None,
    pool: ThreadPoolExecutor,
) -> Iterable[_Ended]:
    """Starts of all designs, some at a time: compiled together, begun at once, or plain, each when it is asked for."""

    def alone(design: int) -> _Ended:
        try:
            # NaN stands for links that cannot close, and is no news.
            with np.errstate(all="ignore"):
                if in_short is not None:
                    return [design], _of_rows(in_short.alone(design))
                run = ready.run(design, StartAsked())
                given = {stage.gives: stage.function(run) for stage in stages}
                return [design], _Made(given | {StartEvents: [start_events(run)]}, [run.reason])
        except InputError as error:
            return [design], _Made({}, [""], error.problems[0])

    left, is_first = list(range(n_designs)), False
    first, compiled = list[_Ended](), iter(list[_Ended]())
    if in_short is not None and in_short.kernels not in _compiled and is_there("numba"):
        since = perf_counter()
        first.append(alone(left.pop(0)))
        is_first = _is_worth_compiling(in_short.kernels, (perf_counter() - since) * (n_left - 1))
    if in_short is not None and (is_first or in_short.kernels in _compiled):
        with np.errstate(all="ignore"):
            groups = in_short.groups(left)
            left = sorted(set(left).difference(*groups))
            compiled = _together(in_short, groups, alone, pool, is_first=is_first)
    return chain(first, compiled, map(alone, left))


def _of_rows(ran: RanRows) -> _Made:
    """What became of starts that were run in short."""
    each = list(happened_in(ran))
    facts = facts_of_rows(ran, np.array([one.n_reversals for one in each], dtype=np.float64))
    told = (RanFacts(*own) for own in zip(*(column.tolist() for column in ran.told), strict=True))
    reasons = [why_ended(case, own) for case, own in zip(ran.cases, told, strict=True)]
    return _Made({StartFacts: facts, StartEvents: [numbered_events(*one) for one in each]}, reasons)


def _together(
    in_short: StartsInShort,
    groups: Sequence[Sequence[int]],
    alone: Callable[[int], _Ended],
    pool: ThreadPoolExecutor,
    *,
    is_first: bool,
) -> Iterator[_Ended]:
    """Begin groups of designs, compiled, on several threads; the first of all alone, as it compiles or loads."""
    each = [group[at : at + AT_ONCE] for group in groups for at in range(0, len(group), AT_ONCE)]

    def some(designs: Sequence[int]) -> list[_Ended]:
        made, first = list[_Ended](), 0
        with np.errstate(all="ignore"):  # of each thread
            for ran in in_short.together(designs):
                n_designs = 1 if ran is None else len(ran.cases)
                own = designs[first : first + n_designs]
                made.append(alone(own[0]) if ran is None else (own, _of_rows(ran)))
                first += n_designs
        return made

    first = list[_Ended]()
    if is_first and each:
        with uncollected():
            first = some(each.pop(0))
        _compiled.add(in_short.kernels)
    return chain(first, chain.from_iterable(pool.map(some, each)))


def _is_worth_compiling(kernels: Kernels, seconds: float) -> bool:
    """Whether plain starts that take so long in all are better compiled; what is kept on disk is sooner there."""
    return seconds > _COMPILING or (seconds > _LOADING and is_kept(row_of_starts(kernels)))


@contextmanager
def _threads() -> Generator[ThreadPoolExecutor]:
    """Threads for what is compiled; what nobody has begun when something stops them is not begun."""
    with ThreadPoolExecutor(_n_threads()) as pool:
        try:
            yield pool
        finally:
            pool.shutdown(cancel_futures=True)


def _n_threads() -> int:
    """As many as there are processors; one where other processes are at the same work."""
    if parent_process() is not None:
        return 1
    # Not every system lets a process have some of them alone.
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
