"""The law of gearing by the torque that each stage passes on (golden/drive/stages.json, power_sign.json)."""

import json

import numpy as np
import pytest
from tests.reference_case import GOLDEN
from tests.starts import heavy_drive, kernels

from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms.equation import equation_of_motion
from cranktrain.transient.gearing import (
    NONE,
    SEVERAL,
    UNIQUE,
    acceleration,
    accelerations,
    always_moves,
    equal_friction,
    input_torque,
    one_stage_acceleration,
    overall_ratio,
    stages,
    turning_inertia,
    worm_efficiencies,
)
from cranktrain.transient.law import accelerated, in_one_stage, lines_of

STAGES = json.loads((GOLDEN / "drive/stages.json").read_text(encoding="utf-8"))
POWER_SIGN = json.loads((GOLDEN / "drive/power_sign.json").read_text(encoding="utf-8"))
TWO = stages(0.02, (3.0, 0.95, 0.95, 0.0, 0.9), (40 / 3, 0.94, 0.94, 0.0, 0.0))


@pytest.mark.parametrize("case", STAGES["cases"], ids=lambda case: case["name"])
def test_several_stages(case):
    sense = np.sign(case["omega"])
    found, lost, count = acceleration(case["T_motor"], sense, case["J"], case["H"], TWO)
    assert count == UNIQUE
    assert found == pytest.approx(case["crank_acceleration"], rel=1e-13)
    assert lost * case["omega"] == pytest.approx(case["power_lost"], rel=1e-13)


@pytest.mark.parametrize("case", STAGES["worm"], ids=lambda case: f"{case['lead_deg']}/{case['friction_angle_deg']}")
def test_worm(case):
    forward, backward = worm_efficiencies(*np.radians([case["lead_deg"], case["friction_angle_deg"]]))
    np.testing.assert_allclose([forward, backward], [case["eta_forward"], case["eta_back"]], rtol=1e-12)
    assert equal_friction(forward) == pytest.approx(case["two_minus_inverse"], rel=1e-12)


@pytest.mark.parametrize("case", STAGES["self_locking"], ids=["motor strong enough", "motor too small"])
def test_irreversible_gearing_has_none_one_or_two(case):
    gearing = stages(case["Jm"], (case["n"], case["eta_f"], case["eta_b"], 0.0, 0.0))
    assert always_moves(np.array([case["J"]]), gearing) == (case["slope_back"] > 0)
    for solution in case["solutions"]:
        expected = sorted(solution["accelerations"], reverse=True)
        found = accelerations(solution["T_motor"], case["omega"], case["J"], case["H"], gearing)
        np.testing.assert_allclose(found, expected, rtol=1e-12)
        one, _, count = acceleration(solution["T_motor"], case["omega"], case["J"], case["H"], gearing)
        assert count == {0: NONE, 1: UNIQUE, 2: SEVERAL}[len(expected)]
        assert np.isnan(one) if count else one == found[0]


@pytest.mark.parametrize("case", POWER_SIGN, ids=lambda case: f"{case['load']} at {case['crank_speed']}")
def test_mean_motor_torque_at_constant_speed(case):
    """Only the sign of the transmitted torque makes the motor's mean power that of the losses."""
    drive = heavy_drive(95.0, load=-case["load"])
    mechanism = drive.machine
    phi = np.linspace(0.0, 2 * np.pi, 7200, endpoint=False)
    reduced = equation_of_motion(KINDS.named("crank_rocker"))(
        phi, mechanism.geometry, mechanism.bodies, mechanism.load.along, mechanism.gravity
    )
    level = 0.5 * reduced.inertia.first * case["crank_speed"] ** 2 - reduced.load
    torque = input_torque(level, np.array(1.0), 40.0, 0.846, 0.846)
    assert np.mean(torque) == pytest.approx(case["mean_right"], rel=1e-5)
    assert np.sqrt(np.mean(torque**2)) == pytest.approx(case["rms_right"], rel=1e-5)
    lost = np.mean(torque) * 40 * case["crank_speed"]
    assert lost == pytest.approx(case["loss_right_W"], rel=1e-5)


