"""Work and powers against integrals that are known in closed form."""

import numpy as np
import pytest

from cranktrain.fluids.work import (
    friction_power,
    friction_power_by_efficiency,
    indicated_power,
    indicated_work,
    split_mean_pressures,
)

ANGLE = np.arange(720) * (4 * np.pi / 720)


def test_work_is_exact_for_a_trigonometric_sum():
    """∮ (3 + 2 sin φ + cos φ/2) sin φ dφ over 4π is 4π, designs on a leading axis."""
    pressure = np.array([[1.0], [2.0]]) * (3 + 2 * np.sin(ANGLE) + np.cos(ANGLE / 2))
    assert indicated_work(pressure, np.sin(ANGLE), 4 * np.pi) == pytest.approx([4 * np.pi, 8 * np.pi], rel=1e-14)


def test_turns_add_up_to_the_whole():
    """Constant pressures: 5 and 3 in the strokes of the working turn, 2 and 1 in those of the exchange."""
    # The middle of each step, so that no dead centre is on the grid.
    middle = ANGLE + ANGLE[1] / 2
    sense = np.where(np.sin(middle) > 0, 1.0, -1.0)
    turn = np.where(np.cos(middle / 2) > 0, 1.0, -1.0)
    pressure = np.where(turn > 0, np.where(sense > 0, 5.0, 3.0), np.where(sense > 0, 1.0, 2.0))
    found = split_mean_pressures(pressure, np.sin(middle), turn, 4 * np.pi, 2.0)
    # The midpoint sum of sin over a stroke of 180 steps is 2 (π/360)/sin(π/360), not 2.
    excess = (np.pi / 360) / np.sin(np.pi / 360)
    assert list(found) == pytest.approx([2.0 * excess, -1.0 * excess, 1.0 * excess], rel=1e-13)


def test_powers():
    """1 L, 10 bar, 3000 rpm: 25 kW in a four-stroke, 50 kW in a two-stroke; friction of 2 bar takes a fifth."""
    speed = 100 * np.pi
    assert indicated_power(1000.0, 4 * np.pi, speed) == pytest.approx(25e3)
    assert indicated_power(1000.0, 2 * np.pi, speed) == pytest.approx(50e3)
    assert friction_power(2e5, 1e-3, 4 * np.pi, speed) == pytest.approx(5e3)
    assert friction_power_by_efficiency(np.array([25e3, -20e3]), 0.8) == pytest.approx([5e3, 5e3])
