"""Scotch yokes, against closed forms of their own."""

import numpy as np
import pytest

from cranktrain.linkage import Crank, Yoke, crank, yoke

TURN = np.arange(0, 360, 15) * (np.pi / 180)


def test_scotch_yoke_is_a_pure_cosine():
    motion = yoke(crank(TURN, Crank(0.2)), Yoke(0.05, np.pi / 2))
    assert motion.slider.value == pytest.approx(0.2 * np.cos(TURN), abs=1e-16)
    assert motion.slider.second == pytest.approx(-0.2 * np.cos(TURN), abs=1e-16)
    assert motion.block.value == pytest.approx(0.2 * np.sin(TURN) - 0.05, abs=1e-16)


def test_inclined_slot_makes_the_stroke_longer_and_later():
    """A slot at β: amplitude R/sin β, dead centre where the crank stands square to the slot."""
    slot_angle = np.deg2rad(60.0)
    motion = yoke(crank(slot_angle - np.pi / 2, Crank(0.2)), Yoke(0.0, slot_angle))
    assert motion.slider.value == pytest.approx(0.2 / np.sin(slot_angle), rel=1e-15)
    assert motion.slider.first == pytest.approx(0.0, abs=1e-16)
