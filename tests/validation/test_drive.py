"""The drive of a machine file against 50-digit arithmetic and other integrators (golden/drive, reduction_gd2)."""

import json
from dataclasses import replace

import numpy as np
import pytest
from tests.reference_case import GOLDEN, ReferenceCase

import cranktrain as ct
from cranktrain.questions.drive.steady_drive import SteadyDrive
from cranktrain.questions.reduction.gear_train import lost_torque, through_stages
from cranktrain.transient.gearing import stages

BLOCK_B, STAGES, STARTUP, SIZING = (
    json.loads((GOLDEN / f"drive/{name}.json").read_text(encoding="utf-8"))
    for name in ("block_b", "stages", "startup", "sizing")
)
SWING = np.radians(60.14176317846605)
LOSSY = {"ratio": 40, "efficiency": 0.846, "efficiency_back": 0.846}
CAGE = {
    "kind": "cage",
    "curve": "kloss",
    "breakdown_torque": "95 N*m",
    "breakdown_slip": 0.2,
    "synchronous_speed": "1500 rpm",
    "inertia": "0.02 kg*m^2",
}


def table(stage=LOSSY, sense="active", **drive):
    """The tilting table, with another drive."""
    return ct.load("tilting_table").with_({"load.table.sense": sense, "drive": {"stage": [stage], **drive}})


def test_static_torque_and_gd2_of_a_loss_free_gear():
    """The four-bar with weights of the reference: motor shaft by a gear of 20."""
    from tests.validation.test_loads import machine

    case = ReferenceCase.load("reduction_gd2")
    drive = {
        "stage": [{"ratio": case.machine["gear_ratio"]}],
        "part": {
            "rotor": {"inertia": f"{case.machine['motor_rotor_inertia_kgm2']} kg*m^2"},
            "gear": {"inertia": f"{case.machine['gear_inertia_on_motor_shaft_kgm2']} kg*m^2"},
        },
    }
    result = ct.run(machine().with_({"load": {"work": machine().declared["load"]["work"]}, "drive": drive}))
    found = {
        "T_static_motor_Nm": result.static_torque[0],
        "T_static_crank_Nm": result.static_torque[1],
        "J_total_motor_kgm2": result.driven_inertia[0],
        "GD2_total_motor_kgm2": result.driven_flywheel_moment[0],
    }
    case.compare({name: np.append(values, values[..., :1]) for name, values in found.items()}, rel_to_peak=1e-9)
    assert result.rms_static_torque[0] == pytest.approx(
        case.document["expected_values"]["T_motor_rms_Nm"]["value"], rel=1e-9
    )


def test_static_torque_of_an_active_load():
    result, peaks = ct.run(table()), BLOCK_B["peaks"]["M_right"]
    assert result.largest_static_torque[0] == pytest.approx(peaks["half_k_positive"][1], rel=1e-12)
    assert result.smallest_static_torque[0] == pytest.approx(peaks["half_k_negative"][1], rel=1e-12)
    for found, half in ((result.largest_static_torque_at, "positive"), (result.smallest_static_torque_at, "negative")):
        assert found[0] == pytest.approx(BLOCK_B["peaks"]["k"][f"half_k_{half}"][0], abs=5e-6)
    assert result.mean_static_torque[0] == pytest.approx(2000 * SWING * (1 / 0.846 - 0.846) / (80 * np.pi), rel=1e-11)
    assert result.rms_static_torque[0] == pytest.approx(BLOCK_B["rms_over_turn"]["M_right"], rel=1e-11)


def test_static_torque_where_losses_always_divide():
    """The paper's (14): it returns in one half of the turn what it lost in the other."""
    dividing = ct.run(table(), step_degrees=0.25).static_motor_torque[2]
    peaks = BLOCK_B["peaks"]["M_source14"]
    expected = [peaks["half_k_positive"][1], peaks["half_k_negative"][1]]
    np.testing.assert_allclose([np.max(dividing), np.min(dividing)], expected, rtol=2e-5)  # off the grid
    assert np.mean(dividing) == pytest.approx(0.0, abs=1e-12)


