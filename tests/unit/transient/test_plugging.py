"""A motor that is switched to turn the other way: the run ends by itself, and a compressor keeps its gas on the way."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import cranktrain as ct

RPM = np.pi / 30
TOP, BREAKDOWN, SLIP, INERTIA, LOAD = 1500 * RPM, 95.0, 0.2, 0.8, 20.0


def machine(**start):
    """Nothing that depends on the angle: a wheel, and a torque that resists, whichever way it turns."""
    motor = {
        "kind": "cage",
        "curve": "kloss",
        "breakdown_torque": f"{BREAKDOWN} N*m",
        "breakdown_slip": SLIP,
        "synchronous_speed": "1500 rpm",
    }
    return ct.Machine(
        mechanism={"kind": "scotch_yoke", "crank_radius": "10 mm"},
        shaft={"main": {"speed": "1450 rpm"}},
        load={"belt": {"on": "main", "torque": f"{LOAD} N*m"}},
        drive={"motor": motor, "part": {"wheel": {"inertia": f"{INERTIA} kg*m^2"}}, "start": start},
    )


def torque(speed):
    slip = 1 - speed / TOP
    return 2 * BREAKDOWN * slip * SLIP / (slip**2 + SLIP**2)


def by_another_solver(back):
    """Time, and speed, of the end: 98 % of the steady speed the other way, and two turns more at the steady speed."""
    steady = brentq(lambda speed: torque(speed) - LOAD, 0.9 * TOP, TOP)

    def until(first, sense, last, end):
        def rate(_time, speed):
            return (torque(sense * speed) - np.sign(speed + 1e-12 * sense) * sense * LOAD) * sense / INERTIA

        def reached(_time, speed):
            return speed[0] - last

        reached.terminal = True
        return solve_ivp(rate, (0, end), [first], events=reached, rtol=1e-10, atol=1e-10)

    before = until(0.0, 1, 2 * TOP, back)
    stopping = until(before.y[0, -1], -1, 0.0, 60)
    running_up = until(0.0, -1, -0.98 * steady, 60)
    more = 2 * 2 * np.pi / steady
    return back + stopping.t[-1] + running_up.t[-1] + more, until(-0.98 * steady, -1, -2 * TOP, more).y[0, -1]


@pytest.mark.parametrize("back", [3.0, 0.4])
def test_it_ends_where_it_has_run_up_the_other_way(back):
    found = ct.start(machine(motor_reversed=f"{back} s"))
    time, speed = by_another_solver(back)
    assert str(found.run.reason).startswith("it has run up the other way")
    assert found.time[-1] == pytest.approx(time, rel=1e-6)
    assert found.crank_speed[-1] == pytest.approx(speed, rel=1e-6)
    assert [one.sort for one in found.events if one.sort == "turns round"] == ["turns round"]


def test_reversed_from_the_beginning_it_runs_up_backward():
    forward, backward = ct.start(machine()), ct.start(machine(motor_reversed="0 s"))
    assert backward.time[-1] == pytest.approx(forward.time[-1], rel=1e-7)
    assert backward.crank_speed[-1] == pytest.approx(-forward.crank_speed[-1], rel=1e-7)


def test_switched_off_after_it_comes_to_rest():
    """What is asked for besides ends it, as before."""
    found = ct.start(machine(motor_reversed="2 s", motor_off="2.5 s"))
    assert str(found.run.reason) == "it stands still and nothing pulls"


def test_a_weak_motor_stops_a_compressor_and_swings():
    """It runs against its gas, which remembers: as one run does, which ends at a time instead."""
    ended = ct.start("compressor_start", set={"drive.start.motor_reversed": "3 s"})
    end = float(ended.time[-1])
    whole = ct.start("compressor_start", set={"drive.start.motor_reversed": "3 s", "drive.start.duration": f"{end} s"})
    assert str(ended.run.reason).startswith("it stands still")
    assert end < 60
    assert ended.crank_angle_turned[-1] == pytest.approx(whole.crank_angle_turned[-1], abs=1e-5)
    assert ended.motor_work[-1] == pytest.approx(whole.motor_work[-1], rel=1e-6)
