"""A run from one state to its end: phases, steps, events; the same functions plain or compiled."""

import math
from typing import Any

from cranktrain.transient.corners import beside, corner_ahead, few_ahead, on_the_way
from cranktrain.transient.course import (
    BOUND,
    BREAK,
    ENDS,
    FASTEST,
    INERTIA_AFTER,
    INERTIA_BEFORE,
    IS_FRESH,
    OUTPUT,
    REVERSALS,
    SAMPLE,
    SENSE,
    STEPS,
    TIME,
    WIDTH,
    go_ahead,
    note,
)
from cranktrain.transient.crossings import (
    may_pass_dead_position,
    passed_dead_position,
    passed_level,
    state_at,
)
from cranktrain.transient.endings import (
    DEAD_POSITION,
    GEARING_JAMS,
    GOING,
    LINKS_OPEN,
    NO_STEP_SHORT_ENOUGH,
    OVERSPEED,
    REVERSAL,
    SPEED_PASSED,
    SPEED_REACHED,
    SWINGS,
    TIME_OUT,
    TOO_MANY_STEPS,
)
from cranktrain.transient.equation import ANGLE, SPEED, is_open
from cranktrain.transient.rest import kind_of_rest, set_off
from cranktrain.transient.settling import come_to_rest
from cranktrain.transient.step import BESIDE, N_STATE, ROW, error_of, integrate_along, take_step, within
from cranktrain.transient.traced import SPEED_AFTER, TIME_AFTER, trace_step
from cranktrain.transient.traced import WIDTH as STEP_WIDTH

NOWHERE, AT_TIME, AT_CORNER = range(3)
"""Where a step is to land: wherever; at a break or the end of the run; at a corner of the load."""
STOP, OVER, REACHED = range(3)
"""What speeds may end a step."""

LARGEST_TURN = 2 * math.pi / 25
"""In a step: with more, what happens twice between two of its stages would be overlooked."""
_LEAST_WIDTH = 1e-14
_SHORT_OF_BREAK = 1e-13
"""In parts of the run: a torque that begins at a break must not be seen by the last stages of the step before it."""
_AT = 3
"""How near to a corner is at it, in distances of its side."""
_A_LITTLE_MORE = 1.0000001
"""A step that would end so close before a break ends on it."""


def begin_run(kernels: Any, train: Any, asked: Any, course: Any, table: Any) -> None:
    """Let the machine remember how it stands, and write down the samples at which nothing has happened yet."""
    state, row = course.state, 0
    kernels.settle(state[0], train.machine)
    while row < len(asked.samples) and asked.samples[row] <= course.here[TIME]:
        for part in range(N_STATE):
            table[row, part] = state[part]
        row += 1
    course.counts[SAMPLE] = row


def run_to_the_end(
    derive: Any, kernels: Any, train: Any, asked: Any, course: Any, table: Any, marks: Any, steps: Any, most_steps: int
) -> int:
    """As `run_on`, from the very beginning where it is one; and what inertia the machine has at both ends."""
    here, state = course.here, course.state
    if course.counts[STEPS] == 0:
        begin_run(kernels, train, asked, course, table)
        here[INERTIA_BEFORE] = kernels.machine(state[0], state[1], here[SENSE], train.machine)[0]
    reason = run_on(derive, kernels, train, asked, course, table, marks, steps, most_steps)
    here[INERTIA_AFTER] = kernels.machine(state[0], state[1], here[SENSE], train.machine)[0]
    return reason


def run_on(
    derive: Any, kernels: Any, train: Any, asked: Any, course: Any, table: Any, marks: Any, steps: Any, most_steps: int
) -> int:
    """Run until something ends it, or for a number of steps.

    Parameters
    ----------
    derive, kernels
        Of `equation.joined`.
    train : Train
    asked : Wanted
    course : Course
        Changed to where the run stands at the end. It may go on from there, and gives the same as in one go.
    table : Array, shape (samples, 6)
        Filled as far as the run goes.
    marks : Array, shape (most, 4)
        Filled with kind, time, angle and speed of events.
    steps : Array, shape (n, `N_TRACED`)
        Filled with each step, the first n of them, anew in each call.
    most_steps : int

    Returns
    -------
    int
        A reason, or `GOING`.
    """
    goal = course.counts[STEPS] + most_steps
    course.counts[ENDS] = 0
    reason = GOING
    while reason == GOING and course.counts[STEPS] < goal:
        row = course.counts[ENDS]
        if row < len(steps):
            steps[row, STEP_WIDTH] = 0.0
        if course.counts[IS_FRESH] == 1:
            reason = _begin_phase(derive, kernels, train, asked, course, table, marks)
        if reason == GOING:
            reason = _go_a_step(derive, kernels, train, asked, course, table, marks, steps)
        if row < len(steps):
            steps[row, TIME_AFTER] = course.here[TIME]
            steps[row, SPEED_AFTER] = course.state[1]
            course.counts[ENDS] = row + 1
    return reason


