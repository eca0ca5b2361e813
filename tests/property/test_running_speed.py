"""A second run, at a speed that varies over the cycle: what must hold between it, the first, and motion in time."""

from typing import Any

import numpy as np
import pytest
from tests.gas_engines import DUAL_CYCLE
from tests.sentences import SPEED_AS_GIVEN, STEADY_RUNNING
from tests.weighed_machines import WEIGHED

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.numerics import spectral_derivative

SPLINE = 1e-7
"""The slope of a spline through k periods of a turn in steps of 1° is off by (kh)⁴/180 of itself: 10⁻⁷ for k = 4."""

SPEED = 2 * np.pi * 10
RADIUS, ROD, CENTROID = 0.05, 0.18, 0.06
PISTON, ROD_MASS, ROD_INERTIA, CRANK, CRANK_CENTROID, CRANK_INERTIA = 1.2, 1.6, 0.008, 3.0, 0.02, 0.03
SLIDER_CRANK: dict[str, Any] = {
    "shaft": {"main": {"speed": "600 rpm"}},
    "mechanism": {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "180 mm"},
    "masses": {
        "piston": {"mass": "1.2 kg"},
        "rod": {"mass": "1.6 kg", "along": "60 mm", "inertia": "0.008 kg·m²"},
        "crank": {"mass": "3 kg", "along": "20 mm", "inertia": "0.03 kg·m²"},
    },
}
GAS = {
    "cylinder": {"bore": "85 mm", "compression_ratio": 16, "cycle": "four-stroke", "firing_order": "1"},
    "gas": DUAL_CYCLE,
}


def varying(angle, mean=SPEED):
    """A smooth speed that varies by a quarter."""
    return mean * (1 + 0.1 * np.cos(angle) + 0.05 * np.sin(2 * angle))


def moved(phi):
    """Pin, rod's centroid, piston pin and crank's centroid as complex numbers along x and y; the rod's angle."""
    pin = RADIUS * np.exp(1j * phi)
    lean = -np.arcsin(RADIUS / ROD * np.sin(phi))
    rod = np.exp(1j * lean)
    return pin + CENTROID * rod, pin + ROD * rod, CRANK_CENTROID / RADIUS * pin, lean


def in_time(values, speed):
    """Derivative by the time of a periodic curve over one turn."""
    return speed * (spectral_derivative(values.real) + 1j * spectral_derivative(values.imag))


def at_varying_speed(machine=SLIDER_CRANK, **tables):
    angle = np.radians(np.arange(360.0))
    return ct.run(ct.Machine(**{**machine, **tables}), speed=varying(angle)), angle


def test_motion_is_that_in_time():
    found, phi = at_varying_speed()
    speed = varying(phi)
    _rod, piston, _crank, lean = moved(phi)
    velocity = -in_time(piston, speed)
    scale = np.max(np.abs(in_time(velocity, speed)))
    np.testing.assert_allclose(found.piston_velocity[0], velocity.real, atol=1e-12)
    np.testing.assert_allclose(found.piston_acceleration[0], in_time(velocity, speed).real, atol=SPLINE * scale)
    turning = in_time(lean, speed)
    np.testing.assert_allclose(found.rod_angular_velocity[0], turning.real, atol=1e-11)
    turning = in_time(turning, speed).real
    np.testing.assert_allclose(found.rod_angular_acceleration[0], turning, atol=SPLINE * np.max(np.abs(turning)))
    fine = np.linspace(0, 2 * np.pi, 400001)
    first = np.gradient(moved(fine)[1].real, fine)
    dense = -first * varying(fine)
    assert found.largest_piston_velocity == pytest.approx(np.max(dense), rel=1e-8)
    assert found.smallest_piston_velocity == pytest.approx(np.min(dense), rel=1e-8)
    assert found.largest_piston_speed == pytest.approx(np.max(np.abs(dense)), rel=1e-8)
    assert found.largest_piston_velocity_at == pytest.approx(np.degrees(fine[np.argmax(dense)]), abs=0.01)


BALANCE = {
    "weight": [
        {"mass": "2 kg", "radius": "30 mm", "angle": "170 deg", "throw": 1},
        {"mass": "0.5 kg", "radius": "40 mm", "angle": "20 deg", "z": "0 mm", "ratio": -2, "place": ["80 mm", "50 mm"]},
    ]
}


