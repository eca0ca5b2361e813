"""Vectors on the drawing: velocities and forces of a slider-crank by closed forms, of every example by its pins."""

from functools import cache

import numpy as np
import pytest
from tests.machines import RADIUS, ROD, slider

import cranktrain as ct
from cranktrain.io.examples import example_names
from cranktrain.panels.sheets.forces.vectors import forces
from cranktrain.panels.sheets.motion.vectors import velocities
from cranktrain.panels.vectors import vectors_as_shown
from cranktrain.plans.placement import first_throw

OMEGA = 2 * np.pi * 10
"""Of 600 rpm. [rad/s]"""
TURN = np.arange(0.0, 360.0, 5.0)
STEP = 1e-3
"""Of central differences. [deg]"""


@cache
def result(name):
    return ct.run(name)


def found(make, run, angles):
    """Vectors by mechanism, pin and symbol."""
    sorts = make(run, first_throw(run.machines[0]), angles)
    return {(one.mechanism, one.pin, one.symbol): one.value for sort in sorts for one in sort.vectors}


def slope(phi):
    """Angle of the rod from the line of stroke."""
    return np.arcsin(RADIUS / ROD * np.sin(phi))


def test_velocities_of_a_slider_crank():
    """It turns clockwise from the line of stroke, which is Y: the pin goes to the right at first."""
    run = ct.run(ct.Machine(mechanism=slider(), shaft={"main": {"speed": "600 rpm"}}))
    vectors, phi = found(velocities, run, TURN), np.deg2rad(TURN)
    assert set(vectors) == {("1", "A", "v_{A}"), ("1", "B", "v_{B}")}
    around = RADIUS * OMEGA * np.stack([np.cos(phi), -np.sin(phi)])
    np.testing.assert_allclose(vectors["1", "A", "v_{A}"], around, atol=1e-12)
    along = -RADIUS * OMEGA * (np.sin(phi) + np.cos(phi) * np.tan(slope(phi)))
    np.testing.assert_allclose(vectors["1", "B", "v_{B}"], [0.0 * phi, along], atol=1e-12)


def test_no_velocities_without_a_speed():
    assert not found(velocities, ct.run(ct.Machine(mechanism=slider())), TURN)


@pytest.mark.parametrize("name", example_names())
def test_pins_move_as_the_vectors_say(name):
    """By central differences of where they are drawn, at the speed there."""
    run = result(name)
    machine, angles = run.machines[0], np.arange(3.0, 360.0, 40.0)
    vectors = found(velocities, run, angles)
    assert vectors
    ahead, behind = (ct.drawing(machine, angles + by) for by in (STEP, -STEP))
    for (mechanism, pin, _symbol), value in vectors.items():
        moved = ahead.mechanism(mechanism).pins[pin] - behind.mechanism(mechanism).pins[pin]
        by_angle = moved / np.deg2rad(2 * STEP)
        omega = np.sum(value * by_angle, axis=0) / np.sum(by_angle**2, axis=0)
        np.testing.assert_allclose(value, omega * by_angle, atol=1e-5 * np.max(np.abs(value)))
        if machine.main_shaft.speed is not None and not machine.main_shaft.turns_unevenly:
            moving = np.hypot(*by_angle) > 1e-3 * np.max(np.hypot(*by_angle))
            np.testing.assert_allclose(omega[moving], machine.main_shaft.speed.si, rtol=1e-4)


def test_pistons_go_as_fast_as_the_result_says():
    run = result("3d12")
    angles = np.arange(0.0, 720.0, 8.0)
    vectors = found(velocities, run, angles)
    for piston, pin in (("1L", "B"), ("1R", "D")):
        value = run.piston_velocity[run.labels["piston"].index(piston)]
        expected = np.abs(np.interp(angles % 360.0, run.crank_angle[: value.size], value))
        np.testing.assert_allclose(np.hypot(*vectors[piston, pin, f"v_{{{pin}}}"]), expected, atol=1e-9)


