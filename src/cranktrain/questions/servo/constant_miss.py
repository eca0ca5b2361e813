"""By how much a crank at a constant speed misses a wanted motion of the same period."""

from typing import NamedTuple

import numpy as np

from cranktrain.layout.wish.following import Following
from cranktrain.layout.wish.wanted import moved
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.ties import first_smallest

_N_TIMES, _N_PHASES = 720, 180
_GOLDEN = (np.sqrt(5) - 1) / 2
_N_STEPS = 40


class ConstantMiss(NamedTuple):
    """Largest difference of position at equal times [m or rad], and where the constant crank is at time 0 [rad]."""

    largest: float
    phase: float


def constant_miss(made: Following) -> ConstantMiss:
    """Find the phase at which the largest difference is least, on 720 times of a period.

    docs/theory/servo, eq. (29.9).
    """
    time: Array = np.arange(_N_TIMES, dtype=np.float64) * (made.wanted.period / _N_TIMES)
    wanted = moved(made.wanted, time).value
    turned = TURN * np.arange(_N_TIMES) / _N_TIMES

    def largest(phase: Array) -> Array:
        """Largest difference at each of some phases, shape (k,)."""
        angle = np.ravel(phase[:, np.newaxis] + turned)
        places = made.output.motion(angle).value.reshape(-1, _N_TIMES)
        return np.max(np.abs(places - wanted), axis=1)

    step = TURN / _N_PHASES
    phases: Array = np.arange(_N_PHASES, dtype=np.float64) * step
    best = float(phases[first_smallest(largest(phases))])
    low, high = best - step, best + step
    for _ in range(_N_STEPS):
        inner = np.array([high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)])
        values = largest(inner)
        low, high = (low, float(inner[1])) if values[0] < values[1] else (float(inner[0]), high)
    found = 0.5 * (low + high)
    return ConstantMiss(float(largest(np.array([found]))[0]), float(np.mod(found, TURN)))
