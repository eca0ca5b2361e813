"""A crank at rest: which way it sets off, whether it is held, and until when."""

import math
from typing import Any

from cranktrain.questions.drive.running.corners import on_the_way
from cranktrain.questions.drive.running.course import IS_FRESH, SAMPLE, SENSE, TIME, note
from cranktrain.questions.drive.running.endings import AT_REST, GOING, HELD, LINKS_OPEN, SET_OFF, STALLED, TIME_OUT
from cranktrain.questions.drive.running.equation import HEAT, is_open
from cranktrain.questions.drive.running.law import accelerated
from cranktrain.questions.drive.running.step import N_STATE

_REST_LOOKS = 400
_MOST_HALVINGS = 60


def sense_of_start(
    time: float, angle: float, kernels: Any, train: Any, corners: Any = (), period: float = 2 * math.pi
) -> float:
    """Which way a crank at rest sets off: 1 forward, −1 back, 0 held. docs/theory/transient, eq. (26.7)."""
    torque = kernels.motor(0.0, time, train.motor)
    hold = kernels.brake(time, train.brake) * train.place.holds
    on_crank = hold * train.place.on_crank
    drag = hold - on_crank
    for sense in (1.0, -1.0):
        seen = on_the_way(angle, sense, corners, period)
        inertia, _, load, _ = kernels.machine(seen, 0.0, sense, train.machine)
        against = load + on_crank * sense
        grown, _ = accelerated(torque - drag * sense, sense, inertia, against, train.one, train.rows)
        if grown * sense > 0:
            return sense
    return 0.0


def let_go_at(
    time: float, until: float, angle: float, kernels: Any, train: Any, corners: Any = (), period: float = 2 * math.pi
) -> float:
    """When a crank that is held begins to move; infinite if not before `until`. [s]"""
    before = time
    for look in range(1, _REST_LOOKS + 1):
        at = time + (until - time) * look / _REST_LOOKS
        if sense_of_start(at, angle, kernels, train, corners, period) != 0.0:
            for _ in range(_MOST_HALVINGS):
                middle = 0.5 * (before + at)
                if sense_of_start(middle, angle, kernels, train, corners, period) != 0.0:
                    at = middle
                else:
                    before = middle
            return at
        before = at
    return math.inf


def kind_of_rest(time: float, kernels: Any, train: Any) -> int:
    """Whether a motor pulls at a crank that is held, or nothing does."""
    return STALLED if abs(kernels.motor(0.0, time, train.motor)) > 0 else AT_REST


def set_off(derive: Any, kernels: Any, train: Any, asked: Any, course: Any, table: Any, marks: Any) -> int:
    """Let a crank at rest begin to move, at once or when it is let go; a reason where it never does."""
    here, state = course.here, course.state
    time, angle, corners, period = here[TIME], state[0], asked.corners, asked.period
    here[SENSE] = sense_of_start(time, angle, kernels, train, corners, period)
    if here[SENSE] != 0.0:
        return GOING
    note(course, marks, HELD, time, angle, 0.0)
    derive(time, angle, 0.0, 0.0, 0.0, course.slopes, 0, train)
    if is_open(course.slopes, 0):
        return LINKS_OPEN
    let_go = math.inf
    if asked.limits.is_timed:
        let_go = let_go_at(time, asked.limits.end_time, angle, kernels, train, corners, period)
    if let_go == math.inf:
        return kind_of_rest(time, kernels, train)
    _wait(derive, train, asked, course, table, let_go)
    here[SENSE] = sense_of_start(let_go, angle, kernels, train, corners, period)
    note(course, marks, SET_OFF, let_go, angle, 0.0)
    return TIME_OUT if let_go >= asked.limits.end_time else GOING


def _wait(derive: Any, train: Any, asked: Any, course: Any, table: Any, until: float) -> None:
    """Stand still until a time: only the motor grows warmer."""
    time, state, samples = course.here[TIME], course.state, asked.samples
    before, row = course.slopes[HEAT], course.counts[SAMPLE]
    while row < len(samples) and samples[row] <= until:
        for part in range(N_STATE):
            table[row, part] = state[part]
        table[row, HEAT] += before * (samples[row] - time)
        row += 1
    course.counts[SAMPLE] = row
    derive(until, state[0], 0.0, 0.0, 0.0, course.slopes, 0, train)
    state[HEAT] += 0.5 * (before + course.slopes[HEAT]) * (until - time)
    course.here[TIME] = until
    course.counts[IS_FRESH] = 1
