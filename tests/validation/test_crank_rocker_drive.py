"""[gandzha] on a crank-rocker's drive, against 50-digit peaks, tables of two derivations, and equilibrium of bodies.

`tests/golden/drive/block_b*` and `friction.csv` are stored as they came. Their means are sums over points of the crank
angle, so they hold to some 1e-7; peaks, zeros and tables to rounding.
"""

import csv
import json
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import root
from tests.reference_case import ReferenceCase

import cranktrain as ct
from cranktrain.mechanisms.crank_rocker.kinematics import crank_rocker
from cranktrain.plans.machine_drive import drive_data
from cranktrain.texts.crank_rocker_drive import centre_distances, directions, efficiency
from cranktrain.texts.drive_curves import carried, curve_facts, dead_positions, drive_curves, integral, values_at
from cranktrain.texts.drive_errata import drive_example
from cranktrain.texts.drive_table import read_drive
from cranktrain.texts.drive_verdicts import absurdities, pin_friction, swing
from cranktrain.texts.friction_circles import FrictionRadii, rubbing_links

GOLDEN = Path(__file__).parents[1] / "golden/drive"
EXPECTED = json.loads((GOLDEN / "block_b.json").read_text(encoding="utf-8"))
DRIVE = drive_example()
CURVES = {(one.number, one.verdict, one.name): one for one in drive_curves(DRIVE)}
LOAD = 2000.0
"""Q r₁. [N·m]"""
PINS = {"shaft": 0.07, "crank_pin": 0.05, "rocker_pin": 0.05, "pivot": 0.06}


