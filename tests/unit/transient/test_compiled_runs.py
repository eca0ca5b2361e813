"""Runs under Numba: they remember, stop at corners, turn back and come to rest as plain ones; compiled once for all."""

import math

import numpy as np
import pytest

from cranktrain.transient import endings
from cranktrain.transient.equation import DriveTrain, Kernels, joined, no_brake, no_heat
from cranktrain.transient.gearing import stages
from cranktrain.transient.runs import run, wanted

SUCTION, DELIVERY, EXPONENT, CLEARANCE, AREA, CRANK = 1e5, 4e5, 1.3, 0.2, 1e-3, 0.05
MIDDLE = math.pi / 2
STIFF, INERTIA = 900.0, 0.35


def volume(angle):
    return AREA * CRANK * (1 + CLEARANCE - math.cos(angle))


def sprung_gas(angle, _speed, _sense, numbers):
    """Gas that keeps p·Vⁿ between its valves' pressures on a crank of so much arm, and a spring about an angle."""
    inertia, memory, arm, stiffness, rest = numbers
    room = volume(angle)
    pressure = min(max(memory[0] * room**-EXPONENT, SUCTION), DELIVERY)
    torque = -pressure * AREA * arm * math.sin(angle)
    return inertia, 0.0, torque + stiffness * (angle - rest), math.sin(angle)


def settle_gas(angle, numbers):
    room = volume(angle) ** EXPONENT
    numbers[1][0] = min(max(numbers[1][0], SUCTION * room), DELIVERY * room)


def slowing(speed, _time, numbers):
    return -numbers[0] * speed


KERNELS = Kernels(sprung_gas, slowing, no_heat, no_brake, settle_gas)


def both(asked, *, inertia, arm=CRANK, stiffness=0.0, rest=MIDDLE, damping=0.0, turning=0.5):
    """The same run, plain and compiled."""
    found = []
    for is_compiled in (False, True):
        memory = [2e5 * volume(MIDDLE) ** EXPONENT]
        machine = (inertia, np.array(memory) if is_compiled else memory, arm, stiffness, rest)
        drive = DriveTrain(machine, (damping,), 0.0, stages(turning))
        found.append(run(KERNELS, drive, asked, is_compiled=is_compiled))
    return found


@pytest.mark.parametrize(("speed", "stiffness"), [(1.0, 200.0), (10.0, 0.0)])
def test_compiled_runs_remember_and_stop_at_corners_alike(speed, stiffness):
    """Rocking with reversals, and turning on through both dead positions, where the chamber turns round."""
    asked = wanted(2.0, angle=MIDDLE, speed=speed, corners=(0.0, math.pi))
    ends = []
    for found in both(asked, inertia=1.5, stiffness=stiffness):
        marks = [(event.kind, event.time, event.angle, event.speed) for event in found.events]
        ends.append((found.reason, len(marks), np.concatenate([found.end, np.ravel(marks)])))
    assert ends[0][:2] == ends[1][:2]
    np.testing.assert_allclose(ends[1][2], ends[0][2], rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("damping", [4.0, 60.0])
def test_without_a_pull_it_is_at_rest(damping):
    """On a spring, in swings and without; its amplitude falls as exp(−c t/2J), or by the slower of two rates."""
    asked = wanted(60.0, angle=1.2, is_timed=True)
    for found in both(asked, inertia=INERTIA, arm=0.0, stiffness=STIFF, rest=1.0, damping=damping, turning=0.0):
        assert found.reason == endings.AT_REST
        assert found.end[0] == pytest.approx(1.0, abs=2e-6)
        root = math.sqrt(max(0.0, (damping / 2 / INERTIA) ** 2 - STIFF / INERTIA))
        rate = damping / 2 / INERTIA - root
        assert found.end_time == pytest.approx(math.log(0.2 / 1e-6) / rate, rel=0.1)


def test_steps_tell_the_states_within_as_the_run_writes_them_down():
    """Through reversals and corners, plain and compiled, at the beginning, at ends of steps and beyond the end."""
    asked = wanted(2.0, angle=MIDDLE, speed=1.0, corners=(0.0, math.pi))
    for is_compiled in (False, True):
        memory = [2e5 * volume(MIDDLE) ** EXPONENT]
        machine = (1.5, np.array(memory) if is_compiled else memory, CRANK, 200.0, MIDDLE)
        drive = DriveTrain(machine, (0.0,), 0.0, stages(0.5))
        kept = run(KERNELS, drive, asked, is_compiled=is_compiled, keeps_steps=True)
        assert kept.tells_within
        samples = np.unique(np.concatenate([np.linspace(0.0, 2.5, 400), kept.steps[:, 0]]))
        sampled = run(KERNELS, drive, asked._replace(samples=samples), is_compiled=is_compiled)
        found = kept.sampled(samples, is_compiled=is_compiled)
        np.testing.assert_array_equal(found.time, sampled.time)
        np.testing.assert_array_equal(found.states, sampled.states)
        assert not sampled.tells_within  # of which no steps were kept


def test_slopes_are_compiled_once():
    """Whichever stage they are of: all that a run is made of has them in it."""
    pytest.importorskip("numba")
    both(wanted(0.2, angle=1.0, speed=3.0), inertia=INERTIA)
    assert len(joined(KERNELS, True).derive.signatures) == 1
