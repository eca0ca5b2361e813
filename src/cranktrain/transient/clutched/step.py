"""One step of Tsitouras' method for a state whose slopes come at once, in lists: without a compiler the quickest."""

from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np

from cranktrain.motion import Array
from cranktrain.transient.tableau import ERRORS, NODES, WEIGHTS
from cranktrain.transient.tableau import INTERPOLANT as _INTERPOLANT

INTERPOLANT: Array = np.array(_INTERPOLANT)
_ROWS = tuple(enumerate(zip(NODES[1:], WEIGHTS, strict=True), start=1))

Slopes: TypeAlias = list[list[float]]
Derive: TypeAlias = Callable[[float, Any, Any, float, Any], int]
"""(x, state, slopes, sense, parts): writes the slopes and gives 0, or the reason why there are none."""


def no_slopes(n_state: int) -> Slopes:
    """Room for the slopes of all stages."""
    return [[0.0] * n_state for _ in NODES]


def take_step(
    derive: Derive, x: float, width: float, state: list[float], slopes: Slopes, sense: float, parts: Any
) -> tuple[list[float], int]:
    """Go a step from `state`, whose slopes stand in row 0; slopes of all stages are left in `slopes`.

    Only the first three components feed back; the others are integrals along the way. Gives the state behind it, and
    0, or the reason of the first stage that has no slopes.
    """
    trouble, ahead = 0, list(state)
    for stage, (node, weights) in _ROWS:
        a, b, c = 0.0, 0.0, 0.0
        for weight, row in zip(weights, slopes, strict=False):
            a += weight * row[0]
            b += weight * row[1]
            c += weight * row[2]
        ahead[0], ahead[1], ahead[2] = state[0] + width * a, state[1] + width * b, state[2] + width * c
        reason = derive(x + node * width, ahead, slopes[stage], sense, parts)
        trouble = trouble or reason
    for part in range(3, len(state)):
        ahead[part] = state[part] + width * sum(
            weight * row[part] for weight, row in zip(WEIGHTS[-1], slopes, strict=False)
        )
    return ahead, trouble


def error_of(slopes: Slopes, width: float, part: int) -> float:
    """Estimated error of one component of a step."""
    return abs(width * sum(weight * row[part] for weight, row in zip(ERRORS, slopes, strict=True)))
