"""P, N, S, K, T, exact harmonics of inertia, and rods replaced by masses, against closed forms in 30 to 60 digits.

Harmonics: hypergeometric series, equal to quadrature to 1e-30. Rods: by multibody equations in 60 digits.
"""

import json

import numpy as np
import pytest
from tests.reference_case import GOLDEN

from cranktrain.linkage import Crank
from cranktrain.linkage.forces import NO_FRICTION, Body, Conditions, Drive, Gravity, crank_link
from cranktrain.mechanisms.on_crank import force_on_slider
from cranktrain.mechanisms.slider_crank.forces import DYNAMICS, slider_crank_forces
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank
from cranktrain.numerics import turn_grid
from cranktrain.questions.forces.pin_load import PinLoad, pin_load, with_rotating_mass
from cranktrain.questions.forces.piston_formulas import (
    inertia_force,
    piston_forces,
    piston_identities,
    two_harmonic_inertia_force,
)
from cranktrain.questions.forces.rod_masses import ROD_METHODS, excess_inertia, three_masses, two_masses

CASE = json.loads((GOLDEN / "harmonics_pnskt/harmonics_pnskt.json").read_text(encoding="utf-8"))
PHI = turn_grid()
NOTHING = Body(0.0, 0.0, 0.0, 0.0)
WEIGHTLESS = Gravity(0.0, 0.0)


@pytest.mark.parametrize("row", CASE["pnskt"]["rows"], ids=lambda row: str(row["phi_deg"]))
def test_forces_of_a_piston(row):
    given = CASE["pnskt"]["parameters"]
    geometry = SliderCrank(given["R"], given["L"], given["e"])
    motion = slider_crank(np.deg2rad(row["phi_deg"]), geometry)
    inertia = inertia_force(motion.slider, given["m_j"], Drive(given["omega"], 0.0))
    np.testing.assert_allclose(inertia, -given["m_j"] * row["j"], rtol=1e-14)
    forces = piston_forces(row["p_gauge"] * np.pi * given["D"] ** 2 / 4 + inertia, motion, geometry)
    expected = [row[name] for name in "PNSKT"]
    np.testing.assert_allclose(forces, expected, rtol=0, atol=1e-15 * np.max(np.abs(expected)))
    np.testing.assert_allclose(forces.tangential * given["R"], row["TR"], rtol=1e-14)
    np.testing.assert_allclose(forces.side * motion.slider.value, row["Ns"], rtol=1e-14)
    np.testing.assert_allclose(forces.piston * given["e"], row["Pe"], rtol=1e-14)
    resolution, work, reversal = piston_identities(forces, motion, geometry)
    scale = abs(row["S"])
    assert max(abs(work), abs(reversal)) < 1e-15 * scale
    assert abs(resolution) < 1e-15 * scale**2


@pytest.mark.parametrize("ratio", CASE["harmonics"])
def test_harmonics_of_inertia(ratio):
    """What two harmonics leave out is what the exact ones have beyond them."""
    expected, size = CASE["harmonics"][ratio], float(ratio)
    geometry = SliderCrank(size, 1.0, 0.0)
    motion = slider_crank(PHI, geometry)
    exact = inertia_force(motion.slider, 1.0, Drive(1.0, 0.0))
    amplitudes = (
        2 * np.fft.rfft(exact - two_harmonic_inertia_force(PHI, geometry, 1.0, Drive(1.0, 0.0))).real / PHI.size / size
    )
    beyond = [0.0, 0.0, size - expected["A2"], 0.0, -expected["A4"], 0.0, -expected["A6"], 0.0, -expected["A8"]]
    np.testing.assert_allclose(amplitudes[: len(beyond)], beyond, atol=1e-15)
    torque = -exact * motion.slider.first
    amplitudes = -2 * np.fft.rfft(torque).imag / PHI.size / size**2
    np.testing.assert_allclose(amplitudes[1:7], [expected[f"D{k}"] for k in range(1, 7)], atol=1e-15)


@pytest.mark.parametrize("drive", [Drive(1.0, 0.0), Drive(0.0, 1.0)])
def test_two_harmonics_with_an_offset_leave_the_third_power_of_the_ratio(drive):
    """An offset that is some part of the crank; what a rod twice as long leaves is an eighth."""

    def left(ratio):
        geometry = SliderCrank(ratio, 1.0, 0.4 * ratio)
        exact = inertia_force(slider_crank(PHI, geometry).slider, 1.0, drive)
        return np.max(np.abs(exact - two_harmonic_inertia_force(PHI, geometry, 1.0, drive))) / ratio

    assert left(0.1) < 3 * 0.1**3
    assert left(0.1) / left(0.05) == pytest.approx(8, rel=0.02)


ROD = CASE["rod_replacement"]["parameters"]
GEOMETRY = SliderCrank(ROD["R"], ROD["L"], 0.0)
RIGID = Body(ROD["m"], ROD["a"], 0.0, ROD["I_G"])


