"""Loads of crank pins in the crank's axes and in the rod's: statics of a rod that is two masses."""

import numpy as np
import pytest
from tests.sentences import WITHOUT_ROD

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.plans.pin_loads import pin_loads

ROD = {"mass": "0.6 kg", "along": "40 mm"}
TWO_MASSES = {
    "shaft": {"main": {"speed": "3000 rpm"}},
    "mechanism": {"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "140 mm"},
    "masses": {"piston": {"mass": "0.4 kg"}, "rod": ROD},
}
"""A rod without an inertia of its own is two masses at its ends."""


@pytest.mark.parametrize("running", ["ahead", "astern"])
@pytest.mark.parametrize("rotation", ["clockwise", "anticlockwise"])
def test_without_its_rotating_mass_a_rod_of_two_masses_is_loaded_along_itself(rotation, running):
    machine = ct.Machine(**TWO_MASSES, rotation=rotation, running=running)
    loads = pin_loads(machine)
    result = ct.run(machine)
    peak = loads.largest
    assert loads.in_rod_without[0] == pytest.approx(np.zeros(360), abs=1e-12 * peak)
    assert loads.in_rod_without[1] == pytest.approx(result.rod_force_at_crank_pin[1, 0], abs=1e-12 * peak)
    assert np.hypot(*loads.in_rod) == pytest.approx(np.hypot(*loads.on_pin))


def test_at_a_speed_that_varies_the_rotating_mass_is_dragged_round_too():
    """Without it a rod of two masses is loaded along itself at any speed, and with it by m R ε across the crank."""
    phi = np.deg2rad(np.arange(360.0))
    loads = pin_loads(ct.Machine(**TWO_MASSES), speed=100.0 * np.pi * (1.0 + 0.05 * np.cos(phi)))
    assert loads.in_rod_without[0] == pytest.approx(np.zeros(360), abs=1e-12 * loads.largest)
    assert np.max(np.abs(loads.on_pin[0] - loads.on_pin_without[0])) > 1e-3 * loads.largest


def test_rotating_mass_pulls_away_from_the_shaft():
    """m R ω² of 0.6 · 100/140 kg at the crank pin."""
    loads = pin_loads(ct.Machine(**TWO_MASSES))
    pull = 0.6 * 100.0 / 140.0 * 0.040 * (100.0 * np.pi) ** 2
    assert loads.on_pin[1] - loads.on_pin_without[1] == pytest.approx(np.full(360, pull))
    assert loads.on_pin[0] == pytest.approx(loads.on_pin_without[0])


def test_mean_and_largest():
    loads = pin_loads(ct.load("vaz_21213"))
    size = np.hypot(*loads.on_pin)
    assert loads.cycle == 720.0
    assert loads.mean == pytest.approx(size.sum() / 720)
    fine = ct.run(ct.load("vaz_21213"), step_degrees=0.02)
    finer = np.hypot(fine.crankpin_load_radial[0], fine.crankpin_load_tangential[0])
    assert size.max() < loads.largest == pytest.approx(finer.max(), rel=1e-6)
    assert loads.largest_at == pytest.approx(fine.crank_angle[np.argmax(finer)], abs=0.02)


def test_what_has_no_rod_on_a_crank_pin():
    with pytest.raises(InputError, match=f"1R: {WITHOUT_ROD}"):
        pin_loads(ct.load("3d12"), mechanism="1R")
