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
    ct.run(ct.load("3d12"), quantities="largest_joint_force").find_all()
    assert len(found) == 2


def test_gravity_pulls_along_each_axis_by_itself(found):
    machine = ct.load("3d12").with_({"gravity": {"acceleration": "9.81 m/s^2"}})
    loaded = ct.run(machine, quantities="largest_joint_force")[LoadedMachine]
    assert len(found) == 2
    one, other = (batch.gravity for batch in loaded.masses.batches)
    np.testing.assert_allclose(np.hypot(one.x, one.y), 9.81, rtol=1e-15)
    assert not np.allclose(one.y, other.y)


def test_what_slides_in_a_fixed_guide_needs_its_mass_alone():
    """It does not turn: whatever its inertia is, nothing hangs on it; and where it turns both are asked for."""
    table = {
        "kind": "chain",
        "output": "block",
        "fixed": {"C": ["100 mm", "0 mm"]},
        "crank": {"main": {"radius": "50 mm"}},
        "part": [
            {
                "type": "slide",
                "rod": {"name": "rod", "from": "main.pin", "length": "180 mm"},
                "slider": "crosshead",
                "guide": {"through": "O", "direction": "0 deg"},
            },
            {
                "type": "trammel",
                "link": "rod",
                "slider": "block",
                "guide": {"through": "C", "direction": "90 deg"},
            },
        ],
    }

    def of(part, **body):
        bodies = {part: {"mass": "5 kg", **body}}
        return ct.Machine(mechanism=table, shaft={"main": {"speed": "600 rpm"}}, masses=bodies)

    names = ("driving_torque", "joint_force_x", "joint_force_y", "joint_moment")
    alone, other = (ct.run(of("crosshead", **body)) for body in ({}, {"along": "0 mm", "inertia": "3 kg*m^2"}))
    assert np.max(np.abs(alone.driving_torque)) > 1.0
    for name in names:
        np.testing.assert_array_equal(getattr(alone, name), getattr(other, name))
    with pytest.raises(ct.InputError) as refused:
        ct.run(of("rod")).find_all()
    assert [problem.path for problem in refused.value.problems] == ["masses.rod.along", "masses.rod.inertia"]
