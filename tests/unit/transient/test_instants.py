"""Events that last but an instant, within a step: none is stepped over, and each is told once."""

import math

import numpy as np
import pytest

from cranktrain.transient.endings import DEAD_POSITION, OVERSPEED, REVERSAL
from cranktrain.transient.equation import DriveTrain, Kernels, no_brake, no_heat, no_motor
from cranktrain.transient.gearing import stages
from cranktrain.transient.runs import run, wanted


def pendulum(angle, _speed, _sense, numbers):
    """A wheel with a weight: greatest speed at the bottom, angle 0; what it drives has dead positions at ±δ there."""
    return 1.0, 0.0, numbers[0] * math.sin(angle), math.cos(angle) - numbers[1]


PENDULUM = Kernels(pendulum, no_motor, no_heat, no_brake)


@pytest.mark.parametrize("start", np.linspace(-2.3, -2.0, 13).tolist())
def test_a_speed_that_is_passed_for_an_instant_is_not_stepped_over(start):
    """ω² = ω₀² − 2 A (1 − cos φ), and ω is above the level over less than a degree, a tenth of the largest step."""
    weight, fastest, level = 50.0, 100.0, 100.0 * (1 - 1e-7)
    speed = math.sqrt(fastest**2 - 2 * weight * (1 - math.cos(start)))
    drive = DriveTrain((weight, -2.0), (), 0.0, stages(0.0))
    asked = wanted(0.06, angle=start, speed=speed, overspeed=level, tolerance=1e-10)
    done = run(PENDULUM, drive, asked, is_compiled=False)
    assert done.reason == OVERSPEED
    assert done.end[0] == pytest.approx(-math.acos(1 - (fastest**2 - level**2) / (2 * weight)), abs=2e-5)


@pytest.mark.parametrize("start", np.linspace(-2.3, -2.0, 13).tolist())
def test_two_dead_positions_near_to_each_other_are_both_found(start):
    apart, speed = 0.02, 100.0
    drive = DriveTrain((0.0, math.cos(apart)), (), 0.0, stages(0.0))
    done = run(PENDULUM, drive, wanted(0.06, angle=start, speed=speed), is_compiled=False)
    dead = done.of_kind(DEAD_POSITION)
    assert [event.angle for event in dead] == pytest.approx([-apart, apart], abs=1e-9)
    assert [event.time for event in dead] == pytest.approx(
        [(-apart - start) / speed, (apart - start) / speed], abs=1e-9
    )


def test_a_dead_position_shortly_before_it_stops_is_told_once():
    """It rises to 0.0104 rad beyond the dead position at π/2 + 0.01, and swings back through it."""
    weight, dead, top = 50.0, math.pi / 2 + 0.01, math.pi / 2 + 0.0204
    start = math.pi / 2 - 0.2
    speed = math.sqrt(2 * weight * (math.cos(start) - math.cos(top)))
    drive = DriveTrain((weight, math.cos(dead)), (), 0.0, stages(0.0))
    done = run(PENDULUM, drive, wanted(0.14, angle=start, speed=speed, tolerance=1e-11), is_compiled=False)
    assert [event.angle for event in done.of_kind(DEAD_POSITION)] == pytest.approx([dead, dead], abs=1e-9)
    assert [event.angle for event in done.of_kind(REVERSAL)] == pytest.approx([top], abs=1e-9)
