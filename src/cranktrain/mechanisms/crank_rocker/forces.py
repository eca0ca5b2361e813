"""Forces of the crank-rocker: reactions of crank, rod and rocker, and the driving torque."""

from typing import Generic, NamedTuple

from cranktrain.linkage import Crank, Pin, PinMotion
from cranktrain.linkage.forces import (
    NOTHING,
    Body,
    Conditions,
    PinLoads,
    Wrench,
    borne,
    carrying_crank,
    crank_link,
    pin_reactions,
)
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker, CrankRockerMotion
from cranktrain.mechanisms.dynamics import FRAME, Across, Dynamics, Group, Reaction
from cranktrain.mechanisms.solved import Each, Forces
from cranktrain.motion import ZERO, Array, Link


class CrankRockerLinks(NamedTuple, Generic[Each]):
    """What each link has: crank, from the shaft to its pin; rod, from that to the joint; rocker, from its pivot to it.

    Its link, its body, or the wrench that it bears, about its first pin.
    """

    crank: Each
    rod: Each
    rocker: Each


class CrankRockerJoints(NamedTuple):
    """Wrenches of the bearing on the crank, the crank on the rod, the rod on the rocker, the pivot on the rocker."""

    main_bearing: Wrench
    crank_pin: Wrench
    joint: Wrench
    pivot: Wrench


def crank_rocker_links(motion: CrankRockerMotion, geometry: CrankRocker) -> CrankRockerLinks[Link]:
    """What moves, as links: crank, rod and rocker."""
    crank = crank_link(motion.pin, Crank(geometry.crank_radius))
    return CrankRockerLinks(crank, motion.rod, motion.rocker)


def crank_rocker_load(_motion: CrankRockerMotion, _geometry: CrankRocker, torque: Array) -> CrankRockerLinks[Wrench]:
    """Loads for a torque on the rocker, in the sense of rotation. [N·m]"""
    return CrankRockerLinks(NOTHING, NOTHING, Wrench(ZERO, ZERO, torque))


def crank_rocker_forces(
    motion: CrankRockerMotion,
    geometry: CrankRocker,
    bodies: CrankRockerLinks[Body],
    loads: CrankRockerLinks[Wrench],
    conditions: Conditions,
) -> Forces[CrankRockerJoints]:
    """All forces of a crank-rocker, which has no sliding friction.

    Parameters
    ----------
    motion : CrankRockerMotion, shape (..., n)
    geometry : CrankRocker, fields broadcastable to (..., 1)
    bodies : CrankRockerLinks of Body, fields broadcastable to (..., 1)
    loads : CrankRockerLinks of Wrench, shape (..., n)
    conditions : Conditions, fields broadcastable to (..., n)

    Returns
    -------
    Forces of CrankRockerJoints, shape (..., n)
        In the mechanism's axes; NaN where the links cannot close.

    Notes
    -----
    Exact for rigid bodies; docs/theory/forces, eqs. (13.5), (13.7) and (13.14).
    """
    links = crank_rocker_links(motion, geometry)
    crank = links[0]
    group = pin_reactions(
        PinMotion(motion.joint, motion.rod, motion.rocker),
        Pin(geometry.rod_length, geometry.rocker_length, geometry.side),
        PinLoads(
            borne(motion.rod, bodies.rod, loads.rod, conditions),
            borne(motion.rocker, bodies.rocker, loads.rocker, conditions),
        ),
    )
    on_crank = borne(crank, bodies.crank, loads.crank, conditions)
    shaft = carrying_crank(crank, on_crank, motion.pin, group.rod)
    return Forces(
        CrankRockerJoints(shaft.bearing, group.rod, group.joint, group.rocker),
        shaft.driving_torque,
        0.0 * shaft.driving_torque,
    )


DYNAMICS = Dynamics(
    bodies=CrankRockerLinks[Body],
    moving=CrankRockerLinks._fields,
    reactions=(
        Reaction("main_bearing", "crank", FRAME, "main_bearing"),
        Reaction("crank_pin", "rod", "crank", "crank_pin"),
        Reaction("joint", "rocker", "rod", "pin"),
        Reaction("pivot", "rocker", FRAME, "pivot"),
    ),
    sliding=(),
    contacts=(),
    groups=(Group("RRR", ("rod", "rocker"), (Across("crank_pin", "rod", "B"), Across("pivot", "rocker", "B"))),),
    links=crank_rocker_links,
    load=crank_rocker_load,
    forces=crank_rocker_forces,
)
