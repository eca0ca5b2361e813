"""Masses: found once for all mechanisms of which the file says the same."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.layout import masses
from cranktrain.questions.forces.loaded_machine import LoadedMachine

GRAVITY = {"direction": "0 deg"}


@pytest.fixture
def found(monkeypatch):
    """Names of the mechanisms whose masses are found."""
    names = []
    true = masses._place_masses

    def counted(place, given, crank):
        names.append(place.name)
        return true(place, given, crank)

    monkeypatch.setattr(masses, "_place_masses", counted)
    return names


def test_what_differs_in_its_phase_alone_has_the_same_masses(found):
    ct.run(ct.load("3d12"), quantities="largest_joint_force")
    assert len(found) == 2


def test_gravity_pulls_along_each_axis_by_itself(found):
    machine = ct.load("3d12").with_({"gravity": {"acceleration": "9.81 m/s^2"}})
    loaded = ct.run(machine, quantities="largest_joint_force")[LoadedMachine]
    assert len(found) == 2
    one, other = (batch.gravity for batch in loaded.masses.batches)
    np.testing.assert_allclose(np.hypot(one.x, one.y), 9.81, rtol=1e-15)
    assert not np.allclose(one.y, other.y)
