"""A start: the run of one machine with its motor over time, from rest to whatever ends it."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import N_, Words, _
from cranktrain.motion import Array
from cranktrain.questions.reduction.unloaded import with_open_valves
from cranktrain.questions.start.asked import MovingParts, StartAsked
from cranktrain.questions.start.case import StartCase, Switching, start_kernels
from cranktrain.questions.start.curves import at_times, close_times, curves_of, each_once, numbers_from
from cranktrain.questions.start.method import Runs, methods_of
from cranktrain.questions.start.notes import start_notes
from cranktrain.questions.start.record import (
    GasOverTime,
    PartOfRun,
    RanFacts,
    RanStart,
    ReadyStarts,
    StartEvent,
    StartRun,
)
from cranktrain.questions.start.spans import (
    LONGEST,
    MOST_REVERSALS,
    MOST_STEPS,
    N_EVEN,
    NEARLY,
    followed_until,
    is_there_already,
    some_cycles_on,
)
from cranktrain.saying.wording import number
from cranktrain.transient import endings
from cranktrain.transient.equation import MOTOR_WORK, SPEED, DriveTrain
from cranktrain.transient.reduced import ReducedMachine
from cranktrain.transient.runs import REASONS, Progress, TransientRun, Wanted, wanted
from cranktrain.transient.step import N_STATE

MOST_SAMPLES = 1_000_000

EVENTS = {
    endings.REVERSAL: N_("turns round"),
    endings.DEAD_POSITION: N_("dead position"),
    endings.SPEED_PASSED: N_("speed reached"),
    endings.HELD: N_("is held"),
    endings.SET_OFF: N_("sets off"),
}
NEARLY_STEADY = N_("98 % of its steady speed")
SETTLED = N_("it has run up: two cycles more at its steady speed")
SETTLED_BACKWARD = N_("it has run up the other way: two cycles more at its steady speed")
STEPS_OVER = N_("60000 steps are over, the most of a start")
LONGEST_OVER = N_("60 s are over, the most without a duration")
OVERSPEED = N_("it turns faster than overspeed allows")


def start_run(ready: ReadyStarts, parts: MovingParts, asked: StartAsked) -> StartRun:
    """Run the start of the only design to its end, and say what of the file it leaves out.

    Notes
    -----
    docs/theory/transient, eqs. (26.7) to (26.13); of a press docs/theory/clutched-drive, eqs. (30.1) to (30.15).
    """
    run = ready.run(0, asked)
    return replace(run, notes=tuple(start_notes(parts, run)))


def run_start(case: StartCase, asked_for: StartAsked) -> StartRun:
    """Run a start, with curves of all of it."""
    return _together(ran_start(case, asked_for))


def ran_start(case: StartCase, asked_for: StartAsked) -> RanStart:
    """Run a start: to its end, and once more for the states on the way where its steps do not tell them."""
    run = methods_of([case])[0]
    first = list(_runs(case, run, _NO_TIMES, np.inf, asked_for.progress, keeps_steps=True))
    last = first[-1][1]
    end = first[-1][0].start + last.end_time
    even = np.linspace(0.0, end, N_EVEN)
    asked = wanted_times(asked_for, case.start.interval, case.interval_text, end, even)
    ends = np.concatenate([found.steps[:, :2] + np.array([span.start, 0.0]) for span, found in first])
    close = close_times(case, ends)
    times = [even, close] if asked is even else [even, asked, close]
    samples = each_once(np.sort(np.concatenate(times), kind="stable"))
    if all(found.tells_within for _span, found in first):
        runs = [(span, found.sampled(_within(span, samples), is_compiled=False)) for span, found in first]
    else:
        runs = list(_runs(case, run, samples, end if last.reason == endings.STOPPED else np.inf, None))
    return RanStart(case, runs, last.reason, asked)


_NO_TIMES = np.empty(0)


def wanted_times(asked: StartAsked, interval: float, text: str, end: float, even: Array) -> Array:
    """Times at which curves are wanted, up to the end: those asked for, by the file's interval, else `even`. [s]"""
    if asked.times is not None:
        if np.any(asked.times > end):
            allowed = _("must be at most {end}, when it ends", end=number(end, "s"))
            raise InputError([Problem("at", number(float(np.max(asked.times)), "s"), allowed)])
        return asked.times
    if math.isinf(interval):
        return even
    n = end / interval + 1
    if n > MOST_SAMPLES:
        allowed = _(
            "must be at least {least}: more than {n} times are too many",
            least=number(end / MOST_SAMPLES, "s"),
            n=MOST_SAMPLES,
        )
        raise InputError([Problem("drive.start.interval", text, allowed)])
    return np.arange(math.floor(n), dtype=np.float64) * interval


