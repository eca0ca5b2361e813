"""Where in a step the speed passes a level, or any curve passes 0."""

from collections.abc import Callable
from typing import Any

from cranktrain.questions.drive.running.step import ROW, within

NOT_PASSED = 2.0
_N_LOOKS = 8
_MOST_LOOKS = 200
_PART_CLOSE = 1e-9
"""Of a step's part: the step is repeated to the event itself afterwards."""


def crossing(value: Callable[[float, Any], float], low: float, high: float, closeness: float, parts: Any) -> float:
    """Where a curve has changed its sign between two places, by chords and halving in turn.

    Parameters
    ----------
    value : callable
        (place, parts) → of one sign at `low`, of the other or 0 at `high`.
    low, high : float
        Either may be the greater.
    closeness : float
        How near to the crossing will do; two roundings do in any case.
    parts
        What the curve needs.

    Returns
    -------
    float
        On the side of `high`.
    """
    before, after = value(low, parts), value(high, parts)
    for look in range(_MOST_LOOKS):
        if abs(high - low) <= closeness + 4.5e-16 * (abs(low) + abs(high)):
            break
        middle = high - after * (high - low) / (after - before) if look % 3 < 2 else 0.5 * (low + high)
        if not (middle - low) * (middle - high) < 0:
            middle = 0.5 * (low + high)
        now = value(middle, parts)
        if now * before > 0:
            low, before = middle, now
            after *= 0.5
        else:
            high, after = middle, now
            before *= 0.5
    return high


def passed_level(course: Any, width: float, level: float, sign: float) -> float:
    """First part θ of a step at which sign·(ω − level) rises to 0 from below; `NOT_PASSED` where it does not.

    Where the speed turns back within the step it is looked at between the ends as well.
    """
    slopes = course.slopes
    turns_back = slopes[1] * slopes[6 * ROW + 1] < 0
    if sign * (course.ahead[1] - level) < 0 and not turns_back:
        return NOT_PASSED
    n_looks = _N_LOOKS if turns_back else 1
    before = 0.0
    is_below = sign * (course.state[1] - level) < 0
    for look in range(1, n_looks + 1):
        theta = look / n_looks
        speed = course.ahead[1] if look == n_looks else within(course.state, slopes, width, theta, 1)
        if sign * (speed - level) < 0:
            is_below = True
            before = theta
        elif is_below:
            return crossing(speed_less, before, theta, _PART_CLOSE, (course.state, slopes, width, level))
    return NOT_PASSED


def passed_angle(course: Any, width: float, angle: float) -> float:
    """Part θ of a step at which the crank passes an angle that lies in it."""
    return crossing(angle_less, 0.0, 1.0, _PART_CLOSE, (course.state, course.slopes, width, angle))


def angle_of_dead_position(machine: Any, numbers: Any, sense: float, low: float, high: float) -> float:
    """Crank angle between two at which x′ of what is driven passes 0."""
    return crossing(output_rate, low, high, 0.0, (numbers, machine, sense))


def speed_less(theta: float, parts: Any) -> float:
    """Speed at a part of a step, less a level. [rad/s]"""
    state, slopes, width, level = parts
    return within(state, slopes, width, theta, 1) - level


def angle_less(theta: float, parts: Any) -> float:
    """Crank angle at a part of a step, less another. [rad]"""
    state, slopes, width, level = parts
    return within(state, slopes, width, theta, 0) - level


def output_rate(angle: float, parts: Any) -> float:
    """x′ of what is driven, at rest. [m/rad or 1]"""
    numbers, machine, sense = parts
    return machine(angle, 0.0, sense, numbers)[3]