def test_the_frame_bears_the_change_of_momentum_in_time():
    """Forces and rolling moment, with the momentum and its moment written out by hand, and no formula for ε."""
    found, phi = at_varying_speed(balance=BALANCE)
    speed = varying(phi)
    rod, piston, crank, lean = moved(phi)
    masses = ((ROD_MASS, rod), (PISTON, piston), (CRANK, crank))
    momentum = sum(mass * in_time(place, speed) for mass, place in masses)
    force = -in_time(momentum, speed)
    scale = np.max(np.abs(force))
    # X is the mechanism's y and Y its x, as the machine turns clockwise
    np.testing.assert_allclose(found.shaking_force_x[0], force.imag, atol=SPLINE * scale)
    np.testing.assert_allclose(found.shaking_force_y[0], force.real, atol=SPLINE * scale)
    spin = ROD_INERTIA * in_time(lean, speed).real + CRANK_INERTIA * speed
    spin = spin + sum(mass * (np.conj(place) * in_time(place, speed)).imag for mass, place in masses)
    roll = found.driving_torque - in_time(spin, speed).real
    np.testing.assert_allclose(found.rolling_moment[0], roll, atol=SPLINE * np.max(np.abs(roll)))
    # weights: on the crank, and on a shaft of its own at X, Y that turns the other way twice as fast
    on_crank = 2 * 0.03 * np.exp(1j * (phi + np.radians(170)))
    beside = 0.5 * 0.04 * np.exp(1j * (np.radians(20) - 2 * phi))
    of_weights = -in_time(in_time(on_crank + beside, speed), speed)
    np.testing.assert_allclose(found.shaking_force_x[1], (force + of_weights).imag, atol=SPLINE * scale)
    np.testing.assert_allclose(found.shaking_force_y[1], (force + of_weights).real, atol=SPLINE * scale)
    place = 0.05 + 0.08j
    pulled = -in_time(in_time(beside, speed), speed)
    more = (np.conj(place) * pulled).imag
    np.testing.assert_allclose(
        found.rolling_moment[1] - found.rolling_moment[0], more, atol=SPLINE * np.max(np.abs(more))
    )


def test_joints_bear_what_moves():
    """Main bearing and guide together take the force off the frame, and the torque is that of kinetic energy."""
    found, phi = at_varying_speed()
    speed = varying(phi)
    joints = list(found.labels["joint"])
    borne = [found.joint_force_x[joints.index(f"1.{name}")] for name in ("main_bearing", "guide")]
    np.testing.assert_allclose(-np.sum(borne, axis=0), found.shaking_force_y[0], atol=1e-11 * np.max(np.abs(borne)))
    energy = found.reduced_inertia * speed**2 / 2
    power = spectral_derivative(energy)
    np.testing.assert_allclose(found.driving_torque, power, atol=SPLINE * np.max(np.abs(power)))
    assert all(np.all(check.passed[check.judged]) for check in found.checks)


def test_piston_and_pin_bear_what_moves():
    """The piston's inertia is that of its motion in time, exact and of two harmonics; the rod's share runs round."""
    found, phi = at_varying_speed()
    speed = varying(phi)
    mass = PISTON + ROD_MASS * CENTROID / ROD
    two = RADIUS * (np.cos(phi) + RADIUS / ROD * np.cos(2 * phi) / 4)
    for row, outward in enumerate((moved(phi)[1], moved(phi)[1], two)):
        pulled = mass * in_time(in_time(outward, speed), speed).real
        np.testing.assert_allclose(found.inertia_force[row, 0], pulled, atol=SPLINE * np.max(np.abs(pulled)))
    turning = found.crankpin_radial_without_rod[0] - found.crankpin_load_radial[0]
    np.testing.assert_allclose(turning, ROD_MASS * (1 - CENTROID / ROD) * RADIUS * speed**2, rtol=1e-11)


@pytest.mark.parametrize("name", WEIGHED)
def test_machines_of_every_kind_at_a_speed_that_varies(name):
    """The applied torque does not depend on the speed at all, and all checks hold."""
    machine = WEIGHED[name].with_({"evenness": {}})
    first = ct.run(machine)
    speed = varying(np.radians(first.crank_angle), float(machine.main_shaft.speed.si))
    second = ct.run(machine, speed=speed)
    scale = np.max(np.abs(first.applied_torque))
    np.testing.assert_allclose(second.applied_torque, first.applied_torque, atol=1e-9 * scale)
    assert np.ptp(second.driving_torque - first.driving_torque) > 1e-3 * np.ptp(first.driving_torque)
    for check in second.checks:
        assert np.all(check.passed | ~check.judged), (check.name, check.residual)


@pytest.mark.parametrize("flywheel", ["0.5 kg·m²", "2 kg·m²"])
@pytest.mark.parametrize("tables", [{}, {**GAS}], ids=["masses", "gas"])
def test_at_the_running_speed_flywheel_and_torque_make_the_load(tables, flywheel):
    """What the shaft needs for its parts and the flywheel is at every angle the load, and the first run's torque."""
    machine = ct.Machine(**SLIDER_CRANK, **tables, gravity=True, evenness={"flywheel": flywheel})
    first, second = ct.run(machine), ct.run(machine, speed="running")
    scale = np.max(np.abs(first.applied_torque))
    np.testing.assert_allclose(second.applied_torque, first.applied_torque, atol=1e-13 * scale)
    np.testing.assert_allclose(second.crank_speed, first.crank_speed, rtol=1e-12)
    given = float(flywheel.split()[0])
    load = -second.driving_torque - given * second.crank_acceleration
    np.testing.assert_allclose(load, first.mean_torque, atol=1e-12 * scale)
    assert second.mean_speed_over_time == pytest.approx(SPEED, rel=1e-12)
    said, *_rows = second.summary().splitlines()
    assert said.startswith(f"All of this is {STEADY_RUNNING}, ")
    assert "600.0 rpm over time" in said


