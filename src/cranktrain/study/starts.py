"""Starts of many designs of one machine: their facts beside one another, and each design's curves where asked for."""

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from importlib.util import find_spec
from multiprocessing import parent_process
from time import perf_counter
from typing import NamedTuple

import numpy as np

from cranktrain.analysis.blocks import MOST_AT_ONCE
from cranktrain.analysis.parts import differences
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.how_far import say_how_far
from cranktrain.language import Words, _
from cranktrain.layout.question import Stage
from cranktrain.machine import Machine, machine_problems
from cranktrain.motion import Array
from cranktrain.one_line import short
from cranktrain.questions.start.asked import StartAsked
from cranktrain.questions.start.record import ReadyStarts, StartEvents, StartRun
from cranktrain.record import record
from cranktrain.saying.catalogue import Entry, entries
from cranktrain.saying.run import Run
from cranktrain.study.start import Start, over_time_of_designs, start
from cranktrain.transient.equation import Kernels

_COMPILING = 20.0
"""How long it takes: from when on plain starts are longer in all. [s]"""
_compiled = set[Kernels]()
"""What this process has compiled."""
_MOST_SENTENCES = 6


@record
class Starts(Run):
    """Starts of designs of one machine.

    Every fact of `catalogue` is an attribute, an array along the designs and its own dimensions; NaN where a design
    has none. `starts[2]` is the start of one design with its curves, which are computed then.

    Attributes
    ----------
    machines : tuple of Machine
    found : FactsOfStarts
    """

    machines: tuple[Machine, ...]
    found: "FactsOfStarts"

    def __getattr__(self, name: str) -> Array:
        """Give a fact of all designs, in the unit of its entry."""
        if name.startswith("_") or name not in self.found.values:
            raise AttributeError(name)
        return self.found.values[name]

    def __getitem__(self, design: int) -> Start:
        """Give the start of one design, as `start` runs it alone."""
        return start(self.machines[design])

    def __len__(self) -> int:
        """How many designs there are."""
        return len(self.machines)

    def __iter__(self) -> Iterator[Start]:
        """Give the start of each design, computed one by one."""
        return (start(machine) for machine in self.machines)

    def __repr__(self) -> str:
        """Say in one line what it is."""
        about = _("<Starts of {n} designs of {name}, {refused} not computed>")
        return str(about.format(n=len(self), name=short(self.machines[0].name), refused=len(self.refused)))

    @property
    def subject(self) -> Words:
        """Whose they are."""
        return self.machines[0].name

    @property
    def catalogue(self) -> Mapping[str, Entry]:
        """Facts, and what is known of events, by name."""
        return self.found.entries

    @property
    def labels(self) -> Mapping[str, tuple[str, ...]]:
        """Designs by their numbers, events by their names."""
        return {"design": tuple(str(place + 1) for place in range(len(self))), **self.found.labels}

    @property
    def n_designs(self) -> int:
        """How many designs its arrays have along a leading dimension."""
        return len(self.machines)

    @property
    def reasons(self) -> tuple[Words, ...]:
        """Why the start of each design ended; empty of one that was not computed."""
        return self.found.reasons

    @property
    def refused(self) -> Mapping[int, Problem]:
        """What is wrong with designs that were not computed, by their places."""
        return self.found.refused

    def about(self) -> Iterator[tuple[str, Words]]:
        """What heads a file of it: the machine, and what of the designs cannot be."""
        yield "machine", self.machines[0].name
        for place, problem in list(self.refused.items())[:_MOST_SENTENCES]:
            yield "refused", _("design {n}: {why}", n=place + 1, why=str(problem))


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


def starts(machines: Sequence[Machine]) -> Starts:
    """Run designs of one machine with their motors over time, as [drive.start] of each says.

    Parameters
    ----------
    machines : sequence of Machine
        With [drive]; they differ in numbers alone.

    Returns
    -------
    Starts
        With the facts of each, to the last bit what `start` gives of it alone. What is wrong with a design stands at
        its place, and the others are computed.

    Raises
    ------
    InputError
        Where designs differ in more than numbers, or none of them can start.
    """
    refuse(dict.fromkeys(differences(machines)))
    wrong = {place: found[0] for place, one in enumerate(machines) if (found := machine_problems(one))}
    fit = [place for place in range(len(machines)) if place not in wrong]
    computed = facts_of_starts([machines[place] for place in fit])
    found = _spread(computed, fit, wrong)
    if len(found.refused) == len(machines):
        raise InputError([found.refused[0]])
    return Starts(tuple(machines), found)


def _spread(found: FactsOfStarts, places: Sequence[int], wrong: Mapping[int, Problem]) -> FactsOfStarts:
    """Facts of some designs at their places among all."""
    if not wrong:
        return found
    n_designs = len(places) + len(wrong)
    reasons: list[Words] = [""] * n_designs
    for place, reason in zip(places, found.reasons, strict=True):
        reasons[place] = reason
    values: dict[str, Array] = {}
    for name, own in found.values.items():
        values[name] = np.full((n_designs, *own.shape[1:]), np.nan)
        values[name][list(places)] = own
    refused = {**wrong, **{places[place]: problem for place, problem in found.refused.items()}}
    return FactsOfStarts(found.entries, found.labels, values, tuple(reasons), dict(sorted(refused.items())))


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
    said = _("{done} of {all} starts") if is_numba_there() else _("{done} of {all} starts, without Numba one by one")
    return said.format(done=done, all=n_starts)


def is_numba_there() -> bool:
    """Whether runs can be compiled."""
    return find_spec("numba") is not None


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
    if kernels is not None and kernels not in _compiled and is_numba_there():
        since = perf_counter()
        yield outcome(0, is_compiled=False)
        first = 1
        if (perf_counter() - since) * (n_left - 1) > _COMPILING and n_designs > 1:
            yield outcome(1, is_compiled=True)  # which compiles: threads must not do so at once
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


def _n_threads() -> int:
    """As many as there are processors; one where other processes are at the same work."""
    return 1 if parent_process() is not None else len(os.sched_getaffinity(0))


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
