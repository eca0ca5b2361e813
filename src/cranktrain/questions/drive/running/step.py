"""One step of Tsitouras' method, and the state anywhere within it."""

from collections.abc import Callable
from typing import Any, TypeAlias

from cranktrain.motion import Array
from cranktrain.questions.drive.running.tableau import ERRORS, INTERPOLANT, NODES, WEIGHTS

Derive: TypeAlias = Callable[[float, Array, Array, float, Any], int]
"""(x, state, slopes, sense, parts): writes the slopes and gives 0, or the reason why there are none."""


def take_step(
    derive: Derive,
    x: float,
    width: float,
    state: Array,
    slopes: Array,
    n_fed: int,
    ahead: Array,
    sense: float,
    parts: Any,
) -> int:
    """Go a step from `state`, whose slopes stand in row 0, into `ahead`; slopes of all stages are left in `slopes`.

    Only the first `n_fed` components feed back; the others are integrals along the way. Gives 0, or the reason of the
    first stage that has no slopes.
    """
    trouble = 0
    for stage in range(1, 7):
        is_last = stage == 6
        for part in range(len(state) if is_last else n_fed):
            total = 0.0
            for earlier in range(stage):
                total += WEIGHTS[stage, earlier] * slopes[earlier, part]
            ahead[part] = state[part] + width * total
        reason = derive(x + NODES[stage] * width, ahead, slopes[stage], sense, parts)
        if trouble == 0:
            trouble = reason
    return trouble


def error_of(slopes: Array, width: float, part: int) -> float:
    """Estimated error of one component of a step."""
    total = 0.0
    for stage in range(7):
        total += ERRORS[stage] * slopes[stage, part]
    return abs(width * total)


def within(state: Array, slopes: Array, width: float, theta: float, part: int) -> float:
    """One component of the state at the part θ of a step."""
    total = 0.0
    for stage in range(7):
        row = INTERPOLANT[stage]
        total += theta * (row[0] + theta * (row[1] + theta * (row[2] + theta * row[3]))) * slopes[stage, part]
    return state[part] + width * total