def test_forces_of_a_cylinder_without_masses():
    """P along the cylinder, N = P tan β across it, T = P sin(φ+β)/cos β and K = P cos(φ+β)/cos β on the crank pin."""
    run = result("burning_cylinder")
    machine = run.machines[0]
    assert not machine.masses
    angles = np.arange(0.0, 720.0, 4.0)
    mechanism, phi = machine.places[0].geometry, np.deg2rad(angles)
    pressed = np.interp(angles, run.crank_angle, run.gas_force[0])
    beta = np.arcsin(mechanism.crank_radius / mechanism.rod_length * np.sin(phi))
    tangential, radial = (pressed * part(phi + beta) / np.cos(beta) for part in (np.sin, np.cos))
    out, around = np.stack([np.sin(phi), np.cos(phi)]), np.stack([np.cos(phi), -np.sin(phi)])
    vectors = found(forces, run, angles)
    limit = 1e-9 * np.max(pressed)
    zero = 0.0 * phi
    for key, expected in {
        ("1", "B", "P_g"): [zero, -pressed],
        ("1", "A", "T"): tangential * around,
        ("1", "A", "K"): -radial * out,
        ("1", "A", "R"): tangential * around - radial * out,
    }.items():
        np.testing.assert_allclose(vectors[key], expected, atol=limit)
    side = vectors["1", "B", "N"]
    np.testing.assert_allclose(np.abs(side), [np.abs(pressed * np.tan(beta)), zero], atol=limit)
    # The wall, the gas and the rod hold the piston in balance.
    np.testing.assert_allclose(side + vectors["1", "B", "P_g"], vectors["1", "A", "R"], atol=limit)


def test_forces_of_an_engine_are_those_of_the_result():
    run = result("3d12")
    angles = np.arange(0.0, 720.0, 4.0)
    vectors = found(forces, run, angles)
    at = np.searchsorted(run.crank_angle, angles)
    np.testing.assert_array_equal(run.crank_angle[at], angles)
    exact = run.labels["force_method"].index("exact")
    for piston, pin in (("1L", "B"), ("1R", "D")):
        side = run.side_force[exact, run.labels["piston"].index(piston)][at]
        np.testing.assert_allclose(np.hypot(*vectors[piston, pin, "N"]), np.abs(side), atol=1e-9 * np.max(np.abs(side)))
    place = run.labels["mechanism"].index("1L")
    radial, tangential = (getattr(run, f"crankpin_load_{way}")[place][at] for way in ("radial", "tangential"))
    np.testing.assert_allclose(np.hypot(*vectors["1L", "A", "R"]), np.hypot(radial, tangential), rtol=1e-12)
    np.testing.assert_allclose(np.hypot(*vectors["1L", "A", "T"]), np.abs(tangential), rtol=1e-9, atol=1e-6)


def test_rods_side_by_side_load_their_pin_together():
    run = result("kamaz_740")
    angles = np.arange(0.0, 720.0, 4.0)
    vectors = found(forces, run, angles)
    at = np.searchsorted(run.crank_angle, angles)
    places = [run.labels["mechanism"].index(name) for name in ("1R", "1L")]
    radial = sum(run.crankpin_load_radial[place][at] for place in places)
    assert ("1L", "A", "K") not in vectors
    np.testing.assert_allclose(np.hypot(*vectors["1R", "A", "K"]), np.abs(radial), atol=1e-9 * np.max(np.abs(radial)))


@pytest.mark.parametrize("name", ["jaw_crusher", "toggle_press", "shaper"])
def test_joints_of_links_have_their_reactions(name):
    run = result(name)
    angles = np.arange(0.0, 360.0, 4.0)
    vectors = found(forces, run, angles)
    at = np.searchsorted(run.crank_angle, angles)
    sizes = np.hypot(run.joint_force_x, run.joint_force_y)[:, at]
    drawn = {pin: np.hypot(*value) for (_mechanism, pin, symbol), value in vectors.items() if symbol == "R"}
    assert len(drawn) > 1
    for size in drawn.values():
        assert np.min(np.max(np.abs(sizes - size), axis=1)) < 1e-9 * np.max(sizes)


def test_all_forces_are_to_one_scale_and_in_one_unit():
    run = result("3d12")
    sorts = [vectors_as_shown(one) for one in forces(run, first_throw(run.machines[0]), np.arange(0.0, 721.0, 4.0))]
    assert {one.unit for one in sorts} == {"kN"}
    assert {one.largest for one in sorts} == {max(vector.largest for one in sorts for vector in one.vectors)}
