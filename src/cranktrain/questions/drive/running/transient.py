"""A run from one state to its end: steps, events, standstill; one kernel, plain or compiled."""

from typing import Any, NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.drive.running.crossings import angle_of_dead_position, passed_angle, passed_level
from cranktrain.questions.drive.running.equation import OPEN
from cranktrain.questions.drive.running.gearing import acceleration
from cranktrain.questions.drive.running.step import error_of, take_step, within

TIME_OUT, SPEED_REACHED, AT_REST, STALLED, OVERSPEED, SWINGS, TOO_MANY_STEPS, LINKS_OPEN, GEARING_JAMS = range(9)
"""Why a run ended."""
REVERSAL, DEAD_POSITION, SPEED_PASSED, HELD, SET_OFF = range(5)
"""What is noted on the way."""

_OVER, _REACHED = 100, 101
"""What else than a reversal may end a step, apart from all that is noted."""
_LARGEST_TURN = 2 * np.pi / 50
"""In a step: with more, a speed that passes a level twice would be overlooked."""
_LEAST_WIDTH = 1e-14
_REST_LOOKS = 400


class RunLimits(NamedTuple):
    """When a run ends and how closely it is computed.

    Attributes
    ----------
    end_time : float
        [s]
    target_speed, overspeed : float
        Of the crank, by amount; infinite where nobody asks. [rad/s]
    stops_at_target : bool
    most_reversals, most_steps : int
    tolerance : float
        Error of a step, of the angle in rad and of the speed in parts of the largest so far.
    is_timed : bool
        Whether motor or brake depend on the time: a crank that is held may then be let go.
    """

    end_time: float
    target_speed: float
    overspeed: float
    stops_at_target: bool
    most_reversals: int
    most_steps: int
    tolerance: float
    is_timed: bool


def sense_of_start(time: float, angle: float, kernels: Any, drive: Any) -> float:
    """Which way a crank at rest sets off: 1 forward, −1 back, 0 held. docs/theory/transient, eq. (26.7)."""
    torque = kernels.motor(0.0, time, drive.motor)
    drag = kernels.brake(time, drive.brake)
    for sense in (1.0, -1.0):
        inertia, _, load, _ = kernels.machine(angle, 0.0, sense, drive.machine)
        grown, _, count = acceleration(torque - drag * sense, sense, inertia, load, drive.gearing)
        if count == 0 and grown * sense > 0:
            return sense
    return 0.0


def let_go_at(time: float, until: float, angle: float, kernels: Any, drive: Any) -> float:
    """When a crank that is held begins to move; infinite if not before `until`. [s]"""
    before = time
    for look in range(1, _REST_LOOKS + 1):
        at = time + (until - time) * look / _REST_LOOKS
        if sense_of_start(at, angle, kernels, drive) != 0.0:
            for _ in range(60):
                middle = 0.5 * (before + at)
                if sense_of_start(middle, angle, kernels, drive) != 0.0:
                    at = middle
                else:
                    before = middle
            return at
        before = at
    return np.inf


def _first_width(state: Array, slopes: Array, limits: RunLimits) -> float:
    """A step small enough to be judged; the next ones adapt."""
    width = 1e-3 * limits.end_time
    if abs(slopes[0, 1]) > 0:
        width = min(width, np.sqrt(2e-4 / abs(slopes[0, 1])))
    if abs(state[1]) > 0:
        width = min(width, 1e-3 / abs(state[1]))
    return width


def _noted(marks: Array, n_marks: int, kind: int, time: float, angle: float, speed: float) -> int:
    """Write down an event where there is room."""
    if n_marks < len(marks):
        marks[n_marks, 0] = kind
        marks[n_marks, 1] = time
        marks[n_marks, 2] = angle
        marks[n_marks, 3] = speed
        return n_marks + 1
    return n_marks


def _settled_on(
    derive: Any, time: float, state: Array, slopes: Array, theta: float, width: float, which: int, level: float,
    ahead: Array, again: Array, sense: float, drive: Any,
) -> float:  # fmt: skip
    """Width of a step to where angle (0) or speed (1) has the level, by Newton's method over steps of that length.

    The interpolant is of a lower order than the step, so it only gives the start.
    """
    part = theta * width
    for part_of in range(len(state)):
        again[0, part_of] = slopes[0, part_of]
    for _ in range(3):
        take_step(derive, time, part, state, again, 2, ahead, sense, drive)
        if again[6, which] == 0 or not abs(again[6, which]) < np.inf:
            break
        move = (level - ahead[which]) / again[6, which]
        if abs(move) > 0.1 * width:
            break
        part += move
    take_step(derive, time, part, state, again, 2, ahead, sense, drive)
    return part


