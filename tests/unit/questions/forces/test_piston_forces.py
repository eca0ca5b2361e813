"""P, N, S, K, T, crank pins and rods replaced by masses, from the file's words, against closed forms."""

import json
from typing import Any

import numpy as np
import pytest
from tests.machines import ROCKER, V12, slider, throws
from tests.reference_case import GOLDEN
from tests.told import texts_of

import cranktrain as ct

CASE = json.loads((GOLDEN / "harmonics_pnskt/harmonics_pnskt.json").read_text(encoding="utf-8"))
EXACT, TEXTBOOK, TWO_HARMONICS = range(3)


def one(mechanism: dict[str, Any], speed: float, masses: dict[str, Any], **tables: Any) -> ct.Result:
    return ct.run(
        ct.Machine(
            shaft=throws(0, speed=f"{speed!r} rad/s"), bank={"A": {"mechanism": mechanism}}, masses=masses, **tables
        )
    )


def mechanism(given: dict[str, float]) -> dict[str, Any]:
    return slider(crank_radius=f"{given['R']!r} m", rod_length=f"{given['L']!r} m", offset=f"{given.get('e', 0.0)!r} m")


@pytest.mark.parametrize("row", CASE["pnskt"]["rows"], ids=lambda row: str(row["phi_deg"]))
def test_forces_of_inertia(row):
    """The case's forces are those for its P; those of its inertia alone are in the same ratio."""
    given = CASE["pnskt"]["parameters"]
    result = one(mechanism(given), given["omega"], {"piston": {"mass": f"{given['m_j']!r} kg"}})
    force = -given["m_j"] * row["j"]
    peak = np.max(np.abs(result.rod_force_at_piston_pin[EXACT]))
    for name, letter in (
        ("piston_force", "P"),
        ("side_force", "N"),
        ("rod_force_at_piston_pin", "S"),
        ("rod_force_at_crank_pin", "S"),
        ("radial_force", "K"),
        ("tangential_force", "T"),
    ):
        for method in (EXACT, TEXTBOOK):
            found = getattr(result, name)[method, 0, round(row["phi_deg"])]
            assert abs(found - row[letter] / row["P"] * force) < 1e-13 * peak, (name, method)
    np.testing.assert_array_equal(result.inertia_force, result.piston_force)
    phi, aside = np.radians(row["phi_deg"]), given["e"] / given["L"]
    two_harmonics = np.cos(phi) + given["R"] / given["L"] * np.cos(2 * phi) + aside * np.sin(phi)
    force = -given["m_j"] * given["R"] * given["omega"] ** 2 * two_harmonics
    found = result.piston_force[TWO_HARMONICS, 0, round(row["phi_deg"])]
    assert abs(found - force) < 1e-13 * peak


def test_two_harmonics():
    result = one(slider(), 300.0, {"piston": {"mass": "0.4 kg"}})
    phi = np.radians(result.crank_angle)
    ratio = 50 / 180
    expected = -0.4 * 0.05 * 300.0**2 * (np.cos(phi) + ratio * np.cos(2 * phi))
    np.testing.assert_allclose(result.inertia_force[TWO_HARMONICS, 0], expected, rtol=0, atol=1e-11)
    beta = np.arcsin(ratio * np.sin(phi))
    np.testing.assert_allclose(result.side_force[TWO_HARMONICS, 0], expected * np.tan(beta), rtol=0, atol=1e-11)
    assert result.labels["force_method"] == ("exact", "textbook", "two_harmonics")


FORCES = (
    *("piston_force", "side_force", "rod_force_at_piston_pin", "rod_force_at_crank_pin"),
    *("radial_force", "tangential_force"),
)


@pytest.mark.parametrize("inertia", ["0.0072 kg·m²", "0.01 kg·m²"])
def test_the_rods_share_goes_with_the_piston(inertia):
    """Of a rod of 1 kg with its centroid a third along, a third; the rotating rest is in none of the five.

    0.0072 kg·m² are those of two masses. What a rod has more turns against its own acceleration: a couple that the wall
    bears, and the pin across the cylinder.
    """
    rod = {"mass": "1 kg", "along": "60 mm", "inertia": inertia}
    alone = one(slider(), 300.0, {"piston": {"mass": f"{0.4 + 1 / 3!r} kg"}})
    result = one(slider(), 300.0, {"piston": {"mass": "0.4 kg"}, "rod": rod})
    for name in FORCES:
        found, expected = getattr(result, name), getattr(alone, name)
        np.testing.assert_allclose(found[TEXTBOOK:], expected[TEXTBOOK:], rtol=0, atol=1e-9)
    more = float(inertia.split()[0]) - 1.0 * 0.06 * 0.12
    phi = np.radians(result.crank_angle)
    beta = np.arcsin(50 / 180 * np.sin(phi))
    turn = 50 / 180 * np.cos(phi) / np.cos(beta)
    wall = -more * 300.0**2 * (turn**2 * np.tan(beta) - np.tan(beta)) / (0.18 * np.cos(beta))
    for name, share in (
        ("piston_force", 0.0),
        ("side_force", 1.0),
        ("rod_force_at_piston_pin", np.sin(beta)),
        ("rod_force_at_crank_pin", np.sin(beta)),
        ("radial_force", -np.sin(phi)),
        ("tangential_force", np.cos(phi)),
    ):
        expected = getattr(alone, name)[EXACT, 0] + share * wall
        np.testing.assert_allclose(getattr(result, name)[EXACT, 0], expected, rtol=0, atol=1e-9, err_msg=name)
    turning = result.crankpin_radial_without_rod - result.crankpin_load_radial
    np.testing.assert_allclose(turning, 2 / 3 * 0.05 * 300.0**2, rtol=1e-11)


