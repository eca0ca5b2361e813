"""Slots that drive a slider on a straight guide, against closed forms of their own."""

import numpy as np
import pytest

from cranktrain.linkage import Crank, Trammel, crank, fixed, trammel, turned_link
from cranktrain.motion import Coefficient, Link


def slotted_crank(angle) -> Link:
    """A slot through the shaft's centre, which turns with the crank."""
    still = 0.0 * angle
    return Link(fixed(still, still), Coefficient(angle, still + 1.0, still), np.cos(angle), np.sin(angle))


ANGLES = np.linspace(0.4, 2.7, 9)


def test_slider_of_a_slotted_crank_is_a_cotangent():
    motion = trammel(slotted_crank(ANGLES), Trammel(0.3, 0.0))
    sin, cot = np.sin(ANGLES), 1 / np.tan(ANGLES)
    assert motion.slider.value == pytest.approx(0.3 * cot, rel=1e-14, abs=1e-16)
    assert motion.slider.first == pytest.approx(-0.3 / sin**2, rel=1e-14)
    assert motion.slider.second == pytest.approx(0.6 * cot / sin**2, rel=1e-14, abs=1e-15)
    assert motion.block.value == pytest.approx(0.3 / sin, rel=1e-14)
    assert motion.block.first == pytest.approx(-0.3 * cot / sin, rel=1e-14, abs=1e-16)
    assert motion.block.second == pytest.approx(0.3 * (cot**2 + 1 / sin**2) / sin, rel=1e-14)


def test_slot_square_to_the_guide_and_beside_its_pivot():
    motion = trammel(slotted_crank(np.float64(np.pi / 2)), Trammel(0.3, 0.1))
    assert [motion.slider.value, motion.block.value] == pytest.approx([-0.1, 0.3], rel=1e-15)


def test_slot_along_the_guide_has_no_crossing():
    link = slotted_crank(np.float64(0.0))
    with np.errstate(all="ignore"):
        assert not np.isfinite(trammel(link, Trammel(0.3, 0.0)).slider.value)


def test_turned_link_has_the_same_derivatives():
    pin = crank(np.float64(0.7), Crank(0.2))
    link = Link(pin, Coefficient(np.float64(-3.0), np.float64(0.4), np.float64(0.1)), np.cos(-3.0), np.sin(-3.0))
    seen = turned_link(link, np.pi / 2)
    assert [seen.origin.x.value, seen.origin.y.first] == pytest.approx(
        [0.2 * np.sin(0.7), 0.2 * np.sin(0.7)], rel=1e-15
    )
    assert seen.angle.value == pytest.approx(2 * np.pi - 3.0 - np.pi / 2, rel=1e-15)
    assert [seen.cos, seen.sin] == pytest.approx([np.sin(-3.0), -np.cos(-3.0)], rel=1e-15)
    assert (seen.angle.first, seen.angle.second) == (0.4, 0.1)
