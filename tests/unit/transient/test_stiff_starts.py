"""Starts whose motor is far quicker than its machine: by an implicit method, with the same events and reasons."""

import numpy as np
import pytest
from tests.machines import ROCKER

import cranktrain as ct

RPM = np.pi / 30
STEEP = 200 / (3 * RPM)
"""Of the motor below, by how much its torque falls: 200 N·m over 3 rpm. [N·m·s]"""


def wheel(inertia, load="40 N*m", **start):
    """A massless yoke with a wheel, a load and a shunt motor without a rotor."""
    return ct.Machine(
        mechanism={"kind": "scotch_yoke", "crank_radius": "100 mm"},
        shaft={"main": {"speed": "60 rpm"}},
        masses={"piston": {"mass": "1e-12 kg"}},
        load={"work": {"on": "main", "torque": load}},
        drive={
            "motor": {"kind": "shunt", "torque": "200 N*m", "speed": "57 rpm", "no_load_speed": "60 rpm"},
            "part": {"wheel": {"on": "motor", "inertia": inertia}},
            "start": start,
        },
    )


def rocker(inertia):
    """A rocker with mass, so that J is the wheel's alone in the dead positions."""
    masses = {"rocker": {"mass": "3 kg", "along": "50 mm", "inertia": "0.1 kg*m^2"}}
    return wheel(inertia).with_({"mechanism": ROCKER, "masses": masses})


def events(found):
    return [(event.sort, event.time, event.angle) for event in found.events]


@pytest.mark.parametrize("inertia", [6e-3, 6e-5])
def test_speed_of_a_wheel_is_an_exponential(inertia):
    """Against a constant load ω goes to 59.4 rpm as 1 − exp(−t/τ), τ = J over the fall of the motor's torque."""
    pytest.importorskip("scipy")
    found = ct.start(wheel(f"{inertia} kg*m^2"))
    assert found.run.method == "LSODA"
    tau, nearly = inertia / STEEP, found.events[0]
    assert nearly.time / tau == pytest.approx(np.log(50), rel=1e-6)
    np.testing.assert_allclose(found.crank_speed, 59.4 * RPM * (1 - np.exp(-found.time / tau)), rtol=0, atol=1e-8)


def test_by_both_methods(monkeypatch):
    """A rocker on a wheel so light that explicit steps are many, and may yet be waited for."""
    pytest.importorskip("scipy")
    implicit = ct.start(rocker("0.1 kg*m^2"))
    monkeypatch.setattr("cranktrain.questions.start.method.is_stiff", lambda *_given: False)
    explicit = ct.start(rocker("0.1 kg*m^2"))
    assert (implicit.run.method, explicit.run.method) == ("LSODA", "tsit5")
    assert str(implicit.run.reason) == str(explicit.run.reason)
    assert implicit.run.n_steps < explicit.run.n_steps
    assert [kind for kind, _time, _angle in events(implicit)] == [kind for kind, _time, _angle in events(explicit)]
    times = [[time for _kind, time, _angle in events(one)] for one in (implicit, explicit)]
    np.testing.assert_allclose(*times, rtol=0, atol=1e-6)
    assert float(implicit.motor_work[-1]) == pytest.approx(float(explicit.motor_work[-1]), rel=1e-6)


@pytest.mark.parametrize("inertia", ["1e-9 kg*m^2", "0 kg*m^2"])
def test_next_to_no_inertia_in_the_dead_positions(inertia):
    """The crank turns at 59.4 rpm of its own accord, and passes the dead positions at their times."""
    pytest.importorskip("scipy")
    found = ct.start(rocker(inertia))
    dead = [event for event in found.events if event.sort == "dead position"]
    extended, folded = (np.arccos((far**2 + 0.4**2 - 0.28**2) / (2 * 0.4 * far)) for far in (0.46, 0.26))
    expected = [extended, np.pi + folded, 2 * np.pi + extended, 3 * np.pi + folded]
    np.testing.assert_allclose([event.angle for event in dead], expected, rtol=0, atol=1e-7)
    for event in dead:
        assert event.time == pytest.approx(event.angle / (59.4 * RPM), rel=2e-3)
    assert abs(found.run.residual) < 1e-6 * found.run.supplied


def test_a_crank_that_is_held_is_a_result():
    """5 kN·m are more than the 4 kN·m of the motor at rest; then a brake holds what had run up."""
    pytest.importorskip("scipy")
    held = ct.start(wheel("6e-3 kg*m^2", "5 kN*m"))
    assert "it stands still" in str(held.run.reason)
    assert held.time[-1] == 0
    stop = {"drive.brake": {"torque": "30 N*m"}, "drive.start": {"motor_off": "1 s", "brake_on": "1 s"}}
    braked = ct.start(wheel("6e-3 kg*m^2").with_(stop))
    assert braked.run.method == "LSODA"
    assert "stands still" in str(braked.run.reason)
    assert braked.time[-1] == pytest.approx(1 + 59.4 * RPM * 6e-3 / (40 + 30), abs=1e-6)


def test_a_crank_that_runs_away_is_a_result(monkeypatch):
    """With the motor off a load drives it into a dead position, where it has no inertia: no step is short enough."""
    pytest.importorskip("scipy")
    monkeypatch.setattr("cranktrain.questions.start.starting.MOST_STEPS", 2000)
    driven = rocker("0 kg*m^2").with_({"load.work.sense": "active", "drive.start.motor_off": "1 s"})
    found = ct.start(driven)
    assert "steps" in str(found.run.reason)
    assert found.time[-1] < 2


def test_what_remembers_goes_by_explicit_steps():
    machine = ct.load("compressor_start").with_({"drive.start.duration": "0.2 s"})
    assert ct.start(machine).run.method == "tsit5"


def test_an_interrupted_start_keeps_what_it_has():
    pytest.importorskip("scipy")

    def stop(time, _angle, _speed):
        if time >= 1:
            raise KeyboardInterrupt

    found = ct.start(wheel("6e-3 kg*m^2", duration="2 s", motor_off="1 s"), progress=stop)
    assert "stopped" in str(found.run.reason)
    assert found.time[-1] == pytest.approx(1.0)
