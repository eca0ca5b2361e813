"""P, N, S, K, T of a master rod and its slaves, from the file's words: massless ones by statics, rigid ones by a case.

The case tests/golden/articulated_v_inertia is a multibody solver's in 40 digits; its master rod has its centroid beside
its line, as rods with a knuckle have.
"""

from typing import Any

import numpy as np
import pytest
from tests.machines import curve as of_piston
from tests.reference_case import ReferenceCase
from tests.told import line_of
from tests.validation.test_machine_forces import articulated_pair, at_rows

import cranktrain as ct

EXACT, TEXTBOOK = 0, 1
R, L, KNUCKLE, SLAVE = 0.09, 0.32, 0.078, 0.242
STEP = 7.5


def massless(zeta: float, *bank_angles: float, step: float = STEP, **tables: Any) -> ct.Result:
    """A master in bank L and slaves in bank S, with gas alone."""
    names = ["1L", *(f"{i}S" for i in range(1, len(bank_angles) + 1))]
    return ct.run(
        ct.Machine(
            shaft={"main": {"speed": "1500 rpm"}},
            bank={
                "L": {"mechanism": {"kind": "slider_crank", "crank_radius": f"{R} m", "rod_length": f"{L} m"}},
                "S": {
                    "angle": [f"{angle} deg" for angle in bank_angles],
                    "mechanism": {
                        "kind": "articulated_rod",
                        "master": "L",
                        "knuckle_radius": f"{KNUCKLE} m",
                        "rod_length": f"{SLAVE} m",
                        "articulation_angle": [f"{angle + zeta} deg" for angle in bank_angles],
                    },
                },
            },
            cylinder={
                "bore": "150 mm",
                "compression_ratio": 14.5,
                "cycle": "four-stroke",
                "firing_order": "-".join(names),
            },
            gas={
                "kind": "dual",
                "start_pressure": "90 kPa",
                "exhaust_pressure": "106 kPa",
                "compression_exponent": 1.36,
                "expansion_exponent": 1.25,
                "pressure_ratio": 1.4,
                "cut_off_ratio": 1.3,
            },
            **tables,
        ),
        step_degrees=step,
    )


