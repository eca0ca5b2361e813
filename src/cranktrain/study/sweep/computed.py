"""Designs of a sweep in blocks: how long they will take is said before they begin, and how far they are meanwhile."""

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from math import prod
from time import perf_counter
from typing import NamedTuple

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.extras import is_there
from cranktrain.how_far import say_how_far
from cranktrain.language import Words, _
from cranktrain.machine import Machine
from cranktrain.paths import path_text, quantity_path
from cranktrain.study.cycle.road import CompiledWay
from cranktrain.study.facts_of_rows import FactsOfRows, joined_rows, rows_of
from cranktrain.study.sweep.blocks import Blocks, blocks_of
from cranktrain.study.sweep.crew import Alone, Compute, Crew, Span, in_order, killed
from cranktrain.study.sweep.facts import FactsOfSweep
from cranktrain.study.sweep.kept import InMemory, Plan, Store
from cranktrain.study.sweep.sweep import Sweep
from cranktrain.study.sweep.varied import (
    SweptDesigns,
    combined_designs,
    listed_designs,
    n_values,
    names_apart,
    path_meant,
)
from cranktrain.study.sweep.wanted import facts_wanted

_TRIED, _GROWTH = 4, 8
"""Designs by which it is found how long one takes; so many times more next, until that can be measured."""
_TRIED_OF = 16
"""Part of those that cost less together."""
_MEASURED = 0.025
"""What can be measured. [s]"""
_BLOCK_SECONDS, _SLOW_BLOCK_SECONDS = 0.2, 2.0
"""What a block takes at least; and at most, unless it has no more designs than cost less together. [s]"""
_LARGEST_BLOCK = 100_000
_MANY_BLOCKS, _LONG_BLOCK_SECONDS = 10_000, 10.0
"""A store with more blocks has too many files, unless each of them would take longer than this. [s]"""
_MOST = 10_000_000
"""Designs in memory at once."""
_LONG = 60.0
"""From when on somebody has to say that it is meant. [s]"""
_WORTH = 6.0
"""From when on more processes are worth their start. [s]"""
_WORTH_NUMBA = 1000
"""Designs from when on it is said that there is none."""
_CREW_OF_BLOCK = 4
"""So many processes hand blocks of the least size back without waiting for who keeps them."""


def swept(
    machine: Machine,
    vary: Mapping[str, object] | Sequence[Mapping[str, object]],
    wanted: Sequence[str] | None = None,
    *,
    over_time: bool = False,
    processes: int = 1,
    is_meant: bool = True,
    settings: Collection[str] = (),
    store: Store | None = None,
    scheduler: object = None,
) -> Sweep:
    """Compute facts of a machine over values of its file.

    Parameters
    ----------
    machine : Machine
    vary : mapping of str, or sequence of such
        As `combined_designs` takes it; or the designs one by one, as `listed_designs` does.
    wanted : sequence of str, optional
        Names of facts; the headlines of the machine's questions, or of a start, unless given.
    over_time : bool
        Whether they are of starts, as [drive.start] says, and not of the cycle.
    processes : int
        How many may work at once.
    is_meant : bool
        Whether it may take however long it takes.
    settings : collection of str
        Paths of values that were set for all designs, of which none may be varied.
    store : Store, optional
        Where facts are kept; memory unless given.
    scheduler : str or distributed.Client, optional
        A cluster that computes in place of processes.

    Raises
    ------
    InputError
        With everything that is wrong with what is asked; a design that cannot be is none of it, unless all are such.
    """
    if store is None and isinstance(vary, Mapping):
        _refuse_many(prod(map(n_values, vary.values())))  # before millions of values are made
    designs, names = _asked(machine, vary, partial(facts_wanted, machine, wanted, over_time=over_time), settings)
    if store is None:
        _refuse_many(len(designs))
    plan = Plan(machine, names_apart(designs, names), names, over_time)
    return _kept(plan, store or InMemory(), processes, scheduler, is_meant=is_meant)


def _refuse_many(n_designs: int) -> None:
    """Refuse more designs than memory has room for."""
    if n_designs > _MOST:
        allowed = _("is {n} designs, and may be {most}", n=n_designs, most=_MOST)
        repair = _("ask for fewer values, or keep them in a store: -o NAME.zarr")
        raise InputError([Problem("vary", None, allowed, repair)])