def _begin_phase(derive: Any, kernels: Any, train: Any, asked: Any, course: Any, table: Any, marks: Any) -> int:
    """Begin what is smooth until the next event, break or corner."""
    here, counts, state = course.here, course.counts, course.state
    if here[SENSE] == 0.0:
        reason = set_off(derive, kernels, train, asked, course, table, marks)
        if reason != GOING:
            return reason
    sense = here[SENSE]
    state[0] = on_the_way(state[0], sense, asked.corners, asked.period)
    here[BOUND] = corner_ahead(state[0], sense, asked.corners, asked.period)
    while counts[BREAK] < len(asked.breaks) and asked.breaks[counts[BREAK]] <= here[TIME]:
        counts[BREAK] += 1
    _, grown = derive(here[TIME], state[0], state[1], sense, here[BOUND], course.slopes, 0 * ROW, train)
    if grown != grown:
        return LINKS_OPEN if is_open(course.slopes, 0 * ROW) else GEARING_JAMS
    output = course.slopes[BESIDE]
    if output * here[OUTPUT] < 0:  # a corner that is a dead position too lies between two phases
        note(course, marks, 1 * DEAD_POSITION, here[TIME], state[0], state[1])
    here[OUTPUT] = output
    if here[WIDTH] == 0.0:
        here[WIDTH] = _first_width(abs(state[1]), abs(grown), asked.limits.end_time)
    counts[IS_FRESH] = 0
    return GOING


def _first_width(speed: float, grown: float, end_time: float) -> float:
    """A step small enough to be judged; the next ones adapt."""
    width = 1e-3 * end_time
    if grown > 0:
        width = min(width, math.sqrt(2e-4 / grown))
    if speed > 0:
        width = min(width, 1e-3 / speed)
    return width


def _go_a_step(
    derive: Any, kernels: Any, train: Any, asked: Any, course: Any, table: Any, marks: Any, steps: Any
) -> int:
    """Try a step; if its error is small enough, go to its end or to the first event in it."""
    here, limits, slopes, ahead = course.here, asked.limits, course.slopes, course.ahead
    if here[TIME] >= limits.end_time:
        return TIME_OUT
    if course.counts[STEPS] >= limits.most_steps:
        return TOO_MANY_STEPS
    course.counts[STEPS] += 1
    width, landing = _width_and_landing(asked, course)
    sense, bound = here[SENSE], here[BOUND]
    take_step(derive, here[TIME], width, course.state, slopes, ahead, sense, bound, train)
    if landing == AT_CORNER:
        width = _width_to_corner(derive, course, width, train)
    error = _error(course, width, limits.tolerance)
    if not error <= 1.0:
        return try_shorter(course, width, max(0.1, 0.9 * error**-0.2) if error > 1.0 else 0.1, limits.end_time)
    if landing != AT_TIME:
        landing = AT_CORNER if abs(ahead[0] - bound) <= _AT * beside(ahead[0]) else NOWHERE
    theta, event, level = _first_event(limits, course, width)
    if sense * (state_at(course, width, theta, 1 * ANGLE) - bound) > _AT * beside(ahead[0]):
        return try_shorter(course, width, 0.5, limits.end_time)
    if event < 0 and ahead[1] * sense < 0:  # it sets off the other way: nearer to where it stands
        reason = try_shorter(course, width, 0.25, limits.end_time)
        return reason if reason == GOING else kind_of_rest(here[TIME], kernels, train, limits.end_time)
    integrate_along(width, course.state, slopes, ahead)
    _note_on_the_way(derive, kernels, train, limits, course, width, theta, marks)
    if event >= 0:
        width = step_to(derive, train, course, theta, width, 1 * SPEED, level)
        if course.trial[1] != course.trial[1]:  # the whole step has slopes, and this one has not
            return GEARING_JAMS
        _sample(asked.samples, course, course.again, width, table, steps)
        go_ahead(course, here[TIME] + width, course.trial)
        kernels.settle(course.state[0], train.machine)
        return _after_event(event, limits, course, marks)
    _sample(asked.samples, course, slopes, width, table, steps)
    output = slopes[6 * ROW + BESIDE]
    if output != 0.0:
        here[OUTPUT] = output
    _go_to_the_end(asked, course, width, landing, error)
    kernels.settle(course.state[0], train.machine)
    return come_to_rest(derive, kernels, train, asked, course, table, marks)


