"""A load that is next to nothing beside the inertia is told in a line of the answer, and is no warning."""

import numpy as np
import pytest
from tests.told import lines_of, texts_of

import cranktrain as ct

SPEED, RADIUS, MASS = 40.0, 0.05, 3.0
INERTIA = MASS * RADIUS**2 * SPEED**2 / 2
"""Largest torque of a yoke's inertia, m r² ω² sin φ cos φ. [N·m]"""


def said(torque, on="main", **tables):
    machine = ct.Machine(
        mechanism={"kind": "scotch_yoke", "crank_radius": f"{RADIUS} m"},
        shaft={"main": {"speed": f"{SPEED} rad/s"}},
        masses={"piston": {"mass": f"{MASS} kg"}},
        load={"work": {"on": on, **({"torque": f"{torque} N*m"} if on == "main" else {"force": f"{torque} N"})}},
        **tables,
    )
    result = ct.run(machine)
    assert not any("inertia" in flag for flag in texts_of(result.flags))
    (rows,) = (rows for title, rows in result.rows() if str(title) == "Loads")
    row = {str(row.name): row for row in rows}.get("beside inertia")
    return None if row is None else row.words.pieces["part"]


@pytest.mark.parametrize("part", [1e-5, 0.005, 0.0099])
def test_a_load_of_next_to_nothing_is_told(part):
    found = said(part * INERTIA)
    assert found.value == pytest.approx(part, rel=1e-9)
    assert found.unit == "%"


def test_a_force_by_its_torque_on_the_crank():
    """F r sin φ at most, beside that of the inertia."""
    found = said(0.002 * INERTIA / RADIUS, on="piston")
    assert found.value == pytest.approx(0.002, rel=1e-4)  # its largest lies between points of the grid


@pytest.mark.parametrize("part", [0.0101, 0.5, 100.0])
def test_others_are_not(part):
    assert said(part * INERTIA) is None


def test_without_masses_nothing_is_said():
    result = ct.run(
        ct.Machine(
            mechanism={"kind": "scotch_yoke", "crank_radius": "50 mm"},
            shaft={"main": {"speed": "40 rad/s"}},
            load={"work": {"on": "piston", "force": "1 N"}},
        )
    )
    torques = next(one for one in result.outcomes if hasattr(one, "reduced_inertia_slope"))
    assert np.max(np.abs(torques.reduced_inertia_slope)) == 0
    names = [line.partition(":")[0] for line in lines_of(result, "Loads")]
    assert "work in a cycle" in names and "beside inertia" not in names
