"""Runs of a machine with its motor: what was asked, and what became of it."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import cache, lru_cache, partial
from time import perf_counter
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.record import record
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
    copied,
    course_from,
)
from cranktrain.transient.endings import GOING, STOPPED, RunLimits
from cranktrain.transient.equation import DriveTrain, Joined, Kernels, TrainNumbers, joined, train_of
from cranktrain.transient.gearing import overall_ratio, turning_inertia
from cranktrain.transient.step import N_STATE
from cranktrain.transient.traced import N_TRACED, states_within
from cranktrain.transient.transient import run_to_the_end

Progress: TypeAlias = Callable[[float, float, float], object]
"""(time, crank angle, speed) → anything. [s, rad, rad/s]"""

TOO_FAST = N_(
    "no step is short enough, as the speed changes too fast: next to nothing has inertia there;"
    " the inertia of motor or flywheel helps"
)
"""Sentence, not yet translated, of a run whose steps become too short."""

REASONS = {
    endings.TIME_OUT: N_("the time asked for is over"),
    endings.SPEED_REACHED: N_("the speed asked for is reached"),
    endings.AT_REST: N_("it stands still and nothing pulls"),
    endings.STALLED: N_("it stands still: the motor's torque is within what load and friction hold"),
    endings.OVERSPEED: N_("the load drives it over the speed allowed"),
    endings.SWINGS: N_("it swings to and fro and does not get over"),
    endings.TOO_MANY_STEPS: N_("it takes more steps than allowed"),
    endings.NO_STEP_SHORT_ENOUGH: TOO_FAST,
    endings.LINKS_OPEN: N_("the links do not close"),
    endings.GEARING_JAMS: N_(
        "the gearing jams: it cannot be driven back (as below an efficiency of 50 %), and no one acceleration fits its"
        " losses; a better efficiency, or more inertia at the motor, helps"
    ),
    endings.STOPPED: N_("it was stopped"),
}
"""Sentences, not yet translated, of why a run ended."""

DEFAULT_TOLERANCE = 1e-8
_MOST_MARKS = 2000
_LEAST_APART = 1e-9
"""Corners nearer to each other are one. [rad]"""
_FIRST_STEPS = 20
"""Before progress is told for the first time."""
_AT_ONCE = 1024
"""Steps whose ends are written down in one call."""
_BETWEEN_CALLS = 1 / 30
"""Between two tellings. [s]"""


class Event(NamedTuple):
    """Something on the way: one of `REVERSAL`, …, at a time [s], crank angle [rad] and speed [rad/s]."""

    kind: int
    time: float
    angle: float
    speed: float


@record
class TransientRun:
    """What became of a run.

    Attributes
    ----------
    reason : int
        A key of `REASONS`.
    start : Array, shape (6,)
        As `end`.
    end_time : float
        [s]
    end : Array, shape (6,)
        Crank angle [rad] and speed [rad/s]; work of the motor, of the load, and lost [J]; heat in the motor [J].
    time : Array, shape (n,)
        Of the samples that the run came to. [s]
    states : Array, shape (n, 6)
        At these times, as `end`.
    marks : Array, shape (n, 4)
        Kind, time, angle and speed of events, in the order of their times. [1, s, rad, rad/s]
    residual, supplied : float
        Kinetic energy less what was given and taken; and the work by which to judge it: of motor and load, each by
        amount, and the largest kinetic energy of start and end. [J]
    n_steps : int
    method : str
        Of `tsit5`, `LSODA`, `Radau`.
    machine : Array, or list of float
        Its numbers, with what it remembers at the end: a run may go on from there.
    steps : Array, shape (n, 2 or more)
        Where steps end, time and speed of the crank, if that was asked for; behind it, of an explicit method, what
        tells the states within a step. [s, rad/s]
    """

    reason: int
    start: Array
    end_time: float
    end: Array
    time: Array
    states: Array
    marks: Array
    residual: float
    supplied: float
    n_steps: int
    method: str
    machine: Any
    steps: Array

    @property
    def events(self) -> tuple[Event, ...]:
        """In the order of their times."""
        return tuple(Event(int(kind), *where) for kind, *where in self.marks.tolist())

    def of_kind(self, kind: int) -> tuple[Event, ...]:
        """Events of one kind."""
        return tuple(event for event in self.events if event.kind == kind)

    @property
    def tells_within(self) -> bool:
        """Whether its steps tell all states: not where it waited, was stopped, or ran implicitly."""
        is_traced = self.steps.shape[1] == N_TRACED and len(self.steps) > 0
        return is_traced and self.reason != STOPPED and not np.any(self.marks[:, 0] == endings.HELD)

    def sampled(self, samples: Array, *, is_compiled: bool) -> "TransientRun":
        """The same with its states at other samples, shape (n,), as a run with these has them. [s]"""
        states = states_within(self.steps, self.start, samples, is_compiled=is_compiled)
        return replace(self, time=samples[: len(states)], states=states)


class Wanted(NamedTuple):
    """How a run starts, ends, where its state is wanted, and where something jumps; see `wanted`."""

    start: Array
    limits: RunLimits
    samples: Array
    breaks: Array
    corners: Array
    period: float
    rows: Array


def wanted(
    end_time: float,
    *,
    angle: float = 0.0,
    speed: float = 0.0,
    samples: Array | None = None,
    breaks: Array | tuple[float, ...] = (),
    corners: Array | tuple[float, ...] = (),
    rows: Array | tuple[float, ...] = (),
    period: float = 2 * np.pi,
    target_speed: float = np.inf,
    overspeed: float = np.inf,
    stops_at_target: bool = False,
    most_reversals: int = 1000,
    most_steps: int = 1_000_000,
    tolerance: float = DEFAULT_TOLERANCE,
    is_timed: bool = False,
) -> Wanted:
    """Say what is wanted of a run; see `RunLimits`. [s, rad, rad/s]

    Parameters
    ----------
    end_time, angle, speed, target_speed, overspeed, stops_at_target, most_reversals, most_steps, tolerance, is_timed
        See `RunLimits`; angle and speed are those of the start.
    samples : Array, ascending, optional
        Times at which the state is wanted. [s]
    breaks : Array, optional
        Times at which motor or brake jump. [s]
    corners : Array, optional
        Crank angles at which a load has a corner or jumps, or a chamber that remembers its gas turns round. A step ends
        there; what the load is at the corner itself is asked on the side to which the crank goes. [rad]
    rows : Array, optional
        Crank angles of rows of a load curve that are next to no corners: a step passes over a few at most. [rad]
    period : float, optional
        After which the corners come again: of a four-stroke engine two turns. [rad]

    Examples
    --------
    >>> wanted(3.0, angle=0.3).limits.tolerance
    1e-08
    """
    limits = RunLimits(
        float(end_time), float(target_speed), float(overspeed), bool(stops_at_target), most_reversals, most_steps,
        float(tolerance), bool(is_timed),
    )  # fmt: skip
    start = np.zeros(N_STATE)
    start[0], start[1] = angle, speed
    times = np.sort(np.asarray(breaks, dtype=float))
    asked = np.array(() if samples is None else samples, dtype=float)
    return Wanted(start, limits, asked, times, each_apart(corners, period), float(period), each_apart(rows, period))


def each_apart(corners: Array | tuple[float, ...], period: float) -> Array:
    """Corners within a period, in their order, each once. [rad]"""
    return _apart(np.asarray(corners, dtype=float).tobytes(), period)


@lru_cache(maxsize=64)
def _apart(corners: bytes, period: float) -> Array:
    """The same of their bytes: many starts have the same."""
    within = np.sort(np.mod(np.frombuffer(corners), period))
    if len(within) < 2:
        return within
    before = np.concatenate((within[-1:] - period, within[:-1]))
    return within[within - before > _LEAST_APART]


def run(
    kernels: Kernels,
    drive: DriveTrain,
    asked: Wanted,
    *,
    is_compiled: bool = True,
    progress: Progress | None = None,
    keeps_steps: bool = False,
) -> TransientRun:
    """Run a machine by an explicit method.

    Parameters
    ----------
    kernels : Kernels
    drive : DriveTrain
        Their numbers: floats, arrays of floats, and tuples of them. A run leaves them as they are: a machine that
        remembers does so in a copy.
    asked : Wanted
    is_compiled : bool, optional
        With Numba; the first run with these kernels compiles.
    progress : callable, optional
        (time, crank angle, speed) → anything, called some 30 times a second of the user's time. With it, a run that
        the user interrupts (Ctrl-C) gives what was computed so far, with the reason `STOPPED`; numbers are the same.
    keeps_steps : bool, optional
        Whether its `steps` are kept.

    Returns
    -------
    TransientRun

    Notes
    -----
    docs/theory/transient, eqs. (26.7) to (26.14).
    """
    loop = loop_of(joined(kernels, is_compiled), is_compiled)
    train, course = train_of(drive, kernels, is_compiled), course_from(asked.start, is_compiled)
    n_rows = _AT_ONCE if keeps_steps else 0
    log = Log(np.empty((len(asked.samples), N_STATE)), np.empty((_MOST_MARKS, 4)), np.empty((n_rows, N_TRACED)))
    steps = list[Array]()
    if not is_compiled:
        asked = asked._replace(
            **{name: getattr(asked, name).tolist() for name in ("start", "samples", "breaks", "corners", "rows")}
        )
    reason, course = _run_through(partial(loop, train, asked), course, log, asked.limits.most_steps, progress, steps)
    return _result(reason, course, log, asked, drive, train.machine, _one_behind_other(log, steps))


class Log(NamedTuple):
    """States at the samples, events, and the steps of one call: filled by the loop."""

    table: Array
    marks: Array
    steps: Array


def _run_through(
    loop: Any,
    course: Course,
    log: Log,
    most_steps: int,
    progress: Progress | None,
    steps: list[Array],
) -> tuple[int, Course]:
    """Run to the end, so many steps at a time as are written down, or take the time between two tellings."""
    is_kept = len(log.steps) > 0
    if progress is None and not is_kept:
        return loop(course, *log, most_steps + 1), course
    kept, n_steps = course if progress is None else copied(course), _AT_ONCE if progress is None else _FIRST_STEPS
    try:
        while True:
            start = perf_counter()
            reason = loop(course, *log, n_steps)
            kept = course if progress is None else copied(course)
            if is_kept:
                own = log.steps[: course.counts[ENDS]]
                steps.append(own.copy() if reason == GOING else own)
            if progress is not None:
                progress(float(course.here[TIME]), float(course.state[0]), float(course.state[1]))
                n_steps = max(1, int(n_steps * min(4.0, _BETWEEN_CALLS / max(perf_counter() - start, 1e-9))))
            n_steps = min(n_steps, _AT_ONCE) if is_kept else n_steps
            if reason != GOING:
                return reason, course
    except KeyboardInterrupt:
        if progress is None:
            raise
        return STOPPED, kept


def _result(
    reason: int, course: Course, log: Log, asked: Wanted, drive: DriveTrain, machine: Any, steps: Array
) -> TransientRun:
    """What became of a run whose course has ended."""
    n_samples, marks = course.counts[SAMPLE], log.marks[: course.counts[MARKS]]
    inertias = course.here[INERTIA_BEFORE], course.here[INERTIA_AFTER]
    residual, supplied = energy_account(turning_inertia(drive.gearing), inertias, asked.start, course.state)
    return TransientRun(
        reason,
        np.asarray(asked.start),
        float(course.here[TIME]),
        np.asarray(course.state),
        np.asarray(asked.samples[:n_samples], dtype=float),
        log.table[:n_samples],
        marks[np.argsort(marks[:, 1], kind="stable")],
        residual,
        supplied,
        int(course.counts[STEPS]),
        "tsit5",
        machine,
        steps,
    )


def _one_behind_other(log: Log, steps: list[Array]) -> Array:
    """Steps of all calls; most runs take one."""
    return steps[0] if len(steps) == 1 else np.concatenate([log.steps[:0], *steps])


def run_all(kernels: Kernels, cases: list[tuple[DriveTrain, Wanted]], *, n_threads: int = 2) -> list[TransientRun]:
    """Run many machines of the same kernels, compiled, on several threads: each has its own cases from the beginning.

    Handed out one by one they would wait for each other longer than half a short run takes.
    """
    done = [run(kernels, *case) for case in cases[:1]]  # compiles, which threads must not do at once
    rest = cases[1:]

    def some(first: int) -> list[TransientRun]:
        return [run(kernels, *case) for case in rest[first::n_threads]]

    with ThreadPoolExecutor(n_threads) as pool:
        shares = list(pool.map(some, range(n_threads)))
    return done + [shares[place % n_threads][place // n_threads] for place in range(len(rest))]


def energy_account(turning: float, inertias: tuple[float, float], start: Any, end: Any) -> tuple[float, float]:
    """Kinetic energy gained less work given, and the work by which to judge that. [J] Eq. (26.11)

    By what turns in the drive, and the machine's reduced inertia at the start and at the end. [kg·m²]
    """
    before = 0.5 * (turning + inertias[0]) * (start[1] * start[1])
    after = 0.5 * (turning + inertias[1]) * (end[1] * end[1])
    given = end[2] - end[3] - end[4]
    return float(after - before - given), float(max(abs(end[2]) + abs(end[3]), before, after))


def motor_speed(run: TransientRun, drive: DriveTrain) -> Array:
    """Speed at the motor's shaft at the samples. [rad/s]"""
    return run.states[:, 1] * overall_ratio(drive.gearing)


@cache
def loop_of(parts: Joined, is_compiled: bool) -> Any:
    """Loop of a run with its kernels in it: given to it at every call, they would cost more than the run."""
    derive, kernels = parts

    def loop(
        train: TrainNumbers, asked: Wanted, course: Course, table: Array, marks: Array, steps: Array, most_steps: int
    ) -> int:
        return inner(derive, kernels, train, asked, course, table, marks, steps, most_steps)

    inner = quick(run_to_the_end, within=True) if is_compiled else run_to_the_end
    return kept(loop) if is_compiled else loop