def _width_and_landing(asked: Any, course: Any) -> tuple[float, int]:
    """How wide a step is to be tried, and where it should end."""
    here, counts, end_time = course.here, course.counts, asked.limits.end_time
    speed, grown = abs(course.state[1]), here[SENSE] * course.slopes[1]
    most = min(LARGEST_TURN, few_ahead(course.state[0], here[SENSE], asked.rows, asked.period))
    width, landing = min(here[WIDTH], time_over(most, speed, abs(grown))), NOWHERE
    until, short = end_time, 0.0
    if counts[BREAK] < len(asked.breaks) and asked.breaks[counts[BREAK]] < end_time:
        until, short = asked.breaks[counts[BREAK]], _SHORT_OF_BREAK * end_time
    if here[TIME] + width * _A_LITTLE_MORE >= until:
        width, landing = until - here[TIME] - short, AT_TIME
    to_corner = time_over(here[SENSE] * (here[BOUND] - course.state[0]), speed, grown)
    if to_corner <= width:
        return to_corner, AT_CORNER
    return width, landing


def time_over(turn: float, speed: float, grown: float) -> float:
    """How long a turn takes at a constant acceleration; infinite where it is never made. [s]"""
    square = speed * speed + 2 * grown * turn
    return 2 * turn / (speed + math.sqrt(square) + 1e-300) if 0 <= square < math.inf else math.inf


def _width_to_corner(derive: Any, course: Any, width: float, train: Any) -> float:
    """Width of a step that ends at the corner, by Newton's method over steps of that length."""
    here, ahead, bound = course.here, course.ahead, course.here[BOUND]
    for _ in range(5):
        miss = bound - ahead[0]
        if not beside(bound) < abs(miss) < 0.5 * width * abs(ahead[1]):
            break
        width += miss / ahead[1]
        take_step(derive, here[TIME], width, course.state, course.slopes, ahead, here[SENSE], bound, train)
    return width


def _error(course: Any, width: float, tolerance: float) -> float:
    """Error of a step in parts of what is allowed, eq. (26.12); NaN where there are no slopes."""
    fastest = max(course.here[FASTEST], abs(course.ahead[1]))
    of_angle = error_of(course.slopes, width, 1 * ANGLE) / tolerance
    of_speed = error_of(course.slopes, width, 1 * SPEED) / (tolerance * fastest + 1e-300)
    # without slopes the speed's is NaN, with which no comparison holds
    return of_angle if of_speed <= of_angle else of_speed


def try_shorter(course: Any, width: float, factor: float, end_time: float) -> int:
    """Have a step tried again, shorter; where it gets too short, the reason why there are no slopes, if so."""
    course.here[WIDTH] = width * factor
    if course.here[WIDTH] >= _LEAST_WIDTH * max(course.here[TIME], 1e-3 * end_time):
        return GOING
    for stage in range(1, 7):
        if course.slopes[stage * ROW + 1] != course.slopes[stage * ROW + 1]:
            return LINKS_OPEN if is_open(course.slopes, stage * ROW) else GEARING_JAMS
    return NO_STEP_SHORT_ENOUGH


def _first_event(limits: Any, course: Any, width: float) -> tuple[float, int, float]:
    """Part θ of a step at which a speed ends it, which one, and that speed; 1 and −1 where none does."""
    sense = course.here[SENSE]
    theta, event, level = 1.0, -1, 0.0
    stop = passed_level(course, width, 0.0, -sense)
    if stop <= theta:
        theta, event = stop, STOP
    if limits.overspeed < math.inf:
        over = passed_level(course, width, sense * limits.overspeed, sense)
        if over < theta or (event < 0 and over <= theta):
            theta, event, level = over, OVER, sense * limits.overspeed
    if limits.stops_at_target and limits.target_speed < math.inf:
        reached = passed_level(course, width, sense * limits.target_speed, sense)
        if reached < theta or (event < 0 and reached <= theta):
            theta, event, level = reached, REACHED, sense * limits.target_speed
    return theta, event, level


