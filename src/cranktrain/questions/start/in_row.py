"""Starts of designs with one machine and one motor, one behind the other in a compiled loop, and their samples in rows.

Each is run, and looked at, as `starting` does it with one alone: of both every number is the same to the last bit.
"""

import math
from functools import cache
from typing import Any, NamedTuple

from cranktrain.motion import Array
from cranktrain.questions.start.case import Braking, Switching
from cranktrain.questions.start.curves import N_CLOSE, QUICKLY
from cranktrain.questions.start.spans import (
    MOST_REVERSALS,
    MOST_STEPS,
    N_EVEN,
    followed_until,
    is_there_already,
    some_cycles_on,
)
from cranktrain.transient import endings
from cranktrain.transient.compiling import kept, quick
from cranktrain.transient.course import (
    ENDS,
    INERTIA_AFTER,
    INERTIA_BEFORE,
    MARKS,
    SAMPLE,
    STEPS,
    TIME,
    Course,
    put_at_start,
)
from cranktrain.transient.endings import RunLimits
from cranktrain.transient.equation import MOTOR_WORK, SPEED, BrakePlace, Kernels, TrainNumbers, joined
from cranktrain.transient.law import OneStage
from cranktrain.transient.reduced import filled_at, inertia_at
from cranktrain.transient.runs import Wanted, energy_account
from cranktrain.transient.step import N_STATE
from cranktrain.transient.traced import SPEED_AFTER, TIME_AFTER, fill_one_by_one
from cranktrain.transient.transient import run_to_the_end

MOST_PARTS = 32
"""Parts of a run; those of more go alone."""


class DesignNumbers(NamedTuple):
    """Numbers of a design, in a row; see `StartCase`, `StartOrders` and `OneStage`.

    `angle` is the crank's own at the beginning. [rad] `has_stage`, `settles`: 1 for true.
    """

    angle: float
    speed: float
    off: float
    back: float
    braked: float
    overspeed: float
    gas_pressure: float
    interval: float
    tolerance: float
    brake_torque: float
    rise_time: float
    on_crank: float
    holds: float
    settles: float
    steady_speed: float
    cycle_time: float
    turning: float
    has_stage: float
    ratio: float
    forward: float
    backward: float
    drag: float
    stage_inertia: float
    motor: float


(
    ANGLE, FIRST_SPEED, OFF, BACK, BRAKED, OVERSPEED, GAS_PRESSURE, INTERVAL, TOLERANCE, BRAKE_TORQUE, RISE_TIME,
    ON_CRANK, HOLDS, SETTLES, STEADY_SPEED, CYCLE_TIME, TURNING, HAS_STAGE, RATIO, FORWARD, BACKWARD, DRAG,
    STAGE_INERTIA, MOTOR,
) = range(len(DesignNumbers._fields))  # fmt: skip
"""Where these stand in the row of a design."""
ENDS_AT, TARGET, WHICH, TO_REST = range(4)
"""Of a planned part of a run: until when at most; the speed to reach; which machine, −1 for no part."""
(
    PART_BEGAN,
    PART_ENDS,
    PART_TARGET,
    PART_TO_REST,
    PART_LASTED,
    FIRST_STEP,
    AFTER_STEP,
    FIRST_SAMPLE,
    AFTER_SAMPLE,
    HELD_ON,
    N_PART,
) = range(11)
"""Of a part that was run; whether the crank was held in it, when steps do not tell its states."""
REASON, N_STEPS, LEFT_OVER, SUPPLIED, END_TIME, END_SPEED, N_SAMPLES, N_MARKS = range(8)
"""Of a design that was run: those of `Told`, and how many samples and events it has."""
MOST_MARKS = 2000
"""Events of a part that are written down."""


