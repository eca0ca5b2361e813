"""Reactions of a class III group: a floating link on three legs, rods or blocks on lines."""

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


class _Hold(NamedTuple):
    """A leg at its point: unit vector of its unknown force, its known force, both moments about the origin."""

    x: Array
    y: Array
    turn: Array
    known_x: Array
    known_y: Array
    known_turn: Array


def _hold(link: Link, end: Link, leg: Leg, load: Wrench) -> _Hold:
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
    return _Hold(x, y, arm_x * y - arm_y * x, known_x, known_y, arm_x * known_y - arm_y * known_x)


def _shares(one: _Hold, other: _Hold) -> tuple[Array, Array, Array]:
    """Cross product of two legs' directions: what a third must carry alone."""
    return (
        one.y * other.turn - one.turn * other.y,
        one.turn * other.x - one.x * other.turn,
        one.x * other.y - one.y * other.x,
    )


def _leg_reactions(hold: _Hold, force: Array, leg: Leg, load: Wrench) -> LegReactions:
    x = hold.known_x + force * hold.x
    y = hold.known_y + force * hold.y
    zero = 0.0 * x
    return LegReactions(Wrench(x, y, zero), Wrench(x - load.x, y - load.y, zero - leg.kind * load.moment))


def triad_reactions(link: Link, ends: TriadEnds, geometry: Triad, loads: TriadLoads) -> TriadReactions:
    """Reactions of a floating link's three legs.

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
    a = _hold(link, ends.first, geometry.first, loads.first)
    b = _hold(link, ends.second, geometry.second, loads.second)
    c = _hold(link, ends.third, geometry.third, loads.third)
    x = -(loads.link.x + a.known_x + b.known_x + c.known_x)
    y = -(loads.link.y + a.known_y + b.known_y + c.known_y)
    turn = -(loads.link.moment + a.known_turn + b.known_turn + c.known_turn)
    bc = _shares(b, c)
    ca = _shares(c, a)
    ab = _shares(a, b)
    determinant = a.x * bc[0] + a.y * bc[1] + a.turn * bc[2]
    return TriadReactions(
        _leg_reactions(a, (x * bc[0] + y * bc[1] + turn * bc[2]) / determinant, geometry.first, loads.first),
        _leg_reactions(b, (x * ca[0] + y * ca[1] + turn * ca[2]) / determinant, geometry.second, loads.second),
        _leg_reactions(c, (x * ab[0] + y * ab[1] + turn * ab[2]) / determinant, geometry.third, loads.third),
    )
