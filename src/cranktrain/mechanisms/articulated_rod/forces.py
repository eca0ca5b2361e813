"""Forces of the articulated rod: reactions of slave rod and slider, and what they add to those of the master."""

from cranktrain.linkage import AHEAD, Crank, Slide, turned
from cranktrain.linkage.forces import (
    NO_FRICTION,
    NOTHING,
    Body,
    Conditions,
    SlideLoads,
    Wrench,
    borne,
    crank_link,
    crank_reactions,
    handed_back,
    slide_reactions,
    slider_link,
    turned_wrench,
)
from cranktrain.mechanisms.articulated_rod.kinematics import ArticulatedRod, ArticulatedRodMotion
from cranktrain.mechanisms.dynamics import FRAME, Across, Contact, Dynamics, Forces, Group, Reaction
from cranktrain.motion import ZERO, Array, Link


def articulated_rod_links(motion: ArticulatedRodMotion, geometry: ArticulatedRod) -> tuple[Link, ...]:
    """What moves, in the slave cylinder's axes: its rod, from the knuckle pin to the slider's; the slider, along it."""
    return motion.rod, slider_link(motion.slider, geometry.offset)


def articulated_rod_load(_motion: ArticulatedRodMotion, _geometry: ArticulatedRod, force: Array) -> tuple[Wrench, ...]:
    """Loads for a force on the slave's slider along its cylinder, away from the shaft; a gas presses toward it. [N]"""
    return NOTHING, Wrench(force, ZERO, ZERO)


def on_master_rod(motion: ArticulatedRodMotion, geometry: ArticulatedRod, knuckle: Wrench) -> Wrench:
    """Load of a slave on its master's rod, about the crank pin, in the master's axes.

    Parameters
    ----------
    motion : ArticulatedRodMotion, shape (..., n)
    geometry : ArticulatedRod, fields broadcastable to (..., 1)
    knuckle : Wrench, shape (..., n)
        Of the master rod on the slave rod, in the slave cylinder's axes.

    Returns
    -------
    Wrench, shape (..., n)
        The master is a slider-crank with the sum of these over its slaves on its rod: so its forces are exact, with
        friction in its guide too. docs/theory/forces, eq. (13.3).
    """
    back = -geometry.bank_angle
    return handed_back(motion.master_rod, turned(motion.knuckle, back), turned_wrench(knuckle, back))


def articulated_rod_forces(
    motion: ArticulatedRodMotion,
    geometry: ArticulatedRod,
    bodies: tuple[Body, ...],
    loads: tuple[Wrench, ...],
    conditions: Conditions,
) -> Forces:
    """All forces of an articulated rod, and its share of its master's.

    Parameters
    ----------
    motion : ArticulatedRodMotion, shape (..., n)
    geometry : ArticulatedRod, fields broadcastable to (..., 1)
    bodies : two of Body, fields broadcastable to (..., 1)
        Of the slave's rod and slider.
    loads : two of Wrench, shape (..., n)
    conditions : Conditions, fields broadcastable to (..., n)
        Gravity in the slave cylinder's axes; friction of the slave's slider.

    Returns
    -------
    Forces, shape (..., n)
        Of the master rod on the slave rod, the slave rod on the slider, the guide on it; and the slave's share of the
        master's: of the bearing on the crank, the crank on the master rod, that on the master's slider, its guide on
        it. All in the slave cylinder's axes. NaN where master or slave cannot close, or friction wedges the slave's
        slider. The shares of the master's joints add up, and to the master's own, where the master's slider has no
        friction.

    Notes
    -----
    The slave loads the master's cylinder and bends its rod. Exact for rigid bodies; docs/theory/forces, eqs. (13.25)
    and (13.26).
    """
    master = geometry.master
    rod, slider = articulated_rod_links(motion, geometry)
    own = slide_reactions(
        rod,
        Slide(geometry.rod_length, geometry.offset, AHEAD),
        SlideLoads(borne(rod, bodies[0], loads[0], conditions), borne(slider, bodies[1], loads[1], conditions)),
        conditions.friction[0],
    )
    share = slide_reactions(
        motion.master_rod,
        Slide(master.rod_length, master.offset, AHEAD),
        SlideLoads(on_master_rod(motion, geometry, own.pin), NOTHING),
        NO_FRICTION,
    )
    crank = crank_link(motion.pin, Crank(master.crank_radius))
    shaft = crank_reactions(handed_back(crank, motion.pin, share.pin))
    gamma = geometry.bank_angle
    return Forces(
        (
            own.pin,
            own.joint,
            own.guide,
            turned_wrench(shaft.bearing, gamma),
            turned_wrench(share.pin, gamma),
            turned_wrench(share.joint, gamma),
            turned_wrench(share.guide, gamma),
        ),
        shaft.driving_torque,
        own.guide.x * motion.slider.first,
    )


DYNAMICS = Dynamics(
    moving=("rod", "slider"),
    reactions=(
        Reaction("knuckle", "rod", "master_rod", "knuckle_pin"),
        Reaction("wrist_pin", "slider", "rod", "piston_pin"),
        Reaction("guide", "slider", FRAME, "guide"),
        Reaction("main_bearing", "crank", FRAME, "main_bearing"),
        Reaction("crank_pin", "master_rod", "crank", "crank_pin"),
        Reaction("master_wrist_pin", "master_slider", "master_rod", "piston_pin"),
        Reaction("master_guide", "master_slider", FRAME, "guide"),
    ),
    sliding=("slider",),
    contacts=(Contact("guide", "D"),),
    groups=(Group("RRP", ("rod", "slider"), (Across("knuckle", "rod", "D"),)),),
    links=articulated_rod_links,
    load=articulated_rod_load,
    forces=articulated_rod_forces,
    on_master=on_master_rod,
)