class Together(NamedTuple):
    """What designs have in common, and the numbers of each.

    Attributes
    ----------
    machines : Array, shape (2, number)
        Of the machine, and as it is with its valves held open.
    motor : NamedTuple of floats
    corners, rows : Array
        As of `StartCase`. [rad]
    cycle : float
        [rad]
    designs : Array, shape (design, number)
        Of `DesignNumbers`.
    lines : Array, shape (design, pattern, column)
        Of several stages.
    spans : Array, shape (design, part, 4)
        Planned parts of a run.
    breaks : Array, shape (design, n)
        Rising. [s]
    """

    machines: Array
    motor: Any
    corners: Array
    rows: Array
    cycle: float
    designs: Array
    lines: Array
    spans: Array
    breaks: Array


class Room(NamedTuple):
    """Where a design is computed: a course, numbers of a machine, and what one run and its samples need."""

    course: Course
    machine: Array
    start: Array
    breaks: Array
    steps: Array
    parts: Array
    starts: Array
    ends: Array
    samples: Array
    close: Array
    within: Array
    table: Array


class Rows(NamedTuple):
    """What is told of designs: a row of each; samples and events one behind the other."""

    designs: Array
    time: Array
    state: Array
    torque: Array
    inertia: Array
    marks: Array


def run_parts(
    derive: Any,
    kernels: Any,
    given: Any,
    design: int,
    room: Any,
    told: Any,
    marks: Any,
    n_samples: int,
    first_mark: int,
) -> int:
    """Run a design part by part, each from where the last one ended; gives how many, or less than 1 for no room.

    Without samples, steps are kept; with them, states at the samples, in the table.
    """
    own, course, start = given.designs[design], room.course, room.start
    now, until, place, which, filled = 0.0, 0.0, 0, -1.0, own[GAS_PRESSURE]
    n_parts, n_steps, n_rows, n_marks = 0, 0, 0, first_mark
    told[LEFT_OVER], told[SUPPLIED] = 0.0, 0.0
    course.state[0], course.state[1] = own[ANGLE], own[FIRST_SPEED]
    while now < until or is_planned(given, design, place):
        if n_parts == len(room.parts) or n_marks + MOST_MARKS > len(marks):
            return 0
        end, target, to_rest, before = until, math.inf, False, which
        if not now < until:
            planned = given.spans[design, place]
            end, target, to_rest = planned[ENDS_AT], planned[TARGET], planned[TO_REST] > 0
            place += 1
            if to_rest and course.state[1] <= 0:
                continue
            which = planned[WHICH]
        if own[SETTLES] > 0 and is_there_already(course.state[1], target):
            target, end = math.inf, min(end, some_cycles_on(now, own[CYCLE_TIME]))
        if which != before:
            lay(given.machines[int(which)], room.machine)
            filled_at(course.state[0], room.machine, filled)
        filled = math.nan
        lay_same(0.0, start)
        start[0], start[1] = course.state[0], course.state[1]
        put_at_start(course, start)
        part, steps = room.parts[n_parts], room.steps[n_steps:] if n_samples == 0 else room.steps[:0]
        part[PART_BEGAN], part[PART_ENDS], part[PART_TARGET], part[PART_TO_REST] = now, end, target, 1.0 * to_rest
        train, asked = train_of(given, design, room, part), asked_of(given, design, room, part, n_samples)
        table, own_marks = room.table[n_rows:], marks[n_marks : n_marks + MOST_MARKS]
        reason = run_to_the_end(derive, kernels, train, asked, course, table, own_marks, steps, MOST_STEPS + 1)
        if n_samples == 0 and course.counts[ENDS] == len(steps):
            return 0
        note_part(room, n_parts, marks, n_marks, n_steps, n_rows)
        n_steps, n_rows, n_marks = int(part[AFTER_STEP]), int(part[AFTER_SAMPLE]), n_marks + course.counts[MARKS]
        n_parts += 1
        tell_end(own, course, start, told, reason, now + part[PART_LASTED])
        told[N_MARKS] = n_marks - first_mark
        now = end if reason == endings.TIME_OUT else told[END_TIME]
        until = now
        if not is_planned(given, design, place):
            until = told[END_TIME]
            if own[SETTLES] > 0:
                speeds = (start[1], course.state[1])
                until = followed_until(reason, until, target, speeds, own[STEADY_SPEED], own[CYCLE_TIME])
        is_over = reason == endings.TIME_OUT or (to_rest and reason == endings.SWINGS)
        if not now < until and not is_over:
            break
    return n_parts


