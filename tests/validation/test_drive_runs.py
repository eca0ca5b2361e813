"""Starts, swings and steady cycles against multibody dynamics and other integrators (golden/drive)."""

import json

import numpy as np
import pytest
from tests.reference_case import GOLDEN, ReferenceCase
from tests.starts import SYNCHRONOUS, heavy_drive, kernels, reference_drive, start_angle

from cranktrain.transient.endings import DEAD_POSITION, REVERSAL, SPEED_PASSED, TIME_OUT
from cranktrain.transient.implicit import run_implicitly
from cranktrain.transient.runs import run, wanted
from cranktrain.transient.steady import steady_cycle

STARTUP = json.loads((GOLDEN / "drive/startup.json").read_text(encoding="utf-8"))
ROWS = np.genfromtxt(GOLDEN / "drive/startup.csv", delimiter=",", names=True, skip_header=1)
DRIVES = {"A": heavy_drive(95.0), "B": heavy_drive(95.0, 0.846), "C": heavy_drive(30.0), "D": heavy_drive(20.0)}


def start(name, end_time=5.0, **asked):
    return wanted(end_time, angle=start_angle(), samples=ROWS["t_s"], target_speed=0.95 * SYNCHRONOUS / 40, **asked)


@pytest.mark.parametrize(("tolerance", "angle", "speed"), [(1e-10, 1e-6, 8e-6), (1e-8, 1e-3, 4e-3)])
def test_reference_start(tolerance, angle, speed):
    """The case's own tolerance holds at rtol 1e-10; with the default one a thousandth of the peak will do."""
    case = ReferenceCase.load("startup_crank_rocker")
    columns = {name: np.array([float(row[name]) for row in case.rows]) for name in case.rows[0]}
    asked = wanted(3.0, angle=0.3, samples=columns["t_s"], tolerance=tolerance)
    found = run(kernels(), reference_drive(case.machine), asked)
    assert found.reason == TIME_OUT
    np.testing.assert_allclose(found.states[:, 0], columns["crank_angle_rad"], rtol=0, atol=angle)
    np.testing.assert_allclose(found.states[:, 1], columns["omega_crank_rad_s"], rtol=0, atol=speed)
    assert abs(found.residual) < 1e-8 * found.supplied


@pytest.mark.parametrize("name", ["A", "B", "C"])
def test_starts(name):
    found = run(kernels(), DRIVES[name], start(name, tolerance=1e-11))
    np.testing.assert_allclose(found.states[:, 0], ROWS[f"phi_{name}"], rtol=0, atol=1e-9)
    np.testing.assert_allclose(found.states[:, 1], ROWS[f"omega_{name}"], rtol=0, atol=1e-9)
    assert abs(found.residual) < 1e-11 * found.supplied


@pytest.mark.parametrize("name", ["A", "B", "C"])
@pytest.mark.parametrize("tolerance", [1e-11, 1e-8])
def test_events_to_a_microsecond(name, tolerance):
    found, expected = run(kernels(), DRIVES[name], start(name, tolerance=tolerance)), STARTUP[name]["events"]
    dead = [event.time for event in found.of_kind(DEAD_POSITION)]
    np.testing.assert_allclose(dead, expected["dead_centre_times"], rtol=0, atol=1e-6)
    assert found.of_kind(SPEED_PASSED)[0].time == pytest.approx(expected["first_95_percent_sync_s"], abs=1e-6)
    reversals = [(event.time, np.degrees(event.angle)) for event in found.of_kind(REVERSAL)]
    np.testing.assert_allclose(np.reshape(reversals, (-1, 2)), np.reshape(expected["reversals"], (-1, 2)), atol=1e-6)


def test_swings_for_ever():
    found = run(kernels(), DRIVES["D"], start("D", 8.0, tolerance=1e-11))
    reversals = [(event.time, np.degrees(event.angle)) for event in found.of_kind(REVERSAL)]
    np.testing.assert_allclose(reversals, STARTUP["D"]["reversals_t_deg"], rtol=0, atol=1e-8)
    assert found.reason == TIME_OUT


@pytest.mark.parametrize("name", DRIVES)
def test_energy_at_the_default_tolerance(name):
    found = run(kernels(), DRIVES[name], start(name))
    assert abs(found.residual) < 1e-6 * found.supplied


@pytest.mark.parametrize("name", ["A", "B"])
def test_steady_cycles(name):
    expected = STARTUP[f"periodic_{name}"]
    cycle = steady_cycle(kernels(), DRIVES[name], 3.0, 4.3)
    assert cycle.period == pytest.approx(expected["period_s"], rel=1e-10)
    assert cycle.mean_speed == pytest.approx(expected["mean_speed"], rel=1e-10)
    assert cycle.speed[0] == pytest.approx(expected["omega_at_alpha0"], rel=0.1)
    # on a grid, between whose points the extremes lie
    assert cycle.fluctuation == pytest.approx(expected["delta"], rel=1e-4)


def test_motor_torque_of_the_steady_cycle_without_losses():
    expected = STARTUP["periodic_A"]
    cycle = steady_cycle(kernels(), DRIVES["A"], 3.0, 4.3)
    assert cycle.mean_torque == pytest.approx(expected["T_motor_mean"], rel=1e-9)
    assert cycle.rms_torque == pytest.approx(expected["T_motor_rms"], rel=1e-10)


def test_no_steady_cycle_of_a_motor_that_cannot_lift_the_load():
    assert steady_cycle(kernels(), DRIVES["D"], 0.5, 1.0) is None


@pytest.mark.parametrize("method", ["LSODA", "Radau"])
def test_implicit_methods_give_the_same(method):
    asked = start("C", 2.0)
    one = run_implicitly(kernels(), DRIVES["C"], asked, method=method)
    other = run(kernels(), DRIVES["C"], start("C", 2.0, tolerance=1e-11))
    assert one.reason == other.reason
    np.testing.assert_allclose(one.states[:, :2], other.states[:, :2], rtol=0, atol=1e-7)
    assert [event.kind for event in one.events] == [event.kind for event in other.events]
    times = [[event.time for event in found.events] for found in (one, other)]
    np.testing.assert_allclose(*times, rtol=0, atol=1e-6)
