"""Swivel kernel against 50 digits: on a fixed pivot, and with pin and pivot both moving."""

from typing import NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray
from tests.exact import oracles
from tests.exact.agreement import assert_exact
from tests.exact.geometries import SwivelCrank, swivel_cranks

from cranktrain.linkage import Crank, Ends, Swivel, crank, fixed, swivel
from cranktrain.motion import Coefficient, Point

Array = NDArray[np.float64]


def swivel_crank(angle: Array, geometry: SwivelCrank) -> NamedTuple:
    pin = crank(angle, Crank(geometry.crank_radius))
    pivot = fixed(geometry.ground_length, 0.0 * geometry.ground_length)
    return swivel(Ends(pin, pivot), Swivel(geometry.offset, geometry.side))


def geared(angle: Array, radius: Array, ratio: float) -> Point:
    """Crank pin that turns `ratio` times as fast."""
    x, y = crank(ratio * angle, Crank(radius))
    return Point(*(Coefficient(c.value, ratio * c.first, ratio * ratio * c.second) for c in (x, y)))


def turning(angle: Array, geometry: SwivelCrank) -> NamedTuple:
    """The same machine on a frame that turns about the shaft with the crank angle."""
    ends = Ends(geared(angle, geometry.crank_radius, 2.0), geared(angle, geometry.ground_length, 1.0))
    return swivel(ends, Swivel(geometry.offset, geometry.side))


@pytest.mark.parametrize(
    ("kernel", "frame_turns", "n", "shortest"),
    [
        (swivel_crank, 0.0, 10_000, 0.02),
        # Accelerations of the ends four times as large, of the slider the same: so much less may be left over.
        (turning, 1.0, 2_000, 0.2),
    ],
)
def test_swivel_is_exact(kernel, frame_turns, n, shortest):
    machines = swivel_cranks(n, seed=1, shortest=shortest)
    angle = machines.tested_angles(np.random.default_rng(2))
    exact = oracles.coefficients(oracles.swivel_crank, angle, *machines.geometry, frame_turns)
    assert_exact(kernel, machines.geometry, angle, exact, machines.margin)
