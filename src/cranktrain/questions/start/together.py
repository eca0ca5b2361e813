"""Starts of designs run together: what they have in common once, the rest in rows, and what the compiled loop tells."""

from collections.abc import Generator, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from cranktrain.errors import InputError
from cranktrain.grouping import grouped
from cranktrain.motion import Array
from cranktrain.questions.reduction.unloaded import with_open_valves
from cranktrain.questions.start.asked import MovingParts, StartAsked
from cranktrain.questions.start.case import StartCase, StartCases, start_kernels
from cranktrain.questions.start.in_row import row_of_starts
from cranktrain.questions.start.many import rows_of_one
from cranktrain.questions.start.method import methods_of
from cranktrain.questions.start.record import RanFacts, RanRows, ReadyStarts, StartRun, StartsInShort
from cranktrain.questions.start.rows_of_designs import (
    MOST_MARKS,
    MOST_PARTS,
    N_PART,
    DesignNumbers,
    StartRoom,
    StartRows,
    Together,
)
from cranktrain.questions.start.starting import breaks_of, ran_start, run_start, spans_of
from cranktrain.transient.course import room_for_a_course
from cranktrain.transient.gearing import turning_inertia
from cranktrain.transient.law import in_one_stage, lines_of
from cranktrain.transient.reduced import ReducedMachine, in_one_row
from cranktrain.transient.runs import each_apart, run
from cranktrain.transient.step import N_STATE
from cranktrain.transient.traced import N_TRACED

AT_ONCE = 16
"""Designs that are best run together: room for what is told of more is too large to be kept near."""
_N_STEPS, _N_SAMPLES, _N_TOLD, _N_MARKS = 4096, 8192, 2500, 200
"""Room of a design for steps, and times that are looked at; that which is told of each on the mean, and its events."""
_MOST_ROOM = 16
"""Times as much: what takes more goes alone."""


class _BigRoom(NamedTuple):
    """Room for steps, for samples, and for what is told of designs."""

    steps: Array
    samples: Array
    told: StartRows


_left_rooms = list[_BigRoom]()
"""Room that nobody uses just now: new memory takes as long as a run."""


def ready_starts(cases: StartCases, parts: MovingParts) -> ReadyStarts:
    """Runs from rest; docs/theory/transient, eqs. (26.7) to (26.13)."""
    kernels = start_kernels(parts.motor, is_compiled=True)
    in_short = StartsInShort(kernels, partial(_ran, cases), partial(_in_groups, cases), partial(_ran_together, cases))
    return ReadyStarts(partial(_run, cases), in_short)


def _run(cases: StartCases, design: int, asked: StartAsked) -> StartRun:
    """Run the start of a design, or refuse it."""
    return run_start(_case_of(cases, design), asked)


def _ran(cases: StartCases, design: int) -> RanRows:
    """Run the start of a design as its file says, or refuse it."""
    return rows_of_one(ran_start(_case_of(cases, design), StartAsked()))


def _case_of(cases: StartCases, design: int) -> StartCase:
    case = cases.each[design]
    if isinstance(case, InputError):
        raise case
    return case


def _in_groups(cases: StartCases, designs: Sequence[int]) -> list[list[int]]:
    """Designs that can be run together, in their order: of motors that are not stiff, machines of as many numbers."""
    each = ((design, cases.each[design]) for design in designs)
    ready = {design: case for design, case in each if isinstance(case, StartCase)}
    fit = zip(ready.items(), methods_of([*ready.values()]), strict=True)
    return list(grouped((_in_common(case), design) for (design, case), method in fit if method is run).values())


def _in_common(case: StartCase) -> tuple[object, ...]:
    return lines_of(case.gearing).shape, sum(part.size for part in map(np.asarray, case.machine))


def _ran_together(cases: StartCases, designs: Sequence[int]) -> Iterator[RanRows | None]:
    """Run designs of one group, in their order; None of one that takes too much room.

    Arrays of what is given are used again when more is asked for. docs/theory/transient, eqs. (26.7) to (26.14).
    """
    own = [_case_of(cases, design) for design in designs]
    loop, given = row_of_starts(start_kernels(own[0].motor, is_compiled=True)), _together(own)
    first, times = 0, 1
    while first < len(own):
        with _room_for(len(own) - first, times) as (steps, samples, told):
            after = loop(given, _room(given, steps, samples), told, first)
            if after > first:
                yield _rows_found(own[first:after], told)
                first, times = after, 1
                continue
        if times < _MOST_ROOM:
            times *= 2
        else:
            yield None
            first += 1


@contextmanager
def _room_for(n_designs: int, times: int) -> Generator[_BigRoom]:
    """Lend room for steps and samples of one design after another, and to tell of some; the usual is used again."""
    is_usual = times == 1 and n_designs <= AT_ONCE
    try:
        room = _left_rooms.pop() if is_usual else _big_room(n_designs, times)
    except IndexError:  # all of it is lent: asked for beforehand, another thread might take the last
        room = _big_room(AT_ONCE, 1)
    yield room
    if is_usual:
        _left_rooms.append(room)


