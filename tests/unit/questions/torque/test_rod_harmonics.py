"""Harmonics of the central slider-crank against the hypergeometric form in 40 digits and a table by quadrature."""

import json
from pathlib import Path

import mpmath
import numpy as np
import pytest

from cranktrain.questions.torque.rod_harmonics import acceleration_harmonics, torque_harmonics
from cranktrain.texts.harmonic_series import acceleration_series, torque_series, two_harmonic_torque, two_harmonics

TABLE = json.loads((Path(__file__).parents[3] / "golden/theory/harmonics_pnskt.json").read_text(encoding="utf-8"))
TABLE = TABLE["harmonics"]
DIGITS = 40


def even_harmonic(ratio, n):
    """A_2n by the hypergeometric function."""
    with mpmath.workdps(DIGITS):
        lam = mpmath.mpf(ratio)
        half = mpmath.mpf(1) / 2
        series = mpmath.hyp2f1(n - half, n + half, 2 * n + 1, lam**2)
        return float(8 * n**2 / lam * mpmath.binomial(half, n) * (lam / 2) ** (2 * n) * series)


def second_harmonic(ratio):
    """A_2 by the complete elliptic integrals."""
    with mpmath.workdps(DIGITS):
        lam = mpmath.mpf(ratio)
        square = lam**2
        first, second = mpmath.ellipk(square), mpmath.ellipe(square)
        return float(16 / (3 * mpmath.pi * lam**3) * ((2 - square) * second - 2 * (1 - square) * first))


@pytest.mark.parametrize("ratio", [1e-4, 0.05, 0.25, 0.5, 0.8, 0.93, 0.99])
def test_every_harmonic_to_rounding_of_itself(ratio):
    found = acceleration_harmonics(ratio, 24)
    expected = [even_harmonic(ratio, n) for n in range(1, 13)]
    np.testing.assert_allclose(found[2::2], expected, rtol=4e-15, atol=1e-300)
    assert found[2] == pytest.approx(second_harmonic(ratio), rel=1e-15)
    np.testing.assert_array_equal(found[:2], [0, 1])
    np.testing.assert_array_equal(found[3::2], 0)


def test_near_one_to_its_own_conditioning():
    # k' = √(1 − λ²) = 0.014 amplifies the rounding of λ itself
    found = acceleration_harmonics(0.9999, 6)
    np.testing.assert_allclose(found[2::2], [even_harmonic(0.9999, n) for n in (1, 2, 3)], rtol=1e-14)


@pytest.mark.parametrize("ratio", TABLE)
def test_table_of_quadrature(ratio):
    acceleration, torque = acceleration_harmonics(float(ratio), 8), torque_harmonics(float(ratio), 6)
    for order in (2, 4, 6, 8):
        assert abs(acceleration[order] - TABLE[ratio][f"A{order}"]) <= 1e-15
    for order in range(1, 7):
        assert abs(torque[order] - TABLE[ratio][f"D{order}"]) <= 1e-15


@pytest.mark.parametrize("ratio", [0.25, 0.93])
def test_torque_harmonics_are_those_of_velocity_times_acceleration(ratio):
    # the coefficient of sin kφ by the trapezoid, which converges geometrically: 4096 points leave nothing at λ = 0.93
    phi = np.arange(4096) * (2 * np.pi / 4096)
    sin, cos = np.sin(phi), np.cos(phi)
    root = np.sqrt(1 - (ratio * sin) ** 2)
    velocity = sin + ratio * sin * cos / root
    acceleration = cos + ratio * np.cos(2 * phi) / root + ratio**3 * (sin * cos) ** 2 / root**3
    expected = [-2 * np.mean(velocity * acceleration * np.sin(k * phi)) for k in range(1, 13)]
    np.testing.assert_allclose(torque_harmonics(ratio, 12)[1:], expected, rtol=0, atol=4e-15)


def test_infinite_rod_leaves_one_harmonic():
    np.testing.assert_array_equal(acceleration_harmonics(0.0, 4), [0, 1, 0, 0, 0])
    np.testing.assert_array_equal(torque_harmonics(0.0, 4), [0, 0, -0.5, 0, 0])


def test_designs_broadcast_and_what_cannot_turn_is_nan():
    ratios = np.array([[0.25, 1.0], [-0.1, np.nan]])
    found, torque = acceleration_harmonics(ratios, 4), torque_harmonics(ratios, 4)
    assert found.shape == torque.shape == (2, 2, 5)
    np.testing.assert_array_equal(np.isnan(found[..., 2]), [[False, True], [True, True]])
    np.testing.assert_array_equal(np.isnan(torque[..., 2]), [[False, True], [True, True]])
    np.testing.assert_allclose(found[0, 0], acceleration_harmonics(0.25, 4), rtol=0, atol=1e-16)


def test_few_orders_are_those_of_many():
    np.testing.assert_array_equal(acceleration_harmonics(0.3, 1), [0, 1])
    np.testing.assert_array_equal(acceleration_harmonics(0.3, 3), acceleration_harmonics(0.3, 40)[:4])


@pytest.mark.parametrize(("ratio", "error"), [(0.2, 2e-6), (0.3, 3e-5)])
def test_series_of_the_texts_are_as_good_as_said(ratio, error):
    largest = np.abs(torque_series(ratio).error).max()
    assert error / 3 <= largest <= error


def test_series_of_acceleration_err_by_the_next_power():
    # half of λ: 2⁹ less error, λ⁹ being the first power left out of A_2
    coarse, fine = (acceleration_series(ratio).error[2] for ratio in (0.1, 0.05))
    assert coarse / fine == pytest.approx(2**9, rel=0.02)


def test_two_harmonics_miss_a_quarter_of_the_cube():
    found = two_harmonics(0.1)
    assert found.textbook[2] == 0.1
    assert found.error[2] == pytest.approx(-(0.1**3) / 4, rel=0.01)
    assert found.error[4] == pytest.approx(0.1**3 / 4, rel=0.01)


def test_torque_of_two_harmonics_is_their_product():
    """−(sin φ + ½λ sin 2φ)(cos φ + λ cos 2φ) has no order above 4: 16 points are exact."""
    phi = np.arange(16) * (2 * np.pi / 16)
    found = two_harmonic_torque(0.25)
    product = -(np.sin(phi) + 0.125 * np.sin(2 * phi)) * (np.cos(phi) + 0.25 * np.cos(2 * phi))
    expected = [2 * np.mean(product * np.sin(k * phi)) for k in range(7)]
    np.testing.assert_allclose(found.textbook, expected, rtol=0, atol=1e-15)
    np.testing.assert_array_equal(found.error, found.textbook - torque_harmonics(0.25, 6))
