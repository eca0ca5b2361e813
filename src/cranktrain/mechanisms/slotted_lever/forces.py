"""Forces of the slotted lever: reactions of crank, block and lever, and the driving torque."""

from cranktrain.linkage import AHEAD, Crank, CrankAndPivot, OnLine, Swivel
from cranktrain.linkage.forces import (
    Body,
    Conditions,
    SwivelLoads,
    Wrench,
    carrying_crank,
    crank_link,
    swivel_reactions,
    swivel_slider_link,
)
from cranktrain.mechanisms.dynamics import FRAME, Across, Contact, Dynamics, Forces, Group, Reaction
from cranktrain.mechanisms.on_crank import each_borne, torque_on_rocker
from cranktrain.mechanisms.slotted_lever.kinematics import SlottedLeverMotion
from cranktrain.motion import Link


def slotted_lever_links(motion: SlottedLeverMotion, geometry: CrankAndPivot) -> tuple[Link, ...]:
    """What moves: crank, from the shaft to its pin; block, from that along the slot; rocker, from its pivot too."""
    crank = crank_link(motion.pin, Crank(geometry.crank_radius))
    block = swivel_slider_link(motion.pin, motion.rocker)
    return crank, block, motion.rocker


def slotted_lever_forces(
    motion: SlottedLeverMotion,
    geometry: CrankAndPivot,
    bodies: tuple[Body, ...],
    loads: tuple[Wrench, ...],
    conditions: Conditions,
) -> Forces:
    """All forces of a slotted lever.

    Parameters
    ----------
    motion : SlottedLeverMotion, shape (..., n)
    geometry : CrankAndPivot, fields broadcastable to (..., 1)
    bodies : three of Body, fields broadcastable to (..., 1)
        Of crank, block and rocker.
    loads : three of Wrench, shape (..., n)
    conditions : Conditions, fields broadcastable to (..., n)
        Friction's sense is that of the block along the slot, away from the pivot.

    Returns
    -------
    Forces, shape (..., n)
        Of the bearing on the crank, the crank on the block, the block on the lever, the pivot on the lever; in the
        mechanism's axes. NaN where the links cannot close, or friction wedges the block.

    Notes
    -----
    Exact for rigid bodies; docs/theory/forces, eqs. (13.5), (13.7) and (13.17).
    """
    links = slotted_lever_links(motion, geometry)
    on_crank, on_block, on_rocker = each_borne(links, bodies, loads, conditions)
    group = swivel_reactions(
        OnLine(motion.rocker, motion.pin),
        Swivel(geometry.offset, AHEAD),
        SwivelLoads(on_block, on_rocker),
        conditions.friction[0],
    )
    shaft = carrying_crank(links[0], on_crank, motion.pin, group.pin)
    drag = motion.rocker.cos * group.slider.x + motion.rocker.sin * group.slider.y
    return Forces(
        (shaft.bearing, group.pin, group.slider, group.pivot),
        shaft.driving_torque,
        -drag * motion.block.first,
    )


DYNAMICS = Dynamics(
    moving=("crank", "block", "rocker"),
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
    load=torque_on_rocker,
    forces=slotted_lever_forces,
)