def test_static_torque_with_the_same_efficiency_back():
    """Of as much friction torque both ways less comes back than of the same efficiency."""
    gear, linkage = {"ratio": 40, "efficiency": 0.94}, {"kind": "linkage", "ratio": 1, "efficiency": 0.9}
    machine = table()
    machine = machine.with_({"drive": {**machine.declared["drive"], "stage": [gear, linkage]}})
    by_friction, same, _dividing = ct.run(machine, step_degrees=0.25).static_motor_torque
    peaks = BLOCK_B["peaks"]["M_right"]
    expected = [peaks["half_k_positive"][1], peaks["half_k_negative"][1]]
    np.testing.assert_allclose([np.max(same), np.min(same)], expected, rtol=2e-5)  # off the grid
    share = (2 - 1 / 0.94) * (2 - 1 / 0.9) / 0.846
    np.testing.assert_allclose(by_friction, np.where(same > 0, same, share * same), rtol=1e-14)


def test_static_torque_of_dry_friction_never_changes_its_sign():
    result = ct.run(table(sense="resisting"))
    assert result.largest_static_torque[0] == pytest.approx(-BLOCK_B["peaks"]["M_source14"]["half_k_negative"][1])
    assert result.smallest_static_torque[0] == pytest.approx(0.0, abs=1e-9)
    assert result.mean_static_torque[0] == pytest.approx(4000 * SWING / 0.846 / (80 * np.pi), rel=1e-11)
    assert result.rms_static_torque[0] == pytest.approx(BLOCK_B["rms_over_turn"]["M_right_reactive"], rel=1e-11)
    np.testing.assert_allclose(result.half_period_length, [360.0])
    np.testing.assert_allclose(result.half_period_work, [4000 * SWING / 0.846], rtol=1e-12)


def test_half_periods_lie_between_the_dead_positions():
    """Their lengths are those of the rocker's ways; works are closed forms of its swing."""
    result, zeros = ct.run(table()), BLOCK_B["zero_crossings_deg"]
    np.testing.assert_allclose(result.half_period_start, [zeros["extended"], zeros["folded"]], atol=1e-9)
    first = zeros["folded"] - zeros["extended"]
    np.testing.assert_allclose(result.half_period_length, [first, 360 - first], atol=1e-9)
    np.testing.assert_allclose(result.half_period_work, [2000 * SWING / 0.846, -2000 * SWING * 0.846], rtol=1e-12)
    peaks = BLOCK_B["peaks"]["M_right"]
    np.testing.assert_allclose(
        result.half_period_peak, [peaks["half_k_positive"][1], peaks["half_k_negative"][1]], rtol=1e-12
    )


def test_flywheel_moment_of_the_paper():
    """(GD²)₀ by its parts, and with rod and crank on top of it the humps."""
    parts = {"all": {"flywheel_moment": "2.4 kg*m^2"}}
    result = ct.run(table(part=parts), step_degrees=0.25)
    assert result.gear_flywheel_moment[0] == pytest.approx(2.4, rel=1e-14)
    assert ct.run("tilting_table").gear_flywheel_moment[0] == pytest.approx(2.4, rel=1e-14)
    peak = BLOCK_B["peaks"]["GD2_full"]["half_k_negative"][1]
    assert np.max(result.driven_flywheel_moment[0]) == pytest.approx(peak, rel=1e-7)
    mean = BLOCK_B["mean_over_turn"]["GD2_full"]
    assert np.mean(result.driven_flywheel_moment[0]) == pytest.approx(mean, rel=1e-12)


@pytest.mark.parametrize("case", STAGES["cases"], ids=lambda case: case["name"])
def test_two_stages(case):
    gearing = stages(0.02, (3.0, 0.95, 0.95, 0.0, 0.9), (40 / 3, 0.94, 0.94, 0.0, 0.0))
    torque, inertia, load = (np.array([case[key]]) for key in ("T_motor", "J", "H"))
    if case["omega"] < 0:
        pytest.skip("turns back")
    found = through_stages(torque, inertia, load, gearing)
    expected = [case["belt_slow_side_torque"], case["crank_torque"]]
    np.testing.assert_allclose(found.acceleration, [case["crank_acceleration"]], rtol=1e-12)
    np.testing.assert_allclose(found.outputs[:, 0], expected, rtol=1e-12)
    np.testing.assert_allclose(lost_torque(found.outputs, gearing) * case["omega"], [case["power_lost"]], rtol=1e-12)


