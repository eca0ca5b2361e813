"""Where in a step the speed passes a level, or any curve of the step passes 0."""

from typing import Any

from cranktrain.motion import Array
from cranktrain.questions.drive.running.step import within

_N_LOOKS = 8
_MOST_HALVINGS = 60


def passed_level(state: Array, slopes: Array, width: float, level: float, sign: float) -> float:
    """First part θ of a step at which sign·(ω − level) rises to 0 from below; 2 where it does not.

    Where the speed turns back within the step it is looked at between the ends as well.
    """
    end = sign * (within(state, slopes, width, 1.0, 1) - level)
    turns_back = slopes[0, 1] * slopes[6, 1] < 0
    if end < 0 and not turns_back:
        return 2.0
    n_looks = _N_LOOKS if turns_back else 1
    before = 0.0
    is_below = sign * (state[1] - level) < 0
    for look in range(1, n_looks + 1):
        theta = look / n_looks
        value = sign * (within(state, slopes, width, theta, 1) - level)
        if value >= 0 and is_below:
            return _level_between(state, slopes, width, level, sign, before, theta)
        if value < 0:
            is_below = True
            before = theta
    return 2.0


def _level_between(
    state: Array, slopes: Array, width: float, level: float, sign: float, low: float, high: float
) -> float:
    """Where sign·(ω − level) passes 0 between two parts of a step, by halving."""
    for _ in range(_MOST_HALVINGS):
        middle = 0.5 * (low + high)
        if sign * (within(state, slopes, width, middle, 1) - level) < 0:
            low = middle
        else:
            high = middle
    return high


def angle_of_dead_position(machine: Any, numbers: Any, sense: float, low: float, high: float) -> float:
    """Crank angle between two at which x′ of what is driven passes 0, by halving."""
    before = machine(low, 0.0, sense, numbers)[3]
    for _ in range(_MOST_HALVINGS):
        middle = 0.5 * (low + high)
        if machine(middle, 0.0, sense, numbers)[3] * before > 0:
            low = middle
        else:
            high = middle
    return high


def passed_angle(state: Array, slopes: Array, width: float, angle: float, sense: float) -> float:
    """Part θ of a step at which the crank passes an angle that lies in it."""
    low, high = 0.0, 1.0
    for _ in range(_MOST_HALVINGS):
        middle = 0.5 * (low + high)
        if sense * (within(state, slopes, width, middle, 0) - angle) < 0:
            low = middle
        else:
            high = middle
    return high
