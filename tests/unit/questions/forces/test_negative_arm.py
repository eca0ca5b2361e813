"""A force on an arm less than 0 acts on the far side of the first pin: the same torque, another load of the pivot."""

import numpy as np
import pytest

import cranktrain as ct


def test_the_pivot_tells_on_which_side_it_acts():
    """Q behind the pivot, and Q the other way at the rocker's end, turn it alike; on the pivot they differ by 2 Q."""
    behind = ct.run("tilting_table")
    at_end = ct.run("tilting_table", set={"load.table.radius": "500 mm", "load.table.force": "-4000 N"})
    np.testing.assert_allclose(behind.static_torque, at_end.static_torque, rtol=1e-12)
    forces = [np.array([one.joint_force_x, one.joint_force_y]) for one in (behind, at_end)]
    apart = dict(zip(behind.labels["joint"], np.hypot(*(forces[0] - forces[1])), strict=True))
    assert apart.pop("1.pivot") == pytest.approx(8000.0, rel=1e-9)
    assert max(map(np.max, apart.values())) < 1e-6
