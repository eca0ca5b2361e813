"""Forces of the slotted lever: reactions of crank, block and lever, and the driving torque."""

from typing import Generic, NamedTuple

from cranktrain.linkage import AHEAD, Crank, CrankAndPivot, OnLine, Swivel
from cranktrain.linkage.forces import (
    NOTHING,
    Body,
    Conditions,
    SwivelLoads,
    Wrench,
    borne,
    carrying_crank,
    crank_link,
    swivel_reactions,
    swivel_slider_link,
)
from cranktrain.mechanisms.dynamics import FRAME, Across, Contact, Dynamics, Group, Reaction
from cranktrain.mechanisms.slotted_lever.kinematics import SlottedLeverMotion
from cranktrain.mechanisms.solved import Each, Forces
from cranktrain.motion import ZERO, Array, Link


class SlottedLeverLinks(NamedTuple, Generic[Each]):
    """What each link has: crank, from the shaft to its pin; block, from that along the slot; rocker, from its pivot.

    Its link, its body, or the wrench that it bears, about its first pin. The rocker too counts along the slot.
    """

    crank: Each
    block: Each
    rocker: Each


class SlottedLeverJoints(NamedTuple):
    """Wrenches of the bearing on the crank, the crank on the block, the block on the lever, the pivot on the lever."""

    main_bearing: Wrench
    crank_pin: Wrench
    slot: Wrench
    pivot: Wrench


def slotted_lever_links(motion: SlottedLeverMotion, geometry: CrankAndPivot) -> SlottedLeverLinks[Link]:
    """What moves, as links: crank, block and rocker."""
    crank = crank_link(motion.pin, Crank(geometry.crank_radius))
    block = swivel_slider_link(motion.pin, motion.rocker)
    return SlottedLeverLinks(crank, block, motion.rocker)


def slotted_lever_load(
    _motion: SlottedLeverMotion, _geometry: CrankAndPivot, torque: Array
) -> SlottedLeverLinks[Wrench]:
    """Loads for a torque on the lever, in the sense of rotation. [N·m]"""
    return SlottedLeverLinks(NOTHING, NOTHING, Wrench(ZERO, ZERO, torque))


def slotted_lever_forces(
    motion: SlottedLeverMotion,
    geometry: CrankAndPivot,
    bodies: SlottedLeverLinks[Body],
    loads: SlottedLeverLinks[Wrench],
    conditions: Conditions,
) -> Forces[SlottedLeverJoints]:
    """All forces of a slotted lever.

    Parameters
    ----------
    motion : SlottedLeverMotion, shape (..., n)
    geometry : CrankAndPivot, fields broadcastable to (..., 1)
    bodies : SlottedLeverLinks of Body, fields broadcastable to (..., 1)
    loads : SlottedLeverLinks of Wrench, shape (..., n)
    conditions : Conditions, fields broadcastable to (..., n)
        Friction's sense is that of the block along the slot, away from the pivot.

    Returns
    -------
    Forces of SlottedLeverJoints, shape (..., n)
        In the mechanism's axes; NaN where the links cannot close, or friction wedges the block.

    Notes
    -----
    Exact for rigid bodies; docs/theory/forces, eqs. (13.5), (13.7) and (13.17).
    """
    links = slotted_lever_links(motion, geometry)
    crank, block = links[:2]
    group = swivel_reactions(
        OnLine(motion.rocker, motion.pin),
        Swivel(geometry.offset, AHEAD),
        SwivelLoads(
            borne(block, bodies.block, loads.block, conditions),
            borne(motion.rocker, bodies.rocker, loads.rocker, conditions),
        ),
        conditions.friction[0],
    )
    on_crank = borne(crank, bodies.crank, loads.crank, conditions)
    shaft = carrying_crank(crank, on_crank, motion.pin, group.pin)
    drag = motion.rocker.cos * group.slider.x + motion.rocker.sin * group.slider.y
    return Forces(
        SlottedLeverJoints(shaft.bearing, group.pin, group.slider, group.pivot),
        shaft.driving_torque,
        -drag * motion.block.first,
    )


DYNAMICS = Dynamics(
    bodies=SlottedLeverLinks[Body],
    moving=SlottedLeverLinks._fields,
    reactions=(
        Reaction("main_bearing", "crank", FRAME, "main_bearing"),
        Reaction("crank_pin", "block", "crank", "crank_pin"),
        Reaction("slot", "rocker", "block", "slot"),
        Reaction("pivot", "rocker", FRAME, "pivot"),
    ),
    sliding=("block",),
    contacts=(Contact("slot", "A"),),
    groups=(Group("RPR", ("block", "rocker"), (Across("crank_pin", "rocker", "C"),)),),
    links=slotted_lever_links,
    load=slotted_lever_load,
    forces=slotted_lever_forces,
)
