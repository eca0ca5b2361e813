"""Integrals of a vector's size, against those of 40 digits."""

import mpmath
import numpy as np
import pytest

from cranktrain.numerics import subintervals
from cranktrain.numerics.size_integral import integral_of_size

CUT = subintervals(np.array([0.3, 2.0]), np.pi / 9, 2 * np.pi)


def out_and_back(slow):
    """Integral of |1 − cos φ + s sin φ| over a turn."""
    corner = -2 * np.arctan(slow)
    between = -slow - (corner - np.sin(corner) - slow * np.cos(corner))
    return 2 * np.pi - 2 * between


@pytest.mark.parametrize("apart", [0.0, 1e-12, 1e-5, 0.003, 0.1, 0.9])
@pytest.mark.parametrize("turn", [0.4, 1.1234])
def test_a_vector_that_passes_nothing(apart, turn):
    """By a hair, or further off: cos(φ − turn) along, a constant across, four times an elliptic integral."""
    along, across = np.cos(CUT.angle - turn), np.full(CUT.angle.size, apart)
    found = integral_of_size(CUT, (np.stack([along, -3 * across]), np.stack([across, 3 * along])))
    with mpmath.workdps(40):
        square = 1 + mpmath.mpf(apart) ** 2
        whole = float(4 * mpmath.sqrt(square) * mpmath.ellipe(1 / square))
    np.testing.assert_allclose(found, [whole, 3 * whole], rtol=1e-11)


def test_a_vector_that_turns_round_anywhere_in_a_panel():
    """|sin(φ − turn)| has the integral 4, whether its corners are between a panel's points or beyond the last one."""
    turn = np.random.default_rng(1).uniform(0, 2 * np.pi, (400, 1))
    found = integral_of_size(CUT, (np.sin(CUT.angle - turn), np.zeros((400, CUT.angle.size))))
    np.testing.assert_allclose(found, 4, rtol=1e-11)


@pytest.mark.parametrize("slow", [1e-3, 5e-3, 0.014, 0.1])
def test_a_vector_that_turns_round_and_back_between_two_points(slow):
    """|1 − cos φ + s sin φ| with the corners 0 and −2 arctan s, between which ∫ = φ − sin φ − s cos φ is negative."""
    turn = np.random.default_rng(2).uniform(0, 2 * np.pi, (400, 1))
    along = 1 - np.cos(CUT.angle - turn) + slow * np.sin(CUT.angle - turn)
    found = integral_of_size(CUT, (along, np.zeros_like(along)))
    np.testing.assert_allclose(found, out_and_back(slow), rtol=1e-11)


def test_a_vector_that_is_not_known():
    nothing = np.full((1, CUT.angle.size), np.nan)
    assert np.isnan(integral_of_size(CUT, (nothing, nothing)))


def test_a_vector_that_is_nothing():
    assert integral_of_size(CUT, (np.zeros((2, CUT.angle.size)),) * 2).tolist() == [0.0, 0.0]
