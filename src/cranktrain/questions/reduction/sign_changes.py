"""Crank angles at which a torque that has jumps and corners changes its sign."""

from collections.abc import Callable

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics import bracketed_roots
from cranktrain.questions.reduction.cycle_pieces import CyclePieces

ASIDE = 1e-9
"""Of a corner, on both its sides. [rad]"""
_NOTHING = 1e-9
"""Of the peak: a smaller torque is of neither sign."""


def sign_changes(torque: Callable[[Array], Array], mesh: CyclePieces) -> Array:
    """Crank angles at which a torque changes its sign, also where it jumps across 0. [rad]"""
    ends = np.stack([mesh.start + ASIDE, mesh.start + mesh.width - ASIDE], axis=-1)
    places = np.ravel(np.hstack([ends[:, :1], mesh.nodes.reshape(len(mesh.start), -1), ends[:, 1:]]))
    values = torque(places)
    clear = np.abs(values) > _NOTHING * np.max(np.abs(values))
    angles, signs = places[clear], np.sign(values[clear])
    if not angles.size:
        return angles
    cycle = float(np.sum(mesh.width))
    low, high = angles, np.append(angles[1:], angles[0] + cycle)
    changes = signs * np.append(signs[1:], signs[0]) < 0
    return np.mod(bracketed_roots(torque, low[changes], high[changes]), cycle)
