"""A single stroke: from rest by the clutch, to rest by the brake, and how long the flywheel takes to recover."""

import math

import numpy as np

from cranktrain.numerics.harmonics import TURN
from cranktrain.record import record
from cranktrain.transient.clutched.equation import ANGLE, BRAKE_HEAT, CLUTCH_HEAT, WHEEL, Press
from cranktrain.transient.clutched.passings import LOOKS, least_within, states_within
from cranktrain.transient.clutched.runs import (
    AT_STAND,
    COMMAND,
    LOCKED,
    LOOSE,
    OFF,
    RESTS,
    WHEEL_RECOVERED,
    PressPlan,
    PressRun,
    at_rest,
)
from cranktrain.transient.clutched.walking import run_press, starting
from cranktrain.transient.equation import Kernels

RECOVERED_PART = 0.99
"""Of the flywheel's speed at the start, at which it counts as recovered: where nothing pulls it comes to it never."""


@record
class PressStroke:
    """A single stroke; NaN for what did not happen.

    Attributes
    ----------
    run : PressRun
        From the command to start until the crank rests, or why it does not.
    slip_time : float
        In which the clutch slips while the crank turns, from when it sets off, all times together. [s]
    locked_at : float
        Crank angle at which it locks first. [rad]
    clutch_heat, brake_heat : float
        [J]
    speed_drop : float
        Of the flywheel, in parts of its speed at the start, the most. [1]
    pressing_drop : float
        From when the clutch has locked to the lowest speed behind it, in the same parts. [1]
    brake_angle, brake_time : float
        From the command until the crank rests. [rad, s]
    stop_angle : float
        Where it rests, from the nearest top dead centre: below 0 before it. [rad]
    stroke_time : float
        From the command to start until it rests. [s]
    recovery_time : float
        From then until the flywheel has `recovered_part` of its speed again; 0 if it still has. [s]
    recovered_part : float
    """

    run: PressRun
    slip_time: float
    locked_at: float
    clutch_heat: float
    brake_heat: float
    speed_drop: float
    pressing_drop: float
    brake_angle: float
    brake_time: float
    stop_angle: float
    stroke_time: float
    recovery_time: float
    recovered_part: float


def single_stroke(
    kernels: Kernels,
    press: Press,
    plan: PressPlan,
    *,
    wheel_speed: float,
    start_angle: float = 0.0,
    recovered_part: float = RECOVERED_PART,
    recovery_limit: float = 60.0,
) -> PressStroke:
    """Run a stroke from a crank at rest, clutch in at once, clutch out and brake on at the plan's command angle.

    Parameters
    ----------
    kernels : Kernels
    press : Press
    plan : PressPlan
    wheel_speed : float
        Of the flywheel at the start. [rad/s]
    start_angle : float, optional
        [rad]
    recovered_part : float, optional
        Of that speed, which counts as recovered.
    recovery_limit : float, optional
        So long is it waited for. [s]

    Returns
    -------
    PressStroke

    Notes
    -----
    docs/theory/clutched-drive, eqs. (30.10) to (30.12).
    """
    begin = starting(at_rest(wheel_speed, start_angle, plan.jumps), press)
    run = run_press(kernels, press, begin, plan)
    locks, commands = run.of_kind(LOCKED), run.of_kind(COMMAND)
    is_over = run.reason == RESTS
    stands = [event.moment for event in run.of_kind(AT_STAND)] or [run.end]
    rest = stands[-1] if is_over else None
    command = commands[0].moment if commands else None
    recovery = recovered(kernels, press, run, plan, recovered_part, recovery_limit) if is_over else math.nan
    return PressStroke(
        run,
        _slip_time(run),
        float(locks[0].moment.state[ANGLE]) if locks else math.nan,
        float(run.end.state[CLUTCH_HEAT]),
        float(run.end.state[BRAKE_HEAT]),
        1 - run.lowest_speed / wheel_speed,
        _pressing_drop(run) / wheel_speed,
        float(rest.state[ANGLE] - command.state[ANGLE]) if rest and command else math.nan,
        rest.time - command.time if rest and command else math.nan,
        math.remainder(float(rest.state[ANGLE]), TURN) if rest else math.nan,
        rest.time - run.start.time if rest else math.nan,
        recovery,
        recovered_part,
    )


def _slip_time(run: PressRun) -> float:
    """How long the crank turns before the command with the clutch on and not locked. [s]"""
    total, since = 0.0, math.nan
    for event in run.events:
        if event.kind in (OFF, LOOSE) and math.isnan(since):
            since = event.moment.time
        elif event.kind in (LOCKED, COMMAND, AT_STAND) and not math.isnan(since):
            total += event.moment.time - since
            since = math.nan
        if event.kind == COMMAND:
            return total
    return total + (0.0 if math.isnan(since) else run.end.time - since)


def _pressing_drop(run: PressRun) -> float:
    """By how much the flywheel's speed falls from the clutch's first locking to the command; NaN if it locks late."""
    locks, commands = run.of_kind(LOCKED), run.of_kind(COMMAND)
    until = commands[0].moment.time if commands else run.end.time
    if not locks or locks[0].moment.time > until:
        return math.nan
    behind = (run.times[:-1] >= locks[0].moment.time) & (run.times[1:] <= until) & (np.diff(run.times) > 0)
    highest = drop = -math.inf
    for step in np.flatnonzero(behind):
        width = run.times[step + 1] - run.times[step]
        speeds = states_within(run.states[step], run.slopes[step], width, LOOKS)[:, WHEEL]
        within = float(np.max(np.maximum.accumulate(speeds) - speeds))
        drop = max(drop, within, highest - least_within(speeds))
        highest = max(highest, -least_within(-speeds))
    return drop if math.isfinite(drop) else 0.0


def recovered(kernels: Kernels, press: Press, run: PressRun, plan: PressPlan, part: float, limit: float) -> float:
    """How long a crank at rest waits for the flywheel; NaN if in vain. [s]"""
    aim = part * float(run.start.state[WHEEL])
    if run.end.state[WHEEL] >= aim:
        return 0.0
    waiting = plan._replace(
        end_time=run.end.time + limit, command_angle=math.inf, passed=(), wheel_speed=aim, ends_at_rest=False
    )
    found = run_press(kernels, press, run.end, waiting)
    rested = run.of_kind(AT_STAND)[-1].moment.time if run.of_kind(AT_STAND) else run.end.time
    return found.end.time - rested if found.reason == WHEEL_RECOVERED else math.nan


def heat_rate_limit(stroke: PressStroke, clutch_power: float, brake_power: float) -> float:
    """Strokes a second that clutch and brake bear, by the power that each gives off in the mean. [1/s]

    docs/theory/clutched-drive, eq. (30.12).
    """
    each = [
        power / heat
        for power, heat in ((clutch_power, stroke.clutch_heat), (brake_power, stroke.brake_heat))
        if heat > 0
    ]
    return min(each, default=math.inf)


def time_limit(stroke: PressStroke) -> float:
    """Strokes a second between which the flywheel recovers. [1/s]"""
    return 1 / (stroke.stroke_time + stroke.recovery_time)