def _big_room(n_designs: int, times: int) -> _BigRoom:
    """Make room for designs, so many times as much as most of them need."""
    n_samples, n_marks = times * _N_SAMPLES, n_designs * _N_MARKS + 2 * times * MOST_MARKS
    n_rows = n_designs * _N_TOLD + n_samples
    time, torque, inertia = np.empty((3, n_rows))
    return _BigRoom(
        np.empty((times * _N_STEPS, N_TRACED)),
        np.empty((n_samples, 3 + N_STATE)),
        StartRows(np.empty((n_designs, 8)), time, np.empty((n_rows, N_STATE)), torque, inertia, np.empty((n_marks, 4))),
    )


def _together(cases: Sequence[StartCase]) -> Together:
    """Put designs of one group together."""
    cycle, machines, places = cases[0].cycle, list[Array](), dict[tuple[int, bool], int]()

    def place_of(machine: ReducedMachine, has_open_valves: bool) -> int:
        """Where its numbers stand, or stand now."""
        key = id(machine), has_open_valves
        if key not in places:
            places[key] = len(machines)
            machines.append(in_one_row(with_open_valves(machine) if has_open_valves else machine))
        return places[key]

    own = [place_of(case.machine, has_open_valves=False) for case in cases]
    parts = [
        [
            (span.end, span.target, place_of(case.machine, span.machine is not case.machine), span.to_rest)
            for span in spans_of(case)
        ]
        for case in cases
    ]
    corners = [each_apart(case.corners, cycle).tolist() for case in cases]
    rows = [each_apart(case.rows, cycle).tolist() for case in cases]
    numbers = [
        _numbers(case, machine, len(corner), len(row))
        for case, machine, corner, row in zip(cases, own, corners, rows, strict=True)
    ]
    return Together(
        np.stack(machines),
        tuple(case.motor_numbers for case in cases) + (cases[-1].motor_numbers,) * (AT_ONCE - len(cases)),
        _filled(corners, np.inf),
        _filled(rows, np.inf),
        float(cycle),
        np.array(numbers),
        np.stack([lines_of(case.gearing) for case in cases]),
        _filled(parts, (0.0, 0.0, -1.0, 0.0)),
        _filled([sorted(breaks_of(case)) for case in cases], np.inf),
    )


def _filled(rows: Sequence[Sequence[Any]], nothing: Any) -> Array:
    """Rows of designs, filled up to the longest."""
    longest = max(map(len, rows))
    return np.array([[*row, *[nothing] * (longest - len(row))] for row in rows], dtype=np.float64)


def _numbers(case: StartCase, machine: int, n_corners: int, n_rows: int) -> DesignNumbers:
    """Numbers of a design, in a row."""
    start, brake, stage = case.start, case.brake, in_one_stage(case.gearing)
    return DesignNumbers(
        angle=start.angle + case.zero,
        speed=start.speed,
        off=start.motor_off,
        back=start.motor_reversed,
        braked=start.brake_on + brake.begins,
        overspeed=start.overspeed,
        gas_pressure=start.gas_pressure,
        interval=start.interval,
        tolerance=start.tolerance,
        brake_torque=brake.torque,
        rise_time=brake.rise_time,
        on_crank=case.place.on_crank,
        holds=case.place.holds,
        settles=float(case.is_to_settle),
        steady_speed=case.steady_speed,
        cycle_time=case.cycle_time,
        turning=float(turning_inertia(case.gearing)),
        has_stage=float(stage.is_all),
        ratio=stage.ratio,
        forward=stage.forward,
        backward=stage.backward,
        drag=stage.drag,
        stage_inertia=stage.inertia,
        motor=stage.motor,
        machine=machine,
        n_corners=n_corners,
        n_rows=n_rows,
    )


def _room(given: Together, steps: Array, samples: Array) -> StartRoom:
    """Room for one design after another."""
    n_samples = len(samples)
    apart = samples.reshape(-1)
    times, close, within = apart[: 3 * n_samples].reshape(3, n_samples)
    return StartRoom(
        room_for_a_course(),
        np.empty(given.machines.shape[1]),
        np.empty(N_STATE),
        np.empty(given.breaks.shape[1]),
        steps,
        np.empty((MOST_PARTS, N_PART)),
        np.empty((MOST_PARTS, N_STATE)),
        np.empty((MOST_PARTS, N_STATE)),
        times,
        close,
        within,
        apart[3 * n_samples :].reshape(n_samples, N_STATE),
    )


def _rows_found(cases: Sequence[StartCase], told: StartRows) -> RanRows:
    """What became of designs."""
    *of_all, sizes, n_marks = told.designs[: len(cases)].T
    sizes, n_marks = sizes.astype(np.intp), n_marks.astype(np.intp)
    rows, marks = slice(int(np.sum(sizes))), slice(int(np.sum(n_marks)))
    along = (told.time[rows], told.state[rows], told.torque[rows], told.inertia[rows])
    return RanRows(tuple(cases), *along, sizes, told.marks[marks], n_marks, RanFacts(*of_all))
