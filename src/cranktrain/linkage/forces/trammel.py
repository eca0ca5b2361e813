"""Reactions of a PRP group: a block in a moving link's slot, jointed to a slider, with friction in its guide."""

from typing import NamedTuple

from cranktrain.linkage.forces.conditions import Friction, dragged, pressed
from cranktrain.linkage.forces.wrench import Wrench
from cranktrain.motion import Link


class TrammelLoads(NamedTuple):
    """What block and slider bear but for their joints, both about the pin between them."""

    block: Wrench
    slider: Wrench


class TrammelReactions(NamedTuple):
    """Wrenches of the link on the block, of the block on the slider, of the guide on the slider; all about the pin."""

    slot: Wrench
    joint: Wrench
    guide: Wrench


def trammel_reactions(link: Link, loads: TrammelLoads, friction: Friction) -> TrammelReactions:
    """Reactions of a slider on a guide along x and the block by which a moving link's slot drives it.

    Parameters
    ----------
    link : Link, shape (..., n)
        The slotted link, in the guide's axes.
    loads : TrammelLoads, shape (..., n)
    friction : Friction, fields broadcastable to (..., n)
        Of the slider in its guide; the slot has none.

    Returns
    -------
    TrammelReactions, shape (..., n)
        Infinite or NaN where the slot is parallel to the guide; NaN where friction wedges the slider.

    Notes
    -----
    As a yoke whose slot has the link's direction, loaded by block and slider together. docs/theory/forces,
    eqs. (13.20) and (13.21).
    """
    slope = link.cos / link.sin
    load_x = loads.block.x + loads.slider.x
    load_y = loads.block.y + loads.slider.y
    normal = pressed(-load_y - load_x * slope, -slope, friction)
    drag = dragged(normal, friction)
    x = -(load_x + drag)
    y = -x * slope
    zero = 0.0 * x
    return TrammelReactions(
        Wrench(x, y, zero - loads.block.moment),
        Wrench(x + loads.block.x, y + loads.block.y, zero),
        Wrench(drag, normal, zero - loads.slider.moment),
    )