def _kept(plan: Plan, store: Store, processes: int, scheduler: object, *, is_meant: bool) -> Sweep:
    """Compute what a store has not."""
    designs = plan.designs
    compute = FactsOfSweep(plan.machine, designs, plan.wanted, plan.over_time)
    blocks = store.opened(plan)
    missing = [] if blocks is None else [number for number in range(len(blocks)) if number not in store.done]
    if blocks is not None and not missing:
        return Sweep(plan.machine, designs, store.found())
    n_together = compute.n_together
    tried = _tried(compute, n_together, *((0, len(designs)) if blocks is None else blocks.span(missing[0])))
    n_left = len(designs) if blocks is None else sum(after - first for first, after in map(blocks.span, missing))
    seconds = (n_left - len(tried.found.refused)) * tried.each
    if not is_meant and scheduler is None and seconds / processes > _LONG:
        why = "" if isinstance(compute.way, CompiledWay) else compute.way
        raise InputError([_long(len(designs), seconds / processes, why)])
    if tried.after - tried.first == len(designs):
        _refuse_all(tried.found, len(designs))
    n_at_once = processes if seconds > _WORTH else 1
    if blocks is None:
        blocks = blocks_of(designs.shape, _designs_of_block(tried.each, n_at_once, n_together, len(designs)))
        missing = list(range(len(blocks)))
        store.begin(plan, blocks)
    try:
        _fill(designs, blocks, missing, tried, store, _crew(compute, n_at_once, scheduler))
    except KeyboardInterrupt:  # what was computed so far is kept
        pass
    finally:
        store.end()
    return Sweep(plan.machine, designs, store.found())


def _asked(
    machine: Machine,
    vary: Mapping[str, object] | Sequence[Mapping[str, object]],
    wanted: Callable[[], tuple[str, ...]],
    settings: Collection[str],
) -> tuple[SweptDesigns, tuple[str, ...]]:
    """Which designs, and which facts; all that is wrong with either is told."""
    try:
        designs = combined_designs(machine, vary) if isinstance(vary, Mapping) else listed_designs(machine, vary)
        refuse(_without_effect(machine, designs, settings))
    except InputError as error:
        problems = list(error.problems)
        try:
            wanted()
        except InputError as other:
            problems += other.problems
        raise InputError(problems) from None
    return designs, wanted()


def _without_effect(machine: Machine, designs: SweptDesigns, settings: Collection[str]) -> Iterator[Problem]:
    """Refuse what is set for all designs where each has a value of its own."""
    for given in settings:
        path = quantity_path(path_meant(machine, given))
        for one in designs.varied:
            own = quantity_path(one.path)
            if path[: len(own)] == own and None not in one.values:
                allowed = _("is set and varied: what is set would have no effect")
                yield Problem(path_text(path), None, allowed, _("keep one of the two"))


class _Tried(NamedTuple):
    """Facts of the first designs, from one place to another, and how long one of these took. [s]"""

    first: int
    after: int
    found: FactsOfRows
    each: float

    def between(self, first: int, after: int) -> FactsOfRows:
        """Those of a block that are among them."""
        return rows_of(self.found, first - self.first, min(after, self.after) - self.first)


