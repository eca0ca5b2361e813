"""Plans at a speed that varies: motion differentiated twice in time, polygons that close, levers that balance."""

import numpy as np
import pytest
from tests.property.test_running_speed import (
    PISTON,
    ROD_INERTIA,
    ROD_MASS,
    SLIDER_CRANK,
    SPEED,
    SPLINE,
    in_time,
    moved,
    varying,
)
from tests.unit.plans.test_force_polygons import MACHINES, members

import cranktrain as ct
from cranktrain.analysis import speed_over_cycle
from cranktrain.errors import InputError
from cranktrain.plans.force_polygons import force_polygons
from cranktrain.plans.pin_loads import pin_loads
from cranktrain.plans.polygons import acceleration_polygons, velocity_polygons
from cranktrain.plans.zhukovsky import zhukovsky_lever

ANGLES = [30, 140, 300]
PHI = np.radians(np.arange(360.0))
PUMP = ct.Machine(**SLIDER_CRANK)


def on_sheet(place):
    """X and Y of x + iy in the mechanism's axes: its x is Y and its y is X, as the crank turns clockwise."""
    return [place.imag, place.real]


def uneven(machine):
    """A speed that varies by a quarter, on the grid of the machine's cycle."""
    angle = np.radians(ct.run(machine, quantities="closing_margin").crank_angle)
    return varying(angle, machine.main_shaft.speed.si)


def test_plans_are_motion_in_time():
    """Velocities and accelerations of both pins against positions differentiated by series; the crank's two parts."""
    speed = varying(PHI)
    _centroid, piston, _crank, _lean = moved(PHI)
    pin = moved(PHI)[2] * (0.05 / 0.02)
    velocities = velocity_polygons(PUMP, ANGLES, speed=speed)
    accelerations = acceleration_polygons(PUMP, ANGLES, speed=speed)
    for i, angle in enumerate(ANGLES):
        for name, place in (("A", pin), ("B", piston)):
            first = in_time(place, speed)
            second = in_time(first, speed)
            for polygon, symbol, value in ((velocities[i], "v", first), (accelerations[i], "a", second)):
                vectors = {vector.symbol: vector for vector in polygon.vectors}
                drawn = vectors[f"{symbol}_{name}"].value
                np.testing.assert_allclose(drawn, on_sheet(value[angle]), atol=2 * SPLINE * np.max(np.abs(second)))
        vectors = {vector.symbol: vector for vector in accelerations[i].vectors}
        # the crank's normal part is ω²r, its tangential one εr
        assert vectors["a_AO^n"].size == pytest.approx(0.05 * speed[angle] ** 2, rel=1e-12)
        turning = in_time(speed + 0j, speed).real[angle]
        assert vectors["a_AO^t"].size == pytest.approx(0.05 * abs(turning), abs=SPLINE * 0.05 * SPEED**2)


def test_inertia_on_a_polygon_is_mass_by_acceleration_in_time():
    speed = varying(PHI)
    rod, piston, _crank, lean = moved(PHI)
    expected = {
        3: -ROD_MASS * in_time(in_time(rod, speed), speed),
        4: -PISTON * in_time(in_time(piston, speed), speed),
    }
    for polygon in force_polygons(PUMP, ANGLES, speed=speed):
        assert polygon.gap < 1e-12
        for force in polygon.forces:
            number = int(force.symbol.split("_")[1][0])
            if force.cause == "inertia" and number in expected:
                value = expected[number]
                found = on_sheet(value[int(polygon.angle)])
                np.testing.assert_allclose(force.value, found, atol=2 * SPLINE * np.max(np.abs(value)))
    spin = ROD_INERTIA * in_time(in_time(lean, speed), speed).real * in_time(lean, speed).real
    for angle in ANGLES:
        lever = zhukovsky_lever(PUMP, float(angle), speed=speed)
        couple = next(force for force in lever.forces if force.symbol == "M_Φ3")
        assert lever.speed == pytest.approx(speed[angle], rel=1e-12)
        assert couple.moment == pytest.approx(-spin[angle] / speed[angle], abs=1e-6 * np.max(np.abs(spin)))


@pytest.mark.parametrize("name", MACHINES)
def test_polygons_close_and_levers_balance(name):
    machine = MACHINES[name]
    curve = speed_over_cycle(machine, uneven(machine))
    for mechanism in members(machine):
        for polygon in force_polygons(machine, [33.0, 200.0], mechanism=mechanism, speed=curve):
            assert polygon.gap < 1e-12, (mechanism, polygon.links)
        for angle in (33.0, 200.0):
            lever = zhukovsky_lever(machine, angle, mechanism=mechanism, speed=curve)
            even = zhukovsky_lever(machine, angle, mechanism=mechanism)
            assert lever.residual < 1e-12
            assert abs(lever.driving_torque - even.driving_torque) > 1e-3 * abs(even.driving_torque)


def test_levers_of_all_mechanisms_are_the_torque_of_the_machine():
    engine = MACHINES["3d12"]
    speed = uneven(engine)
    curve = speed_over_cycle(engine, speed)
    levers = [zhukovsky_lever(engine, 30.0, mechanism=place.name, speed=curve) for place in engine.places]
    result = ct.run(engine, speed=speed, quantities=("machine_torque",))
    torque = float(result.machine_torque[result.crank_angle == 30.0][0])
    assert -sum(lever.driving_torque for lever in levers) == pytest.approx(torque, rel=1e-9)


def test_pin_loads_of_the_running_speed():
    engine = ct.load("vaz_21213")
    found, result = pin_loads(engine, speed="running"), ct.run(engine, speed="running")
    np.testing.assert_array_equal(found.on_pin[0], result.crankpin_load_tangential[0])
    assert np.max(np.abs(found.on_pin - pin_loads(engine).on_pin)) > 10.0


def test_running_speed_is_found_once():
    """A curve goes through all as it is; there is none at a constant speed."""
    engine = ct.load("vaz_21213")
    curve = speed_over_cycle(engine, "running")
    assert speed_over_cycle(engine, curve) is curve
    assert speed_over_cycle(engine, "constant") is None
    whole, by_curve = (ct.run(engine, speed=speed, quantities="piston_velocity") for speed in ("running", curve))
    np.testing.assert_array_equal(whole.piston_velocity, by_curve.piston_velocity)


def test_without_a_load_there_is_none():
    with pytest.raises(InputError, match=r"speed = running: needs \[evenness\]"):
        force_polygons(PUMP, [30.0], speed="running")
