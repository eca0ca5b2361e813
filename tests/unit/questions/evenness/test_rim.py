"""Rim of a flywheel, and the elementwise functions compiled."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from cranktrain.linkage import compiled
from cranktrain.questions.evenness.rim import RimDemand, rim, rim_speed

FEW = settings(max_examples=40, deadline=None, derandomize=True)


@FEW
@given(st.floats(0.01, 1e5), st.floats(0, 0.5), st.floats(0.1, 5), st.floats(0.2, 4), st.floats(1000, 9000))
def test_rim_has_the_inertia_of_its_ring(inertia, other, diameter, ratio, density):
    found = rim(inertia, RimDemand(diameter, ratio, other, density))
    if np.isnan(found.height):
        # a section that just reaches the axis has too little
        h = diameter
        assert np.pi * density * diameter * ratio * h**2 * (diameter**2 + h**2) / 4 <= inertia * (1 - other) * (
            1 + 1e-9
        )
        return
    outer, inner = diameter / 2 + found.height / 2, diameter / 2 - found.height / 2
    ring = np.pi / 2 * density * found.width * (outer**4 - inner**4)
    assert ring == pytest.approx(inertia * (1 - other), rel=1e-11)
    assert found.mass == pytest.approx(np.pi * density * found.width * (outer**2 - inner**2), rel=1e-11)
    assert found.outer_diameter == 2 * outer
    assert found.width == pytest.approx(ratio * found.height)
    assert found.textbook_mass > found.mass


def test_speed_of_the_outside():
    assert rim_speed(1.2, 50.0) == 30.0


def test_compiled():
    too_small = RimDemand(0.5, 1.0, 0.0, 7800.0)
    for inertia, demand in ((90.0, RimDemand(1.2, 1.5, 0.1, 7200.0)), (1e6, too_small)):
        np.testing.assert_array_equal(compiled(rim)(inertia, demand), rim(inertia, demand))
    assert np.isnan(rim(1e6, too_small).height)
    assert compiled(rim_speed)(1.2, 50.0) == 30.0