def test_one_stage_of_arrays_is_the_same():
    generator = np.random.default_rng(17)
    torque, load = generator.uniform(-50, 50, (2, 500)) * [[1.0], [40.0]]
    sense = generator.choice([-1.0, 1.0], 500)
    gearing = stages(0.02, (40.0, 0.846, equal_friction(0.846), 0.0, 1.5))
    found = one_stage_acceleration(torque, sense, np.full(500, 18.0), load, gearing)
    each = [acceleration(*values, gearing)[0] for values in zip(torque, sense, np.full(500, 18.0), load, strict=True)]
    np.testing.assert_allclose(found, each, rtol=1e-12)


def test_drag_is_taken_at_the_input_whatever_is_passed_on():
    gearing = stages(0.0, (10.0, 1.0, 1.0, 2.0, 0.0))
    assert acceleration(2.0, 1.0, 5.0, 0.0, gearing)[:2] == (0.0, 20.0)
    assert acceleration(2.0, -1.0, 5.0, 0.0, gearing)[0] == pytest.approx(8.0)


def test_inertia_and_ratio_of_the_train():
    assert overall_ratio(TWO) == pytest.approx(40.0)
    assert turning_inertia(TWO) == pytest.approx(0.02 * 1600 + 0.9 * (40 / 3) ** 2)


def test_kernels_are_made_once():
    assert kernels() == kernels()


@pytest.mark.parametrize("n", [0, 1, 2, 3])
@pytest.mark.parametrize("is_irreversible", [False, True])
def test_lines_of_a_gearing_say_what_the_stages_say_one_by_one(n, is_irreversible):
    """Where none or several accelerations satisfy the law neither gives one."""
    generator = np.random.default_rng(n)
    n_jammed = 0
    for _ in range(200):
        back = generator.uniform(-0.5 if is_irreversible else 0.2, 1.0, n)
        each = zip(
            generator.uniform(1, 30, n),
            generator.uniform(0.3, 1.0, n),
            back,
            *generator.uniform(0, 2, (2, n)),
            strict=True,
        )
        gearing = stages(generator.choice([0.0, 0.05]), *each)
        given = (
            generator.normal(0, 50),
            generator.choice([-1.0, 1.0]),
            generator.uniform(0.1, 9),
            generator.normal(0, 300),
        )
        found, lost, count = acceleration(*given, gearing)
        grown, taken = accelerated(*given, in_one_stage(gearing), lines_of(gearing).tolist())
        n_jammed += count != UNIQUE
        if count != UNIQUE:
            assert np.isnan([grown, taken]).all()
            continue
        assert grown == pytest.approx(found, rel=1e-10, abs=1e-10)
        assert taken == pytest.approx(lost, rel=1e-10, abs=1e-9)
    assert (n_jammed > 0) == (is_irreversible and n > 0)


def test_a_pattern_in_which_nothing_accelerates_fits_nowhere():
    """One of i = 2, η = 1/3, J_m i² = J: pulled back, −J + J_m i² = 0. Driven, ε = (iM − 3Q)/(J_m i² + 3J)."""
    gearing = stages(1.0, (2.0, 1 / 3, -1.0, 0.0, 0.0))
    rows = lines_of(gearing).tolist()
    grown, taken = accelerated(1.0, 1.0, 4.0, 3.0, in_one_stage(gearing), rows)
    assert grown == pytest.approx(-7 / 16) and taken == pytest.approx(2 * (4 * grown + 3.0))
    jammed = accelerated(1.0, 1.0, 4.0, -3.0, in_one_stage(gearing), rows)  # driven, ε = 11/16: Jε + Q is less than 0
    assert np.isnan(jammed).all()
