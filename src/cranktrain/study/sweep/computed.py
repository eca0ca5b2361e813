"""Designs of a sweep in blocks: how long they will take is said before they begin, and how far they are meanwhile."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from functools import partial
from itertools import islice
from multiprocessing import get_context
from signal import SIG_IGN, SIGINT, signal
from time import perf_counter

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.how_far import say_how_far
from cranktrain.language import Words, _
from cranktrain.machine import Machine
from cranktrain.study.sweep.facts import FactsOfRows, facts_of_rows, joined_rows
from cranktrain.study.sweep.sweep import Sweep
from cranktrain.study.sweep.varied import SweptDesigns, combined_designs, listed_designs
from cranktrain.study.sweep.wanted import facts_wanted

_TRIED = 4
"""Designs by which it is found how long one takes."""
_BLOCK = 64
_MOST = 10_000_000
"""Designs at once."""
_LONG = 60.0
"""From when on somebody has to say that it is meant. [s]"""
_WORTH = 6.0
"""From when on more processes are worth their start. [s]"""


def swept(
    machine: Machine,
    vary: Mapping[str, object] | Sequence[Mapping[str, object]],
    wanted: Sequence[str] | None = None,
    *,
    over_time: bool = False,
    processes: int = 1,
    is_meant: bool = True,
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

    Raises
    ------
    InputError
        With everything that is wrong with what is asked; a design that cannot be is none of it, unless all are such.
    """
    designs, names = _asked(machine, vary, partial(facts_wanted, machine, wanted, over_time=over_time))
    compute = partial(facts_of_rows, machine, wanted=names, over_time=over_time)
    n_designs, rows = len(designs), designs.rows
    if n_designs > _MOST:
        allowed = _("is {n} designs, and may be {most}", n=n_designs, most=_MOST)
        raise InputError([Problem("vary", None, allowed, _("ask for fewer values"))])
    parts = [compute(list(islice(rows, min(_TRIED, n_designs))))]
    # The first one loads what the others have then.
    since = perf_counter()
    tried = list(islice(rows, min(_TRIED, n_designs - len(parts[0].refused))))
    parts += [compute(tried)] if tried else []
    each = (perf_counter() - since) / max(len(tried), 1)
    n_left = n_designs - sum(len(part.refused) for part in parts)
    if not is_meant and n_left * each / processes > _LONG:
        raise InputError([_long(n_designs, n_left * each / processes)])
    try:
        for part in _in_blocks(compute, rows, n_left, processes if n_left * each > _WORTH else 1):
            parts.append(part)
    except KeyboardInterrupt:  # what was computed so far is kept
        parts.append(_stopped(n_designs - sum(len(part.refused) for part in parts)))
    found = joined_rows(parts)
    if found.refused and None not in found.refused:
        # What is wrong with all of them is wrong with what was asked.
        refuse(_none_of(len(found.refused), problem) for problem in found.refused[:1] if problem is not None)
    return Sweep(machine, designs, found)


def _asked(
    machine: Machine,
    vary: Mapping[str, object] | Sequence[Mapping[str, object]],
    wanted: Callable[[], tuple[str, ...]],
) -> tuple[SweptDesigns, tuple[str, ...]]:
    """Which designs, and which facts; all that is wrong with either is told."""
    try:
        designs = combined_designs(machine, vary) if isinstance(vary, Mapping) else listed_designs(machine, vary)
    except InputError as error:
        problems = list(error.problems)
        try:
            wanted()
        except InputError as other:
            problems += other.problems
        raise InputError(problems) from None
    return designs, wanted()


def _none_of(n_designs: int, first: Problem) -> Problem:
    """Say that none of the designs can be, with what is wrong with the first."""
    if n_designs == 1:
        return replace(first, repair=None)
    said = _("none of the {n} designs can be; the first: {why}", n=n_designs, why=str(replace(first, repair=None)))
    return Problem("", None, said)


def _stopped(n_designs: int) -> FactsOfRows:
    """Designs that were not computed."""
    problem = Problem("", None, _("not computed, as the sweep was stopped"))
    nothing: tuple[Words, ...] = ("",) * n_designs
    return FactsOfRows({}, {}, {}, (problem,) * n_designs, nothing, nothing)


def _long(n_designs: int, seconds: float) -> Problem:
    """Refuse what takes long and may not be meant."""
    hours, minutes = divmod(round(seconds / 60), 60)
    allowed = _("is {n} designs, which take some {hours} h {minutes} min", n=n_designs, hours=hours, minutes=minutes)
    return Problem("vary", None, allowed, _("ask for fewer values, or write --yes"))


def _in_blocks(
    compute: Callable[[Sequence[Mapping[str, object]]], FactsOfRows],
    rows: Iterator[Mapping[str, object]],
    n_left: int,
    processes: int,
) -> Iterator[FactsOfRows]:
    """Facts block by block, in their order."""
    since, done = perf_counter(), 0
    blocks = iter(lambda: list(islice(rows, _BLOCK)), [])
    if processes == 1:
        for block in blocks:
            say_how_far(partial(_how_far, done, n_left, perf_counter() - since))
            yield compute(block)
            done += len(block)
        return
    # Ctrl-C is for who waits: it reaches all processes of a terminal.
    ignoring = partial(signal, SIGINT, SIG_IGN)
    with ProcessPoolExecutor(processes, mp_context=get_context("spawn"), initializer=ignoring) as pool:
        try:
            for part in pool.map(compute, blocks):
                yield part
                done += len(part.refused)
                say_how_far(partial(_how_far, done, n_left, perf_counter() - since))
        finally:
            pool.shutdown(cancel_futures=True)


def _how_far(done: int, n_left: int, seconds: float) -> Words:
    """How many designs are done, and how long the others will take."""
    if done == 0:
        return _("{done} of {all} designs", done=done, all=n_left)
    left = seconds / done * (n_left - done)
    said = _("{done} of {all} designs, {left:.0f} s left   (Ctrl-C ends it)")
    return said.format(done=done, all=n_left, left=left)