def rod_at(result: ct.Result, angle: float = 0.0, zeta: float = 0.0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Crank angle, β of the master rod, χ of the slave's in a bank at an angle."""
    phi = np.deg2rad(result.crank_angle)
    beta = np.arcsin(R * np.sin(phi) / L)
    ahead = phi - np.deg2rad(angle)
    return phi, beta, np.arcsin((R * np.sin(ahead) + KNUCKLE * np.sin(np.deg2rad(zeta) - beta)) / SLAVE)


def exact(result: ct.Result, name: str, quantity: str) -> np.ndarray:
    return getattr(result, quantity)[EXACT, result.labels["piston"].index(name)]


@pytest.mark.parametrize("bank_angles", [(60.0,), (-60.0,), (80.0, 160.0, -120.0)])
def test_massless_rods_by_statics(bank_angles):
    """N_m = P_m tan β − Σ P_s r sin(ζ − γ + χ − β)/(L cos β cos χ); the pin bears all gas and all walls."""
    zeta = 7.4
    result = massless(zeta, *bank_angles)
    phi, beta, _ = rod_at(result)
    pressed = of_piston(result, "1L", "gas_force")
    wall = pressed * np.tan(beta)
    alone = -pressed + 1j * wall
    others = np.zeros_like(alone)
    scale = 1e-12 * np.max(result.gas_force)
    for number, angle in enumerate(bank_angles, start=1):
        name = f"{number}S"
        _, _, chi = rod_at(result, angle, zeta)
        force = of_piston(result, name, "gas_force")
        wall = wall - force * KNUCKLE * np.sin(np.deg2rad(zeta) + chi - beta) / (L * np.cos(beta) * np.cos(chi))
        others += (-force + 1j * force * np.tan(chi)) * np.exp(1j * np.deg2rad(angle))
        np.testing.assert_allclose(exact(result, name, "piston_force"), force, rtol=0, atol=scale)
        np.testing.assert_allclose(exact(result, name, "side_force"), force * np.tan(chi), rtol=0, atol=scale)
        np.testing.assert_allclose(
            exact(result, name, "rod_force_at_piston_pin"), force / np.cos(chi), rtol=0, atol=scale
        )
    on_pin = -pressed + 1j * wall + others
    along = np.exp(-1j * beta)
    at_crank = on_pin * np.exp(-1j * phi)
    expected = {
        "piston_force": pressed,
        "side_force": wall,
        "rod_force_at_piston_pin": ((pressed - 1j * wall) * np.conj(along)).real,
        "rod_force_at_crank_pin": -(on_pin * np.conj(along)).real,
        "radial_force": -at_crank.real,
        "tangential_force": at_crank.imag,
    }
    for quantity, values in expected.items():
        np.testing.assert_allclose(exact(result, "1L", quantity), values, rtol=0, atol=scale, err_msg=quantity)
    # Without mass the pin's load is the same with the rod's and without, and what is not the master's is its slaves'.
    place = result.labels["mechanism"].index
    own = alone * np.exp(-1j * phi)
    np.testing.assert_allclose(result.crankpin_load_radial[place("1L")], -at_crank.real, rtol=0, atol=scale)
    np.testing.assert_allclose(result.crankpin_share_radial[place("1L")], -own.real, rtol=0, atol=scale)
    np.testing.assert_allclose(result.crankpin_share_tangential[place("1L")], own.imag, rtol=0, atol=scale)
    slaves = [place(f"{number}S") for number in range(1, len(bank_angles) + 1)]
    rest = np.sum(result.crankpin_share_tangential[slaves], axis=0)
    np.testing.assert_allclose(rest, (at_crank - own).imag, rtol=0, atol=scale)
    assert all(np.all(check.passed[check.judged]) for check in result.checks)


def test_the_formula_stands_beside_with_its_error():
    """P tan β and P sin(φ + β)/cos β of the master's own gas; the errors are the largest at whole degrees."""
    result = massless(7.4, 60.0, step=1.0)
    phi, beta, _ = rod_at(result)
    pressed = of_piston(result, "1L", "gas_force")
    row = result.labels["piston"].index("1L")
    side, tangential = pressed * np.tan(beta), pressed * np.sin(phi + beta) / np.cos(beta)
    np.testing.assert_allclose(result.side_force[TEXTBOOK, row], side, rtol=0, atol=1e-9)
    np.testing.assert_allclose(result.tangential_force[TEXTBOOK, row], tangential, rtol=0, atol=1e-9)
    for formula, quantity, error in (
        (side, "side_force", result.side_force_formula_error),
        (tangential, "tangential_force", result.tangential_force_formula_error),
    ):
        true = exact(result, "1L", quantity)
        expected = np.max(np.abs(formula - true)) / np.max(np.abs(true))
        assert error[TEXTBOOK, row] == pytest.approx(expected, rel=1e-12)
        assert expected > 0.2
    assert np.all(np.isnan(result.side_force[TEXTBOOK:, result.labels["piston"].index("1S")]))


def test_rigid_rods():
    """Shares of the rods at their ends, m b/L and m a/L, go with what is there."""
    case = ReferenceCase.load("articulated_v_inertia")
    given = case.machine
    result = articulated_pair(given)
    at = at_rows(case)
    phi, gamma = case.crank_angle, np.deg2rad(given["vee_angle_deg"])
    small = given["master_rod_mass_kg"] * given["master_rod_com_m"][0] / given["master_rod_length_m"]
    big = given["master_rod_mass_kg"] - small
    of_slave = given["link_rod_mass_kg"] * given["link_rod_com_from_knuckle_m"] / given["link_rod_length_m"]

    def force(name: str) -> np.ndarray:
        return case.column(f"{name}_x_N") + 1j * case.column(f"{name}_y_N")

    along = np.exp(1j * case.column("master_angle_rad"))
    slave_along = np.exp(1j * case.column("link_angle_rad"))
    on_pin = force("F_crankpin_on_crank")
    turning = big * given["crank_radius_m"] * given["crank_speed_rad_s"] ** 2 * np.exp(1j * phi)
    at_pin = (on_pin - turning) * np.exp(-1j * phi)
    first = force("F_wrist1_on_piston1") + small * case.column("a1_m_s2")
    second = force("F_wrist2_on_piston2") + of_slave * case.column("a2_m_s2") * np.exp(1j * gamma)
    peak = np.max(np.abs(on_pin))
    for name, quantity, expected in (
        ("1L", "piston_force", -(given["piston_mass_kg"] + small) * -case.column("a1_m_s2")),
        ("1R", "piston_force", -(given["piston_mass_kg"] + of_slave) * -case.column("a2_m_s2")),
        ("1L", "side_force", case.column("N1_N")),
        ("1R", "side_force", case.column("N2_N")),
        ("1L", "rod_force_at_piston_pin", (first * np.conj(along)).real),
        ("1R", "rod_force_at_piston_pin", (second * np.conj(slave_along)).real),
        ("1L", "rod_force_at_crank_pin", -((on_pin - turning) * np.conj(along)).real),
        ("1L", "radial_force", -at_pin.real),
        ("1L", "tangential_force", at_pin.imag),
    ):
        found = exact(result, name, quantity)[at]
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12 * peak, err_msg=f"{name} {quantity}")
    whole = on_pin * np.exp(-1j * phi)
    np.testing.assert_allclose(result.crankpin_load_radial[0, at], -whole.real, rtol=0, atol=1e-12 * peak)
    np.testing.assert_allclose(result.crankpin_load_tangential[0, at], whole.imag, rtol=0, atol=1e-12 * peak)
    np.testing.assert_allclose(np.sum(result.crankpin_share_radial[:, at], axis=0), -whole.real, atol=1e-12 * peak)
    assert {check.name for check in result.checks if np.all(check.passed)} >= {"rod_forces", "piston_forces"}


