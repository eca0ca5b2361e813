"""Starts of machine files against a multibody solver and other integrators (startup_crank_rocker, drive/startup)."""

import json

import numpy as np
import pytest
from tests.reference_case import GOLDEN, ReferenceCase
from tests.validation.test_loads import machine

import cranktrain as ct

STARTUP = json.loads((GOLDEN / "drive/startup.json").read_text(encoding="utf-8"))
MOTORS = {run: STARTUP[run] for run in "ABC"}


def kloss(breakdown, slip, synchronous, inertia):
    return {
        "kind": "cage",
        "curve": "kloss",
        "breakdown_torque": f"{breakdown} N*m",
        "breakdown_slip": slip,
        "synchronous_speed": f"{synchronous!r} rad/s",
        "inertia": f"{inertia} kg*m^2",
    }


def reference(**start):
    """The machine of `startup_crank_rocker`, and how it starts."""
    own = ReferenceCase.load("startup_crank_rocker").machine
    drive = {
        "motor": kloss(
            own["breakdown_torque_Nm"],
            own["breakdown_slip"],
            own["synchronous_speed_rad_s"],
            own["motor_rotor_inertia_kgm2"],
        ),
        "stage": [{"ratio": own["gear_ratio"]}],
        "start": {"angle": f"{own['crank_angle_0_rad']} rad", "duration": f"{own['t_end_s']} s", **start},
    }
    return machine(drive=drive)


def test_start_of_the_reference_crank_rocker():
    case = ReferenceCase.load("startup_crank_rocker")
    found = ct.start(reference(interval="10 ms", tolerance=1e-10))
    assert found.time.size == case.document["expected"]["rows"]
    case.compare(
        {
            "crank_angle_rad": found.crank_angle_turned,
            "omega_crank_rad_s": found.crank_speed,
            "omega_motor_rad_s": found.motor_speed,
            "T_motor_Nm": found.motor_torque,
        }
    )
    assert abs(found.run.residual) <= 1e-9 * found.run.supplied


def table(run, **start):
    own = MOTORS[run]
    drive = {
        "motor": kloss(own["Tb"], own["sb"], 50 * np.pi, own["Jm"]),
        "stage": [{"ratio": 40, "efficiency": own["eta"], "efficiency_back": own["eta"]}],
        "start": {"angle": "60 deg", "duration": "5 s", "tolerance": 1e-10, **start},
    }
    return ct.load("tilting_table").with_({"drive": drive})


@pytest.mark.parametrize("run", MOTORS)
def test_start_of_the_heavy_crank_rocker(run):
    found, events = ct.start(table(run)), MOTORS[run]["events"]
    assert found.crank_angle_turned[-1] == pytest.approx(MOTORS[run]["phi_end"], abs=1e-8)
    assert found.crank_speed[-1] == pytest.approx(MOTORS[run]["omega_end"], abs=1e-8)
    dead = [event.time for event in found.events if str(event.name) == "dead position"]
    np.testing.assert_allclose(dead, events["dead_centre_times"], rtol=0, atol=1e-7)
    turned = [(event.time, np.degrees(event.angle)) for event in found.events if str(event.name) == "turns round"]
    np.testing.assert_allclose(np.reshape(turned, (-1, 2)), np.reshape(events["reversals"], (-1, 2)), rtol=0, atol=1e-6)


@pytest.mark.parametrize("run", MOTORS)
def test_speed_that_is_asked_for_ends_a_start(run):
    until = 0.95 * 50 * np.pi / 40
    found = ct.start(table(run, until_speed=f"{until!r} rad/s"))
    assert str(found.run.reason) == "the speed asked for is reached"
    assert found.time[-1] == pytest.approx(MOTORS[run]["events"]["first_95_percent_sync_s"], abs=1e-7)
    assert found.crank_speed[-1] == pytest.approx(until, rel=1e-9)
