"""Support reactions of one throw by the source's own formulas (44)–(53) of [crankshaft-reactions].

They hold for one throw between two bearings. A reaction is written as the load of the journal on its bearing, along K,
inward, and along T, with the rotation; of P, the right one, and of L, the left one.
Equations, errors and what the text leaves open: docs/theory/crankshaft.
"""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array


class ThrowLengths(NamedTuple):
    """Lengths of fig. 35 by its own symbols. [m]

    l1, l6: from a support to the web; h_l, h_p: thickness of the left and the right web; l2, l5: from a web to the
    axis of the rod beside it; l3, l4: from the left rod to the middle of the pin, and on to the right rod; l_p1, l_p2:
    from a support to the counterweight beyond it.
    """

    l1: Array
    l2: Array
    l3: Array
    l4: Array
    l5: Array
    l6: Array
    h_l: Array
    h_p: Array
    l_p1: Array
    l_p2: Array


class ThrowForces(NamedTuple):
    """Inertia forces C₁ … C₁₅ of fig. 35 and the forces of the left and the right rod. [N]

    Outward: c2, c6 of the webs, c4 of the pin, c3 and c5 of what turns of the rods. Inward: c1, c7 of the internal and
    c11, c13 of the external counterweights; k1, k2 of the rods. With the rotation: t1, t2, and c10 of the left external
    counterweight. Against it: c8 + c14 in the plane of the left web, c9 + c15 in that of the right one, and c12 of the
    right external counterweight.
    """

    c1: Array
    c2: Array
    c3: Array
    c4: Array
    c5: Array
    c6: Array
    c7: Array
    c8: Array
    c9: Array
    c10: Array
    c11: Array
    c12: Array
    c13: Array
    c14: Array
    c15: Array
    k1: Array
    k2: Array
    t1: Array
    t2: Array


class ThrowReactions(NamedTuple):
    """Loads of the journals on the right (P) and the left (L) bearing, inward (K) and with the rotation (T). [N]"""

    kp: Array
    tp: Array
    kl: Array
    tl: Array


class ThrowConstituents(NamedTuple):
    """Reactions of one throw by what causes them.

    rotating: rotating masses, (44)–(47); first, last: what (48) and (49) add for the external counterweights of a first
    and a last throw; normal: K of the rods, (50), (52); tangential: T of the rods, (51), (53).
    """

    rotating: ThrowReactions
    first: ThrowReactions
    last: ThrowReactions
    normal: ThrowReactions
    tangential: ThrowReactions


class ThrowBalance(NamedTuple):
    """What the forces C of a throw leave over; all four are 0 where they cause no reactions.

    outward, against (the rotation): sums of forces, 0 in static balance [N]; outward_moment, against_moment: sums of
    their moments about the left support, 0 in dynamic balance [N·m].
    """

    outward: Array
    against: Array
    outward_moment: Array
    against_moment: Array


def throw_length(sizes: ThrowLengths) -> Array:
    """Distance of the supports, l: the sum of the chain, and no input of its own. [m]"""
    return sizes.l1 + sizes.h_l + sizes.l2 + sizes.l3 + sizes.l4 + sizes.l5 + sizes.h_p + sizes.l6


def throw_constituents(sizes: ThrowLengths, forces: ThrowForces) -> ThrowConstituents:
    """Reactions of one throw, each constituent by itself.

    Parameters
    ----------
    sizes : ThrowLengths
    forces : ThrowForces
        Broadcastable with the lengths.

    Returns
    -------
    ThrowConstituents

    Notes
    -----
    Equations (44)–(53) of [crankshaft-reactions]; docs/theory/crankshaft, eqs. (24.30) to (24.34).
    """
    s, f, l = sizes, forces, throw_length(sizes)
    left_web, right_web = s.l1 + s.h_l / 2, l - s.l6 - s.h_p / 2
    left_rod, pin = s.l1 + s.h_l + s.l2, s.l1 + s.h_l + s.l2 + s.l3
    right_rod = pin + s.l4
    from_right_rod, from_pin = s.l5 + s.h_p + s.l6, s.l4 + s.l5 + s.h_p + s.l6
    from_left_rod = s.l3 + from_pin
    from_left_web, from_right_web = l - s.l1 - s.h_l / 2, s.l6 + s.h_p / 2
    rotating = ThrowReactions(
        ((f.c1 - f.c2) * left_web - f.c3 * left_rod - f.c4 * pin - f.c5 * right_rod - (f.c6 - f.c7) * right_web) / l,
        -((f.c8 + f.c14) * left_web + (f.c9 + f.c15) * right_web) / l,
        (
            (f.c7 - f.c6) * from_right_web
            - f.c5 * from_right_rod
            - f.c4 * from_pin
            - f.c3 * from_left_rod
            - (f.c2 - f.c1) * from_left_web
        )
        / l,
        -((f.c9 + f.c15) * from_right_web + (f.c8 + f.c14) * from_left_web) / l,
    )
    none = np.zeros_like(l)
    of_rods = (
        ((one * left_rod + other * right_rod) / l, (other * from_right_rod + one * from_left_rod) / l)
        for one, other in ((f.k1, f.k2), (f.t1, f.t2))
    )
    (kp, kl), (tp, tl) = of_rods
    return ThrowConstituents(
        rotating,
        _first_throw(sizes, forces, l),
        _last_throw(sizes, forces, l),
        ThrowReactions(kp, none, kl, none),
        ThrowReactions(none, tp, none, tl),
    )


