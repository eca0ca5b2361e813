"""A working chamber as a card asks for it: its volume by the crank angle, and nothing of the mechanism behind it."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from cranktrain.fluids.state import VolumeLimits
from cranktrain.motion import Array

_CENTRAL = 1e-9
"""By how much a volume may differ from that of a central slider-crank, in parts of the swept volume."""


class Chamber(NamedTuple):
    """A working chamber.

    Attributes
    ----------
    cycle : float
        2π of a two-stroke, 4π of a four-stroke. [rad]
    limits : VolumeLimits
        Floats. [m³]
    volume : callable
        From crank angles since nominal firing, shape (n,) [rad], to volumes of that shape [m³].
    """

    cycle: float
    limits: VolumeLimits
    volume: Callable[[Array], Array]


def central_ratio(chamber: Chamber) -> Array | None:
    """λ, crank radius to rod length, if the chamber's volume is that of a central slider-crank; else None.

    Negative of a chamber on the crank's side, whose piston begins at the bottom.

    Notes
    -----
    At 90° the piston is u = (1 − √(1 − λ²))/λ crank radii beyond the middle of its stroke, so λ = 2u/(1 + u²).
    """
    angle = np.linspace(0.0, 2 * np.pi, 9)
    radius = (chamber.limits.largest - chamber.limits.smallest) / 2
    travel = (chamber.volume(angle) - chamber.limits.smallest) / radius
    beyond = travel[2] - 1.0
    ratio = 2 * beyond / (1 + beyond**2)
    away = 1 - np.cos(angle) + ratio * np.sin(angle) ** 2 / (1 + np.sqrt(1 - (ratio * np.sin(angle)) ** 2))
    is_rod = _CENTRAL < np.abs(ratio) < 1
    return ratio if is_rod and np.max(np.abs(travel - away)) < 2 * _CENTRAL else None
