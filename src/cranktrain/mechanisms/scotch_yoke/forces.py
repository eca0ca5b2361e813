"""Forces of the scotch yoke: reactions of crank, block and slider, and the driving torque."""

from typing import NamedTuple

from cranktrain.linkage import Crank, Yoke
from cranktrain.linkage.forces import (
    NOTHING,
    Body,
    Conditions,
    CrossingFriction,
    Gravity,
    Reduced,
    Wrench,
    YokeLoads,
    block_link,
    borne,
    carrying_crank,
    crank_link,
    reduced_of_three,
    slider_link,
    yoke_reactions,
)
from cranktrain.mechanisms.kind import FRAME, Contact, Dynamics, Group, Reaction
from cranktrain.mechanisms.scotch_yoke.kinematics import ScotchYoke, ScotchYokeMotion
from cranktrain.mechanisms.solved import Forces
from cranktrain.motion import ZERO, Array, Link


class ScotchYokeBodies(NamedTuple):
    """Crank, from the shaft to its pin; block, from the pin along the slot; slider, from where the slot meets x."""

    crank: Body
    block: Body
    slider: Body


class ScotchYokeLoads(NamedTuple):
    """Wrenches on crank, block and slider, about the shaft's centre, the pin, and where the slot meets the guide."""

    crank: Wrench
    block: Wrench
    slider: Wrench


class ScotchYokeJoints(NamedTuple):
    """Wrenches of the bearing on the crank, the crank on the block, the block on the slider, the guide on it."""

    main_bearing: Wrench
    crank_pin: Wrench
    slot: Wrench
    guide: Wrench


def scotch_yoke_links(motion: ScotchYokeMotion, geometry: ScotchYoke) -> tuple[Link, Link, Link]:
    """What moves, as links: crank, block and slider."""
    crank = crank_link(motion.pin, Crank(geometry.crank_radius))
    block = block_link(motion.pin, geometry.slot_angle)
    slider = slider_link(motion.slider, geometry.offset)
    return (crank, block, slider)


def scotch_yoke_load(_motion: ScotchYokeMotion, _geometry: ScotchYoke, force: Array) -> ScotchYokeLoads:
    """Loads for a force on the slider along x, on the line of stroke, away from the shaft. [N]"""
    return ScotchYokeLoads(NOTHING, NOTHING, Wrench(force, ZERO, ZERO))


def scotch_yoke_forces(
    motion: ScotchYokeMotion,
    geometry: ScotchYoke,
    bodies: ScotchYokeBodies,
    loads: ScotchYokeLoads,
    conditions: Conditions,
) -> Forces[ScotchYokeJoints]:
    """All forces of a scotch yoke.

    Parameters
    ----------
    motion : ScotchYokeMotion, shape (..., n)
    geometry : ScotchYoke, fields broadcastable to (..., 1)
    bodies : ScotchYokeBodies, fields broadcastable to (..., 1)
    loads : ScotchYokeLoads, shape (..., n)
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


def scotch_yoke_reduced(
    motion: ScotchYokeMotion,
    geometry: ScotchYoke,
    bodies: ScotchYokeBodies,
    loads: ScotchYokeLoads,
    gravity: Gravity,
) -> Reduced:
    """Reduced inertia, its derivative, and the torque of loads and weights on the crank; parameters as of the forces.

    Without friction, which depends on how the crank turns. docs/theory/forces, eqs. (13.4) and (13.6).
    """
    return reduced_of_three(scotch_yoke_links(motion, geometry), bodies, loads, gravity)


DYNAMICS = Dynamics(
    bodies=ScotchYokeBodies,
    moving=ScotchYokeBodies._fields,
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
    reduced=scotch_yoke_reduced,
)
