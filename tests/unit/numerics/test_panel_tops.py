"""Largest values of curves that are known at points of panels, against closed forms."""

import numpy as np
import pytest

from cranktrain.numerics.panel_tops import tops_in_panels
from cranktrain.numerics.pieces import largest_near
from cranktrain.numerics.subintervals import subintervals

TURN = 2 * np.pi
BREAKS = np.array([0.7, 2.9, 4.4])
CUT = subintervals(BREAKS, np.pi / 9, TURN, 3)
NONE = np.zeros(1)


def largest(curve, wide=0.012):
    """Of one curve, looked at where its panels show tops."""
    samples = curve(CUT.angle)[np.newaxis]
    centre = tops_in_panels(CUT, samples, NONE)
    scale = np.max(np.abs(samples), axis=-1)
    return largest_near(lambda _which, angle: curve(angle), centre, BREAKS[np.newaxis], scale, wide, TURN)


@pytest.mark.parametrize("place", np.linspace(0.0, 6.2, 25))
@pytest.mark.parametrize("sharpness", [1.0, 30.0])
def test_a_smooth_top(place, sharpness):
    found = largest(lambda angle: 2.0 * np.exp(sharpness * (np.cos(angle - place) - 1)))
    assert found.value[0] == pytest.approx(2.0, rel=1e-14)
    assert np.abs(np.mod(found.angle[0] - place + np.pi, TURN) - np.pi) < 1e-9
    assert found.side[0] == 0


@pytest.mark.parametrize("before", [True, False])
def test_a_jump_is_largest_on_its_side(before):
    """A ramp that falls back, or one that begins, at a break."""
    place = float(BREAKS[1])

    def ramp(angle):
        turned = np.mod(angle - place, TURN)
        return turned if before else TURN - turned

    found = largest(ramp)
    assert found.value[0] == pytest.approx(TURN, rel=1e-13)
    assert np.mod(found.angle[0], TURN) == pytest.approx(place, abs=1e-9)
    assert found.side[0] == (-1 if before else 1)


def test_of_alike_tops_the_first():
    found = largest(lambda angle: np.cos(3 * (angle - 0.5)))
    assert found.angle[0] == pytest.approx(0.5, abs=1e-9)


def test_a_top_beyond_its_window_is_gone_after():
    curve = np.cos
    found = largest_near(
        lambda _which, angle: curve(angle), np.array([[0.05]]), BREAKS[np.newaxis], np.ones(1), 0.01, TURN
    )
    assert found.angle[0] == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("level", [0.0, 3.0, np.nan])
def test_what_is_level_or_unknown_has_no_tops(level):
    assert np.all(np.isnan(tops_in_panels(CUT, np.full((1, CUT.angle.size), level), NONE)))


def test_what_is_rounding_beside_others_has_no_tops():
    small = 1e-13 * np.cos(CUT.angle)[np.newaxis]
    assert np.all(np.isnan(tops_in_panels(CUT, small, np.array([1e-12]))))
    assert np.any(~np.isnan(tops_in_panels(CUT, small, NONE)))
