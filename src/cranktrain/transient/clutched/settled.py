"""The stroke that a press settles to: with the command that ends it on top, and one after another at an even pace."""

import math
from dataclasses import replace

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.record import record
from cranktrain.transient.clutched.equation import ANGLE, MOTOR_HEAT, MOTOR_WORK, WHEEL, Press
from cranktrain.transient.clutched.runs import RESTS, PressPlan, PressRun
from cranktrain.transient.clutched.stroke import RECOVERED_PART, PressStroke, recovered, single_stroke
from cranktrain.transient.clutched.walking import run_press
from cranktrain.transient.equation import Kernels

_MOST_TRIALS = 30
_SETTLED = 1e-9
"""Of the angle in rad, of the flywheel's speed in parts of its idle one."""
_LONGEST = 20.0
"""That a stroke may take where no pace is asked for. [s]"""
_LONGEST_RECOVERY = 60.0
"""[s]"""


@record
class Pace:
    """One stroke after another, each beginning as the one before it did.

    Attributes
    ----------
    period : float
        From one command to start to the next. [s]
    waiting : PressRun
        From the end of the stroke to the next command.
    motor_power, motor_heat, clutch_power, brake_power : float
        Means over the period: what the motor gives, and what turns to heat. [W]
    """

    period: float
    waiting: PressRun
    motor_power: float
    motor_heat: float
    clutch_power: float
    brake_power: float


@record
class SettledStroke:
    """A stroke as it is asked for.

    Attributes
    ----------
    is_found : bool
        Whether there is one; if not, `stroke` is the last one tried, whose run may say why.
    command_angle : float
        Crank angle of the command that ends it. [rad]
    wheel_speed : float
        Of the flywheel at its beginning. [rad/s]
    stroke : PressStroke
    pace : Pace or None
        Where one is asked for, and kept.
    """

    is_found: bool
    command_angle: float
    wheel_speed: float
    stroke: PressStroke
    pace: Pace | None


def settled_stroke(
    kernels: Kernels,
    press: Press,
    plan: PressPlan,
    *,
    idle_speed: float,
    start_angle: float = 0.0,
    period: float = math.nan,
) -> SettledStroke:
    """Find the command that ends a stroke a turn behind its start, the speed with which strokes repeat, or both.

    Parameters
    ----------
    kernels : Kernels
    press : Press
    plan : PressPlan
        With a command angle where that is given; infinite asks for it. Its end time is not asked for.
    idle_speed : float
        Of the flywheel without strokes, with which a stroke begins unless a pace is asked for. [rad/s]
    start_angle : float, optional
        [rad]
    period : float, optional
        From one command to start to the next; NaN of a stroke by itself. [s]

    Returns
    -------
    SettledStroke

    Notes
    -----
    By Broyden's method; docs/theory/clutched-drive, eqs. (30.13) and (30.15).
    """
    search = _Search(kernels, press, plan, idle_speed, start_angle, period)
    top = start_angle + TURN
    x = np.array([top - 1e-9, 1.0]) if search.seeks_command else np.array([plan.command_angle, 1.0])
    inverse = np.diag([1.0, -1.0])
    missed, stroke, waiting = search.missed(x)
    for _trial in range(_MOST_TRIALS):
        if np.all(np.abs(missed) <= _SETTLED):
            return search.found(x, stroke, waiting)
        if not np.all(np.isfinite(missed)):
            break
        step = -inverse @ missed
        ahead = x + step
        if not start_angle < ahead[0] <= top or not ahead[1] > 0:
            break
        before, (missed, stroke, waiting) = missed, search.missed(ahead)
        moved = inverse @ (missed - before)
        inverse += np.outer(step - moved, step @ inverse) / (step @ moved)
        x = ahead
    return SettledStroke(False, math.nan, math.nan, stroke, None)


class _Search:
    """What is sought: angle of the command, and the flywheel's speed in parts of its idle one."""

    def __init__(
        self, kernels: Kernels, press: Press, plan: PressPlan, idle: float, start_angle: float, period: float
    ) -> None:
        self.kernels, self.press, self.idle, self.start_angle, self.period = kernels, press, idle, start_angle, period
        self.seeks_command, self.seeks_speed = math.isinf(plan.command_angle), math.isfinite(period)
        self.plan = plan._replace(end_time=period if self.seeks_speed else _LONGEST)

    def stroke(self, x: Array) -> PressStroke:
        """Stroke of a trial."""
        plan = self.plan._replace(command_angle=float(x[0]))
        speed = float(x[1]) * self.idle
        return single_stroke(
            self.kernels, self.press, plan, wheel_speed=speed, start_angle=self.start_angle, recovery_limit=0.0
        )

    def missed(self, x: Array) -> tuple[Array, PressStroke, PressRun | None]:
        """By how much the end is off the top, and the flywheel quicker at the next start; 0 of what is not sought."""
        stroke, waiting = self.stroke(x), None
        if stroke.run.reason != RESTS:
            return np.full(2, math.nan), stroke, None
        off, quicker = 0.0, 0.0
        if self.seeks_command:
            off = float(stroke.run.end.state[ANGLE]) - self.start_angle - TURN
        if self.seeks_speed:
            plan = self.plan._replace(command_angle=math.inf, ends_at_rest=False)
            waiting = run_press(self.kernels, self.press, stroke.run.end, plan)
            quicker = float(waiting.end.state[WHEEL]) / self.idle - float(x[1])
        return np.array([off, quicker]), stroke, waiting

    def found(self, x: Array, stroke: PressStroke, waiting: PressRun | None) -> SettledStroke:
        """Stroke with its recovery, and means over the period."""
        recovery = recovered(self.kernels, self.press, stroke.run, self.plan, RECOVERED_PART, _LONGEST_RECOVERY)
        stroke = replace(stroke, recovery_time=recovery)
        pace = None
        if waiting is not None:
            parts = (MOTOR_WORK, MOTOR_HEAT)
            work, heat = (float(waiting.end.state[part]) / self.period for part in parts)
            own = stroke.clutch_heat / self.period, stroke.brake_heat / self.period
            pace = Pace(self.period, waiting, work, heat, *own)
        return SettledStroke(True, float(x[0]), float(x[1]) * self.idle, stroke, pace)
