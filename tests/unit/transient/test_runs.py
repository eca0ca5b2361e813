"""Runs that closed forms know: starts, standstill, braking, coasting, jamming; each ends with a reason."""

import numpy as np
import pytest
from tests.starts import SYNCHRONOUS, kloss, rotor_heat, wheel

from cranktrain.motors.cage.law import CageMotor, cage_torque, kloss_curve
from cranktrain.transient import endings
from cranktrain.transient.compiling import quick
from cranktrain.transient.equation import (
    DriveTrain,
    Kernels,
    no_brake,
    no_heat,
    no_motor,
    train_of,
    untimed,
)
from cranktrain.transient.gearing import stages
from cranktrain.transient.implicit import is_stiff, run_implicitly, slip_time_constant
from cranktrain.transient.rest import sense_of_start
from cranktrain.transient.runs import REASONS, run, wanted

DIRECT = stages(0.2)
CAGE = Kernels(wheel, untimed(kloss), rotor_heat, no_brake)
MOTOR = (95.0, 0.2, SYNCHRONOUS)


def timed_torque(_speed, time, numbers):
    """A torque that grows from nothing."""
    return numbers[0] * time


def constant(_speed, _time, numbers):
    return numbers[0]


def braking(time, numbers):
    """A torque after a delay."""
    return numbers[0] if time >= numbers[1] else 0.0


def plain(kernels, drive, asked):
    return run(kernels, drive, asked, is_compiled=False)


@pytest.mark.parametrize(("load", "time", "heat"), [(0.0, 0.511401093707019, 2461.2325975216595),
                                                    (20.0, 0.8409334200397934, 4158.992942211376)])  # fmt: skip
def test_start_time_and_rotor_heat(load, time, heat):
    """Unloaded by the closed forms; loaded by quadrature (golden/drive/motor.json)."""
    asked = wanted(5.0, target_speed=0.95 * SYNCHRONOUS, stops_at_target=True, tolerance=1e-11)
    found = plain(CAGE, DriveTrain((0.0, load, 0.0), MOTOR, 0.0, DIRECT), asked)
    assert found.reason == endings.SPEED_REACHED
    assert found.end_time == pytest.approx(time, rel=1e-9)
    assert found.end[5] == pytest.approx(heat, rel=1e-9)


def test_a_choice_between_numbers_is_a_number_in_loops():
    """Not an array of one, which would cost more than all the rest of a step."""
    motor = tuple(float(each) for each in kloss_curve(SYNCHRONOUS, 95.0, 0.2))
    torque = quick(untimed(cage_torque))(0.8 * SYNCHRONOUS, 0.0, CageMotor(*motor))
    assert isinstance(torque, float)
    assert torque == pytest.approx(95.0, rel=1e-12)


def test_plugging_heats_thrice():
    """From synchronous speed to standstill against the field: ½Jω_s²(2² − 1²), whatever the motor."""
    against = (95.0, 0.2, -SYNCHRONOUS)

    def heating(speed, _time, motor):
        return kloss(speed, motor) * (motor[2] - speed)

    machine = Kernels(wheel, untimed(kloss), heating, no_brake)
    asked = wanted(20.0, speed=SYNCHRONOUS, most_reversals=1, tolerance=1e-11)
    found = plain(machine, DriveTrain((0.0, 0.0, 0.0), against, 0.0, DIRECT), asked)
    assert found.reason == endings.SWINGS
    assert found.end[5] == pytest.approx(1.5 * 0.2 * SYNCHRONOUS**2, rel=1e-9)


@pytest.mark.parametrize("load", [100.0, -100.0])
def test_rest_is_kept_between_two_torques(load):
    """η_b H ≤ T ≤ H/η_f of a load that pulls back; the other way round of one that drives."""
    gearing = stages(0.02, (10.0, 0.8, 0.75, 0.0, 0.0))
    machine = Kernels(wheel, constant, no_heat, no_brake)
    ends = sorted([load / 10 / 0.8, load / 10 * 0.75])
    for torque, sense in [(ends[0] - 1e-9, -1), (ends[0] + 1e-9, 0), (ends[1] - 1e-9, 0), (ends[1] + 1e-9, 1)]:
        drive = DriveTrain((2.0, load, 0.0), (torque,), 0.0, gearing)
        assert sense_of_start(0.0, 0.3, machine, train_of(drive, machine, False)) == sense
    found = plain(machine, DriveTrain((2.0, load, 0.0), (load / 10,), 0.0, gearing), wanted(5.0, angle=0.3))
    assert (found.reason, found.end_time, found.end[0]) == (endings.STALLED, 0.0, 0.3)


def test_self_locking_holds_without_a_motor():
    gearing = stages(0.02, (30.0, 0.3, 2 - 1 / 0.3, 0.0, 0.0))
    machine = Kernels(wheel, no_motor, no_heat, no_brake)
    for load in (50.0, -50.0):
        found = plain(machine, DriveTrain((4.0, load, 0.0), (), 0.0, gearing), wanted(5.0))
        assert found.reason == endings.AT_REST