def is_planned(given: Any, design: int, place: int) -> bool:
    """Whether there is a part of a run at a place."""
    return place < given.spans.shape[1] and given.spans[design, place, WHICH] >= 0


def train_of(given: Any, design: int, room: Any, part: Any) -> TrainNumbers:
    """Numbers of a part for its kernels."""
    own, began = given.designs[design], part[PART_BEGAN]
    return TrainNumbers(
        room.machine,
        Switching(given.motor, own[OFF], own[BACK], began),
        Braking(own[BRAKE_TORQUE], own[BRAKED] - began, own[RISE_TIME]),
        BrakePlace(own[ON_CRANK], own[HOLDS]),
        OneStage(
            own[HAS_STAGE] > 0, own[RATIO], own[FORWARD], own[BACKWARD], own[DRAG], own[STAGE_INERTIA], own[MOTOR]
        ),
        given.lines[design],
    )


def asked_of(given: Any, design: int, room: Any, part: Any, n_samples: int) -> Wanted:
    """What is wanted of a part."""
    own, began, ends, target = given.designs[design], part[PART_BEGAN], part[PART_ENDS], part[PART_TARGET]
    is_timed = began <= ends
    limits = RunLimits(
        ends - began,
        target,
        own[OVERSPEED],
        target < math.inf,
        1 if part[PART_TO_REST] > 0 else 1 * MOST_REVERSALS,
        1 * MOST_STEPS,
        own[TOLERANCE],
        is_timed,
    )
    samples = room.within[: samples_within(room, n_samples, began, ends)]
    breaks = room.breaks[: breaks_within(given.breaks[design], room.breaks, began, ends)]
    return Wanted(room.start, limits, samples, breaks, given.corners, given.cycle, given.rows)


def note_part(room: Any, which: int, marks: Any, first_mark: int, first_step: int, first_row: int) -> None:
    """Write down where a part that was run begins and ends, and its events in their order, times counted on."""
    part, counts = room.parts[which], room.course.counts
    after_mark = first_mark + counts[MARKS]
    part[PART_LASTED] = room.course.here[TIME]
    part[FIRST_STEP], part[AFTER_STEP] = first_step, first_step + counts[ENDS]
    part[FIRST_SAMPLE], part[AFTER_SAMPLE] = first_row, first_row + counts[SAMPLE]
    part[HELD_ON] = 1.0 if counts[ENDS] == 0 else 0.0
    in_order(marks, first_mark, after_mark)
    for mark in range(first_mark, after_mark):
        if marks[mark, 0] == endings.HELD:
            part[HELD_ON] = 1.0
        marks[mark, 1] += part[PART_BEGAN]
    lay(room.start, room.starts[which])
    lay(room.course.state, room.ends[which])


def tell_end(own: Any, course: Any, start: Any, told: Any, reason: int, ended: float) -> None:
    """Tell how a part ended, and add up its energy."""
    inertias = (course.here[INERTIA_BEFORE], course.here[INERTIA_AFTER])
    left_over, supplied = energy_account(own[TURNING], inertias, start, course.state)
    told[LEFT_OVER] += left_over
    told[SUPPLIED] += supplied
    told[REASON], told[N_STEPS] = reason, course.counts[STEPS]
    told[END_TIME], told[END_SPEED] = ended, course.state[1]


def lay(numbers: Any, room: Any) -> None:
    """Put numbers to where there is room for them."""
    for at in range(len(numbers)):
        room[at] = numbers[at]


