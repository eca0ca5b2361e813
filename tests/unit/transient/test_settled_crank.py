"""A crank that creeps or swings to where load and motor balance is a stall with angle and time; closed forms."""

import math

import numpy as np
import pytest
from tests.starts import wheel

import cranktrain as ct
from cranktrain.transient import endings
from cranktrain.transient.equation import DriveTrain, Kernels, no_brake, no_heat
from cranktrain.transient.gearing import stages
from cranktrain.transient.runs import REASONS, run, wanted

RADIUS, RATIO, STALL, NO_LOAD = 0.1, 10.0, 60.0, 50 * math.pi
INERTIA = 0.35
STIFF, DAMPED = 900.0, 60.0


def yoke(force, rotor, **start):
    """A yoke without mass, whose slider is pushed back by a force; a motor of a straight line."""
    motor = {"kind": "table", "speeds": ["0 rpm", "1500 rpm"], "torques": [f"{STALL} N*m", "0 N*m"], "inertia": rotor}
    return {
        "name": "a slider against a force",
        "shaft": {"main": {"speed": "60 rpm"}},
        "mechanism": {"kind": "scotch_yoke", "crank_radius": f"{RADIUS} m"},
        "masses": {"piston": {"mass": "1e-9 kg"}},
        "load": {"back": {"on": "piston", "sense": "active", "force": f"{force} N"}},
        "drive": {"motor": motor, "stage": [{"ratio": RATIO}], "start": start},
    }


@pytest.mark.parametrize("rotor", ["0.008 kg*m^2", "0.002 kg*m^2", "1e-6 kg*m^2"])
def test_it_stalls_where_the_torques_balance(rotor):
    """F R sin φ = i M_0: swinging in, creeping in, and with a motor that is stiff; the motor is said to be held."""
    pytest.importorskip("scipy")
    found = ct.start(yoke(9000.0, rotor))
    held = found.events[-1]
    assert "it stands still: the motor's torque" in str(found.run.reason)
    assert held.sort == "is held"
    assert held.angle == pytest.approx(math.asin(RATIO * STALL / (9000.0 * RADIUS)), abs=2e-6)
    assert found.run.whole_time[-1] == held.time < 20.0
    assert found.crank_speed[-1] == 0.0


def test_a_crank_that_creeps_in_does_so_in_its_time():
    """J φ̈ = T_0 − c φ̇ − F R sin φ by SciPy: when it is within a millionth of a radian."""
    integrate = pytest.importorskip("scipy.integrate")
    rotor = 0.002
    inertia, slope = rotor * RATIO**2, STALL / NO_LOAD * RATIO**2
    at = math.asin(RATIO * STALL / (9000.0 * RADIUS))

    def rate(_time, state):
        return [state[1], (RATIO * STALL - slope * state[1] - 9000.0 * RADIUS * math.sin(state[0])) / inertia]

    def near(_time, state):
        return abs(state[0] - at) + abs(state[1]) * math.sqrt(inertia / (9000.0 * RADIUS * math.cos(at))) - 1e-6

    near.terminal = True
    other = integrate.solve_ivp(rate, (0, 20), [0.0, 0.0], rtol=1e-11, atol=1e-13, events=near, max_step=1e-2)
    found = ct.start(yoke(9000.0, f"{rotor} kg*m^2"))
    assert found.events[-1].time == pytest.approx(float(other.t_events[0][0]), rel=0.03)


def spring(angle, _speed, sense, numbers):
    """A wheel on a spring, which is at rest at 1 rad."""
    return numbers[0], 0.0, numbers[1] * (angle - 1.0) + numbers[2] * sense, 1.0


def slowing(speed, time, numbers):
    """A motor that only brakes, and pulls from a time on."""
    pulling = numbers[2] if time >= numbers[1] else 0.0
    return pulling - numbers[0] * speed


def sprung(damping, pulls_at=math.inf, pull=0.0, most=1000, **asked):
    kernels = Kernels(spring, slowing, no_heat, no_brake)
    drive = DriveTrain((INERTIA, STIFF, 0.0), (damping, pulls_at, pull), 0.0, stages(0.0))
    breaks = (pulls_at,) if pulls_at < math.inf else ()
    how = wanted(60.0, angle=1.2, breaks=breaks, is_timed=True, most_reversals=most, **asked)
    return kernels, drive, how


def test_what_is_yet_to_come_is_waited_for():
    """A motor that pulls after 30 s stretches the spring then; the stall is where it holds it."""
    found = run(*sprung(60.0, pulls_at=30.0, pull=90.0), is_compiled=False)
    assert found.reason == endings.STALLED
    assert found.end[0] == pytest.approx(1.0 + 90.0 / STIFF, abs=2e-6)
    assert 30.0 < found.end_time < 33.0


def test_what_nothing_slows_swings_on():
    found = run(*sprung(0.0, most=50), is_compiled=False)
    assert found.reason == endings.SWINGS


def test_a_wheel_that_only_runs_out_does_not_settle():
    """A drag that goes with the speed leaves it turning, ever slower, and nothing pulls it back."""
    kernels = Kernels(wheel, slowing, no_heat, no_brake)
    drive = DriveTrain((INERTIA, 0.0, 0.0), (1.0, math.inf, 0.0), 0.0, stages(0.0))
    found = run(kernels, drive, wanted(3.0, speed=5.0, is_timed=True), is_compiled=False)
    assert found.reason == endings.TIME_OUT
    assert found.end[0] == pytest.approx(5.0 * INERTIA * (1 - math.exp(-3.0 / INERTIA)), rel=1e-6)


def test_a_motor_that_only_runs_slowly_is_no_stall():
    """It passes where the load all but holds it, at a thousandth of its speed and less."""
    force = 0.9999 * RATIO * STALL / RADIUS
    found = ct.start(yoke(force, "0.002 kg*m^2", duration="30 s"))
    assert str(found.run.reason) == REASONS[endings.TIME_OUT]
    assert np.ptp(found.run.whole.crank_angle_turned) > math.pi
