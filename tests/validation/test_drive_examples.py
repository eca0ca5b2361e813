"""Examples with a drive against balances of energy in closed form, and against equations of motion written here.

* Jaw crusher: energy of a start without stone, losses of its belt.
* Shears: area of the cut; its start by scipy's DOP853, slider-crank, Kloss's formula and losses of two stages by hand.
* Shaking conveyor: work of dry friction; its start likewise, through dead positions.
* Compressor: polytropic work of a cycle; its start likewise, from valve to valve; where it stalls, and where not.
"""

from itertools import product

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import cranktrain as ct

RPM = np.pi / 30
POUND, INCH, PSI = 0.45359237, 0.0254, 4.4482216152605 / 0.0254**2
KLOSS = {"kind": "cage", "curve": "kloss", "synchronous_speed": "1500 rpm"}


def cell(found, name):
    return float(np.ravel(getattr(found, name))[0])


def kloss(breakdown, breakdown_slip):
    """Torque by speed of a motor of 1500 rpm."""

    def torque(speed):
        slip = 1 - speed / (1500 * RPM)
        return 2 * breakdown * slip * breakdown_slip / (slip**2 + breakdown_slip**2)

    return torque


class SliderCrank:
    """A central one, with a slide and a rod; angles from the far dead centre. [m, kg, kg·m²]"""

    def __init__(self, radius, rod, slide_mass, rod_mass=0.0, along=0.0, rod_inertia=0.0):
        self.lengths, self.masses = (radius, rod), (slide_mass, rod_mass, along, rod_inertia)

    def slide(self, angle):
        """Distance from the shaft, and its derivative by the crank angle."""
        radius, rod = self.lengths
        side = np.sqrt(rod**2 - (radius * np.sin(angle)) ** 2)
        return (
            radius * np.cos(angle) + side,
            -radius * np.sin(angle) - radius**2 * np.sin(angle) * np.cos(angle) / side,
        )

    def inertia(self, angle):
        radius, rod = self.lengths
        slide_mass, rod_mass, along, rod_inertia = self.masses
        part, slope = along / rod, self.slide(angle)[1]
        x = (1 - part) * -radius * np.sin(angle) + part * slope
        y = (1 - part) * radius * np.cos(angle)
        turning = radius * np.cos(angle) / np.sqrt(rod**2 - (radius * np.sin(angle)) ** 2)
        return slide_mass * slope**2 + rod_mass * (x**2 + y**2) + rod_inertia * turning**2

    def inertia_slope(self, angle, step=1e-4):
        """By differences of fourth order."""
        near, far = (self.inertia(angle + k * step) - self.inertia(angle - k * step) for k in (1, 2))
        return (8 * near - far) / (12 * step)


class Train:
    """Motor, stages (ratio, efficiency, inertia behind it) and mechanism; turning forward."""

    def __init__(self, motor, rotor, stages, mechanism):
        self.motor, self.rotor, self.stages, self.mechanism = motor, rotor, stages, mechanism
        self.ratio = np.prod([ratio for ratio, _efficiency, _inertia in stages])

    def acceleration(self, angle, speed, load):
        """Of the crank: by the one way of flows through the stages that agrees with its own torques."""
        needed = load + 0.5 * self.mechanism.inertia_slope(angle) * speed**2
        for forward in product((True, False), repeat=len(self.stages)):
            # torque behind each stage is a - b α
            a, b, turns, signs = self.motor(speed * self.ratio), self.rotor * self.ratio, self.ratio, []
            for (ratio, efficiency, inertia), ahead in zip(self.stages, forward, strict=True):
                through = ratio * (efficiency if ahead else 1 / (2 - 1 / efficiency))
                signs.append((a, b, ahead))
                turns /= ratio
                a, b = a * through, b * through + inertia * turns
            found = (a - needed) / (b + self.mechanism.inertia(angle))
            if all((a - b * found) * (1 if ahead else -1) > -1e-9 for a, b, ahead in signs):
                return found
        raise AssertionError("no way of flows")

    def run(self, load, times, angle, corners=()):
        """Angle and speed at times; `load` by angle and speed [N·m]; halts at corners of the angle."""
        kinks = [lambda _t, y, at=at: np.sin((y[0] - at) / 2) for at in corners]
        for kink in kinks:
            kink.terminal = True
        state, here = np.array([angle, 0.0]), 0.0
        rows, times = [state[:, np.newaxis]], times[1:]
        while here < times[-1]:
            found = solve_ivp(
                lambda _t, y: (y[1], self.acceleration(y[0], y[1], load(y[0], y[1]))),
                (here, times[-1]),
                state,
                method="DOP853",
                rtol=1e-10,
                atol=1e-12,
                max_step=0.02,
                events=kinks,
                dense_output=True,
            )
            assert found.success
            own = times[(times >= here) & (times < found.t[-1])] if found.t[-1] < times[-1] else times[times >= here]
            if own.size:
                rows.append(found.sol(own))
            # past the corner by less than the tolerance
            here, state = found.t[-1] + 1e-9, found.y[:, -1] + np.array([found.y[1, -1] * 1e-9, 0.0])
        return np.concatenate(rows, axis=1)