def run_on(
    derive: Any, kernels: Any, drive: Any, state: Array, start_time: float, limits: RunLimits, breaks: Array,
    samples: Array, table: Array, marks: Array,
) -> tuple[int, float, int, int]:  # fmt: skip
    """Run until something ends it.

    Parameters
    ----------
    derive, kernels
        Of `equation.joined`.
    drive : DriveTrain
    state : Array, shape (6,)
        Changed to that at the end.
    start_time : float
        [s]
    limits : RunLimits
    breaks : Array, ascending
        Times at which motor or brake jump: a step ends there. [s]
    samples : Array, ascending
        Times at which the state is wanted, of which `table`, shape (samples, 6), is filled as far as the run goes. [s]
    marks : Array, shape (most, 4)
        Filled with kind, time, angle and speed of events.

    Returns
    -------
    tuple
        Reason, time, how many steps and how many marks.
    """
    time, n_marks, n_steps, n_reversals = start_time, 0, 0, 0
    i_sample, i_break = 0, 0
    n_samples, n_breaks = len(samples), len(breaks)
    n_state = len(state)
    slopes, again = np.zeros((7, n_state)), np.zeros((7, n_state))
    ahead, trial = np.zeros(n_state), np.zeros(n_state)
    sense = np.sign(state[1])
    fastest = abs(state[1])
    while i_break < n_breaks and breaks[i_break] <= time:
        i_break += 1
    while i_sample < n_samples and samples[i_sample] <= time:
        for part in range(n_state):
            table[i_sample, part] = state[part]
        i_sample += 1
    while True:
        if sense == 0.0:
            sense = sense_of_start(time, state[0], kernels, drive)
            if sense == 0.0:
                n_marks = _noted(marks, n_marks, HELD, time, state[0], 0.0)
                resting = derive(time, state, slopes[0], 0.0, drive)
                if resting == OPEN:
                    return LINKS_OPEN, time, n_steps, n_marks
                let_go = np.inf
                if limits.is_timed:
                    let_go = let_go_at(time, limits.end_time, state[0], kernels, drive)
                if let_go == np.inf:
                    return _kind_of_rest(time, kernels, drive), time, n_steps, n_marks
                heat = slopes[0, 5]
                while i_sample < n_samples and samples[i_sample] <= let_go:
                    for part in range(n_state):
                        table[i_sample, part] = state[part]
                    table[i_sample, 5] += heat * (samples[i_sample] - time)
                    i_sample += 1
                derive(let_go, state, slopes[0], 0.0, drive)
                state[5] += 0.5 * (heat + slopes[0, 5]) * (let_go - time)
                time = let_go
                sense = sense_of_start(time, state[0], kernels, drive)
                n_marks = _noted(marks, n_marks, SET_OFF, time, state[0], 0.0)
                while i_break < n_breaks and breaks[i_break] <= time:
                    i_break += 1
                if time >= limits.end_time:
                    return TIME_OUT, time, n_steps, n_marks
        # a new phase: from here all is smooth until the next event or break
        trouble = derive(time, state, slopes[0], sense, drive)
        if trouble != 0:
            return LINKS_OPEN if trouble == OPEN else GEARING_JAMS, time, n_steps, n_marks
        output = kernels.machine(state[0], state[1], sense, drive.machine)[3]
        width = _first_width(state, slopes, limits)
        is_same_phase = True
        while is_same_phase:
            if time >= limits.end_time:
                return TIME_OUT, time, n_steps, n_marks
            if n_steps >= limits.most_steps:
                return TOO_MANY_STEPS, time, n_steps, n_marks
            n_steps += 1
            until = limits.end_time
            if i_break < n_breaks and breaks[i_break] < until:
                until = breaks[i_break]
            speed, grown = abs(state[1]), abs(slopes[0, 1])
            width = min(
                width, 2 * _LARGEST_TURN / (speed + np.sqrt(speed * speed + 2 * grown * _LARGEST_TURN) + 1e-300)
            )
            is_last = time + width * 1.0000001 >= until
            if is_last:
                # a torque that begins at the break must not be seen by the last stages of the step before it
                width = until - time - (1e-13 * limits.end_time if until < limits.end_time else 0.0)
            trouble = take_step(derive, time, width, state, slopes, 2, ahead, sense, drive)
            largest = max(fastest, abs(ahead[1]))
            error = max(
                error_of(slopes, width, 0) / limits.tolerance,
                error_of(slopes, width, 1) / (limits.tolerance * largest + 1e-300),
            )
            if trouble != 0 or not error <= 1.0:
                factor = 0.9 * error**-0.2 if trouble == 0 and error == error else 0.1
                width *= max(0.1, factor)
                if width < _LEAST_WIDTH * max(time, 1e-3 * limits.end_time):
                    if trouble == 0:
                        return TOO_MANY_STEPS, time, n_steps, n_marks
                    return LINKS_OPEN if trouble == OPEN else GEARING_JAMS, time, n_steps, n_marks
                continue
            theta_end, ending, level = 1.0, -1, 0.0
            stop = passed_level(state, slopes, width, 0.0, -sense)
            if stop <= theta_end:
                theta_end, ending, level = stop, REVERSAL, 0.0
            over = passed_level(state, slopes, width, sense * limits.overspeed, sense)
            if over < theta_end:
                theta_end, ending, level = over, _OVER, sense * limits.overspeed
            reached = passed_level(state, slopes, width, sense * limits.target_speed, sense)
            if reached < theta_end:
                if limits.stops_at_target:
                    theta_end, ending, level = reached, _REACHED, sense * limits.target_speed
                else:
                    passed = sense * limits.target_speed
                    part = _settled_on(
                        derive, time, state, slopes, reached, width, 1, passed, trial, again, sense, drive
                    )
                    n_marks = _noted(marks, n_marks, SPEED_PASSED, time + part, trial[0], trial[1])
            if ending < 0 and ahead[1] * sense < 0:  # it sets off the other way: nearer to where it stands
                width *= 0.25
                if width < _LEAST_WIDTH * max(time, 1e-3 * limits.end_time):
                    return _kind_of_rest(time, kernels, drive), time, n_steps, n_marks
                continue
            now = kernels.machine(ahead[0], ahead[1], sense, drive.machine)[3]
            if now * output < 0:
                dead = angle_of_dead_position(kernels.machine, drive.machine, sense, state[0], ahead[0])
                at = passed_angle(state, slopes, width, dead, sense)
                if at <= theta_end:
                    part = _settled_on(derive, time, state, slopes, at, width, 0, dead, trial, again, sense, drive)
                    n_marks = _noted(marks, n_marks, DEAD_POSITION, time + part, trial[0], trial[1])
            part = width
            if ending >= 0:
                part = _settled_on(derive, time, state, slopes, theta_end, width, 1, level, trial, again, sense, drive)
            while i_sample < n_samples and samples[i_sample] <= time + part:
                theta = (samples[i_sample] - time) / width
                for component in range(n_state):
                    table[i_sample, component] = within(state, slopes, width, theta, component)
                i_sample += 1
            if ending >= 0:
                time += part
                for component in range(n_state):
                    state[component] = trial[component]
                if ending == _OVER:
                    return OVERSPEED, time, n_steps, n_marks
                if ending == _REACHED:
                    n_marks = _noted(marks, n_marks, SPEED_PASSED, time, state[0], state[1])
                    return SPEED_REACHED, time, n_steps, n_marks
                state[1] = 0.0
                sense = 0.0
                n_reversals += 1
                n_marks = _noted(marks, n_marks, REVERSAL, time, state[0], 0.0)
                if n_reversals >= limits.most_reversals:
                    return SWINGS, time, n_steps, n_marks
                is_same_phase = False
                continue
            if now != 0.0:
                output = now
            time = until if is_last else time + width
            for component in range(n_state):
                state[component] = ahead[component]
                slopes[0, component] = slopes[6, component]
            fastest = largest
            width *= min(5.0, 0.9 * max(error, 1e-10) ** -0.2)
            if is_last and i_break < n_breaks and until == breaks[i_break]:
                i_break += 1
                is_same_phase = False


def _kind_of_rest(time: float, kernels: Any, drive: Any) -> int:
    """Whether a motor pulls at a crank that is held, or nothing does."""
    return STALLED if abs(kernels.motor(0.0, time, drive.motor)) > 0 else AT_REST
