"""Reactions of a class III group whose blocks rub on their lines, each guide on one side or on two edges."""

from typing import NamedTuple, TypeAlias

import numpy as np

from cranktrain.linkage.forces.conditions import Friction
from cranktrain.linkage.forces.triad import (
    Hold,
    TriadLoads,
    TriadReactions,
    hold_of,
    needed_of,
    reactions_of,
    triple,
)
from cranktrain.linkage.forces.wrench import Wrench, plus
from cranktrain.linkage.triad import Leg, OfLegs, Triad, TriadEnds
from cranktrain.linkage.vectors import Vector, at_arm, crossed
from cranktrain.motion import Array, Link

TriadFriction: TypeAlias = OfLegs[Friction]
"""Friction of each leg's block, in the sense of its line's direction; of a rod it does not count."""


class _Line(NamedTuple):
    """What a leg presses in all, where that is linear in its force λ: at + by·λ."""

    at: Array
    by: Array


class _Leg(NamedTuple):
    """A leg with what a newton of pressing adds by friction, and what it presses in all.

    That is the greatest of right, which rises, its opposite left, and |inner|, which is > 0 where these are 0.
    """

    hold: Hold
    lean: Wrench
    right: _Line
    left: _Line
    inner: _Line


def _leg(hold: Hold, end: Link, leg: Leg, load: Wrench, friction: Friction) -> _Leg:
    """Of |λ| and |D₀ − γλ| the steeper one gives right and left; rods and guides without length have |λ| alone."""
    share = -leg.kind * friction.coefficient * friction.sense
    doubled = 2.0 * leg.kind * friction.per_length
    frictionless = -doubled * load.moment
    slope = doubled * friction.middle
    steep = np.abs(slope)
    # 1 where the pin lies beyond the guide's edges, else 0.
    beyond = 1.0 * (steep > 1.0)
    within = 1.0 - beyond
    turn, side = np.sign(slope), np.sign(frictionless)
    right = _Line(-beyond * turn * frictionless, within + beyond * steep)
    return _Leg(
        hold,
        at_arm(hold.arm, Vector(share * end.cos, share * end.sin)),
        right,
        _Line(-right.at, -right.by),
        _Line(within * side * frictionless, beyond * side * turn - within * side * slope),
    )


class _Rubbing(NamedTuple):
    """Three legs and the load on the link."""

    a: _Leg
    b: _Leg
    c: _Leg
    load: Wrench


def _on(line: _Line, force: Array) -> Array:
    return line.at + line.by * force


def _rubbing(leg: _Leg, line: _Line) -> Hold:
    """Leg that presses as on one line: its force leans, and what friction has of its own is known."""
    hold = leg.hold
    return Hold(hold.arm, plus(hold.unit, line.by, leg.lean), plus(hold.known, line.at, leg.lean))


def _agreeing(leg: _Leg, by_right: Array, by_left: Array) -> Hold:
    """Leg on the line that agrees with itself, from its force by right and by left; on inner where neither does."""
    right, left, inner = leg.right, leg.left, leg.inner
    is_right = 1.0 * (_on(right, by_right) >= np.abs(_on(inner, by_right)))
    is_left = (1.0 - is_right) * (_on(left, by_left) >= np.abs(_on(inner, by_left)))
    between = 1.0 - is_right - is_left
    at = is_right * right.at + is_left * left.at + between * inner.at
    return _rubbing(leg, _Line(at, is_right * right.by + is_left * left.by + between * inner.by))


def _force(load: Wrench, leg: Hold, one: Hold, other: Hold) -> Array:
    """Force of a leg beside two others, by Cramer's rule."""
    cross = crossed(one.unit, other.unit)
    return triple(needed_of(load, leg, one, other), cross) / triple(leg.unit, cross)


def _first_force(legs: _Rubbing, line: _Line, second: Hold, third: Hold) -> Array:
    return _force(legs.load, _rubbing(legs.a, line), second, third)


def _first(legs: _Rubbing, second: Hold, third: Hold) -> Hold:
    """First leg, the others being so."""
    right, left = legs.a.right, legs.a.left
    return _agreeing(legs.a, _first_force(legs, right, second, third), _first_force(legs, left, second, third))


def _second_force(legs: _Rubbing, line: _Line, third: Hold) -> Array:
    """Force of the second leg if it were on this line, the first leg agreeing with itself."""
    second = _rubbing(legs.b, line)
    return _force(legs.load, second, third, _first(legs, second, third))


def _second(legs: _Rubbing, third: Hold) -> Hold:
    right, left = legs.b.right, legs.b.left
    return _agreeing(legs.b, _second_force(legs, right, third), _second_force(legs, left, third))


def _third_force(legs: _Rubbing, line: _Line) -> Array:
    """Force of the third leg if it were on this line, the others agreeing with themselves."""
    third = _rubbing(legs.c, line)
    second = _second(legs, third)
    return _force(legs.load, third, _first(legs, second, third), second)


def _held(legs: _Rubbing) -> Array:
    """0 where the determinants of all eight choices of lines have the same sign, NaN where friction wedges the legs."""
    a, b, c = legs.a, legs.b, legs.c
    side = np.sign(triple(a.hold.unit, crossed(b.hold.unit, c.hold.unit)))
    held = 0.0 * side
    for second in (b.right, b.left):
        for third in (c.right, c.left):
            bc = crossed(_rubbing(b, second).unit, _rubbing(c, third).unit)
            for first in (a.right, a.left):
                held = held + 0.0 * np.sqrt(side * triple(_rubbing(a, first).unit, bc))
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
    A guide's force leans from its normal by μσ, one way or the other by its own sign, or as its moment has it where
    that presses two edges. Where the determinants of all choices of lines have one sign, just one choice agrees with
    itself, and the lines are found one after the other: a leg's force is on a line if it is so where it leans for that.
    docs/theory/forces, eqs. (13.41), (13.42) and (13.47).
    """
    a = hold_of(link, ends.first, geometry.first, loads.first)
    b = hold_of(link, ends.second, geometry.second, loads.second)
    c = hold_of(link, ends.third, geometry.third, loads.third)
    legs = _Rubbing(
        _leg(a, ends.first, geometry.first, loads.first, friction.first),
        _leg(b, ends.second, geometry.second, loads.second, friction.second),
        _leg(c, ends.third, geometry.third, loads.third, friction.third),
        loads.link,
    )
    third = _agreeing(legs.c, _third_force(legs, legs.c.right), _third_force(legs, legs.c.left))
    second = _second(legs, third)
    return reactions_of(_first(legs, second, third), second, third, _held(legs), geometry, loads)
