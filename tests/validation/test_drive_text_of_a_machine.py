"""(14) and (20) of the text on the crank drive, of a machine: what `run` says of it, whatever its stages lose."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.cli.textbook.drive import read_drive_file
from cranktrain.plans.machine_drive import machine_drive
from cranktrain.texts.drive_curves import curve_facts, drive_curves, values_at

OWN = "at the motor, active load, by the stages of [drive]"


def curve(drive, number, name):
    return next(one for one in drive_curves(drive) if (one.number, one.name) == (number, name))


def with_stages(stages):
    """The tilting table behind other stages."""
    table = ct.load("tilting_table")
    return table.with_({"drive": {**table.declared["drive"], "stage": stages}})


def random_stage(rng):
    ratio = float(rng.uniform(1.0, 12.0))
    drag = f"{float(rng.choice([0.0, rng.uniform(0.0, 3.0)]))!r} N*m"
    kinds = {
        "alike": {"ratio": ratio, "efficiency": float(rng.uniform(0.6, 1.0)), "drag": drag},
        "back": {
            "ratio": ratio,
            "efficiency": float(rng.uniform(0.4, 1.0)),
            "efficiency_back": float(rng.uniform(-0.5, 1.0)),
            "drag": drag,
        },
        "worm": {
            "kind": "worm",
            "ratio": ratio,
            "lead_angle": f"{float(rng.uniform(3.0, 25.0))!r} deg",
            "friction_angle": f"{float(rng.uniform(1.0, 8.0))!r} deg",
            "drag": drag,
        },
        "linkage": {"kind": "linkage", "ratio": 1, "efficiency": float(rng.uniform(0.7, 1.0))},
        "belt": {"kind": "belt", "ratio": ratio, "efficiency": float(rng.uniform(0.85, 1.0)), "drag": drag},
    }
    return kinds[str(rng.choice(list(kinds)))]


@pytest.mark.parametrize("seed", range(30))
def test_torque_and_flywheel_moment_are_those_of_a_run(seed):
    rng = np.random.default_rng(seed)
    machine = with_stages([random_stage(rng) for _stage in range(rng.integers(1, 4))])
    drive, result = machine_drive(machine), ct.run(machine)
    torque, moment = curve(drive, "(14)", OWN), curve(drive, "(20)", "at the motor, rod and crank with their masses")
    for own, name in ((torque, "static_torque"), (moment, "driven_flywheel_moment")):
        found, wanted = values_at(drive, own, np.ravel(result.grid.angle)), getattr(result, name)[0]
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-12 * np.max(np.abs(wanted)))
    facts = curve_facts(drive, torque)
    size = float(result.rms_static_torque[0])
    assert (facts.mean, facts.rms) == pytest.approx((float(result.mean_static_torque[0]), size), abs=1e-12 * size)
    assert facts.advancing.value == pytest.approx(float(result.largest_static_torque[0]), abs=1e-12 * size)


# Peak and least of the tilting table with other stages, by equal friction torque, by efficiencies back that are given,
# by a self-locking worm's angles, with drag: as they were asked for and checked apart from this program.
OTHERS = {
    "as it is": ({}, 29.86, -24.98),
    "back": ({"efficiency": 0.6, "efficiency_back": 0.2}, 46.78, -5.34),
    "worm": ({"lead_angle": "5 deg", "friction_angle": "6 deg"}, 62.36, 5.32),
    "drag": ({"efficiency": 0.94, "drag": "5 N*m"}, 34.86, -19.98),
}


@pytest.mark.parametrize(("gear", "advancing", "returning"), OTHERS.values(), ids=list(OTHERS))
def test_other_gears(gear, advancing, returning):
    stages = [{"ratio": 40, **(gear or {"efficiency": 0.94})}, {"kind": "linkage", "ratio": 1, "efficiency": 0.9}]
    drive = machine_drive(with_stages(stages))
    facts = curve_facts(drive, curve(drive, "(14)", OWN))
    assert (round(facts.advancing.value, 2), round(facts.returning.value, 2)) == (advancing, returning)


def test_linkage_is_told_from_gears():
    """(12) at 60° has η_ш of the linkage alone, (13) too, and the peak of (19)."""
    drive = machine_drive(ct.load("tilting_table"))
    at = np.array([np.pi / 3])
    by_number = {one.number: one for one in drive_curves(drive) if one.verdict == "source"}
    values = [float(values_at(drive, by_number[number], at)[0]) for number in ("(12)", "(13)")]
    assert np.round(values, 2).tolist() == [697.87, 1395.74]
    assert round(curve_facts(drive, by_number["(19)"]).returning.value, 3) == 80.107


def test_symbols_that_are_typed_stand_for_the_stages():
    drive = read_drive_file("tilting_table", ["eta_p=0.8"]).drive
    assert (float(drive.train.gear_efficiency), drive.train.is_of_machine) == (0.8, False)


def test_each_law_of_losses_has_its_range():
    """Peak and least at the motor: friction torque alike both ways, efficiency alike both ways, and always dividing."""
    found = ct.run("tilting_table", quantities=("largest_static_motor_torque", "smallest_static_motor_torque"))
    assert found.largest_static_motor_torque == pytest.approx([29.85978127] * 3, abs=5e-9)
    assert found.smallest_static_motor_torque[1:] == pytest.approx([-25.39693349, -35.48465242], abs=5e-9)
    friction_alike = -35.48465242 * 0.94 * 0.9 * (2 - 1 / 0.94) * (2 - 1 / 0.9)
    assert found.smallest_static_motor_torque[0] == pytest.approx(friction_alike, abs=5e-9)


@pytest.mark.parametrize("seed", range(5))
def test_ranges_of_laws_hold_their_curves(seed):
    rng = np.random.default_rng(seed)
    machine = with_stages([random_stage(rng) for _stage in range(2)])
    found = ct.run(
        machine,
        step_degrees=0.25,
        quantities=("static_motor_torque", "largest_static_motor_torque", "smallest_static_motor_torque"),
    )
    curves = found.static_motor_torque
    size = np.max(np.abs(curves))
    for ends, extreme in ((found.largest_static_motor_torque, np.max), (found.smallest_static_motor_torque, np.min)):
        np.testing.assert_allclose(ends, extreme(curves, axis=-1), rtol=0, atol=1e-4 * size)
    assert np.all(found.largest_static_motor_torque >= np.max(curves, axis=-1) - 1e-12 * size)
    assert np.all(found.smallest_static_motor_torque <= np.min(curves, axis=-1) + 1e-12 * size)
