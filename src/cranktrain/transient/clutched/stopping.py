"""The stop-time measurement: a running press is told to stop at every angle, and what takes longest counts."""

import math

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.record import record
from cranktrain.transient.clutched.equation import ANGLE, BRAKE_HEAT, SPEED, Press
from cranktrain.transient.clutched.runs import (
    ANGLE_PASSED,
    AT_STAND,
    RESTS,
    Moment,
    PressPlan,
)
from cranktrain.transient.clutched.walking import run_press, stopping
from cranktrain.transient.equation import Kernels

_ZOOM = 8
"""Steps in a denser look."""


@record
class StopMeasurement:
    """Stops by angle of the command, each shape (n,); NaN where it does not stop.

    Attributes
    ----------
    command_angle : Array
        [rad]
    speed : Array
        Of the crank at the command. [rad/s]
    angle, time : Array
        From the command until it rests. [rad, s]
    heat : Array
        In the brake. [J]
    reasons : tuple of int
        Of `PRESS_REASONS`.
    worst_angle, worst_time : int
        Where these are largest.
    """

    command_angle: Array
    speed: Array
    angle: Array
    time: Array
    heat: Array
    reasons: tuple[int, ...]
    worst_angle: int
    worst_time: int


def stop_measurement(kernels: Kernels, press: Press, start: Moment, plan: PressPlan) -> StopMeasurement:
    """Stop a press at each of the angles that a plan lists in `passed`, in a run from a moment.

    Parameters
    ----------
    kernels : Kernels
    press : Press
    start : Moment
        Of a press that runs through, `turning`, or of one that starts a stroke, `starting`.
    plan : PressPlan
        Without a command; its end time holds for the run and for each stop.

    Returns
    -------
    StopMeasurement

    Notes
    -----
    docs/theory/clutched-drive, eq. (30.14). The angles are as dense as they are given; between them nothing is known.
    """
    through = plan._replace(command_angle=math.inf, ends_when_passed=True)
    run = run_press(kernels, press, start, through)
    passed = [event.moment for event in run.of_kind(ANGLE_PASSED)]
    found = [_stop(kernels, press, moment, through) for moment in passed]
    angle, time, heat = (np.array([one[index] for one in found], dtype=float) for index in range(3))
    largest = [first_largest(each) if np.isfinite(each).any() else -1 for each in (angle, time)]
    return StopMeasurement(
        np.array([moment.state[ANGLE] for moment in passed]),
        np.array([moment.state[SPEED] for moment in passed]),
        angle,
        time,
        heat,
        tuple(int(one[3]) for one in found),
        *largest,
    )


def _stop(kernels: Kernels, press: Press, moment: Moment, plan: PressPlan) -> tuple[float, float, float, int]:
    """Angle, time and brake's heat of one stop, and the reason of its end."""
    ahead = plan._replace(end_time=moment.time + plan.end_time, passed=())
    run = run_press(kernels, press, stopping(moment, press), ahead)
    if run.reason != RESTS or not run.of_kind(AT_STAND):
        return math.nan, math.nan, math.nan, run.reason
    rest = run.of_kind(AT_STAND)[-1].moment
    turned, heat = (float(rest.state[part] - moment.state[part]) for part in (ANGLE, BRAKE_HEAT))
    return turned, rest.time - moment.time, heat, run.reason


@record
class WorstStop:
    """The longest stop that any command angle leads to: by angle and by time, which need not be the same one.

    Attributes
    ----------
    angle, time : float
        From the command until the crank rests. [rad, s]
    angle_command, time_command : float
        At which crank angle it is given. [rad]
    """

    angle: float
    time: float
    angle_command: float
    time_command: float


def worst_stop(
    kernels: Kernels,
    press: Press,
    start: Moment,
    plan: PressPlan,
    *,
    over: tuple[float, float],
    n_angles: int = 72,
    n_zooms: int = 4,
) -> WorstStop:
    """Find the longest stop over a range of command angles. [rad]

    On even steps first, then between the neighbours of the worst of them, each time four times as dense, and last at
    the vertex of a parabola. NaN if a command does not stop the press at all.
    """

    def measured(low: float, high: float, n: int) -> StopMeasurement:
        angles = np.linspace(low, high, n + 1)
        passed = tuple(float(angle) for angle in angles)
        return stop_measurement(kernels, press, start, plan._replace(passed=passed))

    found = measured(*over, n_angles)
    if not len(found.reasons) or any(reason != RESTS for reason in found.reasons):
        return WorstStop(math.nan, math.nan, math.nan, math.nan)
    results: list[tuple[float, float]] = []
    for values in ("angle", "time"):
        near, step = found, (over[1] - over[0]) / n_angles
        best = _largest(near, values)
        for _ in range(n_zooms):
            near = measured(max(over[0], best[1] - step), min(over[1], best[1] + step), _ZOOM)
            best, step = max(best, _largest(near, values)), 2 * step / _ZOOM
        vertex = _vertex(near, values)
        if vertex is not None:
            best = max(best, _largest(measured(vertex, vertex, 0), values))
        results.append(best)
    (angle, at_angle), (time, at_time) = results
    return WorstStop(angle, time, at_angle, at_time)


def _vertex(found: StopMeasurement, values: str) -> float | None:
    """Angle of the command at the vertex of a parabola through the worst stop and its neighbours."""
    each = found.angle if values == "angle" else found.time
    at = first_largest(each)
    if not 0 < at < len(each) - 1:
        return None
    left, middle, right = each[at - 1 : at + 2].tolist()
    bend = left - 2 * middle + right
    step = float(found.command_angle[at + 1] - found.command_angle[at])
    return float(found.command_angle[at]) + 0.5 * step * (left - right) / bend if bend < 0 else None


def _largest(found: StopMeasurement, values: str) -> tuple[float, float]:
    """Largest of angles or times, and the angle of its command."""
    each = found.angle if values == "angle" else found.time
    at = first_largest(each)
    return float(each[at]), float(found.command_angle[at])
