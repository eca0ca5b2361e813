"""Yoke kernel against 50 digits."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from tests.exact import oracles
from tests.exact.agreement import assert_exact

from cranktrain.linkage import Crank, Yoke, crank, yoke

Array = NDArray[np.float64]


class YokeCrank(NamedTuple):
    crank_radius: Array
    yoke: Yoke


def yoke_crank(angle: Array, geometry: YokeCrank) -> NamedTuple:
    return yoke(crank(angle, Crank(geometry.crank_radius)), geometry.yoke)


def test_yoke_is_exact():
    n = 10_000
    random = np.random.default_rng(1)
    crank_radius = np.exp(random.uniform(np.log(1e-3), np.log(2.0), size=(n, 1)))
    offset = crank_radius * random.uniform(-3.0, 3.0, size=(n, 1))
    slot_angle = random.uniform(-np.pi, np.pi, size=(n, 1))
    angle = random.uniform(-2 * np.pi, 4 * np.pi, size=(n, 4))
    exact = oracles.coefficients(oracles.yoke_crank, angle, crank_radius, offset, slot_angle)
    # It closes whatever the lengths are.
    margin = np.ones((n, 1))
    assert_exact(yoke_crank, YokeCrank(crank_radius, Yoke(offset, slot_angle)), angle, exact, margin)