def _tried(compute: Compute, n_together: int, first: int, after: int) -> _Tried:
    """Compute some designs, more and more at once, until it is known how long one takes; `after` is not among them.

    One among `n_together`, unless these may take longer than a slow block: of few each bears more of what is shared.
    """
    parts: list[FactsOfRows] = []
    place, n_next, each, seconds = first, max(_TRIED, n_together // _TRIED_OF), 0.0, 0.0
    while place < after and (
        seconds < _MEASURED or (n_next < n_together and 0.0 < seconds < _SLOW_BLOCK_SECONDS * n_next / n_together)
    ):
        if seconds >= _MEASURED:
            n_next = n_together
        end = min(place + n_next, after)
        since = perf_counter()
        parts.append(compute((place, end)))
        seconds = perf_counter() - since
        place, each = end, seconds / (end - place)
        if len(parts) == 1:  # it loads what the others have then
            seconds = 0.0
        elif seconds < _MEASURED:
            n_next *= _GROWTH
    return _Tried(first, place, joined_rows(parts), each)


def _designs_of_block(each: float, n_at_once: int, n_together: int, n_designs: int) -> int:
    """How many designs of such a duration make a block."""
    each = max(each, 1e-12)
    least = max(
        _BLOCK_SECONDS * max(1.0, n_at_once / _CREW_OF_BLOCK),
        min(n_designs * each / _MANY_BLOCKS, _LONG_BLOCK_SECONDS),
    )
    together = min(n_together, _SLOW_BLOCK_SECONDS / each)
    return max(1, min(_LARGEST_BLOCK, round(max(least / each, together))))


def _crew(compute: Compute, n_at_once: int, scheduler: object) -> Crew:
    """Whoever computes."""
    if scheduler is not None:
        from cranktrain.study.sweep.cluster import Cluster  # which needs distributed

        return Cluster(compute, scheduler)
    if n_at_once == 1:
        return Alone(compute)
    from cranktrain.study.sweep.processes import Processes  # most sweeps take no time

    return Processes(compute, n_at_once)


def _fill(
    designs: SweptDesigns, blocks: Blocks, missing: Sequence[int], tried: _Tried, store: Store, crew: Crew
) -> None:
    """Compute blocks that are missing, of which `tried` has the first designs; none is begun before the one before."""
    spans = {number: blocks.span(number) for number in missing}
    known = [number for number, (_first, after) in spans.items() if tried.first < after <= tried.after]
    for number in known:
        store.add(number, tried.between(*spans[number]))
    left = [number for number in missing if number not in set(known)]

    def begins(number: int) -> int:
        first, after = spans[number]
        return tried.after if tried.first <= first < tried.after < after else first

    n_left = sum(spans[number][1] - begins(number) for number in left)
    n_done, since, is_any = 0, perf_counter(), None in tried.found.refused

    def say() -> None:
        say_how_far(partial(_how_far, n_done, n_left, perf_counter() - since))

    def each() -> Iterator[tuple[int, Span]]:
        for number in left:
            yield number, (begins(number), spans[number][1])

    with crew:
        for number, own in in_order(each(), crew, say):
            (first, after), begin = spans[number], begins(number)
            part = killed(after - begin) if own is None else own
            n_done += after - begin
            is_any = is_any or None in part.refused
            parts = [part] if begin == first else [tried.between(first, after), part]
            store.add(number, joined_rows(parts), is_lost=own is None)
    if not is_any and len(missing) == len(blocks):
        _refuse_all(tried.found, len(designs))


def _refuse_all(found: FactsOfRows, n_designs: int) -> None:
    """What is wrong with all designs is wrong with what was asked."""
    if found.refused and None not in found.refused:
        refuse(_none_of(n_designs, problem) for problem in found.refused[:1] if problem is not None)


def _none_of(n_designs: int, first: Problem) -> Problem:
    """Say that none of the designs can be, with what is wrong with the first."""
    if n_designs == 1:
        return replace(first, repair=None)
    said = _("none of the {n} designs can be; the first: {why}", n=n_designs, why=str(replace(first, repair=None)))
    return Problem("", None, said)


def _long(n_designs: int, seconds: float, why: Words) -> Problem:
    """Refuse what takes long and may not be meant; say why it is not compiled, if it is not."""
    hours, minutes = divmod(round(seconds / 60), 60)
    allowed = _("is {n} designs, which take some {hours} h {minutes} min", n=n_designs, hours=hours, minutes=minutes)
    if why:
        allowed = _("{allowed}, as it is not compiled: {why}", allowed=allowed, why=why)
    return Problem("vary", None, allowed, _("ask for fewer values, or write --yes"))


def _how_far(done: int, n_left: int, seconds: float) -> Words:
    """How many designs are done, and how long the others will take."""
    if done == 0:
        return _("{done} of {all} designs", done=done, all=n_left)
    left = seconds / done * (n_left - done)
    if n_left >= _WORTH_NUMBA and not is_there("numba"):
        said = _("{done} of {all} designs, without Numba one by one, {left} left   (Ctrl-C ends it)")
    else:
        said = _("{done} of {all} designs, {left} left   (Ctrl-C ends it)")
    return said.format(done=done, all=n_left, left=_duration(left))


def _duration(seconds: float) -> Words:
    """A time as one would say it."""
    if seconds < 100:
        return _("{seconds:.0f} s", seconds=seconds)
    hours, minutes = divmod(round(seconds / 60), 60)
    return _("{hours} h {minutes} min", hours=hours, minutes=minutes) if hours else _("{n} min", n=minutes)
