"""The driver: a crank that turns with the crank angle, or an eccentric on the same shaft."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array, Coefficient, Point


class Crank(NamedTuple):
    """Crank: radius from the shaft centre to the pin. [m]"""

    radius: Array


def crank(angle: Array, geometry: Crank) -> Point:
    """Crank pin, and its derivatives by the crank angle.

    Parameters
    ----------
    angle : Array, shape (..., n)
        Angle of the crank from x, positive in the sense of rotation. [rad]
    geometry : Crank, fields broadcastable to (..., 1)

    Returns
    -------
    Point, shape (..., n)
        The pin. [m, m/rad, m/rad²]

    Notes
    -----
    x = R cos φ, y = R sin φ; docs/theory/groups.

    Examples
    --------
    >>> pin = crank(0.0, Crank(0.04))
    >>> float(pin.x.value), float(pin.y.first), float(pin.x.second)
    (0.04, 0.04, -0.04)
    """
    x = geometry.radius * np.cos(angle)
    y = geometry.radius * np.sin(angle)
    minus_x = -x
    minus_y = -y
    return Point(Coefficient(x, minus_y, minus_x), Coefficient(y, x, minus_y))
