"""Forces of the crank-rocker: reactions of crank, rod and rocker, and the driving torque."""

from cranktrain.linkage import Crank, Pin, PinMotion
from cranktrain.linkage.forces import Body, Conditions, PinLoads, Wrench, carrying_crank, crank_link, pin_reactions
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker, CrankRockerMotion
from cranktrain.mechanisms.dynamics import FRAME, Across, Dynamics, Forces, Group, Reaction
from cranktrain.mechanisms.on_crank import each_borne, torque_on_rocker
from cranktrain.motion import Link


def crank_rocker_links(motion: CrankRockerMotion, geometry: CrankRocker) -> tuple[Link, ...]:
    """What moves: crank, from the shaft to its pin; rod, from that to the joint; rocker, from its pivot to it."""
    crank = crank_link(motion.pin, Crank(geometry.crank_radius))
    return crank, motion.rod, motion.rocker


def crank_rocker_forces(
    motion: CrankRockerMotion,
    geometry: CrankRocker,
    bodies: tuple[Body, ...],
    loads: tuple[Wrench, ...],
    conditions: Conditions,
) -> Forces:
    """All forces of a crank-rocker, which has no sliding friction.

    Parameters
    ----------
    motion : CrankRockerMotion, shape (..., n)
    geometry : CrankRocker, fields broadcastable to (..., 1)
    bodies : three of Body, fields broadcastable to (..., 1)
        Of crank, rod and rocker.
    loads : three of Wrench, shape (..., n)
    conditions : Conditions, fields broadcastable to (..., n)

    Returns
    -------
    Forces, shape (..., n)
        Of the bearing on the crank, the crank on the rod, the rod on the rocker, the pivot on the rocker; in the
        mechanism's axes. NaN where the links cannot close.

    Notes
    -----
    Exact for rigid bodies; docs/theory/forces, eqs. (13.5), (13.7) and (13.14).
    """
    links = crank_rocker_links(motion, geometry)
    on_crank, on_rod, on_rocker = each_borne(links, bodies, loads, conditions)
    group = pin_reactions(
        PinMotion(motion.joint, motion.rod, motion.rocker),
        Pin(geometry.rod_length, geometry.rocker_length, geometry.side),
        PinLoads(on_rod, on_rocker),
    )
    shaft = carrying_crank(links[0], on_crank, motion.pin, group.rod)
    return Forces(
        (shaft.bearing, group.rod, group.joint, group.rocker),
        shaft.driving_torque,
        0.0 * shaft.driving_torque,
    )


DYNAMICS = Dynamics(
    moving=("crank", "rod", "rocker"),
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
    load=torque_on_rocker,
    forces=crank_rocker_forces,
)