def _runs(
    case: StartCase,
    run: Runs,
    samples: Array,
    end: float,
    progress: Progress | None,
    *,
    keeps_steps: bool = False,
) -> Iterator[tuple[PartOfRun, TransientRun]]:
    """Run span by span, each from where the last one ended, until one ends for a reason of its own."""
    angle, speed, now = case.start.angle + case.zero, case.start.speed, 0.0
    spans, kernels = list(spans_of(case)), start_kernels(case.motor)
    breaks = tuple(breaks_of(case))
    numbers = list[float]()
    machine, filled = None, case.start.gas_pressure
    while spans:
        span = spans.pop(0)
        if span.to_rest and speed <= 0:
            continue
        span = _from_speed(case, span._replace(start=now, end=min(span.end, end)), speed)
        if span.machine is not machine:
            numbers = numbers_from(span.machine, angle, filled)
        filled = math.nan
        asked, train = _wanted(case, span, angle, speed, samples, breaks), _train(case, span, numbers)
        telling = _from(span.start, progress)
        found = run(kernels, train, asked, is_compiled=False, progress=telling, keeps_steps=keeps_steps)
        yield span, found
        is_over = found.reason == endings.TIME_OUT
        now = span.end if is_over else span.start + found.end_time
        until = now if spans else _followed(case, span, found, speed)
        angle, speed = float(found.end[0]), float(found.end[1])
        numbers, machine = found.machine, span.machine
        if now < until and now < end:
            spans = [PartOfRun(now, until, np.inf, span.machine)]
        elif now >= end or not (is_over or (span.to_rest and found.reason == endings.SWINGS)):
            return


def _from_speed(case: StartCase, span: PartOfRun, speed: float) -> PartOfRun:
    """Some cycles in place of a speed to reach, where that is reached already."""
    if case.is_to_settle and is_there_already(speed, span.target):
        return span._replace(target=np.inf, end=min(span.end, some_cycles_on(span.start, case.cycle_time)))
    return span


def _followed(case: StartCase, span: PartOfRun, found: TransientRun, speed: float) -> float:
    """When a span is over that follows on the last one, which began at a speed; its own end where none does. [s]"""
    ended = span.start + found.end_time
    if not case.is_to_settle:
        return ended
    speeds = speed, float(found.end[1])
    return followed_until(found.reason, ended, span.target, speeds, case.steady_speed, case.cycle_time)


def _from(start: float, progress: Progress | None) -> Progress | None:
    """Tell progress with times counted on."""
    return None if progress is None else lambda time, angle, speed: progress(start + time, angle, speed)


def _switches(case: StartCase) -> tuple[float, float, float]:
    """When the motor is switched off, when it is reversed, and when the brake's torque comes. [s]"""
    return case.start.motor_off, case.start.motor_reversed, case.start.brake_on + case.brake.begins


def breaks_of(case: StartCase) -> Iterator[float]:
    """When motor or brake jump, or have a corner: where they are switched, and the motor's own starter. [s]"""
    off, back, braked = _switches(case)
    yield from (off, back, braked, braked + case.brake.rise_time)
    if case.motor is None:
        return
    times = [float(np.ravel(at)[0]) for at in case.motor.law.breaks(case.motor.numbers).times]
    yield from (at for at in times if at < min(off, back))
    yield from (back + at for at in times if back + at < off)


def _train(case: StartCase, span: PartOfRun, machine: list[float]) -> DriveTrain:
    """Numbers of a span's kernels."""
    off, back, braked = _switches(case)
    return DriveTrain(
        machine,
        Switching(case.motor_numbers, off, back, span.start),
        case.brake._replace(begins=braked - span.start),
        case.gearing,
        case.place,
    )


def _within(span: PartOfRun, samples: Array) -> Array:
    """Samples of a span, from its beginning on. [s]"""
    return samples[(samples >= span.start) & (samples <= span.end)] - span.start


def _wanted(
    case: StartCase, span: PartOfRun, angle: float, speed: float, samples: Array, breaks: Sequence[float]
) -> Wanted:
    """What is wanted of a span."""
    return wanted(
        span.end - span.start,
        angle=angle,
        speed=speed,
        samples=_within(span, samples),
        breaks=tuple(at - span.start for at in breaks if span.start < at < span.end),
        corners=case.corners,
        rows=case.rows,
        period=case.cycle,
        target_speed=span.target,
        overspeed=case.start.overspeed,
        stops_at_target=bool(np.isfinite(span.target)),
        most_steps=MOST_STEPS,
        most_reversals=1 if span.to_rest else MOST_REVERSALS,
        tolerance=case.start.tolerance,
        is_timed=True,
    )


def _together(ran: RanStart) -> StartRun:
    """One run of all its spans; in whole, and at the times that were asked for."""
    case, runs = ran.case, ran.runs
    time, state = counted_on(runs)
    wanted_too = np.flatnonzero(np.isin(time, ran.asked))
    whole, pressure = curves_of(case, time, state, loaded(runs))
    return StartRun(
        reason=reason_of(ran),
        time=time[wanted_too],
        curves=at_times(whole, wanted_too),
        whole_time=time,
        whole=whole,
        events=tuple(events_of(ran)),
        residual=residual_of(ran),
        supplied=supplied_of(ran, np.max(whole.kinetic_energy)),
        gas=GasOverTime(case.chambers, pressure, wanted_too),
        tolerance=case.start.tolerance,
        n_steps=sum(found.n_steps for _, found in runs),
        method=runs[-1][1].method,
    )


