"""A crank that settles: it comes ever nearer to where load and motor balance, and never quite stands."""

from typing import Any

from cranktrain.transient.course import BOUND, FASTEST, SAMPLE, SENSE, TIME, note
from cranktrain.transient.endings import GOING, HELD
from cranktrain.transient.rest import REST_LOOKS, kind_of_rest
from cranktrain.transient.step import ROW

_SLOW = 1e-3
"""Of the greatest speed so far: a crank that is quicker does not come to rest yet."""
_STILL = 1e-6
"""By how much a crank that has settled still moves at the most, and how far beside it the pull is asked for. [rad]"""


def may_settle(speed: float, fastest: float) -> bool:
    """Whether a crank is so slow that it is worth asking whether it settles."""
    return abs(speed) <= _SLOW * fastest


def settles(
    derive: Any, time: float, state: Any, sense: float, bound: float, slopes: Any, train: Any, asked: Any
) -> bool:
    """Whether a crank moves next to nothing any more about where load and motor balance, now and later.

    By its energy about that angle, to which all pulls it: it never gets away. `slopes` is room for a stage.
    docs/theory/transient, eq. (26.8).
    """
    angle, speed, end_time = state[0], state[1], asked.limits.end_time
    _, pulled = derive(time, angle, 0.0, sense, bound, slopes, 0 * ROW, train)
    _, beside = derive(time, angle - sense * _STILL, 0.0, sense, bound, slopes, 0 * ROW, train)
    back = sense * (beside - pulled) / _STILL
    if not back > 0 or not pulled * pulled + speed * speed * back <= (_STILL * back) ** 2:
        return False
    for look in range(REST_LOOKS if asked.limits.is_timed else 0):
        # the end first, where a motor that is yet to pull harder does so
        at = end_time - (end_time - time) * look / REST_LOOKS
        _, later = derive(at, angle, 0.0, sense, bound, slopes, 0 * ROW, train)
        if not abs(later) <= _STILL * back:
            return False
    return True


def come_to_rest(derive: Any, kernels: Any, train: Any, asked: Any, course: Any, table: Any, marks: Any) -> int:
    """End a run whose crank has settled at rest; `GOING` where it has not."""
    here, state = course.here, course.state
    if not may_settle(state[1], here[FASTEST]) or here[TIME] >= asked.limits.end_time:
        return GOING
    if not settles(derive, here[TIME], state, here[SENSE], here[BOUND], course.again, train, asked):
        return GOING
    state[1], row = 0.0, course.counts[SAMPLE] - 1
    if row >= 0 and asked.samples[row] >= here[TIME]:
        table[row, 1] = 0.0
    note(course, marks, 1 * HELD, here[TIME], state[0], 0.0)
    return kind_of_rest(here[TIME], kernels, train, asked.limits.end_time)