def lay_same(number: float, room: Any) -> None:
    """The same of one number."""
    for at in range(len(room)):
        room[at] = number


def samples_within(room: Any, n_samples: int, begin: float, end: float) -> int:
    """Lay down the samples of a part of a run, from its beginning on; gives how many. [s]"""
    n_here = 0
    for at in range(n_samples):
        if begin <= room.samples[at] <= end:
            room.within[n_here] = room.samples[at] - begin
            n_here += 1
    return n_here


def breaks_within(breaks: Any, own: Any, begin: float, end: float) -> int:
    """The same of times at which motor or brake jump: those between its ends."""
    n_here = 0
    for at in breaks:
        if begin < at < end:
            own[n_here] = at - begin
            n_here += 1
    return n_here


def in_order(marks: Any, first: int, after: int) -> None:
    """Put events in the order of their times; those of one time stay as they are."""
    for row in range(first + 1, after):
        at = row
        while at > first and marks[at - 1, 1] > marks[at, 1]:
            for column in range(4):
                marks[at - 1, column], marks[at, column] = marks[at, column], marks[at - 1, column]
            at -= 1


def times_to_look_at(kernels: Any, given: Any, design: int, room: Any, n_parts: int, end: float) -> int:
    """Lay down the times at which a run is looked at, rising, each once; gives how many, 0 for no room. [s]"""
    own = given.designs[design]
    if end / own[INTERVAL] > len(room.samples):
        return 0
    n_asked = 0 if own[INTERVAL] == math.inf else math.floor(end / own[INTERVAL] + 1)
    n_close = close_times_of(kernels, given, own, room, n_parts)
    if n_close < 1 or N_EVEN + n_asked + n_close > len(room.samples):
        return 0
    step = end / (N_EVEN - 1)
    even, asked, close, n_found, last = 0, 0, 0, 0, -1.0
    while even < N_EVEN or asked < n_asked or close < n_close:
        at_even = (end if even == N_EVEN - 1 else even * step) if even < N_EVEN else math.inf
        at_asked = asked * own[INTERVAL] if asked < n_asked else math.inf
        at_close = room.close[close] if close < n_close else math.inf
        if at_even <= at_asked and at_even <= at_close:
            at = at_even
            even += 1
        elif at_asked <= at_close:
            at = at_asked
            asked += 1
        else:
            at = at_close
            close += 1
        if at != last:
            room.samples[n_found] = at
            n_found += 1
            last = at
    return n_found


def close_times_of(kernels: Any, given: Any, own: Any, room: Any, n_parts: int) -> int:
    """The same of times at which steps end, and closer ones where the motor's torque changes quickly."""
    motor = Switching(given.motor, own[OFF], own[BACK], 0.0)
    n_steps, largest, is_known = int(room.parts[n_parts - 1, AFTER_STEP]), 0.0, True
    if n_steps > len(room.table):
        return 0
    for which in range(n_parts):
        part = room.parts[which]
        for row in range(int(part[FIRST_STEP]), int(part[AFTER_STEP])):
            time = room.steps[row, TIME_AFTER] + part[PART_BEGAN]
            torque = kernels.motor(room.steps[row, SPEED_AFTER] * own[RATIO], time, motor)
            room.table[row, 0], room.table[row, 1] = time, torque
            largest = max(largest, abs(torque))
            is_known = is_known and torque == torque
    n_found, most = 0, QUICKLY * largest
    for row in range(n_steps):
        is_close = False
        for beside in range(max(row - 1, 0), min(row + 2, n_steps - 1)):
            is_close = is_close or abs(room.table[beside + 1, 1] - room.table[beside, 1]) > most
        n_here = N_CLOSE - 1 if is_close and is_known and row < n_steps - 1 else 1
        if n_found + n_here > len(room.close):
            return 0
        time = room.table[row, 0]
        width = room.table[row + 1, 0] - time if n_here > 1 else 0.0
        for at in range(n_here):
            room.close[n_found] = time + width * (at / (N_CLOSE - 1))
            n_found += 1
    return n_found