@pytest.mark.parametrize(("name", "stage"), [("A", {"ratio": 40}), ("B", LOSSY)])
def test_steady_cycles(name, stage):
    """Shooting in angle against LSODA in time; the reference's extremes are those on a grid that ours has too."""
    result, expected = ct.run(table(stage, motor=CAGE)), STARTUP[f"periodic_{name}"]
    assert result.cycle_time == pytest.approx(expected["period_s"], rel=1e-11)
    assert result.mean_motor_speed == pytest.approx(40 * expected["mean_speed"], rel=1e-11)
    assert result.rms_motor_torque == pytest.approx(expected["T_motor_rms"], rel=1e-10)
    assert result.mean_motor_torque == pytest.approx(expected["T_motor_mean"], rel=1e-9)
    np.testing.assert_allclose(
        [np.min(result.drive_speed), np.max(result.drive_speed)], [expected["w_min"], expected["w_max"]], rtol=1e-11
    )


def test_a_motor_of_the_catalogue_on_dry_friction():
    result, expected = (
        ct.run(table(sense="resisting", motor={"kind": "cage", "size": "4 kW"})),
        SIZING["sizing"]["periodic"],
    )
    assert result.cycle_time == pytest.approx(expected["period"], rel=1e-9)
    assert result.rms_motor_torque == pytest.approx(expected["T_rms_time"], rel=1e-9)
    assert result.mean_motor_torque == pytest.approx(expected["T_mean_time"], rel=1e-9)
    # its extremes are those of a grid
    assert result.largest_motor_torque == pytest.approx(expected["T_max"], rel=1e-4)
    assert result.smallest_motor_torque == pytest.approx(expected["T_min"], abs=1e-3)


def test_a_stiff_motor():
    """Slip of 0.3 %: the motor hardly slows down, and gives what a constant speed asks for; slip constant 0.07 ms."""
    stiff = {**CAGE, "breakdown_torque": "6400 N*m"}
    result = ct.run(table({"ratio": 40}, motor=stiff))
    assert result.drive_fluctuation < 1e-3
    constant = ct.run(table({"ratio": 40}).with_({"shaft.main.speed": f"{result.mean_motor_speed / 40} rad/s"}))
    asked = constant.driving_torque / 40
    np.testing.assert_allclose(result.motor_torque, asked, atol=0.02 * np.max(np.abs(asked)))
    assert all(np.all(check.passed) for check in result.checks)


def test_the_check_of_energy_can_fail():
    """With a speed that is not the solution's the works no longer balance."""
    from cranktrain.questions.drive.steady_drive import _residual

    result = ct.run(table(motor=CAGE))
    found = next(one for one in result.outcomes if isinstance(one, SteadyDrive)).running[0]
    assert found is not None
    turning = _turning(result)
    assert _residual(turning.at(found.mesh.nodes), found) < 1e-12
    disturbed = replace(found, departure=found.departure + 5e-4 * found.speed**2 * np.sin(found.mesh.nodes))
    assert _residual(turning.at(found.mesh.nodes), disturbed) > 1e-9


def _turning(result):
    """Machine, motor and gearing of the first design."""
    from cranktrain.analysis.parts import parts_of
    from cranktrain.layout.drive.declared import DeclaredDrive
    from cranktrain.motors import DeclaredMotor
    from cranktrain.questions.drive.steady_turn import DriveInTurn
    from cranktrain.questions.reduction.machines import ReducedMachines

    parts = parts_of([result.machines[0]], step=np.radians(1))
    drive, motor = parts[DeclaredDrive], parts[DeclaredMotor]
    machines = next(one for one in result.outcomes if isinstance(one, ReducedMachines))
    return DriveInTurn(machines.each[0], motor, 0, drive.gearings[0])
