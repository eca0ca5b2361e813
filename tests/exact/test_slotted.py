"""Kernels of scotch yoke, oscillating cylinder and slotted lever against 50 digits."""

import numpy as np
import pytest
from tests.exact import oracles
from tests.exact.agreement import assert_exact
from tests.exact.geometries import swivel_cranks

from cranktrain.linkage import CrankAndPivot
from cranktrain.mechanisms.oscillating_cylinder.kinematics import oscillating_cylinder
from cranktrain.mechanisms.scotch_yoke.kinematics import ScotchYoke, scotch_yoke
from cranktrain.mechanisms.slotted_lever.kinematics import slotted_lever


def test_scotch_yoke_is_exact():
    n = 2_000
    random = np.random.default_rng(1)
    crank_radius = np.exp(random.uniform(np.log(1e-3), np.log(2.0), size=(n, 1)))
    geometry = ScotchYoke(
        crank_radius, crank_radius * random.uniform(-3.0, 3.0, size=(n, 1)), random.uniform(-np.pi, np.pi, size=(n, 1))
    )
    angle = random.uniform(-2 * np.pi, 4 * np.pi, size=(n, 4))
    exact = oracles.coefficients(oracles.yoke_crank, angle, *geometry)
    assert_exact(scotch_yoke, geometry, angle, exact, np.ones((n, 1)))


@pytest.mark.parametrize(
    ("kernel", "geometry", "oracle"),
    [
        (oscillating_cylinder, CrankAndPivot, oracles.oscillating_cylinder),
        (slotted_lever, CrankAndPivot, oracles.crank_driven_lever),
    ],
)
def test_cylinder_and_lever_are_exact(kernel, geometry, oracle):
    machines = swivel_cranks(2_000, seed=1)
    angle = machines.tested_angles(np.random.default_rng(2))
    lengths = geometry(*machines.geometry[:3], np.ones_like(machines.margin))
    exact = oracles.coefficients(oracle, angle, *lengths[:3])
    assert_exact(kernel, lengths, angle, exact, machines.margin)
