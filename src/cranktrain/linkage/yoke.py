"""RPP group: a block on a pin, in a straight slot of a slider on a fixed guide along x."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array, Coefficient, Point


class Yoke(NamedTuple):
    """Offset of the guide from the axis x [m]; angle of the slot from x [rad], a right angle for a scotch yoke."""

    offset: Array
    slot_angle: Array


class YokeMotion(NamedTuple):
    """Slider: where the slot's line meets the guide, along x [m]; block: its position along the slot from there [m]."""

    slider: Coefficient
    block: Coefficient


def yoke(pin: Point, geometry: Yoke) -> YokeMotion:
    """Slotted slider on a guide along x, driven by a block on `pin`, and its derivatives by the crank angle.

    Parameters
    ----------
    pin : Point, coefficients of shape (..., n)
        Driving pin. [m, m/rad, m/rad²]
    geometry : Yoke, fields broadcastable to (..., 1)

    Returns
    -------
    YokeMotion, shape (..., n)
        It closes at every angle, unless the slot lies along the guide.

    Notes
    -----
    t = (y − e)/sin β, s = x − t cos β, both linear in the pin. Exact; docs/theory/groups-2, eqs. (7.5) and (7.6).

    Examples
    --------
    >>> from cranktrain.linkage import Crank, crank
    >>> round(float(yoke(crank(np.pi / 3, Crank(0.04)), Yoke(0.0, np.pi / 2)).slider.value), 12)
    0.02
    """
    slope = 1.0 / np.sin(geometry.slot_angle)
    lean = np.cos(geometry.slot_angle) * slope
    height = pin.y.value - geometry.offset
    slider = Coefficient(
        pin.x.value - height * lean, pin.x.first - pin.y.first * lean, pin.x.second - pin.y.second * lean
    )
    return YokeMotion(slider, Coefficient(height * slope, pin.y.first * slope, pin.y.second * slope))
