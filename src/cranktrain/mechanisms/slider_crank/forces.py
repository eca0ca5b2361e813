"""Forces of the slider-crank: reactions of crank, rod and slider, and the driving torque."""

from typing import Generic, NamedTuple

from cranktrain.linkage import AHEAD, Crank, Slide
from cranktrain.linkage.forces import (
    NOTHING,
    Body,
    Conditions,
    SlideLoads,
    Wrench,
    borne,
    carrying_crank,
    crank_link,
    slide_reactions,
    slider_link,
)
from cranktrain.mechanisms.dynamics import FRAME, Across, Contact, Dynamics, Group, Reaction
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, SliderCrankMotion
from cranktrain.mechanisms.solved import Each, Forces
from cranktrain.motion import ZERO, Array, Link


class SliderCrankLinks(NamedTuple, Generic[Each]):
    """What each link has: crank, from the shaft to its pin; rod, from the crank pin to the slider's; slider, along x.

    Its link, its body, or the wrench that it bears, about its first pin.
    """

    crank: Each
    rod: Each
    slider: Each


class SliderCrankJoints(NamedTuple):
    """Wrenches of the bearing on the crank, the crank on the rod, the rod on the slider, the guide on the slider."""

    main_bearing: Wrench
    crank_pin: Wrench
    wrist_pin: Wrench
    guide: Wrench


def slider_crank_links(motion: SliderCrankMotion, geometry: SliderCrank) -> SliderCrankLinks[Link]:
    """What moves, as links: crank, rod and slider."""
    crank = crank_link(motion.pin, Crank(geometry.crank_radius))
    slider = slider_link(motion.slider, geometry.offset)
    return SliderCrankLinks(crank, motion.rod, slider)


def slider_crank_load(_motion: SliderCrankMotion, _geometry: SliderCrank, force: Array) -> SliderCrankLinks[Wrench]:
    """Loads for a force on the slider along x, away from the shaft; a gas presses toward it. [N]"""
    return SliderCrankLinks(NOTHING, NOTHING, Wrench(force, ZERO, ZERO))


def slider_crank_forces(
    motion: SliderCrankMotion,
    geometry: SliderCrank,
    bodies: SliderCrankLinks[Body],
    loads: SliderCrankLinks[Wrench],
    conditions: Conditions,
) -> Forces[SliderCrankJoints]:
    """All forces of a slider-crank.

    Parameters
    ----------
    motion : SliderCrankMotion, shape (..., n)
    geometry : SliderCrank, fields broadcastable to (..., 1)
    bodies : SliderCrankLinks of Body, fields broadcastable to (..., 1)
    loads : SliderCrankLinks of Wrench, shape (..., n)
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

    >>> from cranktrain.linkage.forces import NO_FRICTION, Drive, Gravity
    >>> from cranktrain.mechanisms.slider_crank.kinematics import slider_crank
    >>> geometry = SliderCrank(0.05, 0.13, 0.0)
    >>> motion = slider_crank(1.5707963267948966, geometry)
    >>> bodies = SliderCrankLinks(*3 * [Body(0.0, 0.0, 0.0, 0.0)])
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


DYNAMICS = Dynamics(
    bodies=SliderCrankLinks[Body],
    moving=SliderCrankLinks._fields,
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
)
