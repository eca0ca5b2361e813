"""Wittenbauer's and Mertsalov's diagrams of machines: what is read off them is what was computed without them."""

import numpy as np
import pytest
from tests.sentences import MISSING_FOR_DIAGRAM
from tests.unit.questions.evenness.test_evenness import ENGINE, run

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.plans.evenness_diagrams import mertsalov_diagram, wittenbauer_diagram


@pytest.fixture(scope="module")
def engine():
    return run(coefficient=0.1)


def test_tangents_of_wittenbauer(engine):
    found = wittenbauer_diagram(engine)
    assert found.origin_inertia[0] == -engine.flywheel_inertia[0]
    fastest, slowest = (np.sqrt(2 * tangent.slope[0]) for tangent in (found.upper, found.lower))
    assert fastest - slowest == pytest.approx(0.1 * 30 * np.pi, rel=1e-12)
    for tangent, sign in ((found.upper, 1), (found.lower, -1)):
        line = tangent.slope[:, np.newaxis] * found.inertia + tangent.intercept[:, np.newaxis]
        assert np.all(sign * (line - found.work) >= -1e-9)
        # both pass through the origin
        height = tangent.slope * found.origin_inertia + tangent.intercept
        assert height[0] == pytest.approx(found.origin_work[0], rel=1e-12)
    np.testing.assert_array_equal(found.inertia[0], engine.reduced_inertia)
    np.testing.assert_array_equal(found.work[0], engine.excess_work)


def test_range_of_mertsalov(engine):
    found = mertsalov_diagram(run(coefficient=0.1, mean="extremes"))
    taken = float(found.largest.value[0, 0] - found.smallest.value[0, 0])
    size = run(coefficient=0.1, mean="extremes").flywheel_inertia[1]
    assert taken == pytest.approx(0.1 * (30 * np.pi) ** 2 * size, rel=1e-12)


@pytest.mark.parametrize("diagram", [wittenbauer_diagram, mertsalov_diagram])
def test_without_what_they_need(diagram):
    with pytest.raises(InputError, match=r"\[evenness\] coefficient"):
        diagram(run(flywheel="1 kg·m²"))
    with pytest.raises(InputError, match=rf"{MISSING_FOR_DIAGRAM}\[evenness\]"):
        diagram(ct.run(ct.Machine(**ENGINE)))


def test_of_links_that_do_not_close():
    short = {**ENGINE, "mechanism": {**ENGINE["mechanism"], "offset": "150 mm"}}
    result = ct.run(ct.Machine(**short, evenness={"coefficient": 0.02}), partial=True)
    with pytest.raises(InputError, match="not known all round"):
        wittenbauer_diagram(result)