def compared(found, expected, zero, speed=2e-6):
    np.testing.assert_allclose(found.crank_angle_turned, expected[0] - zero, rtol=0, atol=2e-6)
    np.testing.assert_allclose(found.crank_speed, expected[1], rtol=0, atol=speed)


def test_jaw_crusher_starts_without_stone():
    """All that the belt passes on is in the flywheels, and it loses a twentieth; rotor 0.23 kg·m² by the catalogue."""
    found = ct.start("jaw_crusher", set={"load.crushing.force[2]": "0 kN", "drive.start.until_speed": "270 rpm"})
    flywheels, rotor, ratio = 120.0, 0.23, 5.375
    turning = 0.5 * (270 * RPM) ** 2
    assert found.crank_speed[-1] == pytest.approx(270 * RPM, rel=1e-9)
    assert found.kinetic_energy[-1] == pytest.approx((flywheels + rotor * ratio**2) * turning, rel=1e-9)
    assert found.motor_work[-1] == pytest.approx((flywheels / 0.95 + rotor * ratio**2) * turning, rel=1e-7)
    assert found.lost_work[-1] == pytest.approx(flywheels * (1 / 0.95 - 1) * turning, rel=1e-6)


def test_jaw_crusher_crushes_with_30_kw():
    """Flow through the belt never turns round: power of the motor is that of crushing over the belt's efficiency."""
    result = ct.run("jaw_crusher")
    crushing = -cell(result, "load_work") / cell(result, "cycle_time")
    assert cell(result, "motor_power") == pytest.approx(crushing / 0.95, rel=1e-5)
    assert cell(result, "motor_power") < 30e3


def test_jaw_crusher_does_not_start_amid_the_stone():
    found = ct.start("jaw_crusher", set={"drive.start.angle": "100 deg"})
    assert "stands still" in str(found.run.reason)
    assert found.crank_speed[-1] == pytest.approx(0.0, abs=1e-9)


def test_shears_take_the_area_of_the_cut():
    result = ct.run("shears")
    assert cell(result, "load_work") == pytest.approx(-250e3 * (17.6e-3 + 1e-3), rel=1e-12)
    per_cut = cell(result, "motor_power") * cell(result, "cycle_time")
    assert per_cut == pytest.approx(4650 / (0.96 * 0.94), rel=1e-3)  # but for moments in which the ram drives


def shears_load(mechanism):
    """Torque at the crank by angle from the upper dead centre: it runs from there, nearest to the shaft, outward."""

    def load(angle, _speed):
        place, slope = mechanism.slide(angle)
        travel = place - 0.45
        force = 250e3 * np.interp(travel, [0, 73.1e-3, 74.1e-3, 91.7e-3, 92.7e-3, 0.101], [0, 0, 1, 1, 0, 0])
        return force * slope if slope > 0 else 0.0

    return load


def angles_at(mechanism, travels):
    """Crank angles at which the slide, on its way out from 0.45 m, is so far."""
    radius, rod = mechanism.lengths
    place = 0.45 + np.asarray(travels)
    return 2 * np.pi - np.arccos((radius**2 + place**2 - rod**2) / (2 * radius * place))


def test_shears_start():
    mechanism = SliderCrank(0.05, 0.5, 400.0)
    rated, slip = 5500 / (1440 * RPM), 0.04
    motor = kloss(2.5 * rated, 3 * slip * (2.5 + np.sqrt(2.5**2 - 1)))
    train = Train(motor, 0.03, [(3.0, 0.96, 15.0), (11.5, 0.94, 0.0)], mechanism)
    options = {"drive.start.duration": "4 s", "drive.start.interval": "0.05 s", "drive.start.tolerance": 1e-11}
    found = ct.start("shears", set=options)
    shown = 0.0
    corners = angles_at(mechanism, [73.1e-3, 74.1e-3, 91.7e-3, 92.7e-3])
    expected = train.run(shears_load(mechanism), np.asarray(found.time), shown, corners)
    compared(found, expected, shown)


def conveyor(force=2354.0):
    mechanism = SliderCrank(0.075, 1.5, 1200.0, 60.0, 0.6, 12.0)
    return mechanism, lambda angle, speed: force * abs(mechanism.slide(angle)[1]) * np.sign(speed)


def test_shaking_conveyor_takes_the_work_of_friction():
    result = ct.run("shaking_conveyor")
    assert cell(result, "load_work") == pytest.approx(-2 * 2354 * 0.15, rel=1e-12)
    assert np.min(result.static_torque[0, -1]) >= -1e-9
    assert np.min(result.motor_torque) < 0  # the trough drives the crank


