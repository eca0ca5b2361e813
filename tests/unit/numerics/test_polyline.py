"""A periodic curve of straight lines: against NumPy's interpolation, and its integral against quadrature."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad

from cranktrain.numerics.polyline import Polyline, polyline_integral, polyline_mean, polyline_value

ANGLES = np.array([-0.7, 0.4, 1.1, 1.15, 3.0])
VALUES = np.array([2.0, -1.0, 5.0, 7.0, 0.5])
CURVE = Polyline(ANGLES, VALUES, 2 * np.pi)


def interpolated(angle):
    return np.interp(angle, ANGLES, VALUES, period=2 * np.pi)


def test_value_at_any_angle():
    angle = np.linspace(-20, 20, 777).reshape(7, 111)
    np.testing.assert_allclose(polyline_value(CURVE, angle), interpolated(angle), rtol=0, atol=1e-13)
    np.testing.assert_array_equal(polyline_value(CURVE, ANGLES), VALUES)
    assert np.isnan(polyline_value(CURVE, np.array(np.nan)))


@pytest.mark.parametrize("cycle", [2 * np.pi, 4 * np.pi])
def test_integral(cycle):
    mean = quad(interpolated, 0, 2 * np.pi, points=np.mod(ANGLES, 2 * np.pi))[0] / (2 * np.pi)
    assert polyline_mean(CURVE) == pytest.approx(mean, rel=1e-12)
    corners = np.concatenate([ANGLES + 2 * np.pi * turn for turn in range(3)])
    work = polyline_integral(CURVE, 48, cycle)
    assert work.cycle == cycle
    assert work.samples[0] == 0
    for angle, value in zip(work.angle, work.samples, strict=True):
        breaks = [0.0, *sorted(corner for corner in corners if 0 < corner < angle), angle]
        whole = sum(quad(interpolated, low, high)[0] for low, high in pairwise(breaks))
        assert value == pytest.approx(whole - mean * angle, abs=1e-12)
    found = work.motion(np.array([0.2, 5.0]))
    np.testing.assert_allclose(found.first, interpolated(np.array([0.2, 5.0])) - mean, rtol=1e-13)
    np.testing.assert_allclose(found.second[0], -3.0 / 1.1, rtol=1e-13)
