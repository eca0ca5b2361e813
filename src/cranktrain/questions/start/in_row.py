"""Starts of designs, one behind the other in a compiled loop, and their samples in rows.

Each is run, and looked at, as `starting` does it with one alone: of both every number is the same to the last bit.
"""

import math
from functools import cache
from typing import Any

from cranktrain.questions.start.case import Braking
from cranktrain.questions.start.rows_of_designs import (
    AFTER_SAMPLE,
    AFTER_STEP,
    ANGLE,
    BACKWARD,
    BRAKE_TORQUE,
    BRAKED,
    CYCLE_TIME,
    DRAG,
    END_SPEED,
    END_TIME,
    ENDS_AT,
    FIRST_SAMPLE,
    FIRST_SPEED,
    FIRST_STEP,
    FORWARD,
    GAS_PRESSURE,
    HAS_STAGE,
    HELD_ON,
    HOLDS,
    LEFT_OVER,
    MOST_MARKS,
    MOTOR,
    N_CORNERS,
    N_MARKS,
    N_ROWS,
    N_SAMPLES,
    N_STEPS,
    ON_CRANK,
    OVERSPEED,
    PART_BEGAN,
    PART_ENDS,
    PART_LASTED,
    PART_TARGET,
    PART_TO_REST,
    RATIO,
    REASON,
    RISE_TIME,
    SETTLES,
    STAGE_INERTIA,
    STEADY_SPEED,
    SUPPLIED,
    TARGET,
    TO_REST,
    TOLERANCE,
    TURNING,
    WHICH,
    StartRoom,
    StartRows,
    Together,
)
from cranktrain.questions.start.samples_in_row import (
    lay,
    lay_same,
    samples_within,
    states_from_steps,
    switch_of,
    tell,
    times_to_look_at,
)
from cranktrain.questions.start.spans import (
    MOST_REVERSALS,
    MOST_STEPS,
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
    put_at_start,
)
from cranktrain.transient.endings import RunLimits
from cranktrain.transient.equation import BrakePlace, Kernels, TrainNumbers, joined
from cranktrain.transient.law import OneStage
from cranktrain.transient.reduced import filled_at
from cranktrain.transient.runs import Wanted, energy_account
from cranktrain.transient.transient import run_to_the_end


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
        switch_of(given, design, began),
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
    # As products whole numbers are variables, of one type wherever they are from; so in `run_row`.
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
    corners, rows = given.corners[design][: int(own[N_CORNERS])], given.rows[design][: int(own[N_ROWS])]
    return Wanted(room.start, limits, samples, breaks, corners, given.cycle, rows)


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


def is_known_by_steps(room: Any, n_parts: int) -> bool:
    """Whether steps tell all states of a run: not where the crank was held."""
    is_told = True
    for which in range(n_parts):
        is_told = is_told and room.parts[which, HELD_ON] == 0
    return is_told


@cache
def row_of_starts(kernels: Kernels) -> Any:
    """Loop over designs from one on, compiled with the kernels in it: gives the first for which there is no room."""
    derive, own = joined(kernels, True)

    def run_row(given: Together, room: StartRoom, told: StartRows, first: int) -> int:
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
    by_steps, fill = quick(is_known_by_steps, within=True), quick(states_from_steps, within=True)
    write = quick(tell, within=True)
    return kept(run_row)
