"""Ratio of two things' processor times, taken in turn so that the machine's moods fall on both alike.

Processor time, not the wall's: threads that spin beside the work are paid for too, and others' processes are not.
"""

import gc
import statistics
from collections.abc import Callable
from time import process_time_ns, thread_time_ns
from typing import NamedTuple

Work = Callable[[], object]


class Ratio(NamedTuple):
    """Time of `ours` over time of `theirs`, over the repetitions; and the median time of each. [1, s]"""

    median: float
    least: float
    most: float
    ours: float
    theirs: float


def interleaved_ratio(ours: Work, theirs: Work, *, n_repetitions: int, least_time: float = 2e-3) -> Ratio:
    """Time `ours` and `theirs` in turn and compare neighbour with neighbour.

    Each is first run for a while (compilation, caches, the processor's clock). One repetition calls each as often as
    fills `least_time` [s], half of it on either side of the other (A B B A), so that a drift of the clock cancels.
    What other threads take meanwhile counts as ours: they spin on after the call, and the other ways start none.
    """
    calls = {work: _calls_that_fill(work, 0.5 * least_time) for work in (ours, theirs)}
    times: dict[Work, list[float]] = {ours: [], theirs: []}
    gc.collect()
    gc.disable()
    try:
        for _ in range(n_repetitions):
            start = process_time_ns()
            _repeat(ours, calls[ours])
            between = _time(theirs, 2 * calls[theirs])
            _repeat(ours, calls[ours])
            whole = 1e-9 * (process_time_ns() - start)
            times[ours].append(0.5 * whole / calls[ours] - between * calls[theirs] / calls[ours])
            times[theirs].append(between)
    finally:
        gc.enable()
    ratios = [our / their for our, their in zip(times[ours], times[theirs], strict=True)]
    return Ratio(
        statistics.median(ratios),
        min(ratios),
        max(ratios),
        statistics.median(times[ours]),
        statistics.median(times[theirs]),
    )


def _calls_that_fill(work: Work, time: float) -> int:
    """Number of calls that take at least `time`, found by doubling, which warms up as well."""
    n_calls = 1
    while n_calls * _time(work, n_calls) < time:
        n_calls *= 2
    return n_calls


def _time(work: Work, n_calls: int) -> float:
    """Mean time of a call on the thread that calls. [s]"""
    start = thread_time_ns()
    _repeat(work, n_calls)
    return 1e-9 * (thread_time_ns() - start) / n_calls


def _repeat(work: Work, n_calls: int) -> None:
    for _ in range(n_calls):
        work()
