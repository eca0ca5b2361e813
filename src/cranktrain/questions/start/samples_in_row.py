"""When a start that has run is looked at, and what is told of it there; as `starting` has it, compiled."""

import math
from typing import Any

from cranktrain.questions.start.case import Switching
from cranktrain.questions.start.curves import N_CLOSE, QUICKLY
from cranktrain.questions.start.rows_of_designs import (
    AFTER_SAMPLE,
    AFTER_STEP,
    BACK,
    FIRST_SAMPLE,
    FIRST_STEP,
    INTERVAL,
    MACHINE,
    OFF,
    PART_BEGAN,
    PART_ENDS,
    PART_LASTED,
    RATIO,
)
from cranktrain.questions.start.spans import N_EVEN
from cranktrain.transient.equation import MOTOR_WORK, SPEED
from cranktrain.transient.reduced import inertia_at
from cranktrain.transient.step import N_STATE
from cranktrain.transient.traced import SPEED_AFTER, TIME_AFTER, fill_one_by_one


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


def times_to_look_at(kernels: Any, given: Any, design: int, room: Any, n_parts: int, end: float) -> int:
    """Lay down the times at which a run is looked at, rising, each once; gives how many, 0 for no room. [s]"""
    own = given.designs[design]
    if end / own[INTERVAL] > len(room.samples):
        return 0
    n_asked = 0 if own[INTERVAL] == math.inf else math.floor(end / own[INTERVAL] + 1)
    n_close = close_times_of(kernels, given, design, room, n_parts)
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


def close_times_of(kernels: Any, given: Any, design: int, room: Any, n_parts: int) -> int:
    """The same of times at which steps end, and closer ones where the motor's torque changes quickly."""
    own, motor = given.designs[design], switch_of(given, design, 0.0)
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


def switch_of(given: Any, design: int, began: float) -> Switching:
    """A design's motor with its switch, as a part of its run from a time on has it."""
    own = given.designs[design]
    return Switching(given.motors[design], own[OFF], own[BACK], began)


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
    machine = given.machines[int(own[MACHINE])]
    motor = switch_of(given, design, 0.0)
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
            told.inertia[row] = inertia_at(told.state[row, 0], machine)
            row += 1
        for component in range(MOTOR_WORK, N_STATE):
            room.start[component] += room.ends[which, component]
    return row - first
