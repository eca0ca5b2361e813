"""Rockers: dead positions where crank and rod lie in line, by the cosine rule; double cranks."""

import numpy as np
import pytest
from tests.machines import ROCKER, throws
from tests.told import lines_of

import cranktrain as ct

R, L, C, G = 0.1, 0.36, 0.28, 0.4
"""Of the reference rocker. [m]"""


def run(**changes):
    return ct.run(ct.Machine(mechanism=ROCKER | changes, shaft=throws(0, speed="60 rpm")))


def dead_position(reach):
    """Rocker angle and direction of crank and rod in line, by the triangle of reach, rocker and ground."""
    rocker = np.pi - np.arccos((G**2 + C**2 - reach**2) / (2 * G * C))
    direction = np.arccos((G**2 + reach**2 - C**2) / (2 * G * reach))
    return rocker, direction


@pytest.mark.parametrize("side", ["left", "right"])
def test_dead_positions(side):
    """Stretched, the rocker is farthest from the shaft; folded, nearest, the crank pointing away from the rod."""
    result = run(side=side)
    far, toward = dead_position(L + R)
    near, away = dead_position(L - R)
    assert result.swing[0] == pytest.approx(near - far, rel=1e-13)
    # Left of the line from crank pin to pivot is above the ground line; right is its mirror image.
    sign = 1 if side == "left" else -1
    smallest, largest = sorted((sign * far, sign * near))
    assert result.smallest_rocker_angle[0] == pytest.approx(smallest, rel=1e-13)
    assert result.largest_rocker_angle[0] == pytest.approx(largest, rel=1e-13)
    stretched, folded = np.degrees(sign * toward) % 360, np.degrees(sign * away + np.pi) % 360
    at = (result.smallest_rocker_angle_at[0], result.largest_rocker_angle_at[0])
    assert at == pytest.approx((stretched, folded) if side == "left" else (folded, stretched), rel=1e-12)
    slower = max((folded - stretched) % 360, (stretched - folded) % 360)
    assert result.time_ratio[0] == pytest.approx(slower / (360 - slower), rel=1e-12)


def test_angles_close_the_linkage():
    result = run()
    phi = np.radians(result.crank_angle)
    joint = R * np.exp(1j * phi) + L * np.exp(1j * result.coupler_angle[0])
    np.testing.assert_allclose(joint, G + C * np.exp(1j * result.rocker_angle[0]), atol=1e-15)
    np.testing.assert_allclose(np.diff(result.rocker_angle[0]), 0, atol=0.02)


def test_double_crank_turns():
    """A drag link: the rocker goes round with the crank, its angle has no jump, and it has no dead position."""
    result = run(crank_radius="280 mm", ground_length="100 mm", rod_length="330 mm", rocker_length="320 mm")
    angle = result.rocker_angle[0]
    assert angle[-1] - angle[0] == pytest.approx(2 * np.pi * 359 / 360, abs=0.03)
    assert np.all(np.diff(angle) > 0)
    assert np.isnan([result.swing[0], result.time_ratio[0], result.largest_rocker_angle_at[0]]).all()
    assert result.grashof_class[0] == 1
    said = lines_of(result, "Motion")
    assert said[0] == "rocker: turns all round"
    assert "linkage: double crank: crank and rocker both turn" in said
    assert not any(line.startswith(("swing", "dead positions", "time ratio")) for line in said)


def test_speeds():
    result = run()
    omega = 2 * np.pi
    np.testing.assert_allclose(result.rocker_angular_velocity, result.rocker_velocity_coefficient * omega)
    np.testing.assert_allclose(result.coupler_angular_acceleration, result.coupler_acceleration_coefficient * omega**2)


def test_checks_hold():
    result = run()
    assert [(check.name, str(check.verdict())) for check in result.checks] == [
        ("rocker_derivatives", "holds"),
        ("transmission_angle", "holds"),
    ]
