"""Forces in an in-line four from the file's words: P, N, S, K, T, crank pins, torque along the shaft, its orders.

The engine is tests/golden/crankshaft_I4, its forces by closed forms, printed to 1e-4 N and 1e-5 N·m; the orders are
those of tests/golden/theory/torque_orders.json, by quadrature.
"""

import json
from typing import Any

import numpy as np
import pytest
from tests.reference_case import GOLDEN, Array, ReferenceCase
from tests.told import line_of
from tests.validation.test_machine_forces import kg, m
from tests.validation.test_torque_orders import BORE, CYCLE, MASS, OMEGA, L, R, pressure

import cranktrain as ct

CASE = ReferenceCase.load("crankshaft_I4")
GIVEN = CASE.machine
DEGREES = np.arange(720.0)


def columns(name: str) -> dict[str, Array]:
    with (GOLDEN / "crankshaft_I4" / name).open(encoding="utf-8") as file:
        names = file.readline().strip().split(",")
        return dict(zip(names, np.loadtxt(file, delimiter=",").T, strict=True))


def trace(angle: Array) -> Array:
    """Pressure [Pa] by the cylinder's own crank angle [deg], as the case's convention says."""
    gas = GIVEN["gas"]
    ratio, lam = gas["compression_ratio"], gas["rod_ratio"]

    def volume(degrees: Array | float) -> Array:
        a = np.deg2rad(degrees)
        u = 1 - np.cos(a) + (1 - np.sqrt(1 - (lam * np.sin(a)) ** 2)) / lam
        return 1 / (ratio - 1) + u / 2

    def compression(degrees: Array | float) -> Array:
        return gas["induction_pressure_MPa"] * (volume(180.0) / volume(degrees)) ** gas["compression_exponent"]

    def blend(share: Array) -> Array:
        return (1 - np.cos(np.pi * np.clip(share, 0, 1))) / 2

    expansion = (
        gas["pressure_ratio"] * compression(360.0) * (volume(360.0) / volume(angle)) ** gas["expansion_exponent"]
    )
    burnt = np.maximum((angle - gas["burn_start_deg"]) / gas["burn_duration_deg"], 0)
    x = 1 - np.exp(-gas["wiebe_a"] * burnt ** (gas["wiebe_m"] + 1))
    closed = (1 - x) * compression(angle) + x * expansion
    opened = blend((angle - gas["exhaust_opening_deg"]) / gas["blowdown_deg"])
    late = closed + opened * (gas["exhaust_pressure_MPa"] - closed)
    early = gas["exhaust_pressure_MPa"] + blend(angle / 20) * (
        gas["induction_pressure_MPa"] - gas["exhaust_pressure_MPa"]
    )
    return 1e6 * np.where(angle < 180, early, late)


def engine(absolute: Array, crankcase: float, firing: str, cylinder: dict[str, Any], **tables: Any) -> ct.Machine:
    """A four-stroke with the trace as a file of gauge pressures: the case's crankcase is not at one atmosphere."""
    step = 720 / absolute.size
    rows = [f"{i * step!r},{value - crankcase!r}" for i, value in enumerate(absolute.tolist())]
    return ct.Machine(
        cylinder={"cycle": "four-stroke", **cylinder},
        gas={
            "kind": "indicator",
            "file": "trace.csv",
            "text": "\n".join(["crank_angle_deg,p_Pa", *rows]),
            "pressure": "gauge",
            "firing_angle": firing,
        },
        **tables,
    )


def four(radius: float, rod: float, speed: str) -> dict[str, Any]:
    return {
        "shaft": {"main": {"throws": ["0 deg", "180 deg", "180 deg", "0 deg"], "speed": speed}},
        "bank": {"A": {"mechanism": {"kind": "slider_crank", "crank_radius": m(radius), "rod_length": m(rod)}}},
    }


@pytest.fixture(scope="module")
def result() -> ct.Result:
    tables = four(GIVEN["crank_radius_mm"] * 1e-3, GIVEN["rod_length_mm"] * 1e-3, f"{GIVEN['speed_rpm']!r} rpm")
    ends = {"big_end": kg(GIVEN["rod_mass_at_crankpin_kg"]), "small_end": kg(GIVEN["rod_mass_at_piston_kg"])}
    masses = {"piston": {"mass": kg(GIVEN["piston_mass_kg"])}, "rod": ends}
    ambient, ratio = 1e6 * GIVEN["gas"]["ambient_MPa"], GIVEN["gas"]["compression_ratio"]
    cylinder = {"bore": m(GIVEN["bore_mm"] * 1e-3), "compression_ratio": ratio, "firing_order": "1-2-4-3"}
    return ct.run(engine(trace(DEGREES), ambient, "360 deg", cylinder, masses=masses, **tables))


