"""Static and dynamic balance of a throw: which holds, and what is left over, by hand."""

import pytest

from cranktrain.questions.crankshaft.methods.throw_reactions import throw_constituents, throw_reactions
from cranktrain.texts.throw_conditions import balance_conditions
from cranktrain.texts.throw_table import read_throw

SIZES = {"l1": "14 mm", "hL": "22 mm", "l2": "15 mm", "l5": "15 mm", "hP": "22 mm", "l6": "14 mm"}
"""Symmetric: l = 102 mm, webs at 25 and 77 mm, the pin at 51 mm."""


def found(**forces):
    throw = read_throw(SIZES | {"lP1": "20 mm", "lP2": "20 mm"} | {name: f"{f} N" for name, f in forces.items()})
    borne = throw_reactions(throw_constituents(throw.lengths, throw.forces), is_first=True, is_last=True)
    return balance_conditions(throw.lengths, throw.forces), [float(one) for one in borne]


def test_both_hold():
    """C4 balanced by two internal counterweights, and by two external ones."""
    for forces in ({"C4": 4100, "C1": 2050, "C7": 2050}, {"C4": 4100, "C11": 2050, "C13": 2050}):
        conditions, borne = found(**forces)
        assert conditions.hold
        assert borne == pytest.approx([0.0] * 4, abs=1e-9)


def test_static_alone():
    """C4 by C1 alone leaves a couple of 4100 N · 26 mm, and ∓ that over 102 mm."""
    conditions, borne = found(C4=4100, C1=4100)
    assert (conditions.static.holds, conditions.dynamic.holds, conditions.hold) == (True, False, False)
    assert conditions.dynamic.outward == pytest.approx(4100 * 0.026, rel=1e-12)
    assert borne == pytest.approx([-4100 * 26 / 102, 0.0, 4100 * 26 / 102, 0.0], rel=1e-12)
    assert borne[0] == pytest.approx(-4100 * (2 * 15 + 22) / (2 * 102), rel=1e-12)


def test_dynamic_alone_about_the_left_support():
    """C4 by C7 as the moments about L ask: L bears what is left of both, P nothing."""
    counterweight = 4100 * 51 / 77
    conditions, borne = found(C4=4100, C7=counterweight)
    assert (conditions.static.holds, conditions.dynamic.holds) == (False, True)
    assert conditions.static.outward == pytest.approx(4100 - counterweight, rel=1e-12)
    assert borne == pytest.approx([0.0, 0.0, counterweight - 4100, 0.0], abs=1e-9)


def test_across_the_plane():
    """C8 against the rotation is balanced by C10 with it, which is not at the same place."""
    conditions, _borne = found(C8=100, C10=100)
    assert conditions.static.holds
    assert conditions.dynamic.against == pytest.approx(100 * (0.025 + 0.020), rel=1e-12)
    assert conditions.dynamic.outward == 0.0
    assert conditions.dynamic.residual == pytest.approx(4.5 / (200 * 0.142), rel=1e-12)


def test_without_forces_both_hold():
    conditions, _borne = found()
    assert conditions.hold
    assert conditions.static.residual == 0.0
