"""Stroke and turn of a chamber, for central and offset slider-cranks, against the order of the strokes."""

import numpy as np
import pytest

from cranktrain.fluids import VolumeLimits, chamber_state
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank
from cranktrain.motion import Coefficient
from cranktrain.numerics import extremes

FOUR_STROKE, TWO_STROKE = 4 * np.pi, 2 * np.pi


def volume(angle, geometry):
    slider = slider_crank(angle, geometry).slider
    return Coefficient(0.2 - slider.value, -slider.first, -slider.second)


def limits_and_angles(geometry):
    """Volumes and angles of the true dead centres."""
    found = extremes(lambda angle: volume(angle, geometry).value, lambda angle: volume(angle, geometry).first)
    limits = VolumeLimits(float(found.smallest.value[0]), float(found.largest.value[0]))
    top, bottom = (float(np.mod(each.angle[0] + np.pi / 2, 2 * np.pi) - np.pi / 2) for each in found)
    return limits, top, bottom


@pytest.mark.parametrize("offset", [0.0, 0.012, -0.012])
def test_strokes_meet_at_true_dead_centres(offset):
    geometry = SliderCrank(0.045, 0.15, offset)
    limits, top, bottom = limits_and_angles(geometry)
    near = 1e-6
    ends = [top, bottom, top + 2 * np.pi, bottom + 2 * np.pi, top + 4 * np.pi]
    strokes = [(1, 1), (-1, -1), (1, -1), (-1, 1)]  # expansion, exhaust, inlet, compression
    for start, end, (sense, turn) in zip(ends, ends[1:], strokes, strict=False):
        angle = np.linspace(start + near, end - near, 101)
        state = chamber_state(volume(angle, geometry), limits, angle, FOUR_STROKE)
        assert np.all(state.sense == sense)
        assert np.all(state.turn == turn)


@pytest.mark.parametrize("turns", [-4, 0, 4])
def test_at_a_dead_centre_is_as_just_after_it(turns):
    """Also where rounding puts V′ a little on the other side, as at 360°: sin 2π is not 0."""
    geometry = SliderCrank(0.045, 0.15, 0.0)
    angle = np.radians([0.0, 180.0, 360.0, 540.0]) + 2 * np.pi * turns
    limits, _, _ = limits_and_angles(geometry)
    state = chamber_state(volume(angle, geometry), limits, angle, FOUR_STROKE)
    assert state.sense.tolist() == [1, -1, 1, -1]
    assert state.turn.tolist() == [1, -1, -1, 1]


def test_a_two_stroke_works_in_every_turn():
    geometry = SliderCrank(0.045, 0.15, 0.0)
    limits, _, _ = limits_and_angles(geometry)
    angle = np.linspace(0, TWO_STROKE, 37)
    assert np.all(chamber_state(volume(angle, geometry), limits, angle, TWO_STROKE).turn == 1)
