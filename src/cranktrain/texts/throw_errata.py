"""What print broke and what is left open in the text on reactions of a crankshaft's supports."""

import numpy as np

from cranktrain.language import N_
from cranktrain.questions.crankshaft.methods.throw_reactions import (
    ThrowForces,
    ThrowLengths,
    ThrowReactions,
    throw_constituents,
    throw_length,
    throw_reactions,
)
from cranktrain.texts.wrong_step import WrongStep

_LENGTHS = ThrowLengths(*(np.array(1e-3 * size) for size in (14, 15, 13.5, 13.5, 15, 14, 22, 24, 31, 36)))
"""The example of the tests. [m]"""
_NONE = ThrowForces(*(np.array(0.0) for _name in ThrowForces._fields))
_WEIGHT, _K1 = np.array(6100.0), np.array(21500.0)
_ROTATING = np.array(2600.0)
_PIN = np.array(4100.0)


def throw_errata() -> tuple[WrongStep, ...]:
    """Name what is broken in print, in its order, and what the text leaves open.

    Returns
    -------
    tuple of WrongStep
        Numbers are those of the throw of `cranktrain textbook --throw example`.
    """
    alone = float(_of(_NONE._replace(c11=_WEIGHT), is_first=True).kl)
    moment = float(_WEIGHT * _LENGTHS.l_p1) / float(throw_length(_LENGTHS))
    rods = _NONE._replace(k1=_K1, c3=_ROTATING)
    held_once = float(_of(rods).kl)
    held_twice = float(_of(rods._replace(k1=_K1 - _ROTATING)).kl)
    static_alone = float(_of(_NONE._replace(c1=_PIN, c4=_PIN)).kp)
    return (
        WrongStep(
            N_("thickness of the right web in (44) to (53)"),
            "h_p, h_P, h_П",
            None,
            1e3 * float(_LENGTHS.h_p),
            "mm",
            N_("one length, hP, in three spellings; with it all sixteen are the balance of moments"),
        ),
        WrongStep(
            N_("force of the right web's plane in (45) and (47)"),
            "С9",
            None,
            None,
            "N",
            N_("a Cyrillic С for C: it is C9"),
        ),
        WrongStep(
            N_("fractions of (44) to (53)"),
            "l₁ + h_L 2",
            1e3 * float(_LENGTHS.l1 + _LENGTHS.h_l) / 2,
            1e3 * float(_LENGTHS.l1 + _LENGTHS.h_l / 2),
            "mm",
            N_(
                "flattened: the web's thickness alone is halved, l1 + hL/2, and not the sum; each whole bracket is "
                "divided by l"
            ),
        ),
        WrongStep(
            N_("a sum that is broken over two lines"),
            "… + / + …",
            None,
            None,
            "N",
            N_("the sign is printed at the end and at the beginning, as Russian print does: it is one plus, not two"),
        ),
        WrongStep(
            N_("external counterweights by (48), (49), and as moments at the ends of the continuous beam"),
            "(48) + M₀/l",
            alone + moment,
            alone,
            "N",
            N_("both are the same: who uses both counts them twice. Here R_KL of C11 = 6100 N at lP1 = 31 mm"),
        ),
        WrongStep(
            N_("rotating mass of the rods in C3 and C5, and in K"),
            "C₃, C₅; K₁, K₂",
            1e-3 * held_twice,
            1e-3 * held_once,
            "kN",
            N_(
                "C3 and C5 hold it, so K is of gas and of what goes to and fro alone; in K, too, it counts twice. "
                "Here R_KL of K1 = 21 500 N and C3 = 2600 N"
            ),
        ),
        WrongStep(
            N_("“a fully balanced throw has no reactions”"),
            "ΣC = 0",
            0.0,
            static_alone,
            "N",
            N_(
                "it takes ΣC = 0 and ΣCz = 0, static and dynamic balance: C4 = 4100 N balanced by C1 alone leaves "
                "R_KCP = −C4(2l2 + 2l3 + hL)/2l"
            ),
        ),
        WrongStep(
            N_("sense of x in (45), (47), against that of T in (51), (53)"),
            "R_TCP, R_TP",
            None,
            float(_of(_NONE._replace(c8=np.array(1000.0), t1=np.array(1000.0))).tp),
            "N",
            N_(
                "left open: only if x is against the rotation may they be added, and so it is read. Here R_TP of "
                "C8 = T1 = 1000 N; it is less than of T1 alone"
            ),
        ),
        WrongStep(
            N_("l and l7 of fig. 35"),
            "l, l₇",
            None,
            1e3 * float(throw_length(_LENGTHS)),
            "mm",
            N_(
                "l is no length of its own but l1 + hL + l2 + l3 + l4 + l5 + hP + l6, or (44) and (46) do not give the "
                "net force; l7 is in no formula"
            ),
        ),
        WrongStep(
            N_("C8 and C14, C9 and C15"),
            "C₈ + C₁₄, C₉ + C₁₅",
            None,
            float(_of(_NONE._replace(c8=np.array(310.0), c14=np.array(150.0))).tp),
            "N",
            N_(
                "only their sums occur: which is the web's and which the counterweight's the text does not say, and no "
                "reaction depends on it. Here R_TCP of C8 + C14 = 460 N"
            ),
        ),
    )


def _of(forces: ThrowForces, *, is_first: bool = False) -> ThrowReactions:
    """Reactions of the example's throw with other forces."""
    return throw_reactions(throw_constituents(_LENGTHS, forces), is_first=is_first)