def test_shaking_conveyor_starts():
    mechanism, load = conveyor()
    train = Train(kloss(30.0, 0.2), 0.004, [(24.0, 0.9, 0.0)], mechanism)
    motor = {**KLOSS, "breakdown_torque": "30 N*m", "breakdown_slip": 0.2, "inertia": "0.004 kg*m^2"}
    options = {"drive.start.duration": "2 s", "drive.start.interval": "0.02 s", "drive.start.tolerance": 1e-11}
    found = ct.start("shaking_conveyor", set={"drive.motor": motor, **options})
    expected = train.run(load, np.asarray(found.time), np.pi / 2, corners=(0.0, np.pi))
    compared(found, expected, 0.0)


def test_shaking_conveyor_cannot_start_at_mid_stroke():
    """10 kN at the full radius is more than 2.3 times the rated torque of 1.5 kW through the gear."""
    most = 24.781 * 24 * 0.9
    mechanism, _load = conveyor()
    assert 10e3 * abs(mechanism.slide(np.pi / 2)[1]) > most
    found = ct.start("shaking_conveyor", set={"load.goods.force": "10 kN"})
    assert found.time[-1] == 0
    assert "stands still" in str(found.run.reason)


class Gas:
    """Volume of the cylinder by crank angle from the top, and the pressure at which it fills."""

    suction = 14.7 * PSI

    def __init__(self, mechanism):
        self.mechanism, self.area = mechanism, np.pi / 4 * (3.125 * INCH) ** 2
        self.least = 0.099 * self.area * 3.26 * INCH

    def volume(self, angle):
        return self.least + self.area * (self.mechanism.slide(0.0)[0] - self.mechanism.slide(angle)[0])


def compressor():
    radius = 1.63 * INCH
    return SliderCrank(radius, 3.5 * radius, POUND, 2 * POUND, 1.9017 * INCH, 0.0038)


def test_work_of_the_compressor():
    mechanism, n, ratio = compressor(), 1.13, 132 / 14.7
    gas = Gas(mechanism)
    taken_in = gas.volume(np.pi) - gas.least * ratio ** (1 / n)
    work = n / (n - 1) * gas.suction * taken_in * (ratio ** ((n - 1) / n) - 1)
    result = ct.run("compressor_start")
    per_turn = cell(result, "motor_power") * cell(result, "cycle_time")
    assert per_turn == pytest.approx(work / 0.96, rel=2e-3)


def test_compressor_starts_loaded():
    """From just behind the top: its first stroke takes in, all others are as valves have it, with corners."""
    mechanism, n = compressor(), 1.13
    gas = Gas(mechanism)
    discharge, most = 132 * PSI, gas.volume(np.pi)
    opens = brentq(lambda angle: most / gas.volume(angle) - (discharge / gas.suction) ** (1 / n), np.pi, 2 * np.pi)
    fills = brentq(lambda angle: gas.volume(angle) / gas.least - (discharge / gas.suction) ** (1 / n), 0, np.pi)

    def load(angle, _speed):
        turns, here = divmod(angle, 2 * np.pi)
        volume = gas.volume(here)
        if here < np.pi:
            pressure = discharge * (gas.least / volume) ** n if turns > 0 and here < fills else gas.suction
        else:
            pressure = gas.suction * (most / volume) ** n if here < opens else discharge
        return (pressure - 101325) * gas.area * mechanism.slide(here)[1]

    train = Train(kloss(33.0, 0.2), 0.004, [(0.96, 0.96, 0.08)], mechanism)
    motor = {**KLOSS, "breakdown_torque": "33 N*m", "breakdown_slip": 0.2, "inertia": "0.004 kg*m^2"}
    options = {"drive.start.duration": "0.7 s", "drive.start.interval": "0.02 s", "drive.start.angle": "0.1 rad"}
    found = ct.start("compressor_start", set={"drive.motor": motor, "drive.start.tolerance": 1e-11, **options})
    expected = train.run(load, np.asarray(found.time), 0.1, corners=(0.0, np.pi, opens, fills))
    assert found.crank_angle_turned[-1] > 4 * np.pi
    compared(found, expected, 0.0, speed=5e-6)  # theirs goes 1e-9 s past each of a score of corners


def test_compressor_by_star_and_delta():
    starter = {"drive.motor.starter": {"kind": "star_delta", "change_time": "1 s"}}
    loaded = ct.start("compressor_start", set=starter)
    assert "stands still" in str(loaded.run.reason)
    assert loaded.time[-1] > 1  # in delta
    assert np.max(loaded.crank_angle_turned) < 2 * np.pi
    unloaded = ct.start("compressor_start", set={**starter, "drive.start.unloaded_until": "1.5 s"})
    before = np.searchsorted(unloaded.time, 1.5) - 1
    assert abs(unloaded.load_work[before]) < 1.0  # but for 28 Pa between suction and the atmosphere, nothing
    assert unloaded.crank_speed[-1] > 1450 * RPM
    assert unloaded.load_work[-1] > 100
