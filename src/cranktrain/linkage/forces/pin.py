"""Reactions of an RRR group: a rod and a rocker jointed to one another."""

from typing import NamedTuple

from cranktrain.linkage.forces.wrench import Wrench
from cranktrain.linkage.pin import Pin, PinMotion


class PinLoads(NamedTuple):
    """What rod and rocker bear but for their joints, each about its first pin, the outer one."""

    rod: Wrench
    rocker: Wrench


class PinReactions(NamedTuple):
    """Wrenches of the outer pins on rod and rocker, and of the rod on the rocker in their joint; none has a moment."""

    rod: Wrench
    rocker: Wrench
    joint: Wrench


def pin_reactions(motion: PinMotion, geometry: Pin, loads: PinLoads) -> PinReactions:
    """Reactions of a rod and a rocker.

    Parameters
    ----------
    motion : PinMotion, shape (..., n)
    geometry : Pin, fields broadcastable to (..., 1)
    loads : PinLoads, shape (..., n)

    Returns
    -------
    PinReactions, shape (..., n)
        NaN where the links cannot meet. They grow beyond all bounds where rod and rocker come into line.

    Notes
    -----
    With q, t from the outer pins to the joint and moments M_l, M_r about them, the rod on the rocker is
    (M_l t + M_r q)/(q × t). docs/theory/forces, eqs. (13.13) and (13.14).
    """
    rod = motion.rod
    rocker = motion.rocker
    sine = rod.cos * rocker.sin - rod.sin * rocker.cos
    # Force along each link is what the other's moment asks for.
    along_rod = loads.rocker.moment / (geometry.rocker_length * sine)
    along_rocker = loads.rod.moment / (geometry.rod_length * sine)
    x = along_rocker * rocker.cos + along_rod * rod.cos
    y = along_rocker * rocker.sin + along_rod * rod.sin
    zero = 0.0 * x
    return PinReactions(
        Wrench(x - loads.rod.x, y - loads.rod.y, zero),
        Wrench(-x - loads.rocker.x, -y - loads.rocker.y, zero),
        Wrench(x, y, zero),
    )
