"""Forces of the slider-crank: reactions of crank, rod and slider, and the driving torque."""

from typing import NamedTuple

from cranktrain.linkage import AHEAD, Crank, Slide
from cranktrain.linkage.forces import (
    NOTHING,
    Body,
    Conditions,
    Gravity,
    Reduced,
    SlideLoads,
    Wrench,
    borne,
    carrying_crank,
    crank_link,
    reduced_of_three,
    slide_reactions,
    slider_link,
)
from cranktrain.mechanisms.kind import FRAME, Across, Contact, Dynamics, Group, Reaction
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, SliderCrankMotion
from cranktrain.mechanisms.solved import Forces
from cranktrain.motion import ZERO, Array, Link


class SliderCrankBodies(NamedTuple):
    """Crank, from the shaft to its pin; rod, from the crank pin to the slider's; slider, from its pin along x."""

    crank: Body
    rod: Body
    slider: Body


class SliderCrankLoads(NamedTuple):
    """Wrenches on crank, rod and slider, each about its first pin: the shaft's centre, the crank pin, the slider's."""

    crank: Wrench
    rod: Wrench
    slider: Wrench


class SliderCrankJoints(NamedTuple):
    """Wrenches of the bearing on the crank, the crank on the rod, the rod on the slider, the guide on the slider."""

    main_bearing: Wrench
    crank_pin: Wrench
    wrist_pin: Wrench
    guide: Wrench


def slider_crank_links(motion: SliderCrankMotion, geometry: SliderCrank) -> tuple[Link, Link, Link]:
    """What moves, as links: crank, rod and slider."""
    crank = crank_link(motion.pin, Crank(geometry.crank_radius))
    slider = slider_link(motion.slider, geometry.offset)
    return (crank, motion.rod, slider)


def slider_crank_load(_motion: SliderCrankMotion, _geometry: SliderCrank, force: Array) -> SliderCrankLoads:
    """Loads for a force on the slider along x, away from the shaft; a gas presses toward it. [N]"""
    return SliderCrankLoads(NOTHING, NOTHING, Wrench(force, ZERO, ZERO))


def slider_crank_forces(
    motion: SliderCrankMotion,
    geometry: SliderCrank,
    bodies: SliderCrankBodies,
    loads: SliderCrankLoads,
    conditions: Conditions,
) -> Forces[SliderCrankJoints]:
    """All forces of a slider-crank.

    Parameters
    ----------
    motion : SliderCrankMotion, shape (..., n)
    geometry : SliderCrank, fields broadcastable to (..., 1)
    bodies : SliderCrankBodies, fields broadcastable to (..., 1)
    loads : SliderCrankLoads, shape (..., n)
        Rods that hang on this one load it: `loads.rod`.
    conditions : Conditions, fields broadcastable to (..., n)

    Returns
    -------
    Forces of SliderCrankJoints, shape (..., n)
        In the mechanism's axes. NaN where the rod cannot reach, or friction wedges the slider.

    Notes
    -----
    Exact for rigid bodies; docs/theory/forces, eqs. (13.5), (13.7) and (13.12).

    Examples
    --------
    A massless one at right angles, pressed by 1 kN: torque P(R − e), the crank pin bears P/cos β.

    >>> from cranktrain.linkage.forces import NO_FRICTION, Drive
    >>> from cranktrain.mechanisms.slider_crank.kinematics import slider_crank
    >>> geometry = SliderCrank(0.05, 0.13, 0.0)
    >>> motion = slider_crank(1.5707963267948966, geometry)
    >>> bodies = SliderCrankBodies(*3 * [Body(0.0, 0.0, 0.0, 0.0)])
    >>> load = slider_crank_load(motion, geometry, -1000.0)
    >>> standing = Conditions(Drive(0.0, 0.0), Gravity(0.0, 0.0), (NO_FRICTION,))
    >>> forces = slider_crank_forces(motion, geometry, bodies, load, standing)
    >>> round(float(forces.driving_torque), 9), round(float(forces.joints.guide.y), 6)
    (-50.0, 416.666667)
    """
    links = slider_crank_links(motion, geometry)
    crank, _, slider = links
    group = slide_reactions(
        motion.rod,
        Slide(geometry.rod_length, geometry.offset, AHEAD),
        SlideLoads(
            borne(motion.rod, bodies.rod, loads.rod, conditions),
            borne(slider, bodies.slider, loads.slider, conditions),
        ),
        conditions.friction[0],
    )
    on_crank = borne(crank, bodies.crank, loads.crank, conditions)
    shaft = carrying_crank(crank, on_crank, motion.pin, group.pin)
    return Forces(
        SliderCrankJoints(shaft.bearing, group.pin, group.joint, group.guide),
        shaft.driving_torque,
        group.guide.x * motion.slider.first,
    )


def slider_crank_reduced(
    motion: SliderCrankMotion,
    geometry: SliderCrank,
    bodies: SliderCrankBodies,
    loads: SliderCrankLoads,
    gravity: Gravity,
) -> Reduced:
    """Reduced inertia, its derivative, and the torque of loads and weights on the crank; parameters as of the forces.

    Without friction, which depends on how the crank turns. docs/theory/forces, eqs. (13.4) and (13.6).
    """
    return reduced_of_three(slider_crank_links(motion, geometry), bodies, loads, gravity)


DYNAMICS = Dynamics(
    bodies=SliderCrankBodies,
    moving=SliderCrankBodies._fields,
    reactions=(
        Reaction("main_bearing", "crank", FRAME, "main_bearing"),
        Reaction("crank_pin", "rod", "crank", "crank_pin"),
        Reaction("wrist_pin", "slider", "rod", "piston_pin"),
        Reaction("guide", "slider", FRAME, "guide"),
    ),
    sliding=("slider",),
    contacts=(Contact("guide", "B"),),
    groups=(Group("RRP", ("rod", "slider"), (Across("crank_pin", "rod", "B"),)),),
    links=slider_crank_links,
    load=slider_crank_load,
    forces=slider_crank_forces,
    reduced=slider_crank_reduced,
)
