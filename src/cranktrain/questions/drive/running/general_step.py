"""One step of Tsitouras' method for states of any size, in arrays, as a press has."""

from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.drive.running import tableau

NODES: Array = np.array(tableau.NODES)
WEIGHTS: Array = np.array([(*row, *[0.0] * (6 - len(row))) for row in ((), *tableau.WEIGHTS)])
ERRORS: Array = np.array(tableau.ERRORS)
INTERPOLANT: Array = np.array(tableau.INTERPOLANT)

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
