"""Largest forces and torques, looked for together: how often, and at how many crank angles, a machine is solved."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.questions.forces.loaded_machine import LoadedMachine

FACTS = ("largest_joint_force", "largest_rod_force", "largest_torque")
_GRID, _NODES = 720, 9


@pytest.fixture
def solved(monkeypatch):
    """Shapes of the crank angles at which the machine is solved."""
    shapes = []
    true = LoadedMachine.solved

    def counted(self, angle, **known):
        shapes.append(angle.shape)
        return true(self, angle, **known)

    monkeypatch.setattr(LoadedMachine, "solved", counted)
    return shapes


@pytest.mark.parametrize("asked", [FACTS, *((fact,) for fact in FACTS)])
def test_a_machine_is_solved_on_its_grid_and_once_near_its_peaks(solved, asked):
    ct.run(ct.load("3d12"), quantities=asked).find_all()
    assert [shape[-1] == _GRID for shape in solved] == [True, False]


def test_curves_that_are_largest_near_to_each_other_share_a_window(solved):
    """Seven curves of joints and seven of pistons on each rod's throw, of up to three pieces each: eleven windows."""
    ct.run(ct.load("3d12"), quantities=FACTS[:2]).find_all()
    assert solved[-1] == (1, 12, 11 * _NODES)


def test_what_is_not_asked_is_not_looked_for(solved):
    ct.run(ct.load("3d12"), quantities=FACTS[2]).find_all()
    assert solved[-1] == (1, 12, 10 * _NODES)


@pytest.mark.parametrize("machine", ["3d12", "vaz_21213", "deltic"])
def test_a_fact_does_not_hang_on_what_else_is_asked(machine):
    together = ct.run(ct.load(machine), quantities=FACTS)
    for fact in FACTS:
        alone = ct.run(ct.load(machine), quantities=fact)
        for name in (fact, f"{fact}_at"):
            np.testing.assert_allclose(getattr(alone, name), getattr(together, name), rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("fact", FACTS)
def test_what_never_closes_has_no_largest_force(fact):
    mechanism = {"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "30 mm", "offset": "100 mm"}
    machine = ct.Machine(
        mechanism=mechanism, shaft={"main": {"speed": "3000 rpm"}}, masses={"piston": {"mass": "1 kg"}}
    )
    assert np.all(np.isnan(getattr(ct.run(machine, partial=True, quantities=fact), fact)))


def test_the_largest_force_as_a_punch_breaks_through_is_what_its_curve_comes_to():
    """Where the work's force falls off no polynomial through a window shows it; a cubic just beyond does."""
    press = ct.run(ct.load("high_slip_press"), step_degrees=0.01)
    load = np.hypot(press.crankpin_load_radial, press.crankpin_load_tangential)[0]
    at = float(press.largest_crankpin_load_at[0])
    beyond = np.arange(4) + int(np.ceil(100 * at))
    cubic = np.polynomial.Polynomial.fit(beyond / 100 - at, load[beyond], 3)
    assert press.largest_crankpin_load[0] == pytest.approx(cubic(0.0), rel=1e-9)
