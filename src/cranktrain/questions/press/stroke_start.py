"""A start that is a single stroke of a press: its curves over time, its events, and the longest stop on its way."""

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import partial

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import N_, _
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.questions.press.case import PressCase
from cranktrain.questions.press.strokes import PressStrokes
from cranktrain.questions.start.asked import StartAsked
from cranktrain.questions.start.curves import at_times
from cranktrain.questions.start.parts import DeclaredStart
from cranktrain.questions.start.record import ReadyStarts, StartCurves, StartEvent, StartRun, StrokeRun
from cranktrain.questions.start.starting import wanted_times
from cranktrain.transient.clutched.equation import (
    ANGLE,
    BRAKE_HEAT,
    CLUTCH_HEAT,
    LOAD_WORK,
    LOST_WORK,
    MOTOR_HEAT,
    MOTOR_WORK,
    SPEED,
    WHEEL,
    kinetic_energy,
)
from cranktrain.transient.clutched.runs import (
    AT_STAND,
    COMMAND,
    LOCKED,
    LOOSE,
    OFF,
    PRESS_REASONS,
    PressRun,
    turning,
)
from cranktrain.transient.clutched.settled import SettledStroke
from cranktrain.transient.clutched.stopping import WorstStop, worst_stop

_N_SAMPLES = 1001
_N_STOPS, _N_ZOOMS = 24, 1
_LONGEST_STOP = 10.0
"""[s]"""
_METHOD = "tsit5"

STROKE_EVENTS = {
    COMMAND: N_("command to stop"),
    LOCKED: N_("clutch locks"),
    LOOSE: N_("clutch breaks loose"),
    AT_STAND: N_("crank stands"),
    OFF: N_("crank sets off"),
}
WAITED = N_("the next stroke begins")


def ready_strokes(strokes: PressStrokes, start: DeclaredStart) -> ReadyStarts:
    """Strokes of a press: from the command until it rests, or until the next where a pace is asked for.

    Notes
    -----
    docs/theory/clutched-drive, eqs. (30.1) to (30.15).
    """
    return ReadyStarts(partial(_run_of, strokes, start), None)


def _run_of(strokes: PressStrokes, start: DeclaredStart, design: int, asked: StartAsked) -> StartRun:
    """Run the stroke of a design, or refuse it; if none is found, the last one tried is shown."""
    case, settled, why_none = strokes.cases[design], strokes.settled[design], strokes.why_none[design]
    if case is None or settled is None:
        raise InputError([Problem("drive.stroke", None, why_none)])
    run = _run(case, settled, start.of(design).interval, start.texts.get("interval", ""), asked)
    return run if settled.is_found else replace(run, reason=why_none)


def _run(
    case: PressCase, settled: SettledStroke, interval: float, interval_text: str, asked_for: StartAsked
) -> StartRun:
    """Run a stroke that is there."""
    runs = [settled.stroke.run, *([] if settled.pace is None else [settled.pace.waiting])]
    end = float(runs[-1].end.time)
    even = np.linspace(0.0, end, _N_SAMPLES)
    whole_time = np.unique(np.concatenate([*(run.times for run in runs), even]))
    asked = wanted_times(asked_for, interval, interval_text, end, even)
    each = np.union1d(whole_time, asked)
    curves = _curves(case, _states(runs, each))
    whole = at_times(curves, np.searchsorted(each, whole_time))
    reason = _(WAITED) if settled.pace is not None else _(PRESS_REASONS[settled.stroke.run.reason])
    return StartRun(
        reason=reason,
        time=asked,
        curves=at_times(curves, np.searchsorted(each, asked)),
        whole_time=whole_time,
        whole=whole,
        events=tuple(_events(case, runs)),
        residual=sum(run.residual for run in runs),
        supplied=sum(run.supplied for run in runs),
        tolerance=case.plan.tolerance,
        n_steps=sum(run.n_steps for run in runs),
        method=_METHOD,
        stroke=StrokeRun(settled, partial(_longest_stop, case, settled)),
    )


def _states(runs: list[PressRun], times: Array) -> Array:
    """States at times, each by the run in which it lies."""
    first = times <= runs[0].times[-1]
    return np.concatenate([run.at(times[own]) for run, own in zip(runs, (first, ~first), strict=False)])


def _curves(case: PressCase, states: Array) -> StartCurves:
    """Speeds, torques, powers and energies at states, shape (n, 9)."""
    press, kernels = case.press, case.kernels
    at_motor = states[:, WHEEL] * press.motor_ratio
    torque = np.array([kernels.motor(speed, 0.0, press.motor) for speed in at_motor.tolist()])
    each = zip(states[:, ANGLE].tolist(), states[:, SPEED].tolist(), strict=True)
    load = np.array([kernels.machine(angle, speed, np.sign(speed), press.machine)[2] for angle, speed in each])
    return StartCurves(
        crank_angle_turned=states[:, ANGLE] - case.zero,
        crank_speed=states[:, SPEED],
        motor_speed=at_motor,
        motor_torque=torque,
        load_torque=load,
        motor_power=torque * at_motor,
        motor_work=states[:, MOTOR_WORK],
        load_work=states[:, LOAD_WORK],
        lost_work=states[:, LOST_WORK] + states[:, CLUTCH_HEAT] + states[:, BRAKE_HEAT],
        kinetic_energy=np.array([kinetic_energy(kernels, press, state) for state in states]),
        motor_heat=states[:, MOTOR_HEAT],
    )


def _events(case: PressCase, runs: list[PressRun]) -> Iterator[StartEvent]:
    """What happened on the way, by time."""
    for run in runs:
        for event in run.events:
            if event.kind in STROKE_EVENTS:
                state = event.moment.state
                angle, speed = float(state[ANGLE]) - case.zero, float(state[SPEED])
                yield StartEvent(STROKE_EVENTS[event.kind], event.moment.time, angle, speed)


def _longest_stop(case: PressCase, settled: SettledStroke) -> WorstStop | None:
    """The longest stop that a command on the way of a stroke could lead to; None where there is no stroke.

    Of a press that runs through, its clutch locked, with the flywheel's speed at the stroke's start.
    """
    if not settled.is_found:
        return None
    start = turning(case.press, settled.wheel_speed / case.press.ratio, case.start_angle, case.plan.jumps)
    over = (case.start_angle + 1e-9, case.start_angle + TURN)
    plan = case.plan._replace(end_time=_LONGEST_STOP, command_angle=math.inf)
    return worst_stop(case.kernels, case.press, start, plan, over=over, n_angles=_N_STOPS, n_zooms=_N_ZOOMS)
