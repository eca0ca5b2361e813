"""Kinematics of the slotted lever: crank and RPR group whose guide is the output."""

from typing import NamedTuple

from cranktrain.linkage import AHEAD, Crank, CrankAndPivot, Ends, Swivel, crank, fixed, swivel
from cranktrain.motion import Array, Coefficient, Link, Point


class SlottedLeverMotion(NamedTuple):
    """Crank pin; rocker: the lever, a link from the pivot along its slot; block: its position along the slot. [m]"""

    pin: Point
    rocker: Link
    block: Coefficient


def slotted_lever(angle: Array, geometry: CrankAndPivot) -> SlottedLeverMotion:
    """Lever about a fixed pivot, driven by a block on the crank pin in its slot, and the derivatives.

    Parameters
    ----------
    angle : Array, shape (..., n)
        Crank angle from x, the direction from the shaft centre to the pivot. [rad]
    geometry : CrankAndPivot, fields broadcastable to (..., 1)

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
    motion = swivel(Ends(pin, pivot), Swivel(geometry.offset, AHEAD))
    return SlottedLeverMotion(pin, motion.guide, motion.slider)
