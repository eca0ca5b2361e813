"""Reactions of an RPP group: a block on a pin in a slider's slot, with friction in slot and guide."""

import numpy as np

from cranktrain.linkage.forces.crossing import (
    CrossingFriction,
    CrossingLoads,
    CrossingReactions,
    Turning,
    crossing_forces,
)
from cranktrain.linkage.forces.wrench import Wrench
from cranktrain.linkage.yoke import Yoke
from cranktrain.motion import Array, Coefficient, Link, Point


def block_link(pin: Point, angle: Array) -> Link:
    """Block as a link that does not turn, from its pin in the slot's direction."""
    zero = 0.0 * pin.x.value
    return Link(pin, Coefficient(angle + zero, zero, zero), np.cos(angle) + zero, np.sin(angle) + zero)


def yoke_reactions(block: Array, geometry: Yoke, loads: CrossingLoads, friction: CrossingFriction) -> CrossingReactions:
    """Reactions of a block and its slotted slider.

    Parameters
    ----------
    block : Array, shape (..., n)
        Its position along the slot, from where that meets the guide. [m]
    geometry : Yoke, fields broadcastable to (..., 1)
    loads : CrossingLoads, shape (..., n)
    friction : CrossingFriction, fields broadcastable to (..., n)

    Returns
    -------
    CrossingReactions, shape (..., n)
        NaN where friction wedges the slider.

    Notes
    -----
    `crossing_forces` with the slot's angle; the block's force at its place along the slot gives the guide a moment.
    docs/theory/forces, eqs. (13.18) to (13.20).
    """
    sin = np.sin(geometry.slot_angle)
    cos = np.cos(geometry.slot_angle)
    couple = loads.block.moment
    turning = Turning(-(loads.slider.moment + couple), block)
    found = crossing_forces(cos, sin, loads.slider, turning, friction)
    zero = 0.0 * found.x
    across = cos * found.y - sin * found.x
    return CrossingReactions(
        Wrench(found.x - loads.block.x, found.y - loads.block.y, zero),
        Wrench(found.x, found.y, zero + couple),
        Wrench(found.drag, found.normal, turning.moment - block * across),
    )
