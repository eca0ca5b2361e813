"""Formulas (44)–(53) of [crankshaft-reactions] against an example by the balance of moments, and the split shaft."""

import numpy as np
import pytest
from tests.reference_case import ReferenceCase
from tests.straight_shafts import forces_on, straight_shaft

from cranktrain.questions.crankshaft.methods.split import SPLIT
from cranktrain.questions.crankshaft.methods.throw_reactions import (
    ThrowForces,
    ThrowLengths,
    journal_load,
    throw_balance,
    throw_constituents,
    throw_length,
    throw_reactions,
)

CASE = ReferenceCase.load("formulas_44_53")
GIVEN = {key.lower().rpartition("_")[0]: np.float64(value) for key, value in CASE.machine.items()}
LENGTHS = ThrowLengths(*(GIVEN[name] for name in ThrowLengths._fields))
FORCES = ThrowForces(*(GIVEN[name] for name in ThrowForces._fields))
NONE = ThrowForces(*np.zeros(len(ThrowForces._fields)))


def test_all_sixteen():
    found = throw_constituents(LENGTHS, FORCES)
    for numbers, part in (
        (("44 KCP", "45 TCP", "46 KCL", "47 TCL"), found.rotating),
        (("48 KP", "48 TP", "48 KL", "48 TL"), found.first),
        (("49 KP", "49 TP", "49 KL", "49 TL"), found.last),
        (("50 KP", None, "52 KL", None), found.normal),
        ((None, "51 TP", None, "53 TL"), found.tangential),
    ):
        for number, value in zip(numbers, part, strict=True):
            if number is None:
                assert value == 0
            else:
                CASE.compare_value(number, value)


def test_length_is_the_sum_of_the_chain():
    assert throw_length(LENGTHS) == GIVEN["l"]


def placed(**forces):
    """A throw with these forces alone, and the same forces on a split shaft: against the rotation and outward."""
    acting = NONE._replace(**{name: np.float64(value) for name, value in forces.items()})
    s, l = LENGTHS, float(throw_length(LENGTHS))
    left, right, pin = s.l1 + s.h_l / 2, l - s.l6 - s.h_p / 2, s.l1 + s.h_l + s.l2 + s.l3
    where = {
        "c1": (left, -1, 1), "c2": (left, 1, 1), "c3": (pin - s.l3, 1, 1), "c4": (pin, 1, 1), "c5": (pin + s.l4, 1, 1),
        "c6": (right, 1, 1), "c7": (right, -1, 1), "c8": (left, 1, 0), "c14": (left, 1, 0), "c9": (right, 1, 0),
        "c15": (right, 1, 0), "c10": (-s.l_p1, -1, 0), "c11": (-s.l_p1, -1, 1), "c12": (l + s.l_p2, 1, 0),
        "c13": (l + s.l_p2, -1, 1), "k1": (pin - s.l3, -1, 1), "k2": (pin + s.l4, -1, 1), "t1": (pin - s.l3, -1, 0),
        "t2": (pin + s.l4, -1, 0),
    }  # fmt: skip
    z = [where[name][0] for name in forces]
    across = np.zeros((len(z), 2))
    for row, (name, value) in enumerate(forces.items()):
        across[row, where[name][2]] = where[name][1] * value
    return acting, SPLIT.loads(straight_shaft([0.0, l]), forces_on(z, across)).load[0, :, :, 0]


@pytest.mark.parametrize("name", ThrowForces._fields)
def test_each_force_alone_is_that_of_the_split_shaft(name):
    """The split shaft has its loads outward and against the rotation, the formulas inward and with it."""
    acting, borne = placed(**{name: 1000.0})
    found = throw_reactions(throw_constituents(LENGTHS, acting), is_first=True, is_last=True)
    np.testing.assert_allclose([[found.tl, found.kl], [found.tp, found.kp]], -borne, rtol=0, atol=1e-9)


def test_external_counterweights_count_where_they_are_said_to_be():
    found = throw_constituents(LENGTHS, FORCES)
    plain, first, last = (
        throw_reactions(found), throw_reactions(found, is_first=True), throw_reactions(found, is_last=True)
    )  # fmt: skip
    assert first.kp - plain.kp == pytest.approx(found.first.kp)
    assert last.tl - plain.tl == pytest.approx(found.last.tl)


def test_static_balance_alone_leaves_a_couple():
    """C₄ balanced by C₁ alone: R_KCP = −C₄ (2 l₂ + 2 l₃ + h_L)/(2 l)."""
    acting = NONE._replace(c1=np.float64(4100.0), c4=np.float64(4100.0))
    balance = throw_balance(LENGTHS, acting)
    assert (balance.outward, balance.against) == (0.0, 0.0)
    found = throw_reactions(throw_constituents(LENGTHS, acting))
    l2, l3, h_l = LENGTHS.l2, LENGTHS.l3, LENGTHS.h_l
    wanted = -4100.0 * (2 * l2 + 2 * l3 + h_l) / (2 * throw_length(LENGTHS))
    assert found.kp == pytest.approx(wanted, rel=1e-13)
    assert found.kl == pytest.approx(-wanted, rel=1e-13)
    assert balance.outward_moment == pytest.approx(-wanted * throw_length(LENGTHS), rel=1e-13)


def test_a_throw_in_both_balances_has_no_reactions():
    """C₂ … C₆ of a throw, and internal and external counterweights that take both sums to 0."""
    acting = FORCES._replace(
        k1=0.0, k2=0.0, t1=0.0, t2=0.0, c8=0.0, c9=0.0, c14=0.0, c15=0.0, c10=0.0, c12=0.0, c11=0.0, c13=0.0
    )
    alone = throw_balance(LENGTHS, acting._replace(c1=0.0, c7=0.0))
    left = LENGTHS.l1 + LENGTHS.h_l / 2
    right = throw_length(LENGTHS) - LENGTHS.l6 - LENGTHS.h_p / 2
    c7 = (alone.outward_moment - left * alone.outward) / (right - left)
    whole = acting._replace(c1=alone.outward - c7, c7=c7)
    balance = throw_balance(LENGTHS, whole)
    found = throw_reactions(throw_constituents(LENGTHS, whole))
    np.testing.assert_allclose([*balance], 0.0, atol=1e-9)
    np.testing.assert_allclose([*found], 0.0, atol=1e-10)


def test_journal_between_two_throws():
    """Loads as vectors: the throw behind is turned ahead by γ, its T with the rotation, its K inward."""
    before, behind = (
        throw_reactions(throw_constituents(LENGTHS, forces))
        for forces in (FORCES, FORCES._replace(k1=np.float64(-700.0)))
    )
    ahead = 2.1
    inward = np.array([-1.0, 0.0])
    forward = np.array([0.0, 1.0])
    turn = np.array([[np.cos(ahead), -np.sin(ahead)], [np.sin(ahead), np.cos(ahead)]])
    whole = before.kp * inward + before.tp * forward + turn @ (behind.kl * inward + behind.tl * forward)
    normal, tangential = journal_load(before, behind, np.float64(ahead))
    np.testing.assert_allclose([normal, tangential], [whole @ inward, whole @ forward], rtol=1e-13)
