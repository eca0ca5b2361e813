"""Fig. 35 as data: where along the shaft each force acts, and what of it is drawn."""

import numpy as np
import pytest

from cranktrain.plans.throw_scheme import throw_scheme
from cranktrain.questions.crankshaft.methods.throw_reactions import throw_constituents, throw_reactions
from cranktrain.texts.throw_table import read_throw

SIZES = {"l1": "14 mm", "hL": "22 mm", "l2": "15 mm", "l5": "15 mm", "hP": "24 mm", "l6": "14 mm"}
MORE = {"rods": "two", "l3": "13 mm", "l4": "14 mm", "lP1": "31 mm", "lP2": "36 mm"}
FORCES = [*(f"C{n}" for n in range(1, 16)), "K1", "K2", "T1", "T2"]


@pytest.mark.parametrize("name", FORCES)
def test_each_arrow_has_the_moments_that_the_formulas_have(name):
    """Σ of moments about L and P of the arrow alone against (44) to (53)."""
    throw = read_throw(SIZES | MORE | {name: "1000 N"})
    (one,) = throw_scheme(throw).forces
    sense = {"inward": (1, 0), "outward": (-1, 0), "with": (0, 1), "against": (0, -1)}[one.way]
    l = 0.131
    right, left = 1000 * one.place / l, 1000 * (1 - one.place / l)
    borne = throw_reactions(throw_constituents(throw.lengths, throw.forces), is_first=True, is_last=True)
    wanted = np.concatenate([right * np.array(sense), left * np.array(sense)])
    np.testing.assert_allclose([*borne], wanted, rtol=1e-12, atol=1e-9)


def test_lengths_are_a_chain():
    found = throw_scheme(read_throw(SIZES | MORE))
    assert [one.letter for one in found.chain] == ["l_1", "h_L", "l_2", "l_3", "l_4", "l_5", "h_P", "l_6"]
    assert [one.letter for one in found.over] == ["l_P1", "l", "l_P2"]
    assert found.chain[-1].end == pytest.approx(0.131, rel=1e-14)
    assert found.pin == pytest.approx(0.064, rel=1e-14)
    assert found.forces == ()


def test_lengths_of_0_are_left_out():
    found = throw_scheme(read_throw(SIZES))
    assert [one.letter for one in found.chain] == ["l_1", "h_L", "l_2", "l_5", "h_P", "l_6"]
    assert [one.letter for one in found.over] == ["l"]
