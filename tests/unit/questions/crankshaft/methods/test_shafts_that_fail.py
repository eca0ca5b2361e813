"""What no method can find is NaN, without a warning; and a web's shortening."""

import numpy as np
import pytest
from tests.crankshaft_i4 import crankshaft
from tests.crankshafts import drawn_crankshaft
from tests.straight_shafts import forces_on, straight_shaft

from cranktrain.questions.crankshaft.bending.equivalent_stiffness import end_slopes, equivalent_stiffness
from cranktrain.questions.crankshaft.methods import BEARING_METHODS

EVERY = pytest.mark.parametrize("method", BEARING_METHODS, ids=lambda method: method.name)
THROW = np.array([0]), np.array([1])
"""The span of the first throw, and the piece that its pin is."""
THROUGH_SHAFT = pytest.mark.parametrize("method", BEARING_METHODS[:4], ids=lambda method: method.name)


@EVERY
def test_a_shaft_on_one_bearing_floats(method):
    found = method.loads(straight_shaft([0.0], compliance=1e-8), forces_on([0.1], [[1.0, 2.0]]))
    for values in found:
        assert values.shape == (1, 1, 2, 1)
        assert np.all(np.isnan(values))


@THROUGH_SHAFT
def test_a_shaft_without_stiffness(method):
    shaft = straight_shaft([0.0, 1.0, 2.0], bending=0.0, compliance=1e-8)
    assert np.all(np.isnan(method.loads(shaft, forces_on([0.3], [[1.0, 2.0]])).load))


@pytest.mark.parametrize(
    "method", [BEARING_METHODS[0], BEARING_METHODS[2], BEARING_METHODS[5]], ids=lambda one: one.name
)
def test_a_bearing_without_stiffness(method):
    shaft = straight_shaft([0.0, 1.0, 2.0], compliance=np.inf)
    assert np.all(np.isnan(method.loads(shaft, forces_on([0.3], [[1.0, 2.0]])).load))


@EVERY
def test_a_design_that_fails_leaves_others_alone(method):
    shaft, loads = drawn_crankshaft(4, 3)
    both = shaft._replace(
        pieces=type(shaft.pieces)(*(np.concatenate([values, values]) for values in shaft.pieces)),
        webs=type(shaft.webs)(*(np.concatenate([values, values]) for values in shaft.webs)),
        supports=type(shaft.supports)(
            *(np.concatenate([values, values]) for values in shaft.supports[:4]), shaft.supports.thrust
        ),
        straight=type(shaft.straight)(*(np.concatenate([values, values]) for values in shaft.straight)),
    )
    both.pieces.bending[0], both.straight.bending[0] = np.nan, np.nan
    acting = type(loads)(*loads[:2], *(np.concatenate([values, values]) for values in loads[2:]))
    found = method.loads(both, acting).load
    assert np.all(np.isnan(found[0])) or method.name == "split" or found.shape[1] == 2
    np.testing.assert_array_equal(found[1], method.loads(shaft, loads).load[0])


@EVERY
def test_without_loads(method):
    shaft = straight_shaft([0.0, 1.0, 2.5], compliance=1e-8)
    found = method.loads(shaft, forces_on([], np.zeros((0, 2))))
    np.testing.assert_array_equal(found.load, np.zeros((1, 3, 2, 1)))


def test_webs_that_are_shorter_are_stiffer():
    """Ker Wilson's rule takes 0.2 (d_j + d_p) off each: 2(r − …)/EI in place of 2r/EI, under a constant moment."""
    shaft = crankshaft()
    taken = 0.2 * np.array([0.05, 0.048])
    rigid = np.stack([taken, taken[::-1]] * 4)[np.newaxis]
    whole = equivalent_stiffness(shaft, end_slopes(shaft), *THROW).constant_moment[0, 0]
    shorter = shaft._replace(webs=shaft.webs._replace(rigid=rigid))
    short = equivalent_stiffness(shorter, end_slopes(shorter), *THROW).constant_moment[0, 0]
    lost = 2 * np.sum(taken) / np.array([shaft.webs.bending[0, 0], shaft.webs.torsion[0, 0]])
    np.testing.assert_allclose(0.092 / whole - 0.092 / short, lost, rtol=1e-12)


def test_constant_moment_against_its_closed_form():
    """l/EI_eq = Σ l_j/EI_j + l_p/EI_p + 2r/EI_web in the plane, 2r/GJ_web across it."""
    shaft = crankshaft()
    pieces, webs = shaft.pieces, shaft.webs
    straight = 0.046 / pieces.bending[0, 0] + 0.046 / pieces.bending[0, 1]
    wanted = straight + 2 * 0.039 / np.array([webs.bending[0, 0], webs.torsion[0, 0]])
    np.testing.assert_allclose(
        0.092 / equivalent_stiffness(shaft, end_slopes(shaft), *THROW).constant_moment[0, 0], wanted, rtol=1e-13
    )
