"""Where in a step the speed passes a level, or any curve passes 0."""

from collections.abc import Callable
from typing import Any

from cranktrain.transient.course import OUTPUT, SENSE
from cranktrain.transient.equation import ANGLE, SPEED
from cranktrain.transient.step import BESIDE, ROW, within

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


def first_rise(value: Callable[[float, Any], float], start: float, parts: Any) -> tuple[float, float]:
    """Between which two parts of a step a curve first rises to 0 from below; twice `NOT_PASSED` where it does not.

    It is looked at between the ends too, and at the peak of a parabola through the greatest values: it may pass 0 and
    come back.

    Parameters
    ----------
    value : callable
        (part θ, parts) → the curve.
    start : float
        From which θ on.
    parts
        What the curve needs.
    """
    apart = (1.0 - start) / _N_LOOKS
    first, best, greatest = -1, -1, 0.0
    for look in range(_N_LOOKS + 1):
        theta = start + look * apart if look < _N_LOOKS else 1.0
        now = value(theta, parts)
        if now >= 0 and first >= 0:
            return start + (look - 1) * apart, theta
        if now < 0:
            first = look if first < 0 else first
            if best < 0 or now > greatest:
                best, greatest = look, now
    middle = min(max(best, first + 1), _N_LOOKS - 1)
    if first < 0 or middle <= first:
        return NOT_PASSED, NOT_PASSED
    left, centre, right = (
        value(start + (middle - 1) * apart, parts),
        value(start + middle * apart, parts),
        value(start + (middle + 1) * apart, parts),
    )
    bend = left - 2 * centre + right
    peak = middle + 0.5 * (left - right) / bend if bend < 0 else -1.0
    if not first < peak < _N_LOOKS or abs(peak - best) > 1 or value(start + peak * apart, parts) < 0:
        return NOT_PASSED, NOT_PASSED
    return start + (best if peak > best else best - 1) * apart, start + peak * apart


def passed_level(course: Any, width: float, level: float, sign: float) -> float:
    """First part θ of a step at which sign·(ω − level) rises to 0 from below; `NOT_PASSED` where it does not.

    No closer look is taken where the level is further from the speeds of all stages than these from one another.
    """
    low = high = sign * course.state[1]
    for stage in range(1, 7):
        speed = sign * course.slopes[stage * ROW]
        low, high = min(low, speed), max(high, speed)
    if 2 * high - low < sign * level:
        return NOT_PASSED
    parts = (course, width, level, sign)
    before, after = first_rise(speed_over, 0.0, parts)
    return NOT_PASSED if after == NOT_PASSED else crossing(speed_over, before, after, _PART_CLOSE, parts)


def may_pass_dead_position(course: Any) -> bool:
    """Whether x′ of what is driven changes its sign over a step, or comes near to that at a stage within."""
    start = abs(course.here[OUTPUT])
    sign = 1.0 if course.here[OUTPUT] > 0 else -1.0
    end = course.slopes[6 * ROW + BESIDE] * sign
    within_it = high = course.slopes[ROW + BESIDE] * sign
    for stage in range(2, 6):
        output = course.slopes[stage * ROW + BESIDE] * sign
        within_it, high = min(within_it, output), max(high, output)
    return end <= 0 or (within_it < min(start, end) and 2 * within_it <= max(start, high, end))


def passed_dead_position(machine: Any, numbers: Any, course: Any, width: float, start: float) -> tuple[float, float]:
    """First part θ of a step, from one on, at which x′ of what is driven passes 0, and the crank angle there. [rad]

    Both are `NOT_PASSED` where it does not.
    """
    before, after = first_rise(output_against, start, (course, width, numbers, machine))
    if after == NOT_PASSED:
        return NOT_PASSED, NOT_PASSED
    low, high = (
        state_at(course, width, before, 1 * ANGLE),
        state_at(course, width, after, 1 * ANGLE),
    )
    dead = crossing(output_rate, low, high, 0.0, (numbers, machine, course.here[SENSE]))
    return crossing(angle_less, before, after, _PART_CLOSE, (course, width, dead)), dead


def state_at(course: Any, width: float, theta: float, part: int) -> float:
    """One component of the state at the part θ of a step; at its end as the step has it."""
    return course.ahead[part] if theta == 1.0 else within(course.state, course.slopes, width, theta, part)


def speed_over(theta: float, parts: Any) -> float:
    """By how much the speed at a part of a step is beyond a level. [rad/s]"""
    course, width, level, sign = parts
    return sign * (state_at(course, width, theta, 1 * SPEED) - level)


def angle_less(theta: float, parts: Any) -> float:
    """Crank angle at a part of a step, less another. [rad]"""
    course, width, angle = parts
    return state_at(course, width, theta, 1 * ANGLE) - angle


def output_against(theta: float, parts: Any) -> float:
    """x′ of what is driven at a part of a step, above 0 where it is not of the sign that it had. [m/rad or 1]"""
    course, width, numbers, machine = parts
    output = output_rate(state_at(course, width, theta, 1 * ANGLE), (numbers, machine, course.here[SENSE]))
    return -output if course.here[OUTPUT] > 0 else output


def output_rate(angle: float, parts: Any) -> float:
    """x′ of what is driven, at rest. [m/rad or 1]"""
    numbers, machine, sense = parts
    return machine(angle, 0.0, sense, numbers)[3]
