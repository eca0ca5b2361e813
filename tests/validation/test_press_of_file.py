"""A press from its machine file against the same press from closed forms; its starts; a brake on a crank."""

import math
import re

import numpy as np
import pytest
from tests.presses import GRAVITY, IDLE, NUMBERS, RADIUS, RAM, ROD, high_slip, press_with
from tests.told import texts_of

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.questions.press.strokes import PressStrokes
from cranktrain.transient.clutched.runs import PressPlan
from cranktrain.transient.clutched.settled import settled_stroke
from cranktrain.transient.equation import Kernels, no_brake, no_heat

FULL = 600e3
CORNERS = (0.125, 0.12505)


def travel(angle):
    """Of the ram from its upper dead centre. [m]"""
    return RADIUS - ROD - RADIUS * math.cos(angle) + math.sqrt(ROD**2 - RADIUS**2 * math.sin(angle) ** 2)


def slope(angle):
    """Travel of a ram below the shaft by the crank angle, and its derivative. [m/rad, m/rad²]"""
    sin, cos = math.sin(angle), math.cos(angle)
    root = math.sqrt(ROD**2 - RADIUS**2 * sin**2)
    first = RADIUS * sin - RADIUS**2 * sin * cos / root
    return first, RADIUS * cos - RADIUS**2 * (cos**2 - sin**2) / root - (RADIUS**2 * sin * cos) ** 2 / root**3


def angle_of(place):
    """Crank angle on the way down, by the cosine rule. [rad]"""
    reach = ROD - RADIUS + place
    return math.pi - math.acos((RADIUS**2 + reach**2 - ROD**2) / (2 * RADIUS * reach))


def ram_by_travel(angle, _speed, sense, _numbers):
    """Crank, ram with its weight, dry friction at the shaft, and a force that comes on within 0.05 mm of travel."""
    first, second = slope(angle)
    is_down = math.sin(angle) * sense > 0
    force = FULL * min(max((travel(angle) - CORNERS[0]) / (CORNERS[1] - CORNERS[0]), 0.0), 1.0) if is_down else 0.0
    load = (force - RAM * GRAVITY) * first + 150.0 * sense
    return 14.0 + RAM * first**2, 2 * RAM * first * second, load, first


def grip(own):
    names = ("torque", "static_torque", "delay", "rise_time", "release_delay", "fall_time")
    return {name: f"{value!r} {'N*m' if 'torque' in name else 's'}" for name, value in zip(names, own, strict=True)}


def press(**stroke):
    """The press of the closed forms, as a machine file has it."""
    return ct.Machine(
        name="press",
        rotation="clockwise",
        angle="180 deg",
        gravity=True,
        shaft={"main": {"speed": "91 rpm"}},
        mechanism={"kind": "slider_crank", "crank_radius": "65 mm", "crank_to_rod_ratio": 0.1},
        masses={
            "crank": {"mass": "1 kg", "along": "0 mm", "inertia": "14 kg*m^2"},
            "piston": {"mass": "900 kg"},
        },
        load={
            "pressing": {
                "on": "piston",
                "travel": ["0 mm", "125 mm", "125.05 mm", "131 mm"],
                "force": ["0 kN", "0 kN", "600 kN", "600 kN"],
                "force_back": ["0 kN"] * 4,
            },
            "dry": {"on": "main", "torque": "150 N*m"},
        },
        drive={
            "motor": {
                "kind": "cage",
                "curve": "kloss",
                "synchronous_speed": "1500 rpm",
                "breakdown_torque": "190 N*m",
                "breakdown_slip": 0.45,
            },
            "stage": [{"ratio": 3.3}, {"ratio": 5, "efficiency": 0.96, "efficiency_back": 0.95}],
            "part": {"flywheel": {"on": 1, "inertia": "24 kg*m^2"}},
            "clutch": {"on": 1, "driven_inertia": "0.4 kg*m^2", **grip(NUMBERS["clutch"])},
            "brake": {"on": "crank", **grip(NUMBERS["brake"])},
            "stroke": {"start_angle": "180 deg", **stroke},
            "start": {"tolerance": 1e-11},
        },
    )


def fact(result, name):
    return float(np.ravel(getattr(result, name))[0])


@pytest.mark.parametrize("period", [math.nan, 2.0])
def test_stroke_against_closed_forms(period):
    jumps = (0.0, *map(angle_of, CORNERS), math.pi)
    kernels = Kernels(ram_by_travel, high_slip, no_heat, no_brake)
    own = press_with()
    plan = PressPlan(4.0, jumps=jumps, tolerance=1e-11)
    other = settled_stroke(kernels, own, plan, idle_speed=IDLE, period=period)
    found = ct.run(press(**({} if math.isnan(period) else {"strokes_per_minute": 30})))
    stroke = other.stroke
    expected = {
        "command_angle": other.command_angle + math.pi,
        "clutch_slip_time": stroke.slip_time,
        "clutch_lock_angle": stroke.locked_at,
        "clutch_heat": stroke.clutch_heat,
        "brake_heat": stroke.brake_heat,
        "stroke_speed_drop": stroke.speed_drop,
        "pressing_speed_drop": stroke.pressing_drop,
        "braking_angle": stroke.brake_angle,
        "braking_time": stroke.brake_time,
        "stroke_time": stroke.stroke_time,
        "recovery_time": stroke.recovery_time,
        "flywheel_start_speed": other.wheel_speed,
    }
    for name, value in expected.items():
        assert fact(found, name) == pytest.approx(value, rel=1e-7), name
    assert fact(found, "stop_angle") == 0
    if other.pace is not None:
        assert fact(found, "stroke_motor_power") == pytest.approx(other.pace.motor_power, rel=1e-7)
        assert fact(found, "clutch_heating") == pytest.approx(stroke.clutch_heat / 2, rel=1e-7)


