"""Pressures of the gas, and how often they are found."""

import pytest

import cranktrain as ct
from cranktrain.questions.gas.chambers import GasInChambers


@pytest.fixture
def shapes(monkeypatch):
    """Shapes of the volumes for which pressure and slope are asked, in turn."""
    asked = []
    true = GasInChambers.pressure_and_slope

    def counted(self, angle, volume):
        asked.append(volume.value.shape)
        return true(self, angle, volume)

    monkeypatch.setattr(GasInChambers, "pressure_and_slope", counted)
    return asked


def test_crest_and_steepest_rise_are_looked_for_in_one_look(shapes):
    """Pressure and slope together: once on the grid, and once near the peaks of either."""
    ct.run(ct.load("3d12"), quantities=("peak_pressure", "steepest_pressure_rise")).find_all()
    on_grid, near = shapes
    assert on_grid == (1, 12, 720)
    assert near[-1] < on_grid[-1] / 4


def test_crests_are_not_looked_for_where_forces_alone_are_asked(shapes):
    """Forces take the pressure at every crank angle, and no peak of it."""
    ct.run(ct.load("3d12"), quantities=("largest_torque", "largest_piston_force")).find_all()
    assert shapes == [(1, 12, 720)]
