"""Forces of the oscillating cylinder: reactions of crank, piston and cylinder, and the driving torque."""

from typing import Generic, NamedTuple

from cranktrain.linkage import AHEAD, Crank, CrankAndPivot, OnLine, Swivel
from cranktrain.linkage.forces import (
    NOTHING,
    Body,
    Conditions,
    Friction,
    SwivelLoads,
    Wrench,
    borne,
    carrying_crank,
    crank_link,
    swivel_reactions,
    swivel_slider_link,
)
from cranktrain.mechanisms.dynamics import FRAME, Across, Contact, Dynamics, Group, Reaction
from cranktrain.mechanisms.oscillating_cylinder.kinematics import OscillatingCylinderMotion
from cranktrain.mechanisms.solved import Each, Forces
from cranktrain.motion import ZERO, Array, Link


class OscillatingCylinderLinks(NamedTuple, Generic[Each]):
    """What each link has: crank, from the shaft to its pin; piston and its rod, from that; cylinder, from its trunnion.

    Its link, its body, or the wrench that it bears, about its first pin. Piston and cylinder both count along the
    direction from the trunnion to the crank pin: the head lies at minus.
    """

    crank: Each
    slider: Each
    cylinder: Each


class OscillatingCylinderJoints(NamedTuple):
    """Wrenches of the bearing on the crank, the crank on the piston, the piston on the cylinder, the trunnion on it.

    That of the piston on the cylinder is about the crank pin.
    """

    main_bearing: Wrench
    crank_pin: Wrench
    guide: Wrench
    trunnion: Wrench


def oscillating_cylinder_links(
    motion: OscillatingCylinderMotion, geometry: CrankAndPivot
) -> OscillatingCylinderLinks[Link]:
    """What moves, as links: crank, slider and cylinder."""
    crank = crank_link(motion.pin, Crank(geometry.crank_radius))
    piston = swivel_slider_link(motion.pin, motion.cylinder)
    return OscillatingCylinderLinks(crank, piston, motion.cylinder)


def oscillating_cylinder_load(
    motion: OscillatingCylinderMotion, geometry: CrankAndPivot, force: Array
) -> OscillatingCylinderLinks[Wrench]:
    """Loads for a force on the piston along the slider's coordinate, toward the head; the cylinder gets its opposite.

    Both act along the cylinder's axis. [N]
    """
    cylinder = motion.cylinder
    x = force * cylinder.cos
    y = force * cylinder.sin
    return OscillatingCylinderLinks(NOTHING, Wrench(-x, -y, ZERO), Wrench(x, y, -geometry.offset * force))


def oscillating_cylinder_forces(
    motion: OscillatingCylinderMotion,
    geometry: CrankAndPivot,
    bodies: OscillatingCylinderLinks[Body],
    loads: OscillatingCylinderLinks[Wrench],
    conditions: Conditions,
) -> Forces[OscillatingCylinderJoints]:
    """All forces of an oscillating cylinder.

    Parameters
    ----------
    motion : OscillatingCylinderMotion, shape (..., n)
    geometry : CrankAndPivot, fields broadcastable to (..., 1)
    bodies : OscillatingCylinderLinks of Body, fields broadcastable to (..., 1)
    loads : OscillatingCylinderLinks of Wrench, shape (..., n)
    conditions : Conditions, fields broadcastable to (..., n)
        Friction's sense is that of the slider's coordinate, toward the head.

    Returns
    -------
    Forces of OscillatingCylinderJoints, shape (..., n)
        In the mechanism's axes; NaN where the links cannot close, or friction wedges the piston.

    Notes
    -----
    Exact for rigid bodies; docs/theory/forces, eqs. (13.5), (13.7) and (13.17).
    """
    links = oscillating_cylinder_links(motion, geometry)
    crank, piston = links[:2]
    friction = conditions.friction[0]
    group = swivel_reactions(
        OnLine(motion.cylinder, motion.pin),
        Swivel(geometry.offset, AHEAD),
        SwivelLoads(
            borne(piston, bodies.slider, loads.slider, conditions),
            borne(motion.cylinder, bodies.cylinder, loads.cylinder, conditions),
        ),
        # The group counts its slider from the trunnion, the mechanism toward it.
        Friction(friction.coefficient, -friction.sense, friction.per_length, -friction.middle),
    )
    on_crank = borne(crank, bodies.crank, loads.crank, conditions)
    shaft = carrying_crank(crank, on_crank, motion.pin, group.pin)
    drag = motion.cylinder.cos * group.slider.x + motion.cylinder.sin * group.slider.y
    return Forces(
        OscillatingCylinderJoints(shaft.bearing, group.pin, group.slider, group.pivot),
        shaft.driving_torque,
        drag * motion.slider.first,
    )


DYNAMICS = Dynamics(
    bodies=OscillatingCylinderLinks[Body],
    moving=OscillatingCylinderLinks._fields,
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
