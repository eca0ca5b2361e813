"""Runs of a machine with its motor: what was asked, and what became of it."""

from concurrent.futures import ThreadPoolExecutor
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.questions.drive.running import transient
from cranktrain.questions.drive.running.compiling import quick
from cranktrain.questions.drive.running.equation import N_STATE, DriveTrain, Joined, Kernels, joined
from cranktrain.questions.drive.running.gearing import overall_ratio, turning_inertia
from cranktrain.questions.drive.running.transient import RunLimits, run_on
from cranktrain.record import record

REASONS = {
    transient.TIME_OUT: N_("the time asked for is over"),
    transient.SPEED_REACHED: N_("the speed asked for is reached"),
    transient.AT_REST: N_("it stands still and nothing pulls"),
    transient.STALLED: N_("it stands still: the motor's torque is within what load and friction hold"),
    transient.OVERSPEED: N_("the load drives it over the speed allowed"),
    transient.SWINGS: N_("it swings to and fro and does not get over"),
    transient.TOO_MANY_STEPS: N_("it takes more steps than allowed"),
    transient.LINKS_OPEN: N_("the links do not close"),
    transient.GEARING_JAMS: N_("no acceleration or several satisfy the irreversible gearing: it jams"),
}
"""Sentences, not yet translated, of why a run ended."""

DEFAULT_TOLERANCE = 1e-8
_MOST_MARKS = 2000


@record
class Event:
    """Something on the way: one of `REVERSAL`, …, at a time [s], crank angle [rad] and speed [rad/s]."""

    kind: int
    time: float
    angle: float
    speed: float


@record
class Run:
    """What became of a run.

    Attributes
    ----------
    reason : int
        A key of `REASONS`.
    end_time : float
        [s]
    end : Array, shape (6,)
        Crank angle [rad] and speed [rad/s]; work of the motor, of the load, and lost [J]; heat in the motor [J].
    time : Array, shape (n,)
        Of the samples that the run came to. [s]
    states : Array, shape (n, 6)
        At these times, as `end`.
    events : tuple of Event
        In the order of their times.
    residual, supplied : float
        Kinetic energy less what was given and taken; and the work by which to judge it: of motor and load, each by
        amount, and the largest kinetic energy of start and end. [J]
    n_steps : int
    method : str
        Of `tsit5`, `LSODA`, `Radau`.
    """

    reason: int
    end_time: float
    end: Array
    time: Array
    states: Array
    events: tuple[Event, ...]
    residual: float
    supplied: float
    n_steps: int
    method: str

    def of_kind(self, kind: int) -> tuple[Event, ...]:
        """Events of one kind."""
        return tuple(event for event in self.events if event.kind == kind)


class Wanted(NamedTuple):
    """How a run starts, ends, and where its state is wanted."""

    start: Array
    limits: RunLimits
    samples: Array
    breaks: Array


def wanted(
    end_time: float,
    *,
    angle: float = 0.0,
    speed: float = 0.0,
    samples: Array | None = None,
    breaks: Array | tuple[float, ...] = (),
    target_speed: float = np.inf,
    overspeed: float = np.inf,
    stops_at_target: bool = False,
    most_reversals: int = 1000,
    most_steps: int = 1_000_000,
    tolerance: float = DEFAULT_TOLERANCE,
    is_timed: bool = False,
) -> Wanted:
    """Say what is wanted of a run; see `RunLimits`. [s, rad, rad/s]

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
    return Wanted(start, limits, np.array(() if samples is None else samples, dtype=float), times)


def run(kernels: Kernels, drive: DriveTrain, asked: Wanted, *, is_compiled: bool = True) -> Run:
    """Run a machine by an explicit method.

    Parameters
    ----------
    kernels : Kernels
    drive : DriveTrain
        Their numbers: floats, arrays of floats, and tuples of them.
    asked : Wanted
    is_compiled : bool, optional
        With Numba; the first run with these kernels compiles.

    Returns
    -------
    Run

    Notes
    -----
    docs/theory/transient, eqs. (26.7) to (26.12).
    """
    parts = joined(kernels, is_compiled)
    loop = loop_of(parts, is_compiled)
    state, table = asked.start.copy(), np.full((len(asked.samples), N_STATE), np.nan)
    marks = np.empty((_MOST_MARKS, 4))
    reason, time, n_steps, n_marks = loop(drive, state, asked.limits, asked.breaks, asked.samples, table, marks)
    noted = sorted((Event(int(row[0]), *map(float, row[1:])) for row in marks[:n_marks]), key=lambda one: one.time)
    is_there = ~np.isnan(table[:, 0])
    residual, supplied = energy_account(parts, drive, asked.start, state)
    return Run(
        reason,
        time,
        state,
        asked.samples[is_there],
        table[is_there],
        tuple(noted),
        residual,
        supplied,
        n_steps,
        "tsit5",
    )


def run_all(kernels: Kernels, cases: list[tuple[DriveTrain, Wanted]], *, n_threads: int = 2) -> list[Run]:
    """Run many machines of the same kernels, compiled, on several threads."""
    first, rest = cases[0], cases[1:]
    done = [run(kernels, *first)]

    def one(case: tuple[DriveTrain, Wanted]) -> Run:
        return run(kernels, *case)

    with ThreadPoolExecutor(n_threads) as pool:
        return done + list(pool.map(one, rest))


def energy_account(parts: Joined, drive: DriveTrain, start: Array, end: Array) -> tuple[float, float]:
    """Kinetic energy gained less work given, and the work by which to judge that. [J] Eq. (26.10)"""
    turning = turning_inertia(drive.gearing)

    def kinetic(state: Array) -> float:
        inertia = parts.kernels.machine(state[0], state[1], np.sign(state[1]), drive.machine)[0]
        return 0.5 * (turning + inertia) * state[1] ** 2

    before, after = kinetic(start), kinetic(end)
    given = end[2] - end[3] - end[4]
    return float(after - before - given), float(max(abs(end[2]) + abs(end[3]), before, after))


def motor_speed(run: Run, drive: DriveTrain) -> Array:
    """Speed at the motor's shaft at the samples. [rad/s]"""
    return run.states[:, 1] * overall_ratio(drive.gearing)


@cache
def loop_of(parts: Joined, is_compiled: bool) -> Any:
    """Loop of a run with its kernels in it: given to it at every call, they would cost more than the run."""
    derive, kernels = parts

    def loop(
        drive: DriveTrain, state: Array, limits: RunLimits, breaks: Array, samples: Array, table: Array, marks: Array
    ) -> tuple[int, float, int, int]:
        return inner(derive, kernels, drive, state, 0.0, limits, breaks, samples, table, marks)

    inner = quick(run_on) if is_compiled else run_on
    return quick(loop) if is_compiled else loop
