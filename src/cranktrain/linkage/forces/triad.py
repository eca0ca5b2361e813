"""Reactions of a class III group: a floating link on three legs, rods or blocks on lines, where nothing rubs."""

from typing import NamedTuple, TypeAlias

import numpy as np

from cranktrain.linkage.forces.wrench import Wrench, added, opposite, plus
from cranktrain.linkage.point import arm_of
from cranktrain.linkage.triad import Leg, OfLegs, Triad, TriadEnds
from cranktrain.linkage.vectors import Vector, at_arm, crossed
from cranktrain.motion import ZERO, Array, Link


class TriadLoads(NamedTuple):
    """What link and legs bear but for their joints.

    The link's about its first pin, a rod's about its outer end, a block's about its pin on the link.
    """

    link: Wrench
    first: Wrench
    second: Wrench
    third: Wrench


class LegReactions(NamedTuple):
    """Wrenches of a leg on the floating link, at the link's point; of the leg's end on the leg.

    The end's is about the rod's outer end, or about the block's pin; only a block's has a moment.
    """

    joint: Wrench
    end: Wrench


TriadReactions: TypeAlias = OfLegs[LegReactions]
"""Reactions of the three legs."""


class Hold(NamedTuple):
    """A leg's arm from the link's first pin, and its forces on the link about that pin: of unit size, and known."""

    arm: Vector
    unit: Wrench
    known: Wrench


def hold_of(link: Link, end: Link, leg: Leg, load: Wrench) -> Hold:
    """Along a rod, across a guide; what is known is the rod's force across itself, or the block's own load."""
    arm = arm_of(link, leg.point)
    guide = leg.kind
    rod = 1.0 - guide
    x = (link.origin.x.value + arm.x) - end.origin.x.value
    y = (link.origin.y.value + arm.y) - end.origin.y.value
    # A block may stand where its line begins: its distance from there is not divided by.
    square = rod * (x * x + y * y) + guide
    length = np.sqrt(square)
    across = rod * (load.moment / square)
    return Hold(
        arm,
        at_arm(arm, Vector(rod * (x / length) - guide * end.sin, rod * (y / length) + guide * end.cos)),
        at_arm(arm, Vector(guide * load.x - across * y, guide * load.y + across * x)),
    )


def needed_of(load: Wrench, a: Hold, b: Hold, c: Hold) -> Wrench:
    """What the unknown forces must come to."""
    return opposite(added(added(added(load, a.known), b.known), c.known))


def triple(one: Wrench, cross: Wrench) -> Array:
    """Determinant of three forces, two of them as their cross product."""
    return one.x * cross.x + one.y * cross.y + one.moment * cross.moment


def leg_reactions(hold: Hold, force: Array, leg: Leg, load: Wrench) -> LegReactions:
    """Reactions of a leg whose force has been found."""
    joint = plus(hold.known, force, hold.unit)
    zero = 0.0 * joint.x
    return LegReactions(
        Wrench(joint.x, joint.y, zero), Wrench(joint.x - load.x, joint.y - load.y, zero - leg.kind * load.moment)
    )


def reactions_of(a: Hold, b: Hold, c: Hold, held: Array, geometry: Triad, loads: TriadLoads) -> TriadReactions:
    """Reactions of three legs; `held` is 0, or NaN where they do not hold the link."""
    needed = needed_of(loads.link, a, b, c)
    bc = crossed(b.unit, c.unit)
    determinant = triple(a.unit, bc) + held
    first = triple(needed, bc) / determinant
    second = triple(needed, crossed(c.unit, a.unit)) / determinant
    third = triple(needed, crossed(a.unit, b.unit)) / determinant
    return OfLegs(
        leg_reactions(a, first, geometry.first, loads.first),
        leg_reactions(b, second, geometry.second, loads.second),
        leg_reactions(c, third, geometry.third, loads.third),
    )


def triad_reactions(link: Link, ends: TriadEnds, geometry: Triad, loads: TriadLoads) -> TriadReactions:
    """Reactions of a floating link's three legs, without friction.

    Parameters
    ----------
    link : Link, shape (..., n)
        The floating link, as `triad` gives it.
    ends : TriadEnds, shape (..., n)
    geometry : Triad, fields broadcastable to (..., 1)
    loads : TriadLoads, shape (..., n)

    Returns
    -------
    TriadReactions, shape (..., n)
        They grow beyond all bounds where the link is loose: where `TriadMotion.transmission` is zero.

    Notes
    -----
    Each leg has one unknown force, along a rod or across a guide; equilibrium of the link in x, y and moment gives the
    three, by the same matrix as its velocities, transposed. docs/theory/forces, eqs. (13.22) to (13.24).
    """
    a = hold_of(link, ends.first, geometry.first, loads.first)
    b = hold_of(link, ends.second, geometry.second, loads.second)
    c = hold_of(link, ends.third, geometry.third, loads.third)
    return reactions_of(a, b, c, ZERO, geometry, loads)