def states_from_steps(room: Any, n_parts: int, n_samples: int) -> None:
    """Lay down the states of all parts at the samples, by their steps."""
    n_rows = 0
    for which in range(n_parts):
        part, table = room.parts[which], room.table[n_rows:]
        n_here = samples_within(room, n_samples, part[PART_BEGAN], part[PART_ENDS])
        n_before = 0
        while n_before < n_here and room.within[n_before] <= 0.0:
            for component in range(N_STATE):
                table[n_before, component] = room.starts[which, component]
            n_before += 1
        steps = room.steps[int(part[FIRST_STEP]) : int(part[AFTER_STEP])]
        part[FIRST_SAMPLE] = n_rows
        n_rows += fill_one_by_one(steps, room.within[:n_here], n_before, table)
        part[AFTER_SAMPLE] = n_rows


def tell(kernels: Any, given: Any, design: int, room: Any, told: Any, n_parts: int, n_samples: int, first: int) -> int:
    """Tell a design's samples from a row on, times counted on and works added up; gives how many, less for no room."""
    own, row = given.designs[design], first
    motor = Switching(given.motor, own[OFF], own[BACK], 0.0)
    lay_same(0.0, room.start)
    for which in range(n_parts):
        part = room.parts[which]
        n_here = samples_within(room, n_samples, part[PART_BEGAN], part[PART_ENDS])
        first_here = int(part[FIRST_SAMPLE])
        for at in range(min(n_here, int(part[AFTER_SAMPLE]) - first_here)):
            since = room.within[at]
            if which < n_parts - 1 and not since < part[PART_LASTED]:
                continue
            if row == len(told.time):
                return -1
            for component in range(N_STATE):
                told.state[row, component] = room.table[first_here + at, component] + room.start[component]
            told.time[row] = since + part[PART_BEGAN]
            told.torque[row] = kernels.motor(told.state[row, SPEED] * own[RATIO], told.time[row], motor)
            told.inertia[row] = inertia_at(told.state[row, 0], given.machines[0])
            row += 1
        for component in range(MOTOR_WORK, N_STATE):
            room.start[component] += room.ends[which, component]
    return row - first


def is_told_by_steps(room: Any, n_parts: int) -> bool:
    """Whether steps tell all states of a run: not where the crank was held."""
    is_told = True
    for which in range(n_parts):
        is_told = is_told and room.parts[which, HELD_ON] == 0
    return is_told


@cache
def row_of_starts(kernels: Kernels) -> Any:
    """Loop over designs from one on, compiled with the kernels in it: gives the first for which there is no room."""
    derive, own = joined(kernels, True)

    def run_row(given: Together, room: Room, told: Rows, first: int) -> int:
        n_rows, n_marks, nothing = 0 * first, 0 * first, 0 * first
        for design in range(first, len(given.designs)):
            n_parts = through(
                derive, own, given, design, room, told.designs[design - first], told.marks, nothing, n_marks
            )
            if n_parts < 1:
                return design
            n_samples = looked_at(own, given, design, room, n_parts, told.designs[design - first, END_TIME])
            if n_samples < 1:
                return design
            if by_steps(room, n_parts):
                fill(room, n_parts, n_samples)
            else:
                through(derive, own, given, design, room, told.designs[design - first], told.marks, n_samples, n_marks)
            n_told = write(own, given, design, room, told, n_parts, n_samples, n_rows)
            if n_told < 1:
                return design
            told.designs[design - first, N_SAMPLES] = n_told
            n_rows += n_told
            n_marks += int(told.designs[design - first, N_MARKS])
        return len(given.designs)

    through, looked_at = quick(run_parts, within=True), quick(times_to_look_at, within=True)
    by_steps, fill, write = (quick(one, within=True) for one in (is_told_by_steps, states_from_steps, tell))
    return kept(run_row)
