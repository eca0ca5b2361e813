"""Forces of the slider-crank: reactions of crank, rod and slider, and the driving torque."""

from cranktrain.linkage import AHEAD, Crank, Slide
from cranktrain.linkage.forces import (
    Body,
    Conditions,
    SlideLoads,
    Wrench,
    carrying_crank,
    crank_link,
    slide_reactions,
    slider_link,
)
from cranktrain.mechanisms.dynamics import FRAME, Across, Contact, Dynamics, Forces, Group, Reaction
from cranktrain.mechanisms.on_crank import each_borne, force_on_slider
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, SliderCrankMotion
from cranktrain.motion import Link


def slider_crank_links(motion: SliderCrankMotion, geometry: SliderCrank) -> tuple[Link, ...]:
    """What moves: crank, from the shaft to its pin; rod, from the crank pin to the slider's; slider, along x."""
    crank = crank_link(motion.pin, Crank(geometry.crank_radius))
    slider = slider_link(motion.slider, geometry.offset)
    return crank, motion.rod, slider


def slider_crank_forces(
    motion: SliderCrankMotion,
    geometry: SliderCrank,
    bodies: tuple[Body, ...],
    loads: tuple[Wrench, ...],
    conditions: Conditions,
) -> Forces:
    """All forces of a slider-crank.

    Parameters
    ----------
    motion : SliderCrankMotion, shape (..., n)
    geometry : SliderCrank, fields broadcastable to (..., 1)
    bodies : three of Body, fields broadcastable to (..., 1)
        Of crank, rod and slider.
    loads : three of Wrench, shape (..., n)
        Rods that hang on this one load it.
    conditions : Conditions, fields broadcastable to (..., n)

    Returns
    -------
    Forces, shape (..., n)
        Of the bearing on the crank, the crank on the rod, the rod on the slider, the guide on the slider; in the
        mechanism's axes. NaN where the rod cannot reach, or friction wedges the slider.

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
    >>> bodies = 3 * (Body(0.0, 0.0, 0.0, 0.0),)
    >>> load = force_on_slider(motion, geometry, -1000.0)
    >>> standing = Conditions(Drive(0.0, 0.0), Gravity(0.0, 0.0), (NO_FRICTION,))
    >>> forces = slider_crank_forces(motion, geometry, bodies, load, standing)
    >>> _bearing, _crank_pin, _wrist_pin, guide = forces.joints
    >>> round(float(forces.driving_torque), 9), round(float(guide.y), 6)
    (-50.0, 416.666667)
    """
    links = slider_crank_links(motion, geometry)
    on_crank, on_rod, on_slider = each_borne(links, bodies, loads, conditions)
    group = slide_reactions(
        motion.rod,
        Slide(geometry.rod_length, geometry.offset, AHEAD),
        SlideLoads(on_rod, on_slider),
        conditions.friction[0],
    )
    shaft = carrying_crank(links[0], on_crank, motion.pin, group.pin)
    return Forces(
        (shaft.bearing, group.pin, group.joint, group.guide),
        shaft.driving_torque,
        group.guide.x * motion.slider.first,
    )


DYNAMICS = Dynamics(
    moving=("crank", "rod", "slider"),
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
    load=force_on_slider,
    forces=slider_crank_forces,
)
