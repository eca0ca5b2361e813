"""Reactions of a class III group whose blocks rub on their lines, each guide on one side or on two edges."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.forces.conditions import Friction
from cranktrain.linkage.forces.triad import (
    Hold,
    LegReactions,
    Screw,
    TriadLoads,
    TriadReactions,
    crossed,
    hold_of,
    leg_reactions,
    needed_of,
    screw_of,
    triple,
)
from cranktrain.linkage.forces.wrench import Wrench
from cranktrain.linkage.triad import Leg, Triad, TriadEnds
from cranktrain.motion import Array, Link


class TriadFriction(NamedTuple):
    """Friction of each leg's block, in the sense of its line's direction; of a rod it does not count."""

    first: Friction
    second: Friction
    third: Friction


def _lean(hold: Hold, end: Link, leg: Leg, friction: Friction) -> Screw:
    """What friction adds for each newton that a leg presses in all."""
    share = -leg.kind * friction.coefficient * friction.sense
    return screw_of(hold.arm_x, hold.arm_y, share * end.cos, share * end.sin)


class _Line(NamedTuple):
    """What a leg presses in all, where that is linear in its force λ: at + by·λ."""

    at: Array
    by: Array


class _Pressing(NamedTuple):
    """What a leg presses in all: the greater of |outer|, which rises, and |inner|, which is > 0 where outer is 0."""

    outer: _Line
    inner: _Line


def _pressing(leg: Leg, load: Wrench, friction: Friction) -> _Pressing:
    """Of |λ| and |D₀ − γλ| the one that is steeper is the outer; rods and guides without length have |λ| alone."""
    doubled = 2.0 * leg.kind * friction.per_length
    frictionless = -doubled * load.moment
    slope = doubled * friction.middle
    steep = np.abs(slope)
    # 1 where the pin lies beyond the guide's edges, else 0.
    beyond = 1.0 * (steep > 1.0)
    within = 1.0 - beyond
    turn, side = np.sign(slope), np.sign(frictionless)
    return _Pressing(
        _Line(-beyond * turn * frictionless, within + beyond * steep),
        _Line(within * side * frictionless, beyond * side * turn - within * side * slope),
    )


def _on(line: _Line, force: Array) -> Array:
    return line.at + line.by * force


def _turned_over(line: _Line) -> _Line:
    return _Line(-line.at, -line.by)


def _chosen(pressing: _Pressing, by_right: Array, by_left: Array) -> _Line:
    """Line that agrees with itself, from the leg's force by `outer` and by its opposite; `inner` where neither does."""
    outer, inner = pressing
    right = 1.0 * (_on(outer, by_right) >= np.abs(_on(inner, by_right)))
    left = (1.0 - right) * (-_on(outer, by_left) >= np.abs(_on(inner, by_left)))
    between = 1.0 - right - left
    way = right - left
    return _Line(way * outer.at + between * inner.at, way * outer.by + between * inner.by)


class _Side(NamedTuple):
    """A leg's force of unit size, what a newton of pressing adds by friction, and what it presses."""

    unit: Screw
    lean: Screw
    pressing: _Pressing


class _Rubbing(NamedTuple):
    """Three legs and what their forces must come to."""

    a: _Side
    b: _Side
    c: _Side
    needed: Screw


def _leaning(side: _Side, line: _Line) -> Screw:
    """Force that a leg adds for each newton across its guide."""
    unit, lean = side.unit, side.lean
    return Screw(unit.x + line.by * lean.x, unit.y + line.by * lean.y, unit.turn + line.by * lean.turn)


def _less(needed: Screw, side: _Side, line: _Line) -> Screw:
    """What is left after the friction that a leg has whatever its force."""
    lean = side.lean
    return Screw(needed.x - line.at * lean.x, needed.y - line.at * lean.y, needed.turn - line.at * lean.turn)


def _force(side: _Side, line: _Line, cross: Screw, needed: Screw) -> Array:
    """Force of a leg on one line by Cramer's rule, the others' cross product given."""
    return triple(_less(needed, side, line), cross) / triple(_leaning(side, line), cross)


def _either(side: _Side, cross: Screw, needed: Screw) -> _Line:
    """Line of a leg where those of the others are known."""
    outer = side.pressing.outer
    opposite = _turned_over(outer)
    return _chosen(side.pressing, _force(side, outer, cross, needed), _force(side, opposite, cross, needed))


