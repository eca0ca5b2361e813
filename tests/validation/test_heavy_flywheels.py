"""Steady running with flywheels from next to nothing to 10¹² kg·m²: the heavier, the nearer to closed forms.

With a heavy flywheel the crank turns at the speed ω at which the motor gives on the mean what the machine takes. Its
fluctuation is then the excess work at that speed over Jω², that of the rest of the machine's inertia among it: found
here from the torques at a constant speed alone.
"""

import numpy as np
import pytest
from scipy.optimize import brentq
from tests.told import texts_of
from tests.validation.test_motor_corners import CRANK, MOTORS, PISTON, RATIO, ROTOR, piston_rate

import cranktrain as ct
from cranktrain.motors import motor_of

FORCE, LOAD = 2500.0, 60.0
DRIVING = [name for name in MOTORS if name != "servo"]
"""Motors whose torque falls to that of the load below their top speed."""
ASKED = ("drive_fluctuation", "mean_motor_speed")
ANGLES = np.linspace(0.0, 2 * np.pi, 20001)


def machine(name, flywheel, load=LOAD):
    return ct.Machine(
        rotation="anticlockwise",
        angle="-90 deg",
        shaft={"main": {"speed": "16 rad/s"}},
        mechanism={"kind": "slider_crank", "crank_radius": "60 mm", "rod_length": "240 mm"},
        masses={
            "piston": {"mass": f"{PISTON} kg"},
            "crank": {"mass": "1 kg", "along": "0 m", "inertia": f"{CRANK} kg*m^2"},
        },
        load={
            "gas": {"on": "piston", "sense": "active", "direction": "0 deg", "force": f"{-FORCE} N"},
            "work": {"on": "main", "torque": f"{load} N*m"},
        },
        drive={
            "motor": {**MOTORS[name], "inertia": f"{ROTOR} kg*m^2"},
            "stage": [{"ratio": RATIO}],
            "part": {"flywheel": {"on": 1, "inertia": f"{flywheel!r} kg*m^2"}},
        },
    )


def balanced(motor):
    """Highest speed of the motor at which it gives what the load takes. [rad/s]"""
    speeds = np.linspace(3.0, 1.2 * min(motor.highest_speed(0), 400.0), 2001)
    excess = RATIO * motor.torque(speeds)[0] - LOAD
    (*_, last) = np.flatnonzero((excess[:-1] > 0) & (excess[1:] <= 0))
    return brentq(lambda at: RATIO * motor.torque(np.array([at]))[0, 0] - LOAD, *speeds[last : last + 2], xtol=1e-13)


@pytest.mark.parametrize("power", [5, 6, 12])
@pytest.mark.parametrize("name", DRIVING)
def test_the_heavier_the_nearer_to_a_constant_speed(name, power):
    """What is left of the machine's own share goes with one over the flywheel's inertia."""
    flywheel = 10.0**power
    found = ct.run(machine(name, flywheel), quantities=ASKED)
    speed = balanced(motor_of(machine(name, 1.0).drive.motor))
    rate = piston_rate(ANGLES, np)
    swung = -FORCE * (np.concatenate([[0.0], np.cumsum((rate[1:] + rate[:-1]) / 2) * (ANGLES[1] - ANGLES[0])]))
    kinetic = swung - 0.5 * PISTON * rate**2 * (speed / RATIO) ** 2
    even = np.ptp(kinetic) / (flywheel * (speed / RATIO) ** 2)
    assert float(found.mean_motor_speed) == pytest.approx(speed, rel=10 / flywheel + 1e-11)
    assert float(found.drive_fluctuation) == pytest.approx(even, rel=100 / flywheel + 1e-6)
    assert all(np.all(check.passed) for check in found.checks)


@pytest.mark.parametrize("name", DRIVING)
def test_every_flywheel_has_its_cycle(name):
    """The heavier, the more even; no flag says that there is none."""
    found = [ct.run(machine(name, 10.0**power), quantities=ASKED) for power in (-6, -3, -1, 0, 1, 3, 5, 7, 9, 12)]
    fluctuations = np.array([float(one.drive_fluctuation) for one in found])
    assert np.all(np.diff(fluctuations) < 1e-9 * fluctuations[:-1])
    for one in found:
        assert not [flag for flag in texts_of(one.flags) if "steady running" in flag.lower()]
        assert all(np.all(check.passed) for check in one.checks)
