"""Slider-crank kernel against 50 digits."""

from typing import NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray
from tests.exact import oracles
from tests.exact.agreement import assert_exact
from tests.exact.geometries import slider_cranks

from cranktrain.linkage import Crank, Slide, crank, slide
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, SliderCrankMotion, slider_crank


def behind(angle: NDArray[np.float64], geometry: SliderCrank) -> NamedTuple:
    """The same links with the slider on the other side of the shaft."""
    pin = crank(angle, Crank(geometry.crank_radius))
    return SliderCrankMotion(pin, *slide(pin, Slide(geometry.rod_length, geometry.offset, -1.0)))


@pytest.mark.parametrize(("kernel", "side", "n"), [(slider_crank, 1.0, 10_000), (behind, -1.0, 2_000)])
def test_slider_crank_is_exact(kernel, side, n):
    machines = slider_cranks(n, seed=1)
    angle = machines.tested_angles(np.random.default_rng(2))
    exact = oracles.coefficients(oracles.slider_crank, angle, *machines.geometry, side)
    assert_exact(kernel, machines.geometry, angle, exact, machines.margin)
