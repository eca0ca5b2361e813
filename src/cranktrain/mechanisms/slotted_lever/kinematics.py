"""Kinematics of the slotted lever: crank and RPR group whose guide is the output."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage import AHEAD, Crank, Swivel, SwivelEnds, crank, fixed, swivel, swivel_gap
from cranktrain.motion import Array, Coefficient, Link, Point


class SlottedLever(NamedTuple):
    """Crank radius, ground (shaft centre to pivot, along x), offset of the slot's line from the pivot, to its left. [m]

    way is +1 where the pivot lies outside the crank circle, −1 inside, where the lever turns all round: Whitworth's
    quick return.
    """

    crank_radius: Array
    ground_length: Array
    offset: Array
    way: Array


class SlottedLeverMotion(NamedTuple):
    """Crank pin; rocker: the lever, a link from the pivot along its slot; block: its position along the slot. [m]"""

    pin: Point
    rocker: Link
    block: Coefficient


def slotted_lever(angle: Array, geometry: SlottedLever) -> SlottedLeverMotion:
    """Lever about a fixed pivot, driven by a block on the crank pin in its slot, and the derivatives.

    Parameters
    ----------
    angle : Array, shape (..., n)
        Crank angle from x, the direction from the shaft centre to the pivot. [rad]
    geometry : SlottedLever, fields broadcastable to (..., 1)

    Returns
    -------
    SlottedLeverMotion, shape (..., n)
        NaN where the crank pin is nearer to the pivot than the slot's line. The angle is a principal value in (−π, π].

    Notes
    -----
    Exact; docs/theory/slotted-lever, eqs. (11.1) and (11.2).
    """
    pin = crank(angle, Crank(geometry.crank_radius))
    pivot = fixed(geometry.ground_length, 0.0 * geometry.ground_length)
    motion = swivel(SwivelEnds(pin, pivot), Swivel(geometry.offset, AHEAD))
    return SlottedLeverMotion(pin, motion.guide, motion.slider)


def slotted_lever_gap(angle: Array, geometry: SlottedLever) -> Array:
    """By how much the crank pin is farther from the pivot than the guide's line; negative where not. [m]

    Negative also where the pivot has come to the other side of the crank circle: on the way there it was on it.
    """
    pin = crank(angle, Crank(geometry.crank_radius))
    pivot = fixed(geometry.ground_length, 0.0 * geometry.ground_length)
    nearest = geometry.ground_length - geometry.crank_radius
    crossed = np.abs(nearest) - geometry.way * nearest
    return swivel_gap(SwivelEnds(pin, pivot), Swivel(geometry.offset, AHEAD)) - crossed
