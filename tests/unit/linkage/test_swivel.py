"""Guides about a pivot, against closed forms of their own."""

import numpy as np
import pytest

from cranktrain.linkage import AHEAD, Crank, Ends, Swivel, crank, fixed, swivel, swivel_gap


def ends(angle, crank_radius: float, ground_length: float) -> Ends:
    return Ends(crank(angle, Crank(crank_radius)), fixed(ground_length, 0.0))


def test_slotted_lever_swings_by_the_arcsine_of_crank_over_ground():
    # The crank stands square to the lever there: the lever is at rest.
    guide = swivel(ends(np.arccos(0.3 / 0.5), 0.3, 0.5), Swivel(0.0, AHEAD)).guide
    assert np.pi - guide.angle.value == pytest.approx(np.arcsin(0.3 / 0.5), rel=1e-15)
    assert guide.angle.first == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize(("angle", "ratio"), [(0.0, 0.5 / (0.5 - 0.2)), (np.pi, 0.5 / (0.5 + 0.2))])
def test_whitworth_guide_turns_in_the_ratio_of_the_distances(angle, ratio):
    motion = swivel(ends(angle, 0.5, 0.2), Swivel(0.0, AHEAD))
    assert motion.guide.angle.first == pytest.approx(ratio, rel=1e-15)
    assert motion.slider.first == pytest.approx(0.0, abs=1e-15)
    # At rest on its guide the slider is accelerated toward the shaft, less the guide's own centripetal acceleration.
    toward_shaft = -0.5 * np.cos(angle) * motion.guide.cos
    assert motion.slider.second == pytest.approx(toward_shaft + motion.slider.value * ratio**2, rel=1e-14)


def test_offset_guide_lies_on_its_side_of_the_pivot():
    # Pin 0.5 from the pivot, offset 0.3: the slider is 0.4 along the guide.
    for offset, side in ((0.3, AHEAD), (0.3, -1.0), (-0.3, AHEAD), (-0.3, -1.0)):
        motion = swivel(ends(np.pi / 2, 0.3, 0.4), Swivel(offset, side))
        along = np.array([motion.guide.cos, motion.guide.sin])
        left = np.array([-motion.guide.sin, motion.guide.cos])
        assert motion.slider.value == pytest.approx(side * 0.4, rel=1e-15)
        assert motion.slider.value * along + offset * left == pytest.approx([-0.4, 0.3], rel=1e-15)


def test_pin_within_the_offset_cannot_close():
    near, far = ends(0.0, 0.3, 0.5), ends(np.pi, 0.3, 0.5)
    assert swivel_gap(near, Swivel(-0.25, AHEAD)) == pytest.approx(-0.05, rel=1e-14)
    assert swivel_gap(far, Swivel(-0.25, AHEAD)) == pytest.approx(0.55, rel=1e-14)
    with np.errstate(invalid="ignore"):
        motion = swivel(near, Swivel(-0.25, AHEAD))
    assert np.isnan([*motion.slider, *motion.guide.angle, motion.guide.cos, motion.guide.sin]).all()
