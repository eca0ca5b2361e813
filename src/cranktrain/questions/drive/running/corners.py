"""Crank angles at which a load has a corner or jumps: no step looks beyond one, in whichever sense the crank turns."""

import math
from typing import Any

_BESIDE, _OF_ANGLE = 1e-13, 1e-15
"""How far from a corner one stands on its side, in rad and of the angle: more than what rounding makes of the angle."""
_NEAR = 5
"""How near is at a corner, in these distances."""


def beside(angle: float) -> float:
    """How far from a corner one stands that is on its one side. [rad]"""
    return _BESIDE + _OF_ANGLE * abs(angle)


def on_the_way(angle: float, sense: float, corners: Any, period: float) -> float:
    """Crank angle of a motion that begins: at a corner, the side of it to which the crank goes. [rad]"""
    for corner in corners:
        at = corner + math.floor((angle - corner) / period + 0.5) * period
        if abs(angle - at) <= _NEAR * beside(angle):
            return at + sense * beside(angle)
    return angle


def corner_ahead(angle: float, sense: float, corners: Any, period: float) -> float:
    """How far a crank turns until the next corner, to this side of it: an angle, infinite without corners. [rad]"""
    nearest = math.inf
    for corner in corners:
        turns = math.floor(sense * (angle - corner) / period)
        at = corner + sense * turns * period
        while sense * (at - angle) <= _NEAR * beside(angle):
            at += sense * period
        nearest = min(nearest, sense * at)
    return sense * (nearest - beside(angle))
