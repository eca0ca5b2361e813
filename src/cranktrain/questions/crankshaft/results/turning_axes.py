"""Bearing loads in axes that turn with the shaft, and torque in its sense of rotation."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array


class TurningLoad(NamedTuple):
    """Load of journals on their bearings in axes of the shaft: along a throw's crank, and 90° ahead of it. [N]"""

    along: Array
    across: Array


def in_turning_axes(x: Array, y: Array, direction: Array, turn: Array | float) -> TurningLoad:
    """Loads toward X and Y, in axes that turn with a shaft.

    Parameters
    ----------
    x, y : Array, shape (..., n)
    direction : Array, broadcastable to (..., n)
        Of the first of these axes, from X toward Y. [rad]
    turn : float, or Array broadcastable to (..., n)
        1 where the shaft runs from X toward Y, −1 where it runs the other way.

    Returns
    -------
    TurningLoad, shape (..., n)

    Notes
    -----
    docs/theory/crankshaft, eq. (24.44).

    Examples
    --------
    A load to the right, of a shaft that turns clockwise, while throw 1 points up:

    >>> along, across = in_turning_axes(np.array([5.0]), np.array([0.0]), np.array([np.pi / 2]), -1.0)
    >>> round(float(along[0]), 9), float(across[0])
    (0.0, 5.0)
    """
    cos, sin = np.cos(direction), np.sin(direction)
    return TurningLoad(x * cos + y * sin, turn * (y * cos - x * sin))