def test_against_a_load_curve_the_torque_is_that_of_the_curve():
    text = "angle;torque [N·m]\n0;0\n140;0\n150;60\n170;60\n180;0\n360;0\n"
    load = {"saw": {"on": "main", "file": "load.csv", "text": text}}
    found = ct.run(ct.Machine(**SLIDER_CRANK, load=load, evenness={"flywheel": "1 kg·m²"}), speed="running")
    needed = found.driving_torque + found.crank_acceleration
    np.testing.assert_allclose(needed, -found.remaining_torque, atol=1e-11)


def is_angle(name):
    """Whether it is where something is, of which there may be two, or the phase of what is nothing."""
    return name.endswith("_at") or "phase" in name or "direction" in name


def test_a_huge_flywheel_makes_it_the_first_run():
    machine = ct.Machine(**SLIDER_CRANK, **GAS, evenness={"flywheel": "1e9 kg·m²"})
    first, second = ct.run(machine), ct.run(machine, speed="running")
    for name in first.catalogue:
        if name in ("coefficient_of_fluctuation", "crank_acceleration") or is_angle(name):
            continue
        one, other = getattr(first, name), getattr(second, name)
        peak = np.nanmax(np.abs(one), initial=0.0)
        np.testing.assert_allclose(other, one, atol=1e-6 * peak + 1e-9, rtol=1e-6, err_msg=name)


def test_a_constant_curve_is_a_constant_speed():
    machine = ct.Machine(**SLIDER_CRANK, balance=BALANCE, evenness={"flywheel": "1 kg·m²"})
    first = ct.run(machine)
    second = ct.run(machine, speed=np.full(360, SPEED))
    for name in first.catalogue:
        one, other = getattr(first, name), getattr(second, name)
        if is_angle(name):
            continue
        np.testing.assert_allclose(other, one, rtol=1e-9, atol=1e-9 * np.nanmax(np.abs(one), initial=1.0), err_msg=name)
    assert second.summary().startswith(f"All of this is {SPEED_AS_GIVEN}, 600.0 rpm to 600.0 rpm")


def test_powers_are_of_the_mean_over_time():
    """A motor has its own speed: powers go with it."""
    motor = {"kind": "shunt", "torque": "50 N·m", "speed": "590 rpm", "no_load_speed": "600 rpm"}
    machine = ct.Machine(**SLIDER_CRANK, **GAS, evenness={"flywheel": "2 kg·m²"}, drive={"motor": motor})
    first, second = ct.run(machine), ct.run(machine, speed="running")
    ratio = first.mean_speed_over_time / SPEED
    assert ratio > 1.002
    assert second.indicated_power == pytest.approx(ratio * first.indicated_power, rel=1e-12)
    assert second.mean_piston_speed == pytest.approx(ratio * first.mean_piston_speed, rel=1e-12)


def test_several_designs():
    """Each of several designs is as if alone; a zero of the crank angle changes nothing but the counting."""
    tables = [{"flywheel": "0.5 kg·m²"}, {"flywheel": "3 kg·m²"}]
    machines = [ct.Machine(**SLIDER_CRANK, **GAS, evenness=table) for table in tables]
    both = ct.run(machines, speed="running", step_degrees=2)
    for design, machine in enumerate(machines):
        alone = ct.run(machine, speed="running", step_degrees=2)
        for name in ("joint_force_y", "piston_acceleration", "shaking_force_largest", "largest_torque"):
            np.testing.assert_allclose(getattr(both, name)[design], getattr(alone, name), rtol=1e-9, atol=1e-6)
    turned = ct.run(ct.Machine(**SLIDER_CRANK, **GAS, crank_zero="90 deg", evenness=tables[0]), speed="running")
    plain = ct.run(machines[0], speed="running")
    np.testing.assert_allclose(turned.driving_torque, np.roll(plain.driving_torque, -90), rtol=1e-9, atol=1e-9)
    assert turned.largest_torque == pytest.approx(plain.largest_torque, rel=1e-9)


@pytest.mark.parametrize(
    ("tables", "speed", "said"),
    [
        ({}, "running", "speed = running: needs [evenness], [evenness] flywheel or flywheel_moment in the file"),
        ({"evenness": {}}, "running", "speed = running: needs [evenness] flywheel or flywheel_moment in the file"),
        ({"evenness": {"flywheel": "0 kg·m²"}, **GAS}, "running", "speed = running: No steady running at this speed"),
        ({}, "even", 'speed = even: must be "constant", "running" or speeds in rad/s'),
        ({}, np.ones(10), "speed = 10: must be one speed at each of the 360 crank angles"),
        ({}, np.zeros(360), "speed: must be finite and more than 0 all round"),
    ],
)
def test_refused(tables, speed, said):
    with pytest.raises(InputError) as caught:
        ct.run(ct.Machine(**SLIDER_CRANK, **tables), speed=speed)
    assert str(caught.value).startswith(said)
