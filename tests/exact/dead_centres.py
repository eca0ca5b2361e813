"""Dead centres, found by a root finder of the tests' own."""

from collections.abc import Callable
from typing import NamedTuple

from scipy.optimize import brentq

from cranktrain.motion import Coefficient


class DeadCentre(NamedTuple):
    """Crank angle [rad] and position there."""

    angle: float
    position: float


def dead_centre(motion: Callable[[float], Coefficient], near: float, within: float) -> DeadCentre:
    """Where a coordinate stands still, no farther than `within` from the crank angle `near`."""
    angle = brentq(lambda angle: float(motion(angle).first), near - within, near + within, xtol=1e-15, rtol=1e-15)
    return DeadCentre(angle, float(motion(angle).value))