def test_steps_of_a_stroke():
    """They end at angles where the load has corners; rejected ones and those that settle events are few."""
    (settled,) = ct.run("high_slip_press")[PressStrokes].settled
    assert settled.is_found
    assert settled.stroke.run.n_steps < 90
    assert settled.pace.waiting.n_steps < 16


def test_what_heat_allows():
    machine = ct.load("high_slip_press")
    bare = ct.run(machine)
    hot = ct.run(machine.with_({"drive.clutch.mean_power": "400 W"}))
    assert fact(hot, "most_strokes_per_minute") == pytest.approx(60 * 400 / fact(bare, "clutch_heat"), rel=1e-9)
    assert any("400" in flag and "clutch" in flag for flag in texts_of(hot.flags))
    wait = fact(bare, "stroke_time") + fact(bare, "recovery_time")
    assert fact(bare, "most_strokes_per_minute") == pytest.approx(60 / wait, rel=1e-12)


def test_started_it_makes_a_stroke():
    """What the motor gives over a period is what the load takes and what is lost: the flywheel is as fast again."""
    found = ct.start("high_slip_press")
    assert found.motor_work[-1] == pytest.approx(found.load_work[-1] + found.lost_work[-1], rel=1e-7)
    assert found.time[-1] == pytest.approx(2.0)
    assert [str(event.name) for event in found.events][:2] == ["crank sets off", "clutch locks"]
    assert found.crank_angle_turned[-1] == pytest.approx(3 * math.pi, abs=1e-8)
    work = np.trapezoid(found.motor_power, found.time)
    assert work == pytest.approx(found.motor_work[-1], rel=1e-3)


def test_longest_stop_is_longest():
    """Commands given at other angles stop sooner; one at its own angle takes as long."""
    machine = ct.load("high_slip_press")
    worst = ct.start(machine).run.stroke.longest_stop
    for command in (230.0, 280.0):
        commanded = ct.run(machine.with_({"drive.stroke.command_angle": f"{command} deg"}))
        assert fact(commanded, "braking_angle") < worst.angle
        assert fact(commanded, "braking_time") < worst.time


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"drive.brake.torque": "60 N*m", "drive.brake.static_torque": "60 N*m"}, "too weak to end it where it began"),
        ({"drive.clutch.torque": "20 N*m", "drive.clutch.static_torque": "20 N*m"}, "slips on"),
        ({"drive.stroke.strokes_per_minute": 100}, "not over when the next begins"),
    ],
)
def test_no_stroke_says_why(change, words):
    machine = ct.load("high_slip_press").with_(change)
    result = ct.run(machine)
    assert np.isnan(fact(result, "stroke_time"))
    assert any(words in flag for flag in texts_of(result.flags))
    assert words in str(ct.start(machine).run.reason)


def test_a_weak_brake_tells_where_the_crank_rests():
    """In the next pressing, which takes 600 kN from 5 mm before the lowest point on, and stops it within 4 mm."""
    weak = {"drive.brake.torque": "60 N*m", "drive.brake.static_torque": "60 N*m"}
    (said,) = [flag for flag in texts_of(ct.run(ct.load("high_slip_press").with_(weak)).flags) if "too weak" in flag]
    command, angle, rest = map(float, re.findall(r"([\d.]+) deg", said))
    assert (command + angle) % 360 == pytest.approx(rest, abs=0.011)
    before_bottom = math.radians(360 - rest)
    crank, rod = 65.0, 650.0
    left = crank * (1 - math.cos(before_bottom)) - rod * (
        1 - math.sqrt(1 - (crank / rod * math.sin(before_bottom)) ** 2)
    )
    assert 1 < left < 5


def test_a_flywheel_must_be_there():
    result = ct.run(ct.load("high_slip_press").with_({"drive.part.flywheel.inertia": "0 kg*m^2"}))
    assert any("nothing turns before the clutch" in flag for flag in texts_of(result.flags))


@pytest.mark.parametrize(("start", "path"), [("3 s", "drive.start.duration"), ("1 s", "drive.start.brake_on")])
def test_a_start_of_its_own_is_refused(start, path):
    with pytest.raises(InputError) as refused:
        ct.load("high_slip_press").with_({path: start})
    assert path in [problem.path for problem in refused.value.problems]


class TestBrakeOnTheCrank:
    """Coasting with a brake, J = 2 kg·m² at the crank: against ω(t) in closed form."""

    def machine(self, on, torque):
        return ct.Machine(
            name="wheel",
            shaft={"main": {"speed": "100 rpm"}},
            mechanism={"kind": "scotch_yoke", "crank_radius": "10 mm"},
            masses={"crank": {"mass": "1 kg", "along": "0 mm", "inertia": "2 kg*m^2"}, "piston": {"mass": "1e-9 kg"}},
            drive={
                "stage": [{"ratio": 4}],
                "brake": {"on": on, "torque": torque, "static_torque": "100 N*m", "rise_time": "0.5 s"},
                "start": {"speed": "100 rpm", "brake_on": "1 s", "duration": "9 s", "tolerance": 1e-10},
            },
        )

    @pytest.mark.parametrize(("on", "torque", "share"), [("crank", "6 N*m", 1), ("motor", "6 N*m", 4)])
    def test_it_slows(self, on, torque, share):
        found = ct.start(self.machine(on, torque))
        begun, slowing = 100 * math.pi / 30, 6.0 * share / 2.0
        rests = 1.0 + 0.25 + begun / slowing
        assert found.time[-1] == pytest.approx(rests, abs=1e-6)
        assert found.lost_work[-1] == pytest.approx(begun**2, rel=1e-7)
