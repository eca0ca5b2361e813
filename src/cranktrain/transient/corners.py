"""Crank angles at which a load has a corner or jumps: no step looks beyond one, in whichever sense the crank turns.

Corners are those of a period in their order, each once, as `runs.wanted` lays them; they are counted on through all
periods, so that one is found by halving.
"""

import math
from typing import Any

_BESIDE, _OF_ANGLE = 1e-13, 1e-15
"""How far from a corner one stands on its side, in rad and of the angle: more than what rounding makes of the angle."""
_FEW = 12
"""So many rows a step passes at most: what bends between them is seen at its stages."""
_NEAR = 5
"""How near is at a corner, in these distances."""


def beside(angle: float) -> float:
    """How far from a corner one stands that is on its one side. [rad]"""
    return _BESIDE + _OF_ANGLE * abs(angle)


def on_the_way(angle: float, sense: float, corners: Any, period: float) -> float:
    """Crank angle of a motion that begins: at a corner, the side of it to which the crank goes. [rad]"""
    if len(corners) == 0:
        return angle
    count = count_before(angle, corners, period)
    for which in range(count - 1, count + 1):
        at = counted(which, corners, period)
        if abs(angle - at) <= _NEAR * beside(angle):
            return at + sense * beside(angle)
    return angle


def corner_ahead(angle: float, sense: float, corners: Any, period: float) -> float:
    """How far a crank turns until the next corner, to this side of it: an angle, infinite without corners. [rad]"""
    if len(corners) == 0:
        return sense * math.inf
    count, onward = count_before(angle, corners, period), 1 if sense > 0 else -1
    which = count - 1 if sense > 0 else count  # one back: rounding may have counted the corner at which it stands
    at = counted(which, corners, period)
    while sense * (at - angle) <= _NEAR * beside(angle):
        which += onward
        at = counted(which, corners, period)
    return at - sense * beside(angle)


def few_ahead(angle: float, sense: float, rows: Any, period: float) -> float:
    """How far a crank turns over as many rows of a load curve as a step may pass, infinite without rows. [rad]"""
    if len(rows) == 0:
        return math.inf
    count = count_before(angle, rows, period)
    return abs(counted(count + _FEW if sense > 0 else count - 1 - _FEW, rows, period) - angle)


def count_before(angle: float, corners: Any, period: float) -> int:
    """How many corners lie before an angle, counted from 0; below 0 for an angle before that."""
    periods = math.floor(angle / period)
    within = angle - periods * period
    low, high = 0, len(corners)
    while low < high:
        middle = (low + high) // 2
        if corners[middle] <= within:
            low = middle + 1
        else:
            high = middle
    return periods * len(corners) + low


def counted(which: int, corners: Any, period: float) -> float:
    """Where a corner lies that is counted on through all periods. [rad]"""
    return corners[which % len(corners)] + which // len(corners) * period
