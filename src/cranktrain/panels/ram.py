"""A ram that works downward: its face, and the bed below it, by places along the line of stroke."""

import numpy as np

from cranktrain.motion import Array
from cranktrain.record import record

_UPRIGHT = np.cos(np.deg2rad(45.0))
"""Upward part of a line of stroke, from which on one end of it is the upper."""

_WIDTH, _FACE, _BACK, _BED = 0.6, 0.27, 0.95, 0.15
"""Width of a ram, how far it reaches beyond its pin and behind it, what is left to the bed; in parts of the stroke."""


@record
class RamDrawing:
    """A ram below its shaft; only its pin is to scale, and how far the bed lies below no file says.

    Attributes
    ----------
    width : float
        [m]
    face : float
        From the pin to the working face. [m]
    back : float
        From the pin to the ram's other end, which its guides hold in every position. [m]
    ends : Array, shape (2,)
        Where the face is at the upper dead position and at the lower one, from the foot of the line. [m]
    bed : float
        Where the bed begins, from there. [m]
    """

    width: float
    face: float
    back: float
    ends: Array
    bed: float


def upward(along: Array) -> int:
    """Say whether the far end of a line of stroke is its upper end, +1, its lower one, −1, or neither, 0.

    Parameters
    ----------
    along : Array, shape (2,)
        Unit vector away from the shaft, Y up.
    """
    up = float(along[1])
    return int(np.sign(up)) if abs(up) > _UPRIGHT else 0


def ram_of(travel: Array) -> RamDrawing:
    """Give a ram for the nearest and farthest place of its pin, shape (2,), in their unit."""
    stroke = float(travel[1] - travel[0])
    ends = travel + _FACE * stroke
    bed = float(ends[1]) + _BED * stroke
    return RamDrawing(width=_WIDTH * stroke, face=_FACE * stroke, back=_BACK * stroke, ends=ends, bed=bed)
