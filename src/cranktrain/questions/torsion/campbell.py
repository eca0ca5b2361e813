"""Campbell's diagram as data: natural frequencies over the speed, rays of the orders, and where they cross."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.torsion.critical import CriticalSpeeds, ModeVectorSums
from cranktrain.questions.torsion.modes import TorsionalModes

_BEYOND = 1.25
"""The diagram reaches beyond the declared speed by this factor."""
_ORDERS = 12.0
"""Highest order that has a ray."""
_MODES = 3
"""So many of the lowest frequencies are in sight, if rays get there."""
_ABOVE = 1.15
"""Room above the highest frequency in sight."""


class Crossing(NamedTuple):
    """Where an order meets a natural frequency.

    Attributes
    ----------
    mode : int
        From 1.
    order : float
    speed, frequency : float
        [rad/s]
    vector_sum, weight : float
        Of amplitude 1 at the free end, and of amplitude 1 where the mode has its largest, which is at most the number
        of cylinders; NaN where no firing order says it.
    """

    mode: int
    order: float
    speed: float
    frequency: float
    vector_sum: float
    weight: float


class Campbell(NamedTuple):
    """Campbell's diagram of one design.

    Attributes
    ----------
    largest_speed, highest_frequency : float
        How far it reaches. [rad/s]
    frequency : Array, shape (mode,)
        Levels, also those out of sight. [rad/s]
    order : Array, shape (ray,)
        A ray is the frequency order · speed.
    crossings : tuple of Crossing
        In sight, by rising speed.
    """

    largest_speed: float
    highest_frequency: float
    frequency: Array
    order: Array
    crossings: tuple[Crossing, ...]


def campbell(
    modes: TorsionalModes, critical: CriticalSpeeds, sums: ModeVectorSums | None, *, design: int = 0
) -> Campbell:
    """Lay out Campbell's diagram: beyond the declared speed, or where there is none, as far as order 3 of mode 1.

    docs/theory/torsion, eq. (23.9).
    """
    frequency, speeds = modes.natural_frequency[design], critical.critical_speed[design]
    order = np.array([float(name) for name in critical.labels["order"]])
    rays = order[order <= _ORDERS]
    running = float(frequency[0]) / 3 if critical.speed is None else float(critical.speed[design])
    largest = _BEYOND * running
    reached = frequency[:_MODES][frequency[:_MODES] <= largest * _ORDERS]
    highest = _ABOVE * float(np.max(reached, initial=frequency[0]))
    size = np.full_like(speeds, np.nan) if sums is None else sums.mode_vector_sum[design]
    weight = size / np.max(np.abs(modes.mode_shape[design]), axis=-1, keepdims=True)
    in_sight = (speeds[:, : rays.size] <= largest) & (frequency[:, np.newaxis] <= highest)
    found = [
        Crossing(
            mode + 1,
            float(order[k]),
            float(speeds[mode, k]),
            float(frequency[mode]),
            float(size[mode, k]),
            float(weight[mode, k]),
        )
        for mode, k in np.argwhere(in_sight).tolist()
    ]
    return Campbell(largest, highest, frequency, rays, tuple(sorted(found, key=lambda one: one.speed)))
