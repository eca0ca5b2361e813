"""One stroke after another at an even pace: with which speed the flywheel begins each of them."""

import math

from cranktrain.questions.drive.clutched.equation import MOTOR_HEAT, MOTOR_WORK, WHEEL, Press
from cranktrain.questions.drive.clutched.runs import RESTS, PressPlan, PressRun
from cranktrain.questions.drive.clutched.stroke import PressStroke, single_stroke
from cranktrain.questions.drive.clutched.walking import run_press
from cranktrain.questions.drive.running.equation import Kernels
from cranktrain.record import record

_MOST_TRIALS = 40
_SETTLED = 1e-12


@record
class RepeatedStroke:
    """A stroke that begins as the one before it did; NaN if there is none.

    Attributes
    ----------
    period : float
        [s]
    wheel_speed : float
        Of the flywheel at the beginning. [rad/s]
    stroke : PressStroke
        The last one tried: where it does not end at rest, its run says why.
    is_in_time : bool
        Whether it is at rest before the next one begins.
    motor_power, motor_heat, clutch_power, brake_power : float
        Means over the period: what the motor gives, and what turns to heat. [W]
    """

    period: float
    wheel_speed: float
    stroke: PressStroke
    is_in_time: bool
    motor_power: float
    motor_heat: float
    clutch_power: float
    brake_power: float


def repeated_stroke(
    kernels: Kernels,
    press: Press,
    plan: PressPlan,
    *,
    period: float,
    idle_speed: float,
    start_angle: float = 0.0,
) -> RepeatedStroke:
    """Stroke that repeats itself every so often, all beginning at the same crank angle.

    Parameters
    ----------
    kernels : Kernels
    press : Press
    plan : PressPlan
        With the command angle; its end time is not asked for.
    period : float
        From one command to start to the next. [s]
    idle_speed : float
        Of the flywheel without strokes, from which it is looked for. [rad/s]
    start_angle : float, optional
        [rad]

    Returns
    -------
    RepeatedStroke

    Notes
    -----
    By the secant method in the speed; docs/theory/clutched-drive, eq. (30.15).
    """
    whole = plan._replace(end_time=period)

    def after(speed: float) -> tuple[PressStroke, PressRun | None]:
        stroke = single_stroke(
            kernels, press, whole, wheel_speed=speed, start_angle=start_angle, recovery_limit=0.0,
        )  # fmt: skip
        if stroke.run.reason != RESTS:
            return stroke, None
        waiting = whole._replace(command_angle=math.inf, ends_at_rest=False)
        return stroke, run_press(kernels, press, stroke.run.end, waiting)

    speed, grown, before = idle_speed, math.nan, math.nan
    stroke, wait = after(speed)
    for _ in range(_MOST_TRIALS):
        if wait is None:
            return _none(period, stroke, is_in_time=False)
        excess = float(wait.end.state[WHEEL]) - speed
        if abs(excess) <= _SETTLED * idle_speed:
            return _found(period, speed, stroke, wait)
        slope = (excess - grown) / (speed - before) if math.isfinite(before) else -1.0
        before, grown = speed, excess
        speed -= excess / (slope if slope < 0 else -1.0)
        stroke, wait = after(speed)
    return _none(period, stroke, is_in_time=True)


def _found(period: float, speed: float, stroke: PressStroke, wait: PressRun) -> RepeatedStroke:
    """Means over the period."""
    work, heat = (float(wait.end.state[part]) / period for part in (MOTOR_WORK, MOTOR_HEAT))
    return RepeatedStroke(
        period, speed, stroke, True, work, heat, stroke.clutch_heat / period, stroke.brake_heat / period
    )


def _none(period: float, stroke: PressStroke, *, is_in_time: bool) -> RepeatedStroke:
    """No stroke repeats itself."""
    return RepeatedStroke(period, math.nan, stroke, is_in_time, math.nan, math.nan, math.nan, math.nan)
