"""Articulated-rod kernel against 50 digits."""

import numpy as np
from tests.exact import oracles
from tests.exact.agreement import assert_exact
from tests.exact.geometries import articulated_rods

from cranktrain.mechanisms.articulated_rod.kinematics import articulated_rod


def test_articulated_rod_is_exact():
    machines = articulated_rods(10_000, seed=1)
    angle = machines.tested_angles(np.random.default_rng(2))
    exact = oracles.coefficients(oracles.articulated_rod, angle, *machines.geometry.master, *machines.geometry[1:])
    assert_exact(articulated_rod, machines.geometry, angle, exact, machines.margin)
