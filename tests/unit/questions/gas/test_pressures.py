"""Pressures of the gas, and how often they are found."""

import cranktrain as ct
from cranktrain.questions.gas.chambers import GasInChambers


def test_crest_and_steepest_rise_are_looked_for_in_one_look(monkeypatch):
    """Pressure and slope together: once on the grid, and once near the peaks of either."""
    shapes = []
    true = GasInChambers.pressure_and_slope

    def counted(self, angle, volume):
        shapes.append(volume.value.shape)
        return true(self, angle, volume)

    monkeypatch.setattr(GasInChambers, "pressure_and_slope", counted)
    ct.run(ct.load("3d12"), quantities=("peak_pressure", "steepest_pressure_rise")).find_all()
    on_grid, near = shapes
    assert on_grid == (1, 12, 720)
    assert near[-1] < on_grid[-1] / 4
