"""Reactions of a PRP group: a block in a moving link's slot, jointed to a slider, with friction in slot and guide."""

from cranktrain.linkage.forces.conditions import Friction
from cranktrain.linkage.forces.crossing import (
    CrossingFriction,
    CrossingLoads,
    CrossingReactions,
    Turning,
    crossing_forces,
)
from cranktrain.linkage.forces.wrench import Wrench, added
from cranktrain.motion import Link


def trammel_reactions(link: Link, loads: CrossingLoads, friction: CrossingFriction) -> CrossingReactions:
    """Reactions of a slider on a guide along x and the block by which a moving link's slot drives it.

    Parameters
    ----------
    link : Link, shape (..., n)
        The slotted link, in the guide's axes.
    loads : CrossingLoads, shape (..., n)
    friction : CrossingFriction, fields broadcastable to (..., n)
        The slot's sense is that of the block along the link.

    Returns
    -------
    CrossingReactions, shape (..., n)
        Infinite or NaN where the slot is parallel to the guide; NaN where friction wedges the slider.

    Notes
    -----
    As a yoke whose slot has the link's direction, loaded by block and slider together. Here the block is the slider's
    and not the slot's, so that friction has the other sign. docs/theory/forces, eqs. (13.18) to (13.21).
    """
    slot = Friction(friction.slot.coefficient, -friction.slot.sense)
    together = added(loads.block, loads.slider)
    zero = 0.0 * (link.cos + loads.slider.moment)
    turning = Turning(zero - loads.slider.moment, zero)
    found = crossing_forces(link.cos, link.sin, together, turning, CrossingFriction(friction.guide, slot))
    return CrossingReactions(
        Wrench(found.x, found.y, zero - loads.block.moment),
        Wrench(found.x + loads.block.x, found.y + loads.block.y, zero),
        Wrench(found.drag, found.normal, turning.moment),
    )
