"""Articulated-rod kernel against 50 digits."""

import numpy as np
from tests.exact import oracles
from tests.exact.agreement import assert_exact
from tests.exact.geometries import articulated_rods

from cranktrain.mechanisms.articulated_rod.kinematics import articulated_rod, articulated_rod_gap


def test_articulated_rod_is_exact():
    machines = articulated_rods(10_000, seed=1)
    angle = machines.tested_angles(np.random.default_rng(2))
    exact = oracles.coefficients(oracles.articulated_rod, angle, *machines.geometry.master, *machines.geometry[1:])
    assert_exact(articulated_rod, machines.geometry, angle, exact, machines.margin)


def test_gap_is_that_of_the_knuckle_that_moves():
    machines = articulated_rods(2_000, seed=3)
    angle, geometry = machines.tested_angles(np.random.default_rng(4)), machines.geometry
    motion = articulated_rod(angle, geometry)
    master = geometry.master.rod_length - np.abs(motion.pin.y.value - geometry.master.offset)
    slave = geometry.rod_length - np.abs(motion.knuckle.y.value - geometry.offset)
    np.testing.assert_allclose(articulated_rod_gap(angle, geometry), np.fmin(master, slave), rtol=0, atol=1e-15)
