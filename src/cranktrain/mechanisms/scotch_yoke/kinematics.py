"""Kinematics of the scotch yoke: crank and RPP group."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage import Crank, Yoke, crank, yoke
from cranktrain.motion import Array, Coefficient, Handed, Point


class ScotchYoke(NamedTuple):
    """Crank radius, offset of the line of stroke toward +y [m]; angle from the line of stroke to the slot [rad]."""

    crank_radius: Array
    offset: Handed
    slot_angle: Handed


class ScotchYokeMotion(NamedTuple):
    """Crank pin; slider along x from the shaft centre; block along the slot, from the line of stroke. [m]"""

    pin: Point
    slider: Coefficient
    block: Coefficient


def scotch_yoke(angle: Array, geometry: ScotchYoke) -> ScotchYokeMotion:
    """Slotted slider driven by a block on the crank pin, and its derivatives by the crank angle.

    Parameters
    ----------
    angle : Array, shape (..., n)
        Crank angle from x, the line of stroke's direction away from the shaft. [rad]
    geometry : ScotchYoke, fields broadcastable to (..., 1)

    Returns
    -------
    ScotchYokeMotion, shape (..., n)

    Notes
    -----
    s = R cos φ − (R sin φ − e) cot β. Exact; docs/theory/scotch-yoke, eq. (9.1).
    """
    pin = crank(angle, Crank(geometry.crank_radius))
    motion = yoke(pin, Yoke(geometry.offset, geometry.slot_angle))
    return ScotchYokeMotion(pin, motion.slider, motion.block)


def scotch_yoke_gap(angle: Array, geometry: ScotchYoke) -> Array:
    """Radius across the slot: it closes at every angle, unless the slot lies along the guide. [m]"""
    return geometry.crank_radius * np.abs(np.sin(geometry.slot_angle)) + 0.0 * angle
