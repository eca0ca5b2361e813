"""Points on links, by complex numbers."""

import numpy as np
import pytest
from tests.machines import RADIUS, ROCKER, ROD, banks, slave, slider, throws

import cranktrain as ct

PHI = np.radians(np.arange(360))
POINTS = {
    "balance": {"link": "rod", "along": "60 mm", "across": "0 mm"},
    "wing": {"link": "rod", "along": "-20 mm", "across": "35 mm"},
}


def position(result, name):
    place = result.labels["point"].index(name)
    return result.point_x[place] + 1j * result.point_y[place]


def on_rod(alpha, along, across):
    beta = np.arcsin(RADIUS / ROD * np.sin(alpha))
    return RADIUS * np.exp(1j * alpha) + (along + 1j * across) * np.exp(-1j * beta)


def test_points_on_rods_of_an_engine():
    """Every cylinder's rod carries them, in that cylinder's axes."""
    bank = banks(L=-30, R=30)
    bank["R"]["mechanism"] = slider(points=POINTS)
    result = ct.run(ct.Machine(shaft=throws(0, 90), bank=bank))
    assert result.labels["point"] == ("1R.balance", "1R.wing", "2R.balance", "2R.wing")
    for name, shift in (("1R", -60), ("2R", 30)):
        alpha = PHI + np.radians(shift)
        np.testing.assert_allclose(position(result, f"{name}.balance"), on_rod(alpha, 0.06, 0), atol=1e-15)
        np.testing.assert_allclose(position(result, f"{name}.wing"), on_rod(alpha, -0.02, 0.035), atol=1e-15)


def test_points_on_a_slave_rod_lie_in_its_own_cylinders_axes():
    bank = {"L": {"mechanism": slider()}, "R": {"angle": "60 deg", "mechanism": slave("L", points=POINTS)}}
    result = ct.run(ct.Machine(bank=bank))
    beta = np.arcsin(RADIUS / ROD * np.sin(PHI))
    knuckle = RADIUS * np.exp(1j * PHI) + 0.045 * np.exp(1j * (np.radians(60) - beta))
    own = knuckle * np.exp(-1j * np.radians(60))
    direction = np.sqrt(0.135**2 - own.imag**2) / 0.135 - 1j * own.imag / 0.135
    np.testing.assert_allclose(position(result, "1R.wing"), own + (-0.02 + 0.035j) * direction, atol=1e-15)


def test_points_on_rod_and_rocker():
    points = {"c": POINTS["wing"], "r": {"link": "rocker", "along": "280 mm", "across": "0 mm"}}
    result = ct.run(ct.Machine(mechanism=ROCKER | {"points": points}))
    rod, rocker = np.exp(1j * result.coupler_angle[0]), np.exp(1j * result.rocker_angle[0])
    np.testing.assert_allclose(position(result, "1.c"), 0.1 * np.exp(1j * PHI) + (-0.02 + 0.035j) * rod, atol=1e-15)
    np.testing.assert_allclose(position(result, "1.r"), 0.4 + 0.28 * rocker, atol=1e-15)


def test_derivatives_are_those_of_the_path():
    result = ct.run(ct.Machine(mechanism=slider(points=POINTS, offset="10 mm")))
    order = 1j * np.fft.fftfreq(360, 1 / 360)
    for axis in "xy":
        value, first, second = (
            getattr(result, f"point_{axis}{part}")
            for part in ("", "_velocity_coefficient", "_acceleration_coefficient")
        )
        np.testing.assert_allclose(np.fft.ifft(order * np.fft.fft(value)).real, first, atol=1e-13)
        np.testing.assert_allclose(np.fft.ifft(order * np.fft.fft(first)).real, second, atol=1e-12)


def test_point_on_no_link():
    points = {"p": {"link": "rocker", "along": "1 mm", "across": "1 mm"}}
    with pytest.raises(ct.InputError, match=r"bank\.A\.mechanism\.points\.p\.link = rocker: must be a link of .*: rod"):
        ct.run(ct.Machine(shaft=throws(0, 180), bank={"A": {"mechanism": slider(points=points)}}))
