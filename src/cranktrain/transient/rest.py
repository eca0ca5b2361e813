"""A crank at rest: which way it sets off, whether it is held, and until when."""

import math
from typing import Any

from cranktrain.transient.corners import on_the_way
from cranktrain.transient.course import IS_FRESH, SAMPLE, SENSE, TIME, note
from cranktrain.transient.endings import AT_REST, GOING, HELD, LINKS_OPEN, SET_OFF, STALLED, TIME_OUT
from cranktrain.transient.equation import HEAT, is_open
from cranktrain.transient.law import accelerated
from cranktrain.transient.step import N_STATE, ROW

REST_LOOKS = 400
"""At what is yet to come, where motor or brake depend on the time."""
_MOST_HALVINGS = 60
HEAT_PANELS = 64
_NODE = math.sqrt(0.6)
"""Of Gauss's rule with three points in −1…1."""


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


def let_go_at(time: float, angle: float, kernels: Any, train: Any, asked: Any) -> float:
    """When a crank that is held begins to move, looked for between any two breaks; infinite if never. [s]"""
    begin = time
    while begin < asked.limits.end_time:
        until = next_break(begin, asked.limits.end_time, asked.breaks)
        found = _let_go_between(begin, until, angle, kernels, train, asked)
        if found < math.inf:
            return found
        begin = until
    return math.inf


def next_break(time: float, until: float, breaks: Any) -> float:
    """The first break behind a time, or `until` if that is earlier. [s]"""
    for at in breaks:
        if at > time:
            return min(at, until)
    return until


def _let_go_between(begin: float, until: float, angle: float, kernels: Any, train: Any, asked: Any) -> float:
    """When it begins to move between two times, infinite if it does not. [s]"""
    before = begin
    for look in range(1, REST_LOOKS + 1):
        at = begin + (until - begin) * look / REST_LOOKS
        if sense_of_start(at, angle, kernels, train, asked.corners, asked.period) != 0.0:
            for _ in range(_MOST_HALVINGS):
                middle = 0.5 * (before + at)
                if sense_of_start(middle, angle, kernels, train, asked.corners, asked.period) != 0.0:
                    at = middle
                else:
                    before = middle
            return at
        before = at
    return math.inf


def kind_of_rest(time: float, kernels: Any, train: Any, until: float) -> int:
    """Whether a motor pulls at a crank that is held, now or later, or nothing does."""
    for look in range(REST_LOOKS + 1):
        at = time + (until - time) * look / REST_LOOKS
        if abs(kernels.motor(0.0, at, train.motor)) > 0:
            return STALLED
    return AT_REST


def set_off(derive: Any, kernels: Any, train: Any, asked: Any, course: Any, table: Any, marks: Any) -> int:
    """Let a crank at rest begin to move, at once or when it is let go; a reason where it never does."""
    here, state = course.here, course.state
    time, angle, corners, period = here[TIME], state[0], asked.corners, asked.period
    end_time = asked.limits.end_time
    here[SENSE] = sense_of_start(time, angle, kernels, train, corners, period)
    if here[SENSE] != 0.0:
        return GOING
    note(course, marks, 1 * HELD, time, angle, 0.0)
    derive(time, angle, 0.0, 0.0, 0.0, course.slopes, 0 * ROW, train)
    if is_open(course.slopes, 0 * ROW):
        return LINKS_OPEN
    let_go = math.inf
    if asked.limits.is_timed:
        let_go = let_go_at(time, angle, kernels, train, asked)
    if let_go == math.inf:
        return kind_of_rest(time, kernels, train, end_time)
    _wait(kernels, train, asked, course, table, let_go)
    here[SENSE] = sense_of_start(let_go, angle, kernels, train, corners, period)
    note(course, marks, 1 * SET_OFF, let_go, angle, 0.0)
    return TIME_OUT if let_go >= end_time else GOING


def _wait(kernels: Any, train: Any, asked: Any, course: Any, table: Any, until: float) -> None:
    """Stand still until a time: only the motor grows warmer."""
    time, state, samples = course.here[TIME], course.state, asked.samples
    widest, row = (until - time) / HEAT_PANELS, course.counts[SAMPLE]
    while True:
        while row < len(samples) and samples[row] <= time:
            for part in range(N_STATE):
                table[row, part] = state[part]
            row += 1
        if time >= until:
            break
        end = min(until, samples[row]) if row < len(samples) else until
        state[HEAT] += heated(time, end, widest, kernels, train, asked.breaks)
        time = end
    course.counts[SAMPLE] = row
    course.here[TIME] = until
    course.counts[IS_FRESH] = 1


def heated(begin: float, end: float, widest: float, kernels: Any, train: Any, breaks: Any) -> float:
    """Heat of a motor that stands, between two times: Gauss's three points on panels that end at breaks. [J]"""
    heat, time = 0.0, begin
    while time < end:
        until = next_break(time, min(end, time + widest), breaks)
        middle, half = 0.5 * (time + until), 0.5 * (until - time)
        ends = kernels.heat(0.0, middle - _NODE * half, train.motor) + kernels.heat(
            0.0, middle + _NODE * half, train.motor
        )
        heat += half * (5 * ends + 8 * kernels.heat(0.0, middle, train.motor)) / 9
        time = until
    return heat
