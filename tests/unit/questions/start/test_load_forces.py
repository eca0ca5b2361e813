"""Forces of loads over time, against the places of the ram by closed form."""

import numpy as np
from numpy.testing import assert_allclose

import cranktrain as ct

RADIUS, ROD = 0.065, 0.65


def test_a_press_presses_over_the_last_of_its_way():
    """Of `high_slip_press`: 600 kN from 125.05 mm below the upper dead centre on, downward alone."""
    found = ct.start("high_slip_press")
    assert found.dataset["force_of_load"]["load"].values.tolist() == ["pressing"]
    turned = found.crank_angle_turned
    sin, cos = np.sin(turned), np.cos(turned)
    root = np.sqrt(ROD**2 - (RADIUS * sin) ** 2)
    travel = RADIUS * cos + root - (ROD - RADIUS)
    is_downward = -RADIUS * sin - RADIUS**2 * sin * cos / root > 0
    pressed = np.interp(travel, [0.0, 0.125, 0.12505, 0.131], [0.0, 0.0, 6e5, 6e5])
    expected = np.where(is_downward, pressed, 0.0)
    assert np.max(expected) == 6e5 and np.min(expected) == 0.0
    assert_allclose(np.abs(found.force_of_load[0]), expected, rtol=0, atol=1e-6 * 6e5)
