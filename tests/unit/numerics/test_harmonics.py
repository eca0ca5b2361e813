"""Harmonics of curves on a grid: against sums whose harmonics are chosen."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from cranktrain.numerics.harmonics import curve, delayed, from_vectors, harmonics

FEW = settings(max_examples=40, deadline=None, derandomize=True)

CYCLES = [2 * np.pi, 4 * np.pi]


def grid(n_points, cycle):
    return np.arange(n_points) * cycle / n_points


@pytest.mark.parametrize("cycle", CYCLES)
def test_orders_amplitudes_and_phases_of_a_chosen_sum(cycle):
    unit = 2 * np.pi / cycle
    phi = grid(64, cycle)
    samples = -3 + 2 * np.cos(unit * phi - 0.4) + 0.5 * np.cos(7 * unit * phi + 2.0)
    found = harmonics(samples, cycle)
    np.testing.assert_allclose(found.order, unit * np.arange(33), rtol=1e-15)
    assert found.mean == pytest.approx(-3, abs=1e-14)
    np.testing.assert_allclose(found.amplitude[[0, 1, 7]], [3, 2, 0.5], atol=1e-14)
    np.testing.assert_allclose(found.phase[[1, 7]], [0.4, -2.0], atol=1e-13)
    assert np.delete(found.amplitude, [0, 1, 7]).max() < 1e-14
    # the phase is where the first peak stands
    assert np.argmax(np.cos(unit * phi - 0.4)) == pytest.approx(found.phase[1] / unit / phi[1], abs=0.5)


@pytest.mark.parametrize("n_points", [8, 9])
def test_the_highest_order_of_an_even_grid_counts_once(n_points):
    highest = n_points // 2
    found = harmonics(np.cos(highest * grid(n_points, 2 * np.pi)))
    assert found.amplitude[highest] == pytest.approx(1.0, abs=1e-14)


def test_a_grid_with_its_first_point_twice_is_off():
    # why the endpoint is left out: 361 points put 0.3 % into the mean of 1 + cos
    phi = np.linspace(0, 2 * np.pi, 361)
    assert harmonics(1 + np.cos(phi)).mean - 1 == pytest.approx(1 / 361, rel=1e-9)


samples_of = st.lists(st.floats(-5, 5), min_size=3, max_size=40).map(np.array)


@FEW
@given(samples_of, st.sampled_from(CYCLES))
def test_the_sum_returns_the_samples(samples, cycle):
    found = curve(harmonics(samples, cycle), grid(len(samples), cycle))
    np.testing.assert_allclose(found, samples, rtol=0, atol=1e-12)


@FEW
@given(samples_of)
def test_parseval(samples):
    found = harmonics(samples)
    power = found.amplitude**2 / 2
    power[0] = found.mean**2
    if len(samples) % 2 == 0:
        power[-1] = found.amplitude[-1] ** 2  # cosine seen at its peaks only
    assert np.sum(power) == pytest.approx(np.mean(samples**2), rel=1e-12, abs=1e-12)


@FEW
@given(st.floats(-10, 10), st.sampled_from(CYCLES))
def test_a_delayed_curve_is_the_curve_moved_to_the_right(angle, cycle):
    rng = np.random.default_rng(3)
    samples = rng.normal(size=(2, 15))
    found = harmonics(samples, cycle)
    phi = np.linspace(-3, 9, 7)
    np.testing.assert_allclose(curve(delayed(found, angle), phi), curve(found, phi - angle), atol=1e-12)


def test_mirror_turns_the_sines():
    samples = np.random.default_rng(1).normal(size=12)
    there, back = harmonics(samples), harmonics(samples[-np.arange(12)])
    np.testing.assert_allclose(back.cosine, there.cosine, atol=1e-15)
    np.testing.assert_allclose(back.sine, -there.sine, atol=1e-15)


def test_curves_each_at_their_own_angles():
    found = harmonics(np.random.default_rng(1).normal(size=(3, 12)))
    angles = np.random.default_rng(2).normal(size=(3, 5))
    rows = [curve(from_vectors(found.order, found.vectors[i]), angles[i]) for i in range(3)]
    np.testing.assert_allclose(curve(found, angles), rows, atol=1e-14)