def test_forces_of_a_piston(result):
    expected = columns("cylinder_forces.csv")
    # Cylinder 1 fires at 0, which is 360° of the table.
    at = (np.round(expected["cylinder_crank_angle_deg"]).astype(int) + 360) % 720
    for name, quantity in (
        ("Pj_N", result.inertia_force),
        ("P_N", result.piston_force),
        ("N_N", result.side_force),
        ("S_N", result.rod_force_at_piston_pin),
        ("S_N", result.rod_force_at_crank_pin),
        ("K_N", result.radial_force),
        ("T_N", result.tangential_force),
    ):
        # A rod of two masses: the formula is exact.
        for method in ("exact", "textbook"):
            found = quantity[result.labels["force_method"].index(method), 0, at]
            np.testing.assert_allclose(found, expected[name], rtol=0, atol=6e-5, err_msg=f"{name} {method}")
    guide = result.joint_force_y[result.labels["joint"].index("1.guide")]
    np.testing.assert_allclose(guide, result.side_force[1, 0], rtol=0, atol=1e-9)


def test_crank_pin_with_and_without_the_rods_rotating_mass(result):
    expected = columns("crankpin_polar.csv")
    at = (np.round(expected["cylinder_crank_angle_deg"]).astype(int) + 360) % 720
    np.testing.assert_allclose(result.crankpin_load_radial[0, at], expected["R_K_N"], rtol=0, atol=6e-4)
    np.testing.assert_allclose(result.crankpin_load_tangential[0, at], expected["T_N"], rtol=0, atol=6e-4)
    np.testing.assert_allclose(result.crankpin_radial_without_rod, result.radial_force[1], rtol=0, atol=1e-9)
    turning = result.crankpin_radial_without_rod - result.crankpin_load_radial
    np.testing.assert_allclose(turning, GIVEN["centrifugal_force_N"]["rod"], rtol=1e-11)


def test_torque_along_the_shaft(result):
    expected = columns("pin_forces_torque.csv")
    at = np.round(expected["crank_angle_deg"]).astype(int) % 720
    for cylinder in range(4):
        for name, quantity in (("K", result.radial_force), ("T", result.tangential_force)):
            column = expected[f"{name}{cylinder + 1}_1_N"]
            np.testing.assert_allclose(quantity[0, cylinder, at], column, rtol=0, atol=6e-5)
        passed = expected[f"M_after_throw{cylinder + 1}_Nm"]
        np.testing.assert_allclose(result.journal_torque[cylinder + 1, at], passed, rtol=0, atol=6e-6)
    assert result.labels["journal"] == ("1", "2", "3", "4", "5")
    CASE.compare_value("mean_torque_per_cylinder_Nm", result.mean_torque / 4)
    CASE.compare_value("imep_MPa", result.mean_indicated_pressure / 1e6)
    power = CASE.document["summary"]["power_kW"]
    assert result.indicated_power / 1e3 == pytest.approx(power, rel=1e-5)


def test_checks(result):
    assert all(np.all(check.passed) for check in result.checks)
    assert "work" in {check.name for check in result.checks}


def test_orders_of_the_torque():
    """Pressure every half degree: between the samples a spline, across the jumps at the bottom too."""
    expected = json.loads((GOLDEN / "theory/torque_orders.json").read_text(encoding="utf-8"))
    tables = four(R, L, f"{OMEGA!r} rad/s")
    cylinder = {"bore": m(BORE), "compression_ratio": 10, "firing_order": "1-3-4-2"}
    absolute = pressure(np.arange(1440) * (CYCLE / 1440))
    machine = engine(absolute, 1e5, "0 deg", cylinder, masses={"piston": {"mass": kg(MASS)}}, **tables)
    result = ct.run(machine, step_degrees=0.5)
    order = result.labels["order"].index
    peak = expected["I4_max"]
    for name, value in (
        ("I4_mean", result.mean_torque),
        ("I4_max", result.largest_torque),
        ("I4_min", result.smallest_torque),
        ("I4_order2", result.torque_order_amplitude[order("2")]),
        ("I4_order4", result.torque_order_amplitude[order("4")]),
    ):
        # The trapezoid over the kink where combustion starts.
        assert abs(value - expected[name]) < 2e-5 * peak, name
    single = expected["orders"]
    for name, turn in (("2.0", 2), ("4.0", 4)):
        phase = np.degrees(np.arctan2(single[name]["b_sin"], single[name]["a_cos"]))
        assert result.torque_order_phase[order(str(turn))] == pytest.approx(phase, abs=1e-3)
    others = [i for i in range(24) if (i + 1) % 4]
    assert np.max(result.torque_order_amplitude[others]) < 1e-11 * peak
    np.testing.assert_allclose(result.phase_star_sum[3::4], 4.0, rtol=1e-12)
    assert np.max(result.phase_star_sum[others]) < 1e-12
    assert line_of(result, "Torque", "major orders") == "2, 4, 6, 8, …"