def _first_line(legs: _Rubbing, second: _Line, third: _Line) -> _Line:
    needed = _less(_less(legs.needed, legs.b, second), legs.c, third)
    return _either(legs.a, crossed(_leaning(legs.b, second), _leaning(legs.c, third)), needed)


def _second_force(legs: _Rubbing, second: _Line, third: _Line) -> Array:
    """Force of the second leg if it were on this line, the first leg agreeing with itself."""
    first = _first_line(legs, second, third)
    needed = _less(_less(legs.needed, legs.a, first), legs.c, third)
    return _force(legs.b, second, crossed(_leaning(legs.c, third), _leaning(legs.a, first)), needed)


def _second_line(legs: _Rubbing, third: _Line) -> _Line:
    outer = legs.b.pressing.outer
    opposite = _turned_over(outer)
    return _chosen(legs.b.pressing, _second_force(legs, outer, third), _second_force(legs, opposite, third))


def _third_force(legs: _Rubbing, third: _Line) -> Array:
    """Force of the third leg if it were on this line, the others agreeing with themselves."""
    second = _second_line(legs, third)
    first = _first_line(legs, second, third)
    needed = _less(_less(legs.needed, legs.a, first), legs.b, second)
    return _force(legs.c, third, crossed(_leaning(legs.a, first), _leaning(legs.b, second)), needed)


def _third_line(legs: _Rubbing) -> _Line:
    outer = legs.c.pressing.outer
    opposite = _turned_over(outer)
    return _chosen(legs.c.pressing, _third_force(legs, outer), _third_force(legs, opposite))


def _held(legs: _Rubbing) -> Array:
    """0 where the determinants of all eight choices of lines have the same sign, NaN where friction wedges the legs."""
    a, b, c = legs.a.pressing.outer, legs.b.pressing.outer, legs.c.pressing.outer
    side = np.sign(triple(legs.a.unit, crossed(legs.b.unit, legs.c.unit)))
    held = 0.0 * side
    for second in (-1.0, 1.0):
        on_b = _leaning(legs.b, _Line(b.at, second * b.by))
        for third in (-1.0, 1.0):
            bc = crossed(on_b, _leaning(legs.c, _Line(c.at, third * c.by)))
            for first in (-1.0, 1.0):
                held = held + 0.0 * np.sqrt(side * triple(_leaning(legs.a, _Line(a.at, first * a.by)), bc))
    return held


def _rubbing_leg(side: _Side, line: _Line, force: Array, known: Screw, leg: Leg, load: Wrench) -> LegReactions:
    """Reactions of a leg with its friction; what friction has of its own counts as known."""
    zero = 0.0 * line.at
    own = _less(known, side, _Line(-line.at, zero))
    return leg_reactions(own, _leaning(side, line), force, leg, load)


def _side(hold: Hold, end: Link, leg: Leg, load: Wrench, friction: Friction) -> _Side:
    return _Side(hold.unit, _lean(hold, end, leg, friction), _pressing(leg, load, friction))


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
    on_a = _side(a, ends.first, geometry.first, loads.first, friction.first)
    on_b = _side(b, ends.second, geometry.second, loads.second, friction.second)
    on_c = _side(c, ends.third, geometry.third, loads.third, friction.third)
    legs = _Rubbing(on_a, on_b, on_c, needed_of(loads.link, a.known, b.known, c.known))
    third = _third_line(legs)
    second = _second_line(legs, third)
    first = _first_line(legs, second, third)
    held = _held(legs)
    needed = _less(_less(_less(legs.needed, on_a, first), on_b, second), on_c, third)
    first_unit, second_unit, third_unit = _leaning(on_a, first), _leaning(on_b, second), _leaning(on_c, third)
    bc = crossed(second_unit, third_unit)
    determinant = triple(first_unit, bc) + held
    by_first = triple(needed, bc) / determinant
    by_second = triple(needed, crossed(third_unit, first_unit)) / determinant
    by_third = triple(needed, crossed(first_unit, second_unit)) / determinant
    return TriadReactions(
        _rubbing_leg(on_a, first, by_first, a.known, geometry.first, loads.first),
        _rubbing_leg(on_b, second, by_second, b.known, geometry.second, loads.second),
        _rubbing_leg(on_c, third, by_third, c.known, geometry.third, loads.third),
    )
