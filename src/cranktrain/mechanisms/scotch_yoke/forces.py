"""Forces of the scotch yoke: reactions of crank, block and slider, and the driving torque."""

from cranktrain.linkage import Crank, Yoke
from cranktrain.linkage.forces import (
    Body,
    Conditions,
    CrossingFriction,
    CrossingLoads,
    Wrench,
    block_link,
    carrying_crank,
    crank_link,
    slider_link,
    yoke_reactions,
)
from cranktrain.mechanisms.dynamics import FRAME, Contact, Dynamics, Forces, Group, Reaction
from cranktrain.mechanisms.on_crank import each_borne, force_on_slider
from cranktrain.mechanisms.scotch_yoke.kinematics import ScotchYoke, ScotchYokeMotion
from cranktrain.motion import Link


def scotch_yoke_links(motion: ScotchYokeMotion, geometry: ScotchYoke) -> tuple[Link, ...]:
    """What moves: crank, from the shaft to its pin; block, from that along the slot; slider, along x.

    The slider's first pin is where the slot meets the guide.
    """
    crank = crank_link(motion.pin, Crank(geometry.crank_radius))
    block = block_link(motion.pin, geometry.slot_angle)
    slider = slider_link(motion.slider, geometry.offset)
    return crank, block, slider


def scotch_yoke_forces(
    motion: ScotchYokeMotion,
    geometry: ScotchYoke,
    bodies: tuple[Body, ...],
    loads: tuple[Wrench, ...],
    conditions: Conditions,
) -> Forces:
    """All forces of a scotch yoke.

    Parameters
    ----------
    motion : ScotchYokeMotion, shape (..., n)
    geometry : ScotchYoke, fields broadcastable to (..., 1)
    bodies : three of Body, fields broadcastable to (..., 1)
        Of crank, block and slider.
    loads : three of Wrench, shape (..., n)
    conditions : Conditions, fields broadcastable to (..., n)
        Friction of the slider in its guide, and of the block along the slot.

    Returns
    -------
    Forces, shape (..., n)
        Of the bearing on the crank, the crank on the block, the block on the slider, the guide on the slider; in the
        mechanism's axes. NaN where friction wedges the slider.

    Notes
    -----
    Exact for rigid bodies; docs/theory/forces, eqs. (13.5), (13.7) and (13.20).
    """
    links = scotch_yoke_links(motion, geometry)
    crank, block, _slider = links
    on_crank, on_block, on_slider = each_borne(links, bodies, loads, conditions)
    group = yoke_reactions(
        motion.block.value,
        Yoke(geometry.offset, geometry.slot_angle),
        CrossingLoads(on_block, on_slider),
        CrossingFriction(conditions.friction[0], conditions.friction[1]),
    )
    shaft = carrying_crank(crank, on_crank, motion.pin, group.block)
    # Of the block on the slot, along it: on the block it is the opposite.
    rubbing = block.cos * group.slider.x + block.sin * group.slider.y
    return Forces(
        (shaft.bearing, group.block, group.slider, group.guide),
        shaft.driving_torque,
        group.guide.x * motion.slider.first - rubbing * motion.block.first,
    )


DYNAMICS = Dynamics(
    moving=("crank", "block", "slider"),
    reactions=(
        Reaction("main_bearing", "crank", FRAME, "main_bearing"),
        Reaction("crank_pin", "block", "crank", "crank_pin"),
        Reaction("slot", "slider", "block", "slot"),
        Reaction("guide", "slider", FRAME, "guide"),
    ),
    sliding=("slider", "block"),
    contacts=(Contact("guide", "B"), Contact("slot", "A", bears_moment=False)),
    groups=(Group("RPP", ("block", "slider")),),
    links=scotch_yoke_links,
    load=force_on_slider,
    forces=scotch_yoke_forces,
)
