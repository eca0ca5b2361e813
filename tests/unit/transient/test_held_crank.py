"""A crank that is held, and one that starts quickly: when, how warm, with which torque; against closed forms."""

import math

import numpy as np
import pytest

import cranktrain as ct

RADIUS, RATIO, EFFICIENCY = 0.11, 16.0, 0.95
FIELD = 50 * math.pi
RATED = 11000 / (1455 * math.pi / 30)
BREAKDOWN, START = 2.9 * RATED, 2.3 * RATED
SLIP = 0.03 * (2.9 + math.sqrt(2.9**2 - 1)) * FIELD
MID_STROKE = "270 deg"  # where the yoke's slider goes out, and the force has the whole crank for its arm


def started(starter, force, **start):
    motor = {
        "kind": "cage",
        "power": "11 kW",
        "speed": "1455 rpm",
        "breakdown_ratio": 2.9,
        "starting_ratio": 2.3,
        "pull_up_ratio": 2.0,
        "inertia": "0.06 kg*m^2",
        **({"starter": starter} if starter else {}),
    }
    return ct.start(
        {
            "name": "a pump that is held",
            "shaft": {"main": {"speed": "90 rpm"}},
            "mechanism": {"kind": "scotch_yoke", "crank_radius": f"{RADIUS} m"},
            "masses": {
                "crank": {"mass": "18 kg", "along": "30 mm", "inertia": "0.35 kg*m^2"},
                "block": {"mass": "7 kg", "along": "0 mm", "inertia": "0 kg*m^2"},
                "piston": {"mass": "62 kg"},
            },
            "load": {"pump": {"on": "piston", "force": f"{force} N"}},
            "drive": {
                "motor": motor,
                "stage": [{"ratio": RATIO, "efficiency": EFFICIENCY}],
                "start": {"angle": MID_STROKE} | start,
            },
        }
    )


def force_against(torque):
    """Force at mid-stroke that takes this torque at the motor. [N]"""
    return torque * RATIO * EFFICIENCY / RADIUS


def when(found, name):
    return next(event.time for event in found.events if event.sort == name)


def heat_at(found, time):
    return float(found.run.whole.motor_heat[np.searchsorted(found.run.whole_time, time - 1e-12)])


@pytest.mark.parametrize("interval", ["0.5 s", "10 ms"])
def test_star_heats_what_it_does_not_turn(interval):
    """A third of the torque for 0.6 s, nothing in the pause; in delta it sets off."""
    star = {"kind": "star_delta", "change_time": "0.6 s", "pause": "80 ms"}
    found = started(star, force_against(0.8 * START), duration="1 s", interval=interval)
    assert when(found, "sets off") == pytest.approx(0.68, abs=1e-9)
    assert heat_at(found, 0.68) == pytest.approx(START / 3 * FIELD * 0.6, rel=1e-9)
    assert heat_at(found, 0.3) == pytest.approx(START / 3 * FIELD * 0.3, rel=1e-9)


def test_a_ramp_of_voltage_heats_by_its_square():
    """M = u² M_st until it is the load's; heat by the integral of u²."""
    first, time, part = 0.3, 1.2, 0.7
    ramp = {"kind": "soft_start", "first_voltage": first, "ramp_time": f"{time} s"}
    found = started(ramp, force_against(part * START), duration="1.2 s")
    off = time * (math.sqrt(part) - first) / (1 - first)
    assert when(found, "sets off") == pytest.approx(off, abs=1e-9)
    before = found.run.whole_time < off
    voltage = first + (1 - first) * found.run.whole_time[before] / time
    own = START * FIELD * time * (voltage**3 - first**3) / (3 * (1 - first))
    np.testing.assert_allclose(found.run.whole.motor_heat[before], own, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("duration", ["1 s", "60 s"])
def test_a_torque_that_lets_go_for_a_moment_is_not_looked_over(duration):
    """An inverter's ramp goes past breakdown at standstill: above 99 % of it for 23 ms only."""
    part, time = 0.99, 0.6
    ramp = {"kind": "inverter", "ramp_time": f"{time} s"}
    found = started(ramp, force_against(part * BREAKDOWN), duration=duration)
    slip = SLIP * (1 - math.sqrt(1 - part**2)) / part
    assert when(found, "sets off") == pytest.approx(time * slip / FIELD, abs=1e-9)


def words_of(found, name):
    """Words of the one line of the answer with a name."""
    (words,) = (line.words for _title, rows in found.answer_rows() for line in rows if str(line.name) == name)
    return words


def test_an_inverter_that_cannot_pulls():
    """Its field begins at rest, where it gives nothing yet: nevertheless a motor pulls."""
    found = started({"kind": "inverter", "ramp_time": "0.6 s"}, force_against(1.05 * BREAKDOWN))
    assert str(found.run.reason) == "it stands still: the motor's torque is within what load and friction hold"


def test_what_stops_and_is_held_does_not_turn_round():
    star = {"kind": "star_delta", "change_time": "0.6 s"}
    found = started(star, 3000.0, speed="60 rpm", motor_off="0 s")
    assert [event.sort for event in found.events if event.sort != "dead position"] == ["is held"]
    assert words_of(found, "turns of the crank").pieces["n"] == "0"


@pytest.mark.parametrize("duration", ["1 s", "20 s"])
def test_a_quick_start_is_looked_at_closely_in_a_long_run(duration):
    """It goes through breakdown within a fifth of a second; so power and torque go through the largest of the curve."""
    found = started(None, 3000.0, angle="20 deg", duration=duration)
    slips = np.linspace(0, SLIP / FIELD, 100_001)[1:]
    torques = 2 * BREAKDOWN * slips * (SLIP / FIELD) / (slips**2 + (SLIP / FIELD) ** 2)
    powers = torques * FIELD * (1 - slips)
    assert np.max(found.run.whole.motor_torque) == pytest.approx(BREAKDOWN, rel=2e-4)
    assert np.max(found.run.whole.motor_power) == pytest.approx(np.max(powers), rel=2e-4)
    assert "beginning" not in str(words_of(found, "energy"))


def test_energy_that_is_there_at_the_beginning_is_told():
    found = started(None, 3000.0, angle="20 deg", speed="60 rpm", motor_off="0 s")
    assert str(words_of(found, "energy")).endswith(" at the beginning")
    assert found.first_kinetic_energy == pytest.approx(found.final_load_work + found.final_lost_work, rel=1e-6)