def test_a_master_alone_has_its_own_share():
    """Superposition: without its slave the pin bears what is the master's share with it."""
    both = ct.load("3d12")
    declared = both.declared
    cylinder = {**declared["cylinder"], "firing_order": "1-5-3-6-2-4"}
    alone = ct.Machine(**{**declared, "bank": {"L": declared["bank"]["L"]}, "cylinder": cylinder})
    whole, master = ct.run(both), ct.run(alone)
    for part in ("radial", "tangential"):
        share = getattr(whole, f"crankpin_share_{part}")[whole.labels["mechanism"].index("1L")]
        load = getattr(master, f"crankpin_load_{part}")[master.labels["mechanism"].index("1")]
        np.testing.assert_allclose(share, load, rtol=0, atol=1e-12 * np.max(np.abs(load)) * 10)


def test_the_headline_takes_all_rods():
    result = ct.run(ct.load("3d12"))
    assert line_of(result, "Largest forces", "in the rod").endswith("71.31 kN (R)")
    slaves = [place for place, name in enumerate(result.labels["piston"]) if name.endswith("R")]
    # A kink, where burning ends: on a fine grid it stands higher by less than a step.
    fine = ct.run(ct.load("3d12"), step_degrees=0.02, quantities="rod_force_at_piston_pin")
    curve = fine.rod_force_at_piston_pin[EXACT, slaves[0]]
    assert np.all(result.largest_rod_force[slaves] >= np.max(curve))
    at = int(np.argmax(curve))
    assert np.all(result.largest_rod_force[slaves] <= np.max(curve) + np.max(np.abs(np.diff(curve[at - 1 : at + 2]))))
    assert np.all(np.isnan(result.radial_force[:, slaves]))