def table(name):
    lines = [line for line in (GOLDEN / name).read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    rows = list(csv.reader(lines))
    columns = np.array(rows[1:], dtype=float).T
    return dict(zip(rows[0], columns, strict=True))


NAMES = {
    "k": ("(10)", "right", "AC/BC"),
    "M_right": ("(14)", "right", "at the motor, active load, efficiency back the same as forward"),
    "M_source14": ("(14)", "source", "at the motor, η always dividing"),
    "M_source13": ("(13)", "source", "at the crank, with r₁ for r"),
    "M_KP": ("(14)", "refuted", "at the motor, by Kunitsky and Popov"),
    "M_right_reactive": ("(14)", "right", "at the motor, dry friction"),
    "GD2_right": ("(20)", "right", "at the motor, with i² and no η"),
    "GD2_full": ("(20)", "right", "at the motor, rod and crank with their masses"),
    "GD2_source_printed": ("(20)", "source", "at the motor, with η and i"),
    "GD2_KP": ("(20)", "refuted", "at the motor, by Kunitsky and Popov"),
}


@pytest.mark.parametrize("name", NAMES)
def test_curves_over_the_turn(name):
    found = table("block_b_curves.csv")
    values = values_at(DRIVE, CURVES[NAMES[name]], np.deg2rad(found["alpha_deg"]))
    assert values == pytest.approx(found[name], rel=1e-12, abs=1e-11)


@pytest.mark.parametrize("name", sorted(NAMES.keys() & EXPECTED["peaks"].keys()))
def test_peaks(name):
    """The stored angles are of a search by values, good to 1e-6°; the values to rounding."""
    facts = curve_facts(DRIVE, CURVES[NAMES[name]])
    for peak, half in ((facts.advancing, "half_k_positive"), (facts.returning, "half_k_negative")):
        angle, value = EXPECTED["peaks"][name][half]
        assert peak.value == pytest.approx(value, rel=1e-13)
        assert np.degrees(peak.angle) == pytest.approx(angle, abs=2e-5)


def test_peaks_of_the_ratio_to_fifty_digits():
    facts = curve_facts(DRIVE, CURVES[NAMES["k"]])
    for peak, half in ((facts.advancing, "half_k_positive"), (facts.returning, "half_k_negative")):
        angle, value = map(float, EXPECTED["peaks_k_50digit"][half])
        assert (np.degrees(peak.angle), peak.value) == pytest.approx((angle, value), rel=1e-13)


@pytest.mark.parametrize("name", sorted(NAMES.keys() & EXPECTED["mean_over_turn"].keys()))
def test_means(name):
    facts = curve_facts(DRIVE, CURVES[NAMES[name]])
    assert facts.mean == pytest.approx(EXPECTED["mean_over_turn"][name], rel=2e-7, abs=1e-12)
    if name in EXPECTED["rms_over_turn"]:
        assert facts.rms == pytest.approx(EXPECTED["rms_over_turn"][name], rel=2e-7)


def test_dead_positions_and_swing():
    """To 50 digits."""
    dead = dead_positions(DRIVE.geometry)
    found = np.degrees([dead.extended, dead.folded, swing(DRIVE)])
    assert found == pytest.approx([31.7525344485698775, 214.622161839731823, 60.14176317846605], rel=1e-14)
    for curve in CURVES.values():
        if curve.unit == "N*m" and "flat" not in curve.name:
            assert values_at(DRIVE, curve, np.array([dead.extended, dead.folded])) == pytest.approx(0.0, abs=1e-10)


def test_work_of_a_turn_in_closed_form():
    """Q r₁ times the swing there and back: with an active load the losses of both ways are left, with friction all."""
    eta, gamma = float(efficiency(DRIVE.train)), np.radians(60.14176317846605)
    work = {name: curve_facts(DRIVE, CURVES[NAMES[name]]).work for name in NAMES if name.startswith("M_")}
    assert eta == pytest.approx(0.846, rel=1e-15)
    assert work["M_right"] == pytest.approx(LOAD * gamma * (1 / eta - eta), rel=1e-12)
    assert work["M_right_reactive"] == pytest.approx(2 * LOAD * gamma / eta, rel=1e-12)
    assert work["M_source14"] == pytest.approx(0.0, abs=1e-9)
    assert (round(work["M_right"], 3), round(work["M_right_reactive"], 3)) == (705.449, 4962.987)
    by_law = curve_facts(
        DRIVE, CURVES["(14)", "right", "at the motor, active load, friction torque the same both ways"]
    )
    back = (2 - 1 / 0.94) * (2 - 1 / 0.9)
    assert by_law.work == pytest.approx(LOAD * gamma * (1 / eta - back), rel=1e-12)
    assert (round(by_law.work, 3), round(by_law.returning.value, 3)) == (734.522, -24.981)


def test_absurdities():
    found = absurdities(DRIVE)
    # A trapezium rule over a turn of a smooth periodic function converges as fast as rounding lets it.
    angle = np.arange(4096) * (2 * np.pi / 4096)
    at = directions(angle, DRIVE.geometry)
    product = np.sin(at.rocker - at.rod) * np.sin(at.crank - at.rod)
    assert found.refuted_work == pytest.approx(4000 * 0.25 * 2 * np.pi * np.mean(product), rel=1e-12)
    assert round(found.refuted_work, 1) == 220.4
    assert found.least_moment == pytest.approx(2.373040486621799, rel=1e-13)
    assert np.degrees(found.below) == pytest.approx(360 - 214.622161839731823 + 31.7525344485698775, rel=1e-13)
    # the cosine rule with the crank along the ground line: cos μ = (l² + r₁² − (d − r)²)/(2 l r₁) = 0.625
    assert found.least_square == pytest.approx(1 - 0.625**2, rel=1e-13)
    lost = 1 / 0.846 - (2 - 1 / 0.94) * (2 - 1 / 0.9)
    assert found.lost == pytest.approx(2000 * np.radians(60.14176317846605) * lost, rel=1e-12)
    assert (found.too_large, found.too_long) == pytest.approx((40 / 0.846, 2.0), rel=1e-15)


def test_reduced_inertia():
    found = table("block_b_curves.csv")
    angle = np.deg2rad(found["alpha_deg"])
    value, slope = carried(DRIVE, "inertia", angle)
    assert value == pytest.approx(found["J_crank"], rel=1e-12)
    assert slope == pytest.approx(found["dJ_crank"], rel=1e-11, abs=1e-11)


def test_centre_lies_on_crank_and_rocker():
    """C by its distances from both pins, along both links, is one point; AC/BC is (10)."""
    angle = np.deg2rad(np.array([60.0, 75.0, 130.0, 300.0]))
    motion, at = crank_rocker(angle, DRIVE.geometry), directions(angle, DRIVE.geometry)
    ac, bc = centre_distances(DRIVE.geometry.rod_length, at)
    along_crank = (motion.pin.x.value + bc * np.cos(at.crank), motion.pin.y.value + bc * np.sin(at.crank))
    along_rocker = (motion.joint.x.value + ac * np.cos(at.rocker), motion.joint.y.value + ac * np.sin(at.rocker))
    assert np.array(along_crank) == pytest.approx(np.array(along_rocker), rel=1e-11)
    assert ac / bc == pytest.approx(values_at(DRIVE, CURVES[NAMES["k"]], angle), rel=1e-12)


def test_friction_over_the_turn():
    found = table("friction.csv")
    links = rubbing_links(np.deg2rad(found["alpha_deg"]), DRIVE.geometry, np.array(LOAD), DRIVE.friction)
    assert links.rod_force == pytest.approx(found["rod_force"], rel=1e-13)
    assert links.torque == pytest.approx(found["T_friction"], rel=1e-12, abs=1e-10)


def test_facts_of_friction():
    """Efficiencies as stored are sums over 36 000 middles of steps; the integrals differ in the seventh figure."""
    expected, found = EXPECTED["friction"], pin_friction(DRIVE, DRIVE.friction)
    middles = (np.arange(36000) + 0.5) * (2 * np.pi / 36000)
    torque = rubbing_links(middles, DRIVE.geometry, np.array(LOAD), DRIVE.friction).torque
    ideal = LOAD * crank_rocker(middles, DRIVE.geometry).rocker.angle.first
    driving = np.sum(ideal[ideal > 0]) / np.sum(torque[ideal > 0])
    driven = np.sum(torque[ideal < 0]) / np.sum(ideal[ideal < 0])
    assert (driving, driven) == pytest.approx(
        (expected["mean_eta_motoring"], expected["mean_eta_backdriving"]), rel=1e-13
    )
    assert (found.driving, found.driven) == pytest.approx((driving, driven), rel=1e-6)
    assert (found.largest, found.smallest) == pytest.approx((expected["max_torque"], expected["min_torque"]), rel=1e-9)
    assert np.round(found.at_dead, 1).tolist() == [59.1, 41.7]
    edges = np.degrees([*found.locked[0], *found.locked[1]]) % 360
    assert np.round(edges, 3).tolist() == [214.622, 218.05, 29.664, 31.753]


@pytest.mark.parametrize("degrees", [20.0, 35.0, 60.0, 120.0, 190.0, 240.0, 300.0, 345.0])
def test_friction_by_equilibrium_of_three_bodies(degrees):
    """Nine equations for crank, rod and rocker: four pin forces, each with a moment of friction, and the torque."""
    angle = np.array([np.deg2rad(degrees)])
    geometry, (rho_o, rho_b, rho_a, rho_1) = DRIVE.geometry, map(float, DRIVE.friction)
    motion = crank_rocker(angle, geometry)
    pin = np.array([motion.pin.x.value[0], motion.pin.y.value[0]])
    joint = np.array([motion.joint.x.value[0], motion.joint.y.value[0]])
    rod, rocker = (float(link.angle.first[0]) for link in (motion.rod, motion.rocker))
    pivot = np.array([0.8, 0.0])
    found = rubbing_links(angle, geometry, np.array(LOAD), DRIVE.friction)

    def moment(arm, force):
        return arm[0] * force[1] - arm[1] * force[0]

    def left_over(unknown):
        """Forces on the crank at O, on the rod at B and A, on the rocker at O₁; moments of friction likewise."""
        o, b, a, o1, torque = unknown[:2], unknown[2:4], unknown[4:6], unknown[6:8], unknown[8]
        size = [np.hypot(*force) for force in (o, b, a, o1)]
        at_o, at_b = -rho_o * size[0], -rho_b * size[1] * np.sign(rod - 1)
        at_a, at_1 = -rho_a * size[2] * np.sign(rod - rocker), -rho_1 * size[3] * np.sign(rocker)
        return [
            *(o - b),
            torque + at_o - at_b + moment(pin, -b),
            *(a + b),
            at_b + at_a + moment(joint - pin, a),
            *(o1 - a),
            -LOAD + at_1 - at_a + moment(joint - pivot, -a),
        ]

    force = float(found.rod_force[0]) * (joint - pin) / 0.7
    start = np.array([*-force, *-force, *force, *force, 0.0])
    solutions = [root(left_over, sign * start, tol=1e-13) for sign in (1.0, -1.0)]
    settled = [one for one in solutions if np.max(np.abs(left_over(one.x))) < 1e-7]
    assert any(one.x[8] == pytest.approx(float(found.torque[0]), abs=1e-8) for one in settled)
    assert any(np.hypot(*one.x[4:6]) == pytest.approx(float(found.rod_force[0]), rel=1e-10) for one in settled)


def test_friction_keeps_the_balance_of_power():
    """T = M_L α₁′ + F (ρ_O + ρ_B |1 − β′| + ρ_A |β′ − α₁′| + ρ₁ |α₁′|), for every radian of the crank."""
    angle = np.deg2rad(np.arange(1.0, 360.0, 7.0))
    motion = crank_rocker(angle, DRIVE.geometry)
    rod, rocker = motion.rod.angle.first, motion.rocker.angle.first
    found = rubbing_links(angle, DRIVE.geometry, np.array(LOAD), DRIVE.friction)
    radii = DRIVE.friction
    lost = found.rod_force * (
        radii.shaft + radii.crank_pin * abs(1 - rod) + radii.rocker_pin * abs(rod - rocker) + radii.pivot * abs(rocker)
    )
    assert found.torque == pytest.approx(LOAD * rocker + lost, abs=1e-9)


def test_links_lock_in_thick_pins():
    """Friction circles wider than the rod's arm about the pivot: no force in the rod can hold the load."""
    thick = FrictionRadii(*(np.array(0.3) for _pin in PINS))
    angle = np.deg2rad(np.arange(0.0, 360.0, 5.0))
    assert np.any(np.isnan(rubbing_links(angle, DRIVE.geometry, np.array(LOAD), thick).torque))
    assert pin_friction(DRIVE, thick) is None


def test_quadrature_has_converged():
    """Twice as many pieces change no mean by more than rounding."""
    dead = dead_positions(DRIVE.geometry)
    for curve in CURVES.values():
        for half in (dead.advance, dead.back):
            whole, fine = (
                integral(lambda angle, curve=curve: values_at(DRIVE, curve, angle), half, n) for n in (8, 16)
            )
            assert whole == pytest.approx(fine, rel=1e-12, abs=1e-12)


def test_reduction_case():
    """Loss-free gear of 20, the table's GD² of crank-rocker, gear and rotor, from the machine's own bodies."""
    case = ReferenceCase.load("reduction_gd2")
    given = case.document["machine"]
    masses = {
        part: {
            "mass": f"{given[f'{name}_mass_kg']} kg",
            "along": f"{given[f'{name}_com_m'][0]} m",
            "across": f"{given[f'{name}_com_m'][1]} m",
            "flywheel_moment": f"{4 * given[f'{name}_inertia_about_com_kgm2']!r} kgf*m^2",
        }
        for part, name in (("crank", "crank"), ("rod", "coupler"), ("rocker", "rocker"))
    }
    machine = ct.Machine(
        mechanism={
            "kind": "crank_rocker",
            "crank_radius": f"{given['crank_length_m']} m",
            "rod_length": f"{given['coupler_length_m']} m",
            "rocker_length": f"{given['rocker_length_m']} m",
            "ground_length": f"{given['ground_length_m']} m",
        },
        masses=masses,
    )
    moment = 4 * (given["motor_rotor_inertia_kgm2"] + given["gear_inertia_on_motor_shaft_kgm2"])
    drive = read_drive(
        drive_data(machine) | {"i": 20, "eta_p": 1.0, "eta_sh": 1.0, "Q": "0 N", "GD2_0": f"{moment!r} kg*m^2"}
    )
    angle = case.crank_angle
    curve = next(one for one in drive_curves(drive) if one.carrier == "inertia")
    assert values_at(drive, curve, angle) == pytest.approx(case.column("GD2_total_motor_kgm2"), rel=1e-11)
    slope = carried(drive, "inertia", angle)[1]
    assert slope == pytest.approx(case.column("dJ_crank_dphi_kgm2_per_rad"), rel=1e-9, abs=1e-11)