def counted_on(runs: Sequence[tuple[PartOfRun, TransientRun]]) -> tuple[Array, Array]:
    """Times and states of all spans of a run, times counted on, works added up, shapes (n,) and (n, 6)."""
    times, states = list[Array](), list[Array]()
    before = np.zeros(N_STATE)
    for at, (span, found) in enumerate(runs):
        is_last = at == len(runs) - 1
        kept = slice(None) if is_last else found.time < found.end_time
        times.append(found.time[kept] + span.start)
        states.append(found.states[kept] + before)
        before[MOTOR_WORK:] += found.end[MOTOR_WORK:]
    return np.concatenate(times), np.concatenate(states)


def residual_of(ran: RanStart) -> float:
    """Kinetic energy at the end less what was given and taken. [J]"""
    return sum(found.residual for _, found in ran.runs)


def supplied_of(ran: RanStart, kinetic: float) -> float:
    """The work by which to judge what is left over, by the largest kinetic energy on the way. [J]"""
    return max(sum(found.supplied for _, found in ran.runs), float(kinetic))


def loaded(runs: Sequence[tuple[PartOfRun, TransientRun]]) -> list[tuple[float, ReducedMachine]]:
    """From when on it is which machine: a compressor that is loaded is another. [s]"""
    found = list[tuple[float, ReducedMachine]]()
    for span, _found in runs:
        if not found or span.machine is not found[-1][1]:
            found.append((span.start, span.machine))
    return found


def reason_of(ran: RanStart) -> Words:
    """Why it ended."""
    return why_ended(ran.case, how_it_ran(ran))


def why_ended(case: StartCase, told: RanFacts) -> Words:
    """Why a design ended, by what was asked for."""
    return _(_reason(case, told))


def _reason(case: StartCase, told: RanFacts) -> str:
    """The same, not yet translated."""
    if told.reason == endings.OVERSPEED:
        return OVERSPEED
    if told.reason == endings.TOO_MANY_STEPS and told.n_steps >= MOST_STEPS:
        return STEPS_OVER
    if told.reason != endings.TIME_OUT or np.isfinite(case.start.duration):
        return REASONS[told.reason]
    if told.end_time >= LONGEST:
        return LONGEST_OVER
    return SETTLED if told.end_speed >= 0 else SETTLED_BACKWARD


def how_it_ran(ran: RanStart) -> RanFacts:
    """What is told of a start besides its samples."""
    span, last = ran.runs[-1]
    residual, supplied = residual_of(ran), sum(found.supplied for _span, found in ran.runs)
    return RanFacts(ran.reason, last.n_steps, residual, supplied, span.start + last.end_time, float(last.end[SPEED]))


class Happened(NamedTuple):
    """What happened on the way of a start: which it was, with time, angle as shown and speed, shape (event, 3)."""

    sorts: tuple[str, ...]
    rows: Array

    @property
    def n_reversals(self) -> int:
        """How often the crank turned round."""
        return self.sorts.count(EVENTS[endings.REVERSAL])


def happened(case: StartCase, marks: Array) -> Happened:
    """What happened on the way, by events counted on; a crank that stops and is held does not turn round."""
    kind, time = marks[:, 0], marks[:, 1]
    turns = kind == endings.REVERSAL
    own = marks[~(turns & np.isin(time, time[kind == endings.HELD]))] if np.any(turns) else marks
    names = EVENTS | {endings.SPEED_PASSED: NEARLY_STEADY} if case.is_to_settle else EVENTS
    return Happened(tuple(names[one] for one in own[:, 0].tolist()), own[:, 1:] - np.array([0.0, case.zero, 0.0]))


def marks_of(ran: RanStart) -> Array:
    """Events of all parts of a run, times counted on."""
    marks = np.concatenate([found.marks for _span, found in ran.runs])
    marks[:, 1] += np.repeat([span.start for span, _found in ran.runs], [len(found.marks) for _span, found in ran.runs])
    return marks


def events_of(ran: RanStart) -> Iterator[StartEvent]:
    """What happened on the way, one by one."""
    sorts, rows = happened(ran.case, marks_of(ran))
    return (StartEvent(sort, *row) for sort, row in zip(sorts, rows.tolist(), strict=True))


def spans_of(case: StartCase) -> Iterator[PartOfRun]:
    """Parts of a run: until a compressor is loaded; until it nearly runs as it will, and a little more; or as asked.

    A motor that is reversed stops the crank first, and then runs it up the other way.
    """
    end = case.start.duration if np.isfinite(case.start.duration) else LONGEST
    asked, back = case.start.until_speed, case.start.motor_reversed
    begins = min(case.start.unloaded_until, end)
    if begins > 0:
        yield PartOfRun(0.0, begins, asked, with_open_valves(case.machine))
    if case.is_to_settle and back < end:
        if back > begins:
            yield PartOfRun(begins, back, np.inf, case.machine)
        yield PartOfRun(back, end, np.inf, case.machine, to_rest=True)
    yield PartOfRun(begins, end, NEARLY * case.steady_speed if case.is_to_settle else asked, case.machine)