@pytest.mark.parametrize(("inertia", "is_doubted"), [(20.0, True), (1e-5, True), (0.0, False), (0.004, False)])
def test_inertia_that_no_such_rod_has_is_doubted(inertia, is_doubted):
    """A rod of 1 kg and 180 mm: a bar's is 0.0027, two masses' at its ends at most 0.0081."""
    rod = {"mass": "1 kg", "along": "60 mm", "inertia": f"{inertia!r} kg·m²"}
    flags = texts_of(one(slider(), 100.0, {"rod": rod}).flags)
    assert any(flag.startswith("The inertia of 1.rod is hardly") for flag in flags) is is_doubted


def test_a_slave_has_no_crank_pin_of_its_own():
    """It has P, N and S, and a share in what its master's pin bears."""
    result = ct.run(ct.Machine(**V12, masses={"piston": {"mass": "3 kg"}}), step_degrees=10)
    slaves = [place for place, name in enumerate(result.labels["piston"]) if name.endswith("R")]
    masters = [place for place, name in enumerate(result.labels["piston"]) if name.endswith("L")]
    for name in ("rod_force_at_crank_pin", "radial_force", "tangential_force"):
        assert np.all(np.isnan(getattr(result, name)[:, slaves]))
    for name in ("piston_force", "side_force", "rod_force_at_piston_pin"):
        assert np.all(np.isnan(getattr(result, name)[TEXTBOOK:, slaves]))
        assert not np.any(np.isnan(getattr(result, name)[EXACT]))
    assert not np.any(np.isnan(result.side_force[:, masters]))
    assert np.all(np.isnan(result.crankpin_load_radial[slaves]))
    assert not np.any(np.isnan(result.crankpin_share_radial))
    assert np.all(np.isnan(result.side_force_error[:, slaves]))
    # The master's pin bears both pistons: more than its own P says.
    own = np.hypot(*(result_of[TEXTBOOK, masters[0]] for result_of in (result.radial_force, result.tangential_force)))
    assert result.largest_crankpin_load[masters[0]] > 1.2 * np.max(own)
    assert "NaN" not in result.summary()


def test_rod_methods():
    """The rod alone: largest errors of two masses over the largest values, as computed with multibody equations."""
    given, expected = CASE["rod_replacement"]["parameters"], CASE["rod_replacement"]
    rod = {"mass": f"{given['m']!r} kg", "along": f"{given['a']!r} m", "inertia": f"{given['I_G']!r} kg·m²"}
    result = one(mechanism(given), given["omega"], {"rod": rod})
    row = result.labels["rod_method"].index("two_masses")
    side = expected["two_mass_max_error_N"] / expected["max_N"]
    torque = expected["two_mass_max_error_M"] / expected["max_M"]
    # A grid of 1° misses the peaks by some 1e-5.
    assert result.side_force_error[row, 0] == pytest.approx(side, rel=1e-4)
    assert result.driving_torque_error[row, 0] == pytest.approx(torque, rel=2e-4)
    exact = [place for place in range(4) if place != row]
    assert np.max(result.side_force_error[exact]) < 1e-14
    assert np.max(result.driving_torque_error[exact]) < 1e-14


def test_no_masses_have_a_centroid_beside_the_rod():
    rod = {"mass": "1 kg", "along": "60 mm", "across": "2 mm", "inertia": "0.01 kg·m²"}
    result = one(slider(), 300.0, {"piston": {"mass": "0.4 kg"}, "rod": rod})
    # Its ends still weigh what they weigh, and the reactions are those of the body.
    assert not np.any(np.isnan([getattr(result, name) for name in FORCES]))
    assert all(np.all(check.passed) for check in result.checks)
    assert result.side_force_error[0, 0] == 0.0
    assert np.all(np.isnan(result.side_force_error[1:, 0]))
    assert not np.any(np.isnan(result.crankpin_load_radial))
    assert "nan" not in result.summary()


def test_machines_without_rods_on_crank_pins_have_no_such_forces():
    yoke = {"kind": "scotch_yoke", "crank_radius": "50 mm"}
    result = one(yoke, 300.0, {"piston": {"mass": "0.4 kg"}})
    assert "piston_force" not in result.catalogue
    # The slider pulls the pin outward with mRω² cos φ: away from the shaft, and back.
    phi = np.radians(result.crank_angle)
    force = 0.4 * 0.05 * 300.0**2 * np.cos(phi)
    np.testing.assert_allclose(result.crankpin_load_radial[0], -force * np.cos(phi), rtol=0, atol=1e-10)
    np.testing.assert_allclose(result.crankpin_load_tangential[0], -force * np.sin(phi), rtol=0, atol=1e-10)
    assert np.all(np.isnan(result.crankpin_radial_without_rod))


def test_the_pin_of_a_crank_rocker():
    """Virtual work: what the pin bears tangentially turns the crank."""
    masses = {"rocker": {"mass": "5 kg", "along": "100 mm", "inertia": "0.1 kg·m²"}}
    result = one(ROCKER, 20.0, masses)
    torque = result.crankpin_load_tangential[0] * 0.1
    np.testing.assert_allclose(torque, result.machine_torque, rtol=0, atol=1e-12 * np.max(np.abs(torque)))
    np.testing.assert_array_equal(result.crankpin_radial_without_rod, result.crankpin_load_radial)