def _first_throw(sizes: ThrowLengths, forces: ThrowForces, l: Array) -> ThrowReactions:
    """What the left external counterweight adds, (48)."""
    here, beyond = (sizes.l_p1 + l) / l, -sizes.l_p1 / l
    return ThrowReactions(forces.c11 * beyond, forces.c10 * beyond, forces.c11 * here, forces.c10 * here)


def _last_throw(sizes: ThrowLengths, forces: ThrowForces, l: Array) -> ThrowReactions:
    """What the right external counterweight adds, (49)."""
    here, beyond = (sizes.l_p2 + l) / l, -sizes.l_p2 / l
    return ThrowReactions(forces.c13 * here, -forces.c12 * here, forces.c13 * beyond, -forces.c12 * beyond)


def throw_reactions(found: ThrowConstituents, *, is_first: bool = False, is_last: bool = False) -> ThrowReactions:
    """All constituents of a throw together; external counterweights count with a first and a last throw alone.

    Where they enter a continuous shaft as moments at its ends, neither (48) nor (49) is to be added: they would count
    twice.
    """
    whole = found.rotating
    for part in (found.normal, found.tangential, *[found.first] * is_first, *[found.last] * is_last):
        whole = ThrowReactions(*(one + other for one, other in zip(whole, part, strict=True)))
    return whole


def journal_load(before: ThrowReactions, behind: ThrowReactions, ahead: Array) -> tuple[Array, Array]:
    """Load on the bearing between two throws, along K and T of the one before it.

    Parameters
    ----------
    before, behind : ThrowReactions
        Of the throw that has the bearing on its right, and of that which has it on its left.
    ahead : Array
        By how much the throw behind the bearing is ahead in the sense of rotation. [rad]

    Returns
    -------
    normal, tangential : Array
        [N]

    Notes
    -----
    docs/theory/crankshaft, eq. (24.35).
    """
    cos, sin = np.cos(ahead), np.sin(ahead)
    return before.kp + behind.kl * cos + behind.tl * sin, before.tp - behind.kl * sin + behind.tl * cos


def throw_balance(
    sizes: ThrowLengths, forces: ThrowForces, *, is_first: bool = False, is_last: bool = False
) -> ThrowBalance:
    """What is missing for a throw without reactions: static and dynamic balance, which are two conditions.

    Parameters
    ----------
    sizes : ThrowLengths
    forces : ThrowForces
    is_first, is_last : bool
        Whether the external counterweights count.

    Returns
    -------
    ThrowBalance

    Notes
    -----
    docs/theory/crankshaft, eq. (24.36).
    """
    s, f, l = sizes, forces, throw_length(sizes)
    left_web, right_web, pin = s.l1 + s.h_l / 2, l - s.l6 - s.h_p / 2, s.l1 + s.h_l + s.l2 + s.l3
    outward = [(f.c2 - f.c1, left_web), (f.c3, pin - s.l3), (f.c4, pin), (f.c5, pin + s.l4), (f.c6 - f.c7, right_web)]
    against = [(f.c8 + f.c14, left_web), (f.c9 + f.c15, right_web)]
    if is_first:
        outward.append((-f.c11, -s.l_p1))
        against.append((-f.c10, -s.l_p1))
    if is_last:
        outward.append((-f.c13, l + s.l_p2))
        against.append((f.c12, l + s.l_p2))
    sums = [sum((force * arm for force, arm in parts), start=np.zeros_like(l)) for parts in (outward, against)]
    forces_alone = [sum((force for force, _arm in parts), start=np.zeros_like(l)) for parts in (outward, against)]
    return ThrowBalance(*forces_alone, *sums)
