"""Motion of all mechanisms on the grid: that of one turn, which the others repeat."""

import numpy as np
import pytest
from tests.machines import V12

import cranktrain as ct
from cranktrain.numerics.nested import leaves
from cranktrain.questions.motion.grid_motion import GridMotion


@pytest.mark.parametrize("name", ["3d12", "lms_class5", "pumping_unit_c57"])
def test_it_is_what_the_kernels_give(name):
    """Of a four-stroke too, whose second turn is not evaluated; rounding of some ten radians is let through."""
    result = ct.run(ct.load(name))
    grid = result[GridMotion]
    assert grid.n_angles == result.crank_angle.size
    phi = result.grid.angle
    for batch, own in zip(grid.mechanisms.batches, grid.batches, strict=True):
        motion = batch.kind.motion(phi + batch.members.phase, batch.members.geometry)
        for found, expected in zip(leaves(own), leaves(motion), strict=True):
            assert np.shape(found) == np.shape(expected)
            np.testing.assert_allclose(found, expected, rtol=0, atol=1e-11 * np.max(np.abs(expected)))


def test_both_turns_of_a_four_stroke_are_one():
    result = ct.run(ct.Machine(**V12))
    first, second = np.split(result.piston_acceleration, 2, axis=-1)
    assert np.array_equal(first, second)


def test_what_stands_in_several_places_is_repeated_once():
    """The crank pin is where the rod begins."""
    (motion,) = ct.run(ct.load("inline_six"))[GridMotion].batches
    assert motion.pin.x.value is motion.rod.origin.x.value