def by(method, drive, gravity=WEIGHTLESS, piston=NOTHING, force=0.0, angle=PHI):
    """Forces of a slider-crank whose rod is replaced: a rod without mass bears what the masses do."""
    motion = slider_crank(angle, GEOMETRY)
    load = force_on_slider(motion, GEOMETRY, force)
    on_rod = ROD_METHODS[method](motion.rod, RIGID, GEOMETRY.rod_length, drive, gravity)
    bodies = (NOTHING, NOTHING, piston)
    return slider_crank_forces(
        motion, GEOMETRY, bodies, (load[0], on_rod, load[2]), Conditions(drive, gravity, (NO_FRICTION,))
    )


def joints(forces):
    return DYNAMICS.by_joint(forces.joints)


def test_a_rod_of_two_masses():
    steady = Drive(ROD["omega"], 0.0)
    expected = CASE["rod_replacement"]
    assert excess_inertia(RIGID, ROD["L"]) == pytest.approx(expected["deltaI"], rel=1e-14)
    phi = turn_grid(3600)  # the grid of the case
    exact, two = by("exact", steady, angle=phi), by("two_masses", steady, angle=phi)
    side = joints(two)["guide"].y - joints(exact)["guide"].y
    torque = two.driving_torque - exact.driving_torque
    motion = slider_crank(phi, GEOMETRY)
    # θ = −β: ΔN = −ΔI β″ω²/(L cos β), ΔM = ΔI β′β″ω².
    couple = -expected["deltaI"] * motion.rod.angle.second * ROD["omega"] ** 2
    np.testing.assert_allclose(side, -couple / (ROD["L"] * motion.rod.cos), atol=1e-11)
    np.testing.assert_allclose(torque, -couple * motion.rod.angle.first, atol=1e-12)
    assert np.max(np.abs(side)) == pytest.approx(expected["two_mass_max_error_N"], rel=1e-13)
    assert np.max(np.abs(joints(exact)["guide"].y)) == pytest.approx(expected["max_N"], rel=1e-13)
    assert np.max(np.abs(torque)) == pytest.approx(expected["two_mass_max_error_M"], rel=1e-13)
    assert np.max(np.abs(exact.driving_torque)) == pytest.approx(expected["max_M"], rel=1e-13)
    # The force on the frame is exact.
    np.testing.assert_allclose(joints(exact)["main_bearing"].x, joints(two)["main_bearing"].x, atol=1e-10)
    shaking = [joints(forces)["main_bearing"].y + joints(forces)["guide"].y for forces in (exact, two)]
    np.testing.assert_allclose(*shaking, atol=1e-10)


def test_a_rod_of_three_masses():
    first, second, middle = CASE["rod_replacement"]["three_mass"]
    np.testing.assert_allclose(three_masses(RIGID, ROD["L"]), [first, middle, second], rtol=1e-14)


@pytest.mark.parametrize("method", ["two_masses_and_couple", "three_masses"])
def test_exact_replacements(method):
    """In everything, while the crank speeds up and things have weight."""
    drive, gravity = Drive(ROD["omega"], 9000.0), Gravity(-5.0, -8.0)
    exact, replaced = by("exact", drive, gravity), by(method, drive, gravity)
    for one, other in zip(replaced.joints, exact.joints, strict=True):
        np.testing.assert_allclose(one, other, atol=1e-12 * np.max(np.abs(joints(exact)["crank_pin"])))
    np.testing.assert_allclose(replaced.driving_torque, exact.driving_torque, atol=1e-13 * np.max(exact.driving_torque))


@pytest.mark.parametrize("method", ["two_masses", "two_masses_and_couple", "three_masses"])
def test_no_masses_on_a_line_have_a_centroid_beside_it(method):
    motion = slider_crank(0.3, GEOMETRY)
    with np.errstate(invalid="ignore"):
        beside = ROD_METHODS[method](motion.rod, RIGID._replace(across=1e-3), 0.15, Drive(1.0, 0.0), WEIGHTLESS)
    assert np.all(np.isnan(beside))


def test_crank_pin_of_the_textbook_is_that_of_a_rod_of_two_masses():
    """P with the rod's reciprocating share, K and T, and the rotating share: all the textbook's parts together."""
    drive, gas = Drive(ROD["omega"], 9000.0), 4000.0 * np.cos(PHI)
    motion = slider_crank(PHI, GEOMETRY)
    masses, piston = two_masses(RIGID, ROD["L"]), 0.4
    inertia = inertia_force(motion.slider, piston + masses.second, drive)
    parts = piston_forces(gas + inertia, motion, GEOMETRY)
    without = PinLoad(parts.radial, parts.tangential)
    load = with_rotating_mass(without, masses.first, ROD["R"], drive)
    whole = by("two_masses", drive, piston=Body(piston, 0.0, 0.0, 0.0), force=-gas)
    found = pin_load(joints(whole)["crank_pin"], crank_link(motion.pin, Crank(ROD["R"])))
    np.testing.assert_allclose(found, load, atol=1e-15 * 20 * np.max(np.abs(found)))
    np.testing.assert_allclose(joints(whole)["guide"].y, parts.side, atol=1e-14 * np.max(np.abs(parts.side)) * 10)
    assert np.max(np.abs(np.subtract(load, without))) > 1.0
