"""Presses with random numbers: every stroke ends with a reason that a press has, and its energy is even."""

import numpy as np
import pytest
from tests.presses import IDLE, KERNELS, PRESSING, SYNCHRONOUS, press_with

from cranktrain.transient.clutched.courses import Grip
from cranktrain.transient.clutched.equation import BRAKE_HEAT, CLUTCH_HEAT
from cranktrain.transient.clutched.runs import RESTS, SLIDES, SLIPS_ON, WHEEL_STALLS, PressPlan
from cranktrain.transient.clutched.stroke import single_stroke


def grip(random, low, high):
    """Torques of any size, times of any length or none."""
    torque = np.exp(random.uniform(np.log(low), np.log(high)))
    times = np.exp(random.uniform(np.log(1e-4), np.log(0.1), 4)) * random.integers(0, 2, 4)
    return Grip(float(torque), float(torque * random.choice([1.0, 1.2])), *map(float, times))


@pytest.mark.parametrize("seed", range(60))
def test_stroke(seed):
    random = np.random.default_rng(seed)
    press = press_with(
        machine=(
            float(random.uniform(5.0, 50.0)),
            float(random.uniform(100.0, 20000.0)),
            float(random.choice([0.0, random.uniform(1e4, 3e6)])),
            float(random.choice([0.0, random.uniform(10.0, 2000.0)])),
            *PRESSING,
        ),
        motor=(float(random.uniform(20.0, 500.0)), float(random.uniform(0.05, 0.6)), SYNCHRONOUS),
        wheel_inertia=float(random.uniform(0.3, 100.0)),
        driven_inertia=float(random.choice([0.0, 0.4, 2.0])),
        ratio=float(random.uniform(1.0, 12.0)),
        forward=float(random.uniform(0.6, 1.0)),
        backward=float(random.uniform(0.5, 1.0)),
        clutch=grip(random, 300.0, 50e3),
        brake=grip(random, 200.0, 20e3),
        brake_on_crank=bool(random.integers(2)),
    )
    plan = PressPlan(8.0, command_angle=float(random.uniform(0.2, 9.0)), jumps=PRESSING)
    start = float(random.choice([0.0, 0.1, -0.2]))
    found = single_stroke(KERNELS, press, plan, wheel_speed=IDLE, start_angle=start, recovery_limit=0.0)
    assert found.run.reason in (RESTS, SLIPS_ON, SLIDES, WHEEL_STALLS)
    assert abs(found.run.residual) < 1e-8 * found.run.supplied
    heat = np.diff(found.run.states[:, [CLUTCH_HEAT, BRAKE_HEAT]], axis=0)
    assert np.all(heat >= -1e-12 * found.run.supplied)
