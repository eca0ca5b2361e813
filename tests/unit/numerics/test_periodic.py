"""Curves between the points of their grid."""

import numpy as np
import pytest
from scipy.interpolate import CubicHermiteSpline, CubicSpline

from cranktrain.numerics.periodic import (
    combined,
    curve_extremes,
    cycle_grid,
    fourier_curve,
    fourier_integral,
    hermite_curve,
    plus,
    spline_curve,
    spline_integral,
)

CYCLES = [2 * np.pi, 4 * np.pi]
AT = np.linspace(-5, 15, 41)


def smooth(phi, cycle):
    unit = 2 * np.pi / cycle
    return 2 + np.cos(3 * unit * phi) - 4 * np.sin(unit * phi)


def smooth_integral(phi, cycle):
    unit = 2 * np.pi / cycle
    return np.sin(3 * unit * phi) / (3 * unit) + 4 * (np.cos(unit * phi) - 1) / unit


@pytest.mark.parametrize("cycle", CYCLES)
@pytest.mark.parametrize("n_points", [24, 25])
def test_series_are_exact_for_a_smooth_curve(cycle, n_points):
    samples = smooth(cycle_grid(n_points, cycle), cycle)
    curve, integral = fourier_curve(samples, cycle), fourier_integral(samples, cycle)
    np.testing.assert_allclose(curve.value(AT), smooth(AT, cycle), atol=1e-13)
    np.testing.assert_allclose(integral.value(AT), smooth_integral(AT, cycle), atol=1e-13)
    np.testing.assert_allclose(integral.slope(AT), smooth(AT, cycle) - 2, atol=1e-13)
    assert integral.value(np.zeros(1))[0] == pytest.approx(0, abs=1e-14)
    np.testing.assert_allclose(integral.samples, smooth_integral(integral.angle, cycle), atol=1e-13)


@pytest.mark.parametrize("cycle", CYCLES)
@pytest.mark.parametrize("n_points", [3, 12, 13])
def test_spline_is_the_periodic_cubic_spline(cycle, n_points):
    samples = np.random.default_rng(0).normal(size=(2, n_points))
    nodes = np.append(cycle_grid(n_points, cycle), cycle)
    curve = spline_curve(samples, cycle)
    centred = samples - samples.mean(axis=-1, keepdims=True)
    integral = spline_integral(samples, cycle)
    for row in range(2):
        known = CubicSpline(nodes, np.append(samples[row], samples[row, 0]), bc_type="periodic")
        np.testing.assert_allclose(curve.value(AT)[row], known(AT % cycle), atol=1e-12)
        np.testing.assert_allclose(curve.slope(AT)[row], known(AT % cycle, 1), atol=1e-11)
        known = CubicSpline(nodes, np.append(centred[row], centred[row, 0]), bc_type="periodic").antiderivative()
        np.testing.assert_allclose(integral.value(AT)[row], known(AT % cycle), atol=1e-12)
        np.testing.assert_allclose(integral.slope(AT)[row], known(AT % cycle, 1), atol=1e-12)
        np.testing.assert_allclose(integral.samples[row], known(integral.angle), atol=1e-13)


def test_each_curve_at_its_own_angles():
    samples = np.random.default_rng(0).normal(size=(3, 11))
    angles = np.random.default_rng(1).uniform(-9, 9, size=(3, 4))
    for kind in (fourier_curve, fourier_integral, spline_curve, spline_integral):
        own = [kind(row).value(at) for row, at in zip(samples, angles, strict=True)]
        np.testing.assert_allclose(kind(samples).value(angles), own, atol=1e-13)


def test_sums_of_curves():
    phi = cycle_grid(16)
    one, other = fourier_curve(np.cos(phi)), fourier_curve(np.sin(phi))
    factors = np.array([0.5, -2.0])
    found = combined(one, factors, other)
    np.testing.assert_allclose(found.value(AT), np.cos(AT) + factors[:, np.newaxis] * np.sin(AT), atol=1e-13)
    np.testing.assert_allclose(found.samples, np.cos(phi) + factors[:, np.newaxis] * np.sin(phi), atol=1e-13)
    np.testing.assert_allclose(found.slope(AT), -np.sin(AT) + factors[:, np.newaxis] * np.cos(AT), atol=1e-13)
    raised = plus(one, factors)
    np.testing.assert_allclose(raised.value(AT), np.cos(AT) + factors[:, np.newaxis], atol=1e-13)
    np.testing.assert_allclose(raised.slope(AT), -np.sin(AT), atol=1e-13)


@pytest.mark.parametrize("cycle", CYCLES)
def test_extremes_lie_between_the_nodes(cycle):
    unit = 2 * np.pi / cycle
    samples = 3 * np.cos(unit * (cycle_grid(24, cycle) - 5.01))
    low, high = curve_extremes(fourier_curve(samples, cycle))
    assert (low.value[0], high.value[0]) == pytest.approx((-3, 3), abs=1e-14)
    assert high.angle[0] == pytest.approx(5.01, abs=1e-12)
    assert low.angle[0] % cycle == pytest.approx((5.01 + cycle / 2) % cycle, abs=1e-12)


def test_cubics_with_given_slopes():
    random = np.random.default_rng(5)
    samples, slopes = random.normal(size=(2, 3, 24))
    curve = hermite_curve(samples, slopes)
    nodes = np.append(curve.angle, 2 * np.pi)
    ends = [np.concatenate([part, part[:, :1]], axis=-1) for part in (samples, slopes)]
    other = CubicHermiteSpline(nodes, *ends, axis=-1)
    inside = np.mod(AT, 2 * np.pi)
    np.testing.assert_allclose(curve.value(AT), other(inside), atol=1e-12)
    np.testing.assert_allclose(curve.slope(AT), other(inside, 1), atol=1e-11)