def test_jam_is_said():
    """No acceleration satisfies the law: J 4, H −50, i 30, η_f 0.3, J_m 0.001, no torque, turning forward."""
    gearing = stages(0.001, (30.0, 0.3, 2 - 1 / 0.3, 0.0, 0.0))
    machine = Kernels(wheel, no_motor, no_heat, no_brake)
    found = plain(machine, DriveTrain((4.0, -50.0, 0.0), (), 0.0, gearing), wanted(5.0, speed=1.0))
    assert (found.reason, found.end_time) == (endings.GEARING_JAMS, 0.0)


def test_coasting_to_rest_by_dry_friction():
    """t = Jω/M, φ = Jω²/2M."""
    machine = Kernels(wheel, no_motor, no_heat, no_brake)
    found = plain(machine, DriveTrain((1.8, 0.0, 4.0), (), 0.0, DIRECT), wanted(50.0, speed=30.0))
    assert found.reason == endings.AT_REST
    assert found.end_time == pytest.approx(15.0, abs=1e-6)
    assert found.end[0] == pytest.approx(225.0, rel=1e-9)
    assert found.end[3] == pytest.approx(900.0, rel=1e-9)


def test_brake_after_a_delay_stops_and_holds():
    """A load of 5 N·m drives 0.2 + 0.8 kg·m² for 0.25 s; then a brake of 12 N·m stops it and holds."""
    machine = Kernels(wheel, no_motor, no_heat, braking)
    drive = DriveTrain((0.8, -5.0, 0.0), (), (12.0, 0.25), DIRECT)
    found = plain(machine, drive, wanted(10.0, speed=3.0, breaks=(0.25,), is_timed=True))
    fastest = 3.0 + 5.0 * 0.25
    assert found.reason == endings.AT_REST
    assert found.end_time == pytest.approx(0.25 + fastest / 7.0, abs=1e-6)
    assert found.end[4] == pytest.approx(12.0 * fastest**2 / 14.0, rel=1e-9)


def test_a_growing_torque_breaks_away():
    """3 N·m/s against a dry load of 6 N·m: it sets off at 2 s, and φ = a t³/6J from there."""
    machine = Kernels(wheel, timed_torque, no_heat, no_brake)
    found = plain(
        machine, DriveTrain((1.8, 0.0, 6.0), (3.0,), 0.0, DIRECT), wanted(4.0, is_timed=True, tolerance=1e-11)
    )
    (set_off,) = found.of_kind(endings.SET_OFF)
    assert set_off.time == pytest.approx(2.0, abs=1e-9)
    assert found.reason == endings.TIME_OUT
    assert found.end[0] == pytest.approx(3.0 * 2.0**3 / 6 / 2.0, rel=1e-8)


def test_overspeed_by_a_load_that_drives():
    machine = Kernels(wheel, no_motor, no_heat, no_brake)
    found = plain(machine, DriveTrain((1.8, -10.0, 0.0), (), 0.0, DIRECT), wanted(50.0, overspeed=20.0))
    assert found.reason == endings.OVERSPEED
    assert found.end_time == pytest.approx(4.0, abs=1e-9)


def test_slip_time_constant_is_that_of_kloss():
    speed = np.linspace(0.0, SYNCHRONOUS, 2001)
    torque = np.array([kloss(own, MOTOR) for own in speed.tolist()])
    found = slip_time_constant(np.stack([speed, speed]), np.stack([torque, 0 * torque]), np.array([2.0, 2.0]))
    assert found[0] == pytest.approx(2.0 * SYNCHRONOUS * 0.2 / (2 * 95.0), rel=1e-3)
    assert np.isinf(found[1])
    assert not is_stiff(float(found[0]), SYNCHRONOUS)
    assert is_stiff(1e-6, SYNCHRONOUS)


def test_every_reason_has_a_sentence():
    assert len(REASONS) == endings.STOPPED + 1
    assert len(set(REASONS.values())) == len(REASONS)


def test_implicit_runs_rest_and_stop_alike():
    machine = Kernels(wheel, no_motor, no_heat, no_brake)
    found = run_implicitly(machine, DriveTrain((1.8, 0.0, 4.0), (), 0.0, DIRECT), wanted(50.0, speed=30.0))
    assert found.reason == endings.AT_REST
    assert found.end_time == pytest.approx(15.0, abs=1e-6)


def falling_away(angle, _speed, _sense, numbers):
    """A wheel that the crank turns ever faster the nearer it comes to the angle 1: load −J/(1 − φ)³."""
    return numbers[0], 0.0, -numbers[0] / (1.0 - angle) ** 3 if angle < 1.0 else -np.inf, 1.0


def test_a_run_without_a_step_short_enough_says_so():
    """φ′ = 1/(1 − φ) from φ = 0: at t = 1/2 the crank is at 1, and faster than any step can follow."""
    machine = Kernels(falling_away, no_motor, no_heat, no_brake)
    asked = machine, DriveTrain((1.0,), (), 0.0, stages(0.0)), wanted(5.0, speed=1.0)
    found = plain(*asked)
    assert (found.reason, found.end_time) == (endings.NO_STEP_SHORT_ENOUGH, pytest.approx(0.5, abs=1e-6))
    assert run_implicitly(*asked).reason == endings.NO_STEP_SHORT_ENOUGH
