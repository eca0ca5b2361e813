"""Loads of rockers: their travel follows the rocker at its radius, counted either way; torque factors."""

import numpy as np
import pytest
from tests.machines import ROCKER
from tests.told import texts_of

import cranktrain as ct

LOADED = ROCKER | {"load_radius": "500 mm"}


def run(**changes):
    return ct.run(ct.Machine(mechanism=LOADED | changes))


def test_travel():
    result = run()
    assert result.load_stroke[0] == pytest.approx(0.5 * result.swing[0], rel=1e-14)
    expected = 0.5 * (result.rocker_angle[0] - result.smallest_rocker_angle[0])
    np.testing.assert_allclose(result.load_displacement[0], expected, atol=1e-15)
    np.testing.assert_allclose(result.load_velocity_coefficient, 0.5 * result.rocker_velocity_coefficient)


def test_travel_against_the_rockers_angle():
    """The same travel backwards: it begins where the other one ends."""
    with_, against = run(), run(load_direction="against")
    np.testing.assert_allclose(against.load_displacement, with_.load_stroke - with_.load_displacement, atol=1e-15)
    np.testing.assert_allclose(against.load_acceleration_coefficient, -with_.load_acceleration_coefficient)
    assert against.load_stroke[0] == with_.load_stroke[0]
    assert against.largest_torque_factor[0] == -with_.smallest_torque_factor[0]
    assert against.smallest_torque_factor[0] == -with_.largest_torque_factor[0]


@pytest.mark.parametrize("direction", ["with", "against"])
def test_astern_the_load_still_travels_the_same_way(direction):
    """It is the same metal: where the load stands does not depend on which way the crank gets there."""
    machine = {"mechanism": LOADED | {"load_direction": direction}}
    ahead, astern = ct.run(ct.Machine(**machine)), ct.run(ct.Machine(running="astern", **machine))
    backwards = np.roll(ahead.load_displacement[..., ::-1], 1, axis=-1)
    np.testing.assert_allclose(astern.load_displacement, backwards, atol=1e-14)
    assert astern.largest_torque_factor[0] == pytest.approx(-ahead.smallest_torque_factor[0])


def test_torque_factors_are_the_extremes_of_the_curve():
    result = ct.run(ct.Machine(mechanism=LOADED), step_degrees=0.05)
    assert result.largest_torque_factor[0] == pytest.approx(np.max(result.load_velocity_coefficient), rel=1e-6)
    assert result.smallest_torque_factor[0] == pytest.approx(np.min(result.load_velocity_coefficient), rel=1e-6)
    assert result.largest_torque_factor[0] >= np.max(result.load_velocity_coefficient)


def test_load_of_one_rocker_of_two():
    bank = {"A": {"mechanism": LOADED}, "B": {"angle": "90 deg", "mechanism": ROCKER}}
    result = ct.run(ct.Machine(bank=bank))
    np.testing.assert_allclose(result.load_stroke, [0.5 * result.swing[0], np.nan])


def test_without_a_load_radius_it_is_missing():
    result = ct.run(ct.Machine(mechanism=ROCKER))
    assert [texts_of(missing.needs) for missing in result.missing if "load_stroke" in missing.results] == [
        ("[mechanism] load_radius",)
    ]
