"""Reactions of a class III group: a floating link on three legs, rods or blocks on lines, with friction on these."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.forces.conditions import Friction
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


class TriadFriction(NamedTuple):
    """Friction of each leg's block, in the sense of its line's direction; of a rod it does not count."""

    first: Friction
    second: Friction
    third: Friction


class _Screw(NamedTuple):
    """A force on the floating link: along x and y, and its moment about the link's first pin."""

    x: Array
    y: Array
    turn: Array


class _Hold(NamedTuple):
    """A leg at its point: arm from the link's first pin, its unknown force of unit size, its known force."""

    arm_x: Array
    arm_y: Array
    unit: _Screw
    known: _Screw


def _screw(arm_x: Array, arm_y: Array, x: Array, y: Array) -> _Screw:
    return _Screw(x, y, arm_x * y - arm_y * x)


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
    return _Hold(arm_x, arm_y, _screw(arm_x, arm_y, x, y), _screw(arm_x, arm_y, known_x, known_y))


def _needed(load: Wrench, a: _Screw, b: _Screw, c: _Screw) -> _Screw:
    """What the unknown forces must come to, the known ones being these."""
    return _Screw(
        -(load.x + a.x + b.x + c.x),
        -(load.y + a.y + b.y + c.y),
        -(load.moment + a.turn + b.turn + c.turn),
    )


def _cross(one: _Screw, other: _Screw) -> _Screw:
    """Cross product of two forces: what a third must carry alone."""
    return _Screw(
        one.y * other.turn - one.turn * other.y,
        one.turn * other.x - one.x * other.turn,
        one.x * other.y - one.y * other.x,
    )


def _triple(one: _Screw, cross: _Screw) -> Array:
    return one.x * cross.x + one.y * cross.y + one.turn * cross.turn


def _leg_reactions(known: _Screw, unit: _Screw, force: Array, leg: Leg, load: Wrench) -> LegReactions:
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
    a = _hold(link, ends.first, geometry.first, loads.first)
    b = _hold(link, ends.second, geometry.second, loads.second)
    c = _hold(link, ends.third, geometry.third, loads.third)
    needed = _needed(loads.link, a.known, b.known, c.known)
    bc = _cross(b.unit, c.unit)
    determinant = _triple(a.unit, bc)
    first = _triple(needed, bc) / determinant
    second = _triple(needed, _cross(c.unit, a.unit)) / determinant
    third = _triple(needed, _cross(a.unit, b.unit)) / determinant
    return TriadReactions(
        _leg_reactions(a.known, a.unit, first, geometry.first, loads.first),
        _leg_reactions(b.known, b.unit, second, geometry.second, loads.second),
        _leg_reactions(c.known, c.unit, third, geometry.third, loads.third),
    )


def _lean(hold: _Hold, end: Link, leg: Leg, friction: Friction) -> _Screw:
    """What friction adds to a leg's force of unit size across its guide; it turns over with the force."""
    share = -leg.kind * friction.coefficient * friction.sense
    return _screw(hold.arm_x, hold.arm_y, share * end.cos, share * end.sin)


def _leaning(unit: _Screw, lean: _Screw, sign: Array | float) -> _Screw:
    return _Screw(unit.x + sign * lean.x, unit.y + sign * lean.y, unit.turn + sign * lean.turn)


class _Rubbing(NamedTuple):
    """Forces of unit size of three legs, what friction adds, what they must come to, sign of the determinant."""

    a: _Screw
    b: _Screw
    c: _Screw
    lean_a: _Screw
    lean_b: _Screw
    lean_c: _Screw
    needed: _Screw
    side: Array


def _first_sign(legs: _Rubbing, second: Array, third: Array) -> Array:
    """Sign of the first leg's force where those of the others are known; its own friction does not change it."""
    b = _leaning(legs.b, legs.lean_b, second)
    c = _leaning(legs.c, legs.lean_c, third)
    return np.sign(legs.side * _triple(legs.needed, _cross(b, c)))


