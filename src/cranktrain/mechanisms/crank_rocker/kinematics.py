"""Kinematics of the crank-rocker: crank and RRR group on a fixed pivot."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage import Crank, CrankAndGround, Ends, Pin, crank, fixed, pin_from_crank, pin_gap
from cranktrain.motion import Array, Handed, Link, Point
from cranktrain.numerics import Extreme


class CrankRocker(NamedTuple):
    """Lengths of crank, rod, rocker and ground (shaft centre to the rocker's pivot, along x) [m].

    side is +1 where the joint of rod and rocker lies left of the line from crank pin to pivot, −1 where it lies right.
    """

    crank_radius: Array
    rod_length: Array
    rocker_length: Array
    ground_length: Array
    side: Handed


class CrankRockerMotion(NamedTuple):
    """Crank pin, joint of rod and rocker [m]; the rod from crank pin to joint, the rocker from pivot to joint."""

    pin: Point
    joint: Point
    rod: Link
    rocker: Link


def crank_rocker(angle: Array, geometry: CrankRocker) -> CrankRockerMotion:
    """Four-bar linkage driven by its crank, and its derivatives by the crank angle.

    Parameters
    ----------
    angle : Array, shape (..., n)
        Crank angle from x, the direction from the shaft centre to the rocker's pivot. [rad]
    geometry : CrankRocker, fields broadcastable to (..., 1)

    Returns
    -------
    CrankRockerMotion, shape (..., n)
        NaN where the links cannot close. Angles are principal values in (−π, π].

    Notes
    -----
    Exact; docs/theory/crank-rocker.
    """
    crank_pin = crank(angle, Crank(geometry.crank_radius))
    group = Pin(geometry.rod_length, geometry.rocker_length, geometry.side)
    motion = pin_from_crank(CrankAndGround(crank_pin, geometry.ground_length), group)
    return CrankRockerMotion(crank_pin, motion.joint, motion.rod, motion.rocker)


def crank_rocker_gap(angle: Array, geometry: CrankRocker) -> Array:
    """By how much rod and rocker can meet at each angle; negative where the links cannot close. [m]"""
    crank_pin = crank(angle, Crank(geometry.crank_radius))
    pivot = fixed(geometry.ground_length, 0.0 * geometry.ground_length)
    return pin_gap(Ends(crank_pin, pivot), Pin(geometry.rod_length, geometry.rocker_length, geometry.side))


def crank_rocker_least_gap(geometry: CrankRocker) -> Extreme:
    """Least gap over a turn: the crank pin nearest to the pivot, or farthest from it. docs/theory/closing-margin."""
    R, l, r, g, _side = geometry  # noqa: N806 - the letters of the equation
    near, far = np.abs(g - R) - np.abs(l - r), l + r - g - R
    return Extreme(np.pi / 2 + np.copysign(np.pi / 2, near - far), np.minimum(near, far))
