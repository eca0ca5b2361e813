"""Frames: a mechanism's own axes as they lie in the machine's, X right and Y up, seen from the free end."""

from typing import NamedTuple

import numpy as np

from cranktrain.engine.places import Place
from cranktrain.motion import Array


class Frame(NamedTuple):
    """Where a mechanism's axes lie.

    direction: of its x, clockwise from Y [rad]; sense: +1 where it runs clockwise, so that y is x turned clockwise by
    90°, and −1 where it runs anticlockwise.
    """

    direction: float
    sense: float


def frame_of(place: Place, *, first_angle: float, clockwise: bool) -> Frame:
    """Find how a place of a machine lies.

    Parameters
    ----------
    place : Place
        Its axis counts from the first bank's, in the sense of its crank.
    first_angle : float
        Of the first bank's axis from Y, in the machine's normal sense. [rad]
    clockwise : bool
        The machine's normal sense. Where a crank turns against it, the metal stays and y is turned the other way.

    Returns
    -------
    Frame
    """
    normal = 1.0 if clockwise else -1.0
    sense = normal * place.sense
    return Frame(normal * first_angle + sense * place.axis, sense)


def in_machine_axes(x: Array, y: Array, frame: Frame) -> tuple[Array, Array]:
    """Give a vector or point of a mechanism's own axes in the machine's.

    Parameters
    ----------
    x, y : Array, of one shape
        In the mechanism's axes; any unit.
    frame : Frame

    Returns
    -------
    X, Y : Array of the same shape and unit

    Examples
    --------
    A cylinder that lies 90° clockwise from Y: its x points right, and its y down.

    >>> right, up = in_machine_axes(np.array(2.0), np.array(1.0), Frame(np.pi / 2, 1.0))
    >>> round(float(right), 9), round(float(up), 9)
    (2.0, -1.0)
    """
    cos, sin = np.cos(frame.direction), np.sin(frame.direction)
    return x * sin + frame.sense * y * cos, x * cos - frame.sense * y * sin
