"""Work and powers against integrals that are known in closed form."""

import numpy as np
import pytest

from cranktrain.fluids.work import friction_power, friction_power_by_efficiency, indicated_power


def test_powers():
    """1 L, 10 bar, 3000 rpm: 25 kW in a four-stroke, 50 kW in a two-stroke; friction of 2 bar takes a fifth."""
    speed = 100 * np.pi
    assert indicated_power(1000.0, 4 * np.pi, speed) == pytest.approx(25e3)
    assert indicated_power(1000.0, 2 * np.pi, speed) == pytest.approx(50e3)
    assert friction_power(2e5, 1e-3, 4 * np.pi, speed) == pytest.approx(5e3)
    assert friction_power_by_efficiency(np.array([25e3, -20e3]), 0.8) == pytest.approx([5e3, 5e3])
