"""Steps to a steady cycle: gentle slopes by a series as by elimination; a balance between few speeds as between all."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.questions.drive import balanced_speed, cycle_equation
from cranktrain.questions.drive.balanced_speed import balances
from cranktrain.questions.drive.steady_drive import SteadyCycles
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.study.start import over_time_of_designs

MACHINES = ("compressor_start", "high_slip_press", "jaw_crusher", "shaking_conveyor", "shears", "tilting_table")
STEEPEST = np.array([1e-12, 1e-3, 0.03, 0.0899])


def test_gentle_slopes_are_those_of_elimination():
    """To rounding: of the largest slopes for which the series is taken, and of all below."""
    random = np.random.default_rng(4)
    steepness = STEEPEST[:, np.newaxis, np.newaxis] * random.uniform(-1, 1, (STEEPEST.size, 5, 12))
    assert np.max(np.abs(steepness)) < cycle_equation._GENTLE
    rest = random.normal(size=steepness.shape)
    found, exact = (way(steepness, steepness, rest) for way in (cycle_equation._by_series, cycle_equation._solved))
    size = np.max(np.abs(exact), axis=(1, 2), keepdims=True)
    np.testing.assert_allclose(found / size, exact / size, rtol=0, atol=1e-15)


@pytest.mark.parametrize("name", MACHINES)
def test_steps_that_end_when_the_next_is_less_than_rounding_are_enough(name, monkeypatch):
    """What more steps, and elimination, change is rounding."""
    machine = ct.load(name)
    (found,) = over_time_of_designs([machine], [SteadyCycles])[SteadyCycles].found
    monkeypatch.setattr(cycle_equation, "_NEARLY", 0.0)
    monkeypatch.setattr(cycle_equation, "_GENTLE", 0.0)
    (longer,) = over_time_of_designs([machine], [SteadyCycles])[SteadyCycles].found
    assert found.period == pytest.approx(longer.period, rel=1e-14)
    np.testing.assert_allclose(found.speed, longer.speed, rtol=1e-14)


@pytest.mark.parametrize("name", MACHINES)
def test_a_balance_is_that_of_all_speeds(name, monkeypatch):
    """To the last bit, as the speeds next to it are the same."""
    known = over_time_of_designs([ct.load(name)], [SteadyCycles, ReducedMachines])
    turning, cycle = known[SteadyCycles].turning, known[ReducedMachines].cycle
    (few,) = balances(turning, cycle)
    monkeypatch.setattr(balanced_speed, "_up_to", lambda there, tops: balanced_speed._downwards(there, speeds(tops)))
    (every,) = balances(turning, cycle)
    assert few.speed is not None
    assert few.speed == every.speed


def speeds(tops):
    """All that are looked at."""
    slowest, beyond = balanced_speed._SLOWEST, balanced_speed._BEYOND
    return np.linspace(slowest, beyond, balanced_speed._N_SPEEDS) * tops[:, np.newaxis]
