"""Reactions of a class III group: a floating link on three legs, rods or blocks on lines, where nothing rubs."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.forces.wrench import Wrench
from cranktrain.linkage.triad import Leg, Triad, TriadEnds
from cranktrain.motion import Array, Link


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


class TriadReactions(NamedTuple):
    """Reactions of the three legs."""

    first: LegReactions
    second: LegReactions
    third: LegReactions


class Screw(NamedTuple):
    """A force on the floating link: along x and y, and its moment about the link's first pin."""

    x: Array
    y: Array
    turn: Array


class Hold(NamedTuple):
    """A leg at its point: arm from the link's first pin, its unknown force of unit size, its known force."""

    arm_x: Array
    arm_y: Array
    unit: Screw
    known: Screw


def screw_of(arm_x: Array, arm_y: Array, x: Array, y: Array) -> Screw:
    """Force at an arm from the link's first pin."""
    return Screw(x, y, arm_x * y - arm_y * x)


def hold_of(link: Link, end: Link, leg: Leg, load: Wrench) -> Hold:
    """Along a rod, across a guide; what is known is the rod's force across itself, or the block's own load."""
    cos = np.cos(leg.point.angle)
    sin = np.sin(leg.point.angle)
    arm_x = leg.point.radius * (cos * link.cos - sin * link.sin)
    arm_y = leg.point.radius * (cos * link.sin + sin * link.cos)
    guide = leg.kind
    rod = 1.0 - guide
    leg_x = (link.origin.x.value + arm_x) - end.origin.x.value
    leg_y = (link.origin.y.value + arm_y) - end.origin.y.value
    # A block may stand where its line begins: its distance from there is not divided by.
    square = rod * (leg_x * leg_x + leg_y * leg_y) + guide
    length = np.sqrt(square)
    x = rod * (leg_x / length) - guide * end.sin
    y = rod * (leg_y / length) + guide * end.cos
    across = rod * (load.moment / square)
    known_x = guide * load.x - across * leg_y
    known_y = guide * load.y + across * leg_x
    return Hold(arm_x, arm_y, screw_of(arm_x, arm_y, x, y), screw_of(arm_x, arm_y, known_x, known_y))


def needed_of(load: Wrench, a: Screw, b: Screw, c: Screw) -> Screw:
    """What the unknown forces must come to, the known ones being these."""
    return Screw(
        -(load.x + a.x + b.x + c.x),
        -(load.y + a.y + b.y + c.y),
        -(load.moment + a.turn + b.turn + c.turn),
    )


def crossed(one: Screw, other: Screw) -> Screw:
    """Cross product of two forces: what a third must carry alone."""
    return Screw(
        one.y * other.turn - one.turn * other.y,
        one.turn * other.x - one.x * other.turn,
        one.x * other.y - one.y * other.x,
    )


def triple(one: Screw, cross: Screw) -> Array:
    """Determinant of three forces, two of them as their cross product."""
    return one.x * cross.x + one.y * cross.y + one.turn * cross.turn


def leg_reactions(known: Screw, unit: Screw, force: Array, leg: Leg, load: Wrench) -> LegReactions:
    """Reactions of a leg whose force has been found."""
    x = known.x + force * unit.x
    y = known.y + force * unit.y
    zero = 0.0 * x
    return LegReactions(Wrench(x, y, zero), Wrench(x - load.x, y - load.y, zero - leg.kind * load.moment))


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
    needed = needed_of(loads.link, a.known, b.known, c.known)
    bc = crossed(b.unit, c.unit)
    determinant = triple(a.unit, bc)
    first = triple(needed, bc) / determinant
    second = triple(needed, crossed(c.unit, a.unit)) / determinant
    third = triple(needed, crossed(a.unit, b.unit)) / determinant
    return TriadReactions(
        leg_reactions(a.known, a.unit, first, geometry.first, loads.first),
        leg_reactions(b.known, b.unit, second, geometry.second, loads.second),
        leg_reactions(c.known, c.unit, third, geometry.third, loads.third),
    )
