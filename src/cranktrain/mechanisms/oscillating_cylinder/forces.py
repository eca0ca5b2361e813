"""Forces of the oscillating cylinder: reactions of crank, piston and cylinder, and the driving torque."""

from cranktrain.linkage import AHEAD, Crank, CrankAndPivot, OnLine, Swivel
from cranktrain.linkage.forces import (
    NOTHING,
    Body,
    Conditions,
    Friction,
    SwivelLoads,
    Wrench,
    carrying_crank,
    crank_link,
    swivel_reactions,
    swivel_slider_link,
)
from cranktrain.mechanisms.dynamics import FRAME, Across, Contact, Dynamics, Forces, Group, Reaction
from cranktrain.mechanisms.on_crank import each_borne
from cranktrain.mechanisms.oscillating_cylinder.kinematics import OscillatingCylinderMotion
from cranktrain.motion import ZERO, Array, Link


def oscillating_cylinder_links(motion: OscillatingCylinderMotion, geometry: CrankAndPivot) -> tuple[Link, ...]:
    """What moves: crank, from the shaft to its pin; piston and its rod, from that; cylinder, from its trunnion.

    Piston and cylinder both count along the direction from the trunnion to the crank pin: the head lies at minus.
    """
    crank = crank_link(motion.pin, Crank(geometry.crank_radius))
    piston = swivel_slider_link(motion.pin, motion.cylinder)
    return crank, piston, motion.cylinder


def oscillating_cylinder_load(
    motion: OscillatingCylinderMotion, geometry: CrankAndPivot, force: Array
) -> tuple[Wrench, ...]:
    """Loads for a force on the piston along the slider's coordinate, toward the head; the cylinder gets its opposite.

    Both act along the cylinder's axis. [N]
    """
    cylinder = motion.cylinder
    x = force * cylinder.cos
    y = force * cylinder.sin
    return NOTHING, Wrench(-x, -y, ZERO), Wrench(x, y, -geometry.offset * force)


def oscillating_cylinder_forces(
    motion: OscillatingCylinderMotion,
    geometry: CrankAndPivot,
    bodies: tuple[Body, ...],
    loads: tuple[Wrench, ...],
    conditions: Conditions,
) -> Forces:
    """All forces of an oscillating cylinder.

    Parameters
    ----------
    motion : OscillatingCylinderMotion, shape (..., n)
    geometry : CrankAndPivot, fields broadcastable to (..., 1)
    bodies : three of Body, fields broadcastable to (..., 1)
        Of crank, piston and cylinder.
    loads : three of Wrench, shape (..., n)
    conditions : Conditions, fields broadcastable to (..., n)
        Friction's sense is that of the slider's coordinate, toward the head.

    Returns
    -------
    Forces, shape (..., n)
        Of the bearing on the crank, the crank on the piston, the piston on the cylinder (about the crank pin), the
        trunnion on the cylinder; in the mechanism's axes. NaN where the links cannot close, or friction wedges the
        piston.

    Notes
    -----
    Exact for rigid bodies; docs/theory/forces, eqs. (13.5), (13.7) and (13.17).
    """
    links = oscillating_cylinder_links(motion, geometry)
    on_crank, on_piston, on_cylinder = each_borne(links, bodies, loads, conditions)
    friction = conditions.friction[0]
    group = swivel_reactions(
        OnLine(motion.cylinder, motion.pin),
        Swivel(geometry.offset, AHEAD),
        SwivelLoads(on_piston, on_cylinder),
        # The group counts its slider from the trunnion, the mechanism toward it.
        Friction(friction.coefficient, -friction.sense, friction.per_length, -friction.middle),
    )
    shaft = carrying_crank(links[0], on_crank, motion.pin, group.pin)
    drag = motion.cylinder.cos * group.slider.x + motion.cylinder.sin * group.slider.y
    return Forces(
        (shaft.bearing, group.pin, group.slider, group.pivot),
        shaft.driving_torque,
        drag * motion.slider.first,
    )


DYNAMICS = Dynamics(
    moving=("crank", "slider", "cylinder"),
    reactions=(
        Reaction("main_bearing", "crank", FRAME, "main_bearing"),
        Reaction("crank_pin", "slider", "crank", "crank_pin"),
        Reaction("guide", "cylinder", "slider", "guide"),
        Reaction("trunnion", "cylinder", FRAME, "pivot"),
    ),
    sliding=("slider",),
    contacts=(Contact("guide", "A", way=-1.0),),
    groups=(Group("RPR", ("slider", "cylinder"), (Across("crank_pin", "cylinder", "C"),)),),
    links=oscillating_cylinder_links,
    load=oscillating_cylinder_load,
    forces=oscillating_cylinder_forces,
)
