"""Fig. 35 of [crankshaft-reactions] as data: where along the shaft each force acts, and which way."""

from typing import Literal, NamedTuple

from cranktrain.questions.crankshaft.methods.throw_reactions import throw_length
from cranktrain.texts.throw_table import CHAIN, Throw

Way = Literal["outward", "inward", "against", "with"]
At = Literal["journal", "web", "counterweight", "pin", "rod"]


class SchemeForce(NamedTuple):
    """A force of the scheme.

    letter: by the source; at: what it acts on; place: along the shaft from the left support [m]; way: where a positive
    one points, outward or inward in the crank's plane, with or against the rotation across it; value: [N].
    """

    letter: str
    at: At
    place: float
    way: Way
    value: float


class SchemeLength(NamedTuple):
    """A length of the scheme, from one place along the shaft to another. [m]"""

    letter: str
    start: float
    end: float


class ThrowScheme(NamedTuple):
    """A throw to scale along the shaft, from the left support, in metres.

    left_web, right_web: from where to where a web is; pin: its middle; chain: lengths from support to support;
    over: l and the overhangs; forces: those that are not 0.
    """

    left_web: tuple[float, float]
    right_web: tuple[float, float]
    pin: float
    chain: tuple[SchemeLength, ...]
    over: tuple[SchemeLength, ...]
    forces: tuple[SchemeForce, ...]


def throw_scheme(throw: Throw) -> ThrowScheme:
    """Lay out the scheme of a throw.

    Parameters
    ----------
    throw : Throw

    Returns
    -------
    ThrowScheme
    """
    s, l = throw.lengths, float(throw_length(throw.lengths))
    chain: list[SchemeLength] = []
    place = 0.0
    for letter in CHAIN:
        size = float(getattr(s, {"hL": "h_l", "hP": "h_p"}.get(letter, letter)))
        chain.append(SchemeLength(_index(letter), place, place + size))
        place += size
    webs = (chain[1].start, chain[1].end), (chain[6].start, chain[6].end)
    over = [SchemeLength("l", 0.0, l)]
    if s.l_p1:
        over.insert(0, SchemeLength("l_P1", -float(s.l_p1), 0.0))
    if s.l_p2:
        over.append(SchemeLength("l_P2", l, l + float(s.l_p2)))
    forces = tuple(one for one in _forces(throw, l, *(sum(web) / 2 for web in webs)) if one.value)
    return ThrowScheme(*webs, chain[3].end, tuple(one for one in chain if one.end > one.start), tuple(over), forces)


def _forces(throw: Throw, l: float, left: float, right: float) -> tuple[SchemeForce, ...]:
    """All forces of the figure; of those in the plane of a web across it only the sums occur."""
    s, f = throw.lengths, throw.forces
    one = float(s.l1 + s.h_l + s.l2)
    pin, other = one + float(s.l3), one + float(s.l3 + s.l4)
    beyond, after = -float(s.l_p1), l + float(s.l_p2)
    return (
        SchemeForce("C_1", "counterweight", left, "inward", float(f.c1)),
        SchemeForce("C_2", "web", left, "outward", float(f.c2)),
        SchemeForce("C_3", "pin", one, "outward", float(f.c3)),
        SchemeForce("C_4", "pin", pin, "outward", float(f.c4)),
        SchemeForce("C_5", "pin", other, "outward", float(f.c5)),
        SchemeForce("C_6", "web", right, "outward", float(f.c6)),
        SchemeForce("C_7", "counterweight", right, "inward", float(f.c7)),
        SchemeForce("C_8+C_14", "web", left, "against", float(f.c8 + f.c14)),
        SchemeForce("C_9+C_15", "web", right, "against", float(f.c9 + f.c15)),
        SchemeForce("C_10", "journal", beyond, "with", float(f.c10)),
        SchemeForce("C_11", "journal", beyond, "inward", float(f.c11)),
        SchemeForce("C_12", "journal", after, "against", float(f.c12)),
        SchemeForce("C_13", "journal", after, "inward", float(f.c13)),
        SchemeForce("K_1", "rod", one, "inward", float(f.k1)),
        SchemeForce("K_2", "rod", other, "inward", float(f.k2)),
        SchemeForce("T_1", "rod", one, "with", float(f.t1)),
        SchemeForce("T_2", "rod", other, "with", float(f.t2)),
    )


def _index(letter: str) -> str:
    """Letter with its index: l1 is l_1."""
    return f"{letter[0]}_{letter[1:]}"
