from math import asin, pi, sqrt, tan

import mpmath
import pytest

from cranktrain.synthesis.slider_crank_lengths import Lengths
from cranktrain.synthesis.toggle import (
    advantage,
    advantage_at_travel,
    advantage_near,
    toggle_advantage,
)

OFFSET = Lengths(0.1, 0.3, 0.05)
TOP, BOTTOM = asin(0.05 / 0.4), pi + asin(0.05 / 0.2)


def position(angle):
    return 0.1 * mpmath.cos(angle) + mpmath.sqrt(mpmath.mpf(0.3) ** 2 - (0.1 * mpmath.sin(angle) - 0.05) ** 2)


@pytest.mark.parametrize("angle", [0.3, 1.2, 2.9, 4.0, 5.5])
def test_advantage_by_virtual_work_in_40_digits(angle):
    with mpmath.workdps(40):
        expected = abs(0.1 / mpmath.diff(position, mpmath.mpf(angle)))
    assert advantage(OFFSET, angle) == pytest.approx(float(expected), rel=1e-13)


@pytest.mark.parametrize(("dead_centre", "at"), [("top", TOP), ("bottom", BOTTOM)])
def test_first_order_near_a_dead_centre(dead_centre, at):
    errors = [
        advantage(OFFSET, at - before) / advantage_near(OFFSET, before, dead_centre) - 1 for before in (1e-2, 1e-3)
    ]
    assert abs(errors[0]) < 2e-3
    assert errors[1] / errors[0] == pytest.approx(0.1, abs=0.01)
    travel = float(abs(position(at) - position(at - 1e-4)))
    assert advantage_at_travel(OFFSET, travel, dead_centre) == pytest.approx(advantage(OFFSET, at - 1e-4), rel=1e-4)


def test_central_press_at_its_lower_dead_centre():
    # |s″| = R(1 − R/L) = 0.08 m: 1 mm before the dead centre F/T = 0.1/√(2·0.08·0.001)
    central = Lengths(0.1, 0.5, 0.0)
    assert advantage_at_travel(central, 1e-3) == pytest.approx(0.1 / sqrt(1.6e-4), rel=1e-14)


def test_toggle_by_statics():
    # two links of 3:4:5 and 5:12:13, knee force 1 = F(tan α₁ + tan α₂)
    first, second = asin(3 / 5), asin(5 / 13)
    assert toggle_advantage(first, second) == pytest.approx(1 / (3 / 4 + 5 / 12), rel=1e-14)
    assert toggle_advantage(0.1, 0.1) == pytest.approx(1 / (2 * tan(0.1)), rel=1e-15)
