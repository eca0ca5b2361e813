"""A crank that swings between two angles, as what it drives moves between two positions within the stroke."""

from typing import NamedTuple

import numpy as np

from cranktrain.layout.wish.following import CrankMotion
from cranktrain.layout.wish.stroke import Output
from cranktrain.layout.wish.wanted import WantedMotion, moved
from cranktrain.motion import Array
from cranktrain.numerics import bracketed_roots
from cranktrain.numerics.harmonics import TURN


class Rocking(NamedTuple):
    """A wanted motion within the stroke of an output, on the half turn behind its high dead centre."""

    output: Output
    wanted: WantedMotion


def rocking_crank(made: Rocking, time: Array) -> CrankMotion:
    """Where a rocking crank is at times, shape (n,), and how it moves; its speed changes sign.

    Notes
    -----
    ω = ẋ/x′, ε = (ẍ − x″ω²)/x′, with x′ never 0. docs/theory/servo, eq. (29.3).
    """
    whole = moved(made.wanted, time)
    low = made.output.high.angle
    high = low + np.mod(made.output.low.angle - low, TURN)
    ends = (np.full(time.shape, end) for end in (low, high))
    angle = bracketed_roots(lambda phi: made.output.motion(phi).value - whole.value, *ends)
    place = made.output.motion(angle)
    speed = whole.first / place.first
    return CrankMotion(time, angle, speed, (whole.second - place.second * speed**2) / place.first)
