"""Crank angles of ghosts: the dead centres that the result has, found there by stages of their own."""

import numpy as np
import pytest
from tests.machines import slider

import cranktrain as ct
from cranktrain.panels.dead_positions import dead_positions
from cranktrain.plans.placement import first_throw

CASES = {
    "3d12": ("top_dead_centre", "bottom_dead_centre"),
    "deltic": ("top_dead_centre", "bottom_dead_centre"),
    "eccentric_press": ("top_dead_centre", "bottom_dead_centre"),
    "jaw_crusher": ("largest_rocker_angle_at", "smallest_rocker_angle_at"),
}


@pytest.mark.parametrize("name", CASES)
def test_ghosts_stand_where_the_output_turns_back(name):
    run = ct.run(name, quantities=CASES[name])
    machine = run.machines[0]
    (place, *_others) = first_throw(machine)
    found = dead_positions(machine, place)
    expected = [getattr(run, quantity)[machine.places.index(place)] for quantity in CASES[name]]
    assert found.shape == (2,)
    np.testing.assert_allclose(np.cos(np.deg2rad(found - expected)), 1.0, atol=1e-14)


def test_an_offset_moves_the_dead_centres_of_a_slider_crank():
    """Crank and rod lie in line there: sin φ = e/(L ± R)."""
    machine = ct.Machine(mechanism=slider(offset="20 mm"))
    found = dead_positions(machine, machine.places[0])
    expected = [np.arcsin(20 / 230), np.pi + np.arcsin(20 / 130)]
    np.testing.assert_allclose(np.deg2rad(found), expected, atol=1e-9)


def test_links_that_do_not_close_all_round_have_six_even_positions():
    machine = ct.Machine(mechanism=slider(rod_length="45 mm"))
    assert dead_positions(machine, machine.places[0]).tolist() == [0.0, 60.0, 120.0, 180.0, 240.0, 300.0]
