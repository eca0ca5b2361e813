"""Forces of the scotch yoke: reactions of crank, block and slider, and the driving torque."""

from typing import Generic, NamedTuple

from cranktrain.linkage import Crank, Yoke
from cranktrain.linkage.forces import (
    NOTHING,
    Body,
    Conditions,
    CrossingFriction,
    Wrench,
    YokeLoads,
    block_link,
    borne,
    carrying_crank,
    crank_link,
    slider_link,
    yoke_reactions,
)
from cranktrain.mechanisms.dynamics import FRAME, Contact, Dynamics, Group, Reaction
from cranktrain.mechanisms.scotch_yoke.kinematics import ScotchYoke, ScotchYokeMotion
from cranktrain.mechanisms.solved import Each, Forces
from cranktrain.motion import ZERO, Array, Link


class ScotchYokeLinks(NamedTuple, Generic[Each]):
    """What each link has: crank, from the shaft to its pin; block, from that along the slot; slider, from there on x.

    Its link, its body, or the wrench that it bears, about its first pin. The slider's
    is where the slot meets the guide.
    """

    crank: Each
    block: Each
    slider: Each


class ScotchYokeJoints(NamedTuple):
    """Wrenches of the bearing on the crank, the crank on the block, the block on the slider, the guide on it."""

    main_bearing: Wrench
    crank_pin: Wrench
    slot: Wrench
    guide: Wrench


def scotch_yoke_links(motion: ScotchYokeMotion, geometry: ScotchYoke) -> ScotchYokeLinks[Link]:
    """What moves, as links: crank, block and slider."""
    crank = crank_link(motion.pin, Crank(geometry.crank_radius))
    block = block_link(motion.pin, geometry.slot_angle)
    slider = slider_link(motion.slider, geometry.offset)
    return ScotchYokeLinks(crank, block, slider)


def scotch_yoke_load(_motion: ScotchYokeMotion, _geometry: ScotchYoke, force: Array) -> ScotchYokeLinks[Wrench]:
    """Loads for a force on the slider along x, on the line of stroke, away from the shaft. [N]"""
    return ScotchYokeLinks(NOTHING, NOTHING, Wrench(force, ZERO, ZERO))


def scotch_yoke_forces(
    motion: ScotchYokeMotion,
    geometry: ScotchYoke,
    bodies: ScotchYokeLinks[Body],
    loads: ScotchYokeLinks[Wrench],
    conditions: Conditions,
) -> Forces[ScotchYokeJoints]:
    """All forces of a scotch yoke.

    Parameters
    ----------
    motion : ScotchYokeMotion, shape (..., n)
    geometry : ScotchYoke, fields broadcastable to (..., 1)
    bodies : ScotchYokeLinks of Body, fields broadcastable to (..., 1)
    loads : ScotchYokeLinks of Wrench, shape (..., n)
    conditions : Conditions, fields broadcastable to (..., n)
        Friction of the slider in its guide, and of the block along the slot.

    Returns
    -------
    Forces of ScotchYokeJoints, shape (..., n)
        In the mechanism's axes; NaN where friction wedges the slider.

    Notes
    -----
    Exact for rigid bodies; docs/theory/forces, eqs. (13.5), (13.7) and (13.20).
    """
    links = scotch_yoke_links(motion, geometry)
    crank, block, slider = links
    group = yoke_reactions(
        motion.block.value,
        Yoke(geometry.offset, geometry.slot_angle),
        YokeLoads(
            borne(block, bodies.block, loads.block, conditions),
            borne(slider, bodies.slider, loads.slider, conditions),
        ),
        CrossingFriction(conditions.friction[0], conditions.friction[1]),
    )
    on_crank = borne(crank, bodies.crank, loads.crank, conditions)
    shaft = carrying_crank(crank, on_crank, motion.pin, group.pin)
    # Of the block on the slot, along it: on the block it is the opposite.
    rubbing = block.cos * group.slot.x + block.sin * group.slot.y
    return Forces(
        ScotchYokeJoints(shaft.bearing, group.pin, group.slot, group.guide),
        shaft.driving_torque,
        group.guide.x * motion.slider.first - rubbing * motion.block.first,
    )


DYNAMICS = Dynamics(
    bodies=ScotchYokeLinks[Body],
    moving=ScotchYokeLinks._fields,
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
    load=scotch_yoke_load,
    forces=scotch_yoke_forces,
)