def _note_on_the_way(
    derive: Any, kernels: Any, train: Any, limits: Any, course: Any, width: float, theta: float, marks: Any
) -> None:
    """Write down what happens within a step and does not end it."""
    here, trial = course.here, course.trial
    if not limits.stops_at_target and limits.target_speed < math.inf:
        level = here[SENSE] * limits.target_speed
        reached = passed_level(course, width, level, here[SENSE])
        if reached <= theta:
            part = _step_on_the_way(derive, train, course, reached, width, 1 * SPEED, level)
            note(course, marks, 1 * SPEED_PASSED, here[TIME] + part, trial[0], trial[1])
    start = 0.0
    while start < theta and may_pass_dead_position(course):
        start, dead = passed_dead_position(kernels.machine, train.machine, course, width, start)
        if start <= theta:
            part = _step_on_the_way(derive, train, course, start, width, 1 * ANGLE, dead)
            note(course, marks, 1 * DEAD_POSITION, here[TIME] + part, trial[0], trial[1])
            here[OUTPUT] = -here[OUTPUT]


def _step_on_the_way(
    derive: Any, train: Any, course: Any, theta: float, width: float, which: int, level: float
) -> float:
    """The same as `step_to`; by the interpolant where that step has no slopes although the whole one has."""
    part = step_to(derive, train, course, theta, width, which, level)
    if course.trial[1] != course.trial[1]:
        for component in range(N_STATE):
            course.trial[component] = state_at(course, width, theta, component)
        return theta * width
    return part


def step_to(derive: Any, train: Any, course: Any, theta: float, width: float, which: int, level: float) -> float:
    """Width of a step to where angle (0) or speed (1) has the level, by Newton's method over steps of that length.

    The interpolant is of a lower order than the step, so it only gives the start. Eq. (26.13)
    """
    here, state, again, trial = course.here, course.state, course.again, course.trial
    part = theta * width
    for component in range(N_STATE):
        again[component] = course.slopes[component]
    for attempt in range(4):
        take_step(derive, here[TIME], part, state, again, trial, here[SENSE], here[BOUND], train)
        miss, slope = level - trial[which], again[6 * ROW + which]
        if attempt == 3 or not 1e-15 * width * abs(slope) < abs(miss) <= 0.1 * width * abs(slope):
            break
        part += miss / slope
    integrate_along(part, state, again, trial)
    return part


def _sample(samples: Any, course: Any, slopes: Any, width: float, table: Any, steps: Any) -> None:
    """Write down a step, and the state at the samples that lie in it."""
    time, row = course.here[TIME], course.counts[SAMPLE]
    if course.counts[ENDS] < len(steps):
        trace_step(steps, course.counts[ENDS], time, width, course.state, slopes)
    while row < len(samples) and samples[row] <= time + width:
        theta = (samples[row] - time) / width
        for part in range(N_STATE):
            table[row, part] = within(course.state, slopes, width, theta, part)
        row += 1
    course.counts[SAMPLE] = row


def _after_event(event: int, limits: Any, course: Any, marks: Any) -> int:
    """What follows when a step has ended at a speed."""
    here, counts, state = course.here, course.counts, course.state
    if event == OVER:
        return OVERSPEED
    if event == REACHED:
        note(course, marks, 1 * SPEED_PASSED, here[TIME], state[0], state[1])
        return SPEED_REACHED
    state[1], here[SENSE], here[WIDTH] = 0.0, 0.0, 0.0
    counts[REVERSALS] += 1
    counts[IS_FRESH] = 1
    note(course, marks, 1 * REVERSAL, here[TIME], state[0], 0.0)
    return SWINGS if counts[REVERSALS] >= limits.most_reversals else GOING


def _go_to_the_end(asked: Any, course: Any, width: float, landing: int, error: float) -> None:
    """Accept a whole step: on in the same phase, or with a new one from a break or corner."""
    here, counts = course.here, course.counts
    time = here[TIME] + width
    if landing == AT_TIME:
        time = asked.limits.end_time
        if counts[BREAK] < len(asked.breaks):
            time = min(time, asked.breaks[counts[BREAK]])
    go_ahead(course, time, course.ahead)
    for component in range(N_STATE):
        course.slopes[component] = course.slopes[6 * ROW + component]
    if landing == NOWHERE:
        here[WIDTH] = width * min(5.0, 0.9 * max(error, 1e-10) ** -0.2)
        return
    counts[IS_FRESH] = 1 if time < asked.limits.end_time else 0
    if landing == AT_TIME:
        here[WIDTH] = 0.0