def _second_sign(legs: _Rubbing, third: Array) -> Array:
    """Sign of the second leg's force where that of the third is known: it is positive if so it would be."""
    a = _leaning(legs.a, legs.lean_a, _first_sign(legs, 1.0 + 0.0 * third, third))
    c = _leaning(legs.c, legs.lean_c, third)
    return np.sign(legs.side * _triple(legs.needed, _cross(c, a)))


def _third_sign(legs: _Rubbing) -> Array:
    """Sign of the third leg's force: it is positive if so it would be."""
    positive = 1.0 + 0.0 * legs.side
    second = _second_sign(legs, positive)
    a = _leaning(legs.a, legs.lean_a, _first_sign(legs, second, positive))
    b = _leaning(legs.b, legs.lean_b, second)
    return np.sign(legs.side * _triple(legs.needed, _cross(a, b)))


def _held(legs: _Rubbing) -> Array:
    """0 where the determinants of all eight choices of signs have the same sign, NaN where friction wedges the legs."""
    held = 0.0 * legs.side
    for second in (-1.0, 1.0):
        b = _leaning(legs.b, legs.lean_b, second)
        for third in (-1.0, 1.0):
            bc = _cross(b, _leaning(legs.c, legs.lean_c, third))
            for first in (-1.0, 1.0):
                held = held + 0.0 * np.sqrt(legs.side * _triple(_leaning(legs.a, legs.lean_a, first), bc))
    return held


def triad_reactions_with_friction(
    link: Link, ends: TriadEnds, geometry: Triad, loads: TriadLoads, friction: TriadFriction
) -> TriadReactions:
    """Reactions of a floating link's three legs, with friction between blocks and their lines.

    Parameters
    ----------
    link : Link, shape (..., n)
        The floating link, as `triad` gives it.
    ends : TriadEnds, shape (..., n)
    geometry : Triad, fields broadcastable to (..., 1)
    loads : TriadLoads, shape (..., n)
    friction : TriadFriction, fields broadcastable to (..., n)

    Returns
    -------
    TriadReactions, shape (..., n)
        NaN where friction wedges the link: where there are loads for which two sets of forces would hold it, or none.

    Notes
    -----
    A guide's force leans from its normal by μσ, one way or the other by its own sign. Where the determinants of all
    choices of signs have one sign, just one choice agrees with itself, and the signs are found one after the other: a
    leg's is positive if it is so where it leans for that. docs/theory/forces, eqs. (13.41) and (13.42).
    """
    a = _hold(link, ends.first, geometry.first, loads.first)
    b = _hold(link, ends.second, geometry.second, loads.second)
    c = _hold(link, ends.third, geometry.third, loads.third)
    lean_a = _lean(a, ends.first, geometry.first, friction.first)
    lean_b = _lean(b, ends.second, geometry.second, friction.second)
    lean_c = _lean(c, ends.third, geometry.third, friction.third)
    side = np.sign(_triple(a.unit, _cross(b.unit, c.unit)))
    needed = _needed(loads.link, a.known, b.known, c.known)
    legs = _Rubbing(a.unit, b.unit, c.unit, lean_a, lean_b, lean_c, needed, side)
    third = _third_sign(legs)
    second = _second_sign(legs, third)
    first_unit = _leaning(a.unit, lean_a, _first_sign(legs, second, third))
    second_unit = _leaning(b.unit, lean_b, second)
    third_unit = _leaning(c.unit, lean_c, third)
    bc = _cross(second_unit, third_unit)
    determinant = _triple(first_unit, bc) + _held(legs)
    on_first = _triple(needed, bc) / determinant
    on_second = _triple(needed, _cross(third_unit, first_unit)) / determinant
    on_third = _triple(needed, _cross(first_unit, second_unit)) / determinant
    return TriadReactions(
        _leg_reactions(a.known, first_unit, on_first, geometry.first, loads.first),
        _leg_reactions(b.known, second_unit, on_second, geometry.second, loads.second),
        _leg_reactions(c.known, third_unit, on_third, geometry.third, loads.third),
    )
