"""Continuous beams in closed form: equal spans under loads in their middles, a bearing that has sunk, three springs."""

from fractions import Fraction

import numpy as np
import pytest
from tests.reference_case import ReferenceCase
from tests.straight_shafts import forces_on, straight_shaft

from cranktrain.questions.crankshaft.methods import BEARING_METHODS

CASE = ReferenceCase.load("beam_closed_forms")
METHODS = {method.name: method for method in BEARING_METHODS}


def found(method, n_spans, **stands):
    """What a method finds of spans of length 1 under unit loads down, as far as there are any."""
    down = np.tile([0.0, -1.0], (n_spans, 1))
    return METHODS[method].loads(
        straight_shaft(np.arange(n_spans + 1.0), **stands), forces_on(np.arange(n_spans) + 0.5, down)
    )


@pytest.mark.parametrize("method", ["three_moment", "frame_rigid"])
@pytest.mark.parametrize("n_spans", [2, 3, 4])
def test_equal_spans(method, n_spans):
    got = found(method, n_spans)
    for bearing in range(n_spans // 2 + 1):
        CASE.compare_value(f"{n_spans} equal spans, central P each: R{bearing}/P", -got.load[0, bearing, 1, 0])
        if bearing:
            CASE.compare_value(f"{n_spans} equal spans, central P each: M{bearing}/(P l)", got.moment[0, bearing, 1, 0])


def test_two_central_loads_against_fractions():
    got = found("three_moment", 2)
    wanted = [Fraction(5, 16), Fraction(11, 8), Fraction(5, 16)]
    np.testing.assert_allclose(-got.load[0, :, 1, 0], [float(one) for one in wanted], rtol=1e-13)


@pytest.mark.parametrize("method", ["three_moment", "frame_rigid"])
def test_a_bearing_that_has_sunk(method):
    settled = straight_shaft([0, 1, 2], settlement=[[0, 0], [0, -1], [0, 0]])
    got = METHODS[method].loads(settled, forces_on([0.5], [[0.0, 0.0]]))
    CASE.compare_value("2 spans, middle support lowered 1 (EI=l=1): R1", -got.load[0, 1, 1, 0])
    CASE.compare_value("same: M1 (sag +)", got.moment[0, 1, 1, 0])
    np.testing.assert_array_equal(got.displacement[0, 1, :, 0], [0.0, -1.0])


@pytest.mark.parametrize("method", ["five_moment", "frame_elastic"])
def test_three_springs(method):
    got = found(method, 2, compliance=1 / 7)
    CASE.compare_value("2 spans on springs k=7: R1 (force method closed form)", -got.load[0, 1, 1, 0])
