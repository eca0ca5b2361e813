"""Torques of whole machines, from the file's words: opposed pistons on two geared shafts and on one.

Cases computed by a multibody solver in 40 digits, tests/golden/opposed_*; x along the cylinder, y anticlockwise
from it.
"""

from typing import Any

import numpy as np
import pytest
from tests.reference_case import GOLDEN, ReferenceCase
from tests.validation.test_machine_forces import at_rows, body, joint, kg, m

import cranktrain as ct


def crank(radius: float, rod: float) -> dict[str, Any]:
    return {"kind": "slider_crank", "crank_radius": m(radius), "rod_length": m(rod)}


def two_shafts(given: dict[str, Any], **changes: Any) -> dict[str, Any]:
    """The case counts from its crank 1, which is behind: the scavenge crank, on the main shaft."""
    mechanism = crank(given["crank_radius_m"], given["rod_length_m"])
    text = (GOLDEN / "opposed_two_shafts/gas_table.csv").read_text(encoding="utf-8")
    return {
        "rotation": "anticlockwise",
        "shaft": {"main": {"speed": f"{given['crank_speed_rad_s']!r} rad/s"}, "second": {}},
        "bank": {
            "A": {
                "angle": "90 deg",
                "scavenge": {"mechanism": mechanism},
                "exhaust": {"mechanism": mechanism, "shaft": "second"},
                "lead": f"{given['lead_deg']!r} deg",
            }
        },
        "masses": {
            "crank": body(given["crank_mass_kg"], given["crank_com_m"][0], given["crank_inertia_about_com_kgm2"]),
            "rod": body(given["rod_mass_kg"], given["rod_com_from_crankpin_m"], given["rod_inertia_about_com_kgm2"]),
            "piston": {"mass": kg(given["piston_mass_kg"])},
        },
        "cylinder": {"bore": m(given["bore_m"]), "cycle": "two-stroke", "compression_ratio": 16},
        # The table's zero is crank 1's own dead centre; both pistons are nearest half the lead before it.
        "gas": {
            "kind": "indicator",
            "file": "gas_table.csv",
            "text": text,
            "pressure": "gauge",
            "firing_angle": f"{-given['lead_deg'] / 2!r} deg",
        },
        **changes,
    }


def test_two_geared_shafts():
    case = ReferenceCase.load("opposed_two_shafts")
    result = ct.run(ct.Machine(**two_shafts(case.machine)))
    at = at_rows(case)
    main, second = (result.labels["shaft"].index(name) for name in ("main", "second"))
    first = {name: joint(result, f"1.scavenge.{name}") for name in ("wrist_pin", "main_bearing")}
    # The exhaust piston's own x points toward crank 1, so its axes are the case's turned by half a turn.
    other = {name: [-part for part in joint(result, f"1.exhaust.{name}")] for name in ("wrist_pin", "main_bearing")}
    case.compare(
        {
            "F_wrist1_on_piston1_x_N": first["wrist_pin"][0][at],
            "F_wrist1_on_piston1_y_N": first["wrist_pin"][1][at],
            "F_wrist2_on_piston2_x_N": other["wrist_pin"][0][at],
            "F_wrist2_on_piston2_y_N": other["wrist_pin"][1][at],
            "F_main1_on_crank_x_N": first["main_bearing"][0][at],
            "F_main1_on_crank_y_N": first["main_bearing"][1][at],
            "F_main2_on_crank2_x_N": other["main_bearing"][0][at],
            "F_main2_on_crank2_y_N": other["main_bearing"][1][at],
            "T_gear_on_crank2_Nm": -result.gear_torque[second, at],
            "T_drive_total_on_crank1_Nm": result.driving_torque[at],
        },
        rel_to_peak=1e-9,
    )
    np.testing.assert_array_equal(result.machine_torque, -result.driving_torque)
    np.testing.assert_allclose(np.sum(result.shaft_torque, axis=0), result.machine_torque, rtol=0, atol=1e-9)
    assert np.all(np.isnan(result.gear_torque[main]))
    expected = case.column("T_gear_on_crank2_Nm")[:-1]
    sense = np.sign(expected[expected != 0.0])
    assert result.gear_reversals[second] == np.count_nonzero(sense != np.roll(sense, 1)) == 4
    whole = case.column("T_drive_total_on_crank1_Nm")[:-1]
    assert result.work_share[second] == pytest.approx(expected.mean() / whole.mean(), rel=1e-9)
    assert result.mean_torque == pytest.approx(-whole.mean(), rel=1e-9)


def test_astern_the_other_shaft_leads():
    """The same metal at −φ: pressures read backwards give the torques ahead, turned round in time and sign."""
    given = ReferenceCase.load("opposed_two_shafts").machine
    declared = two_shafts(given)
    rows = [line.split(",") for line in declared["gas"]["text"].split()]
    backward = "\n".join(",".join(row) for row in [rows[0], *([str((360 - int(a)) % 360), p] for a, p in rows[1:])])
    astern = two_shafts(given, running="astern")
    astern["gas"] |= {"text": backward, "firing_angle": f"{given['lead_deg'] / 2!r} deg"}
    ahead, back = (ct.run(ct.Machine(**one)) for one in (declared, astern))
    mirrored = -np.roll(ahead.shaft_torque[:, ::-1], 1, axis=-1)
    peak = np.max(np.abs(mirrored))
    np.testing.assert_allclose(back.shaft_torque, mirrored, rtol=0, atol=1e-11 * peak)
    np.testing.assert_allclose(back.work_share, ahead.work_share, atol=1e-12)
    assert back.mean_torque == pytest.approx(-ahead.mean_torque, rel=1e-11)


def test_one_shaft():
    case = ReferenceCase.load("opposed_one_shaft")
    given = case.machine

    def end(name: str) -> dict[str, Any]:
        return {
            "rod": body(
                given[f"{name}_rod_mass_kg"],
                given[f"{name}_rod_com_from_crankpin_m"],
                given[f"{name}_rod_inertia_about_com_kgm2"],
            ),
            "piston": {"mass": kg(given[f"{name}_piston_mass_kg"])},
        }

    whole_crank = body(given["crank_mass_kg"], given["crank_com_m"][0], given["crank_inertia_about_com_kgm2"])
    result = ct.run(
        ct.Machine(
            rotation="anticlockwise",
            shaft={
                "main": {
                    "throws": ["0 deg", f"{given['throw_angle_deg']!r} deg"],
                    "speed": f"{given['crank_speed_rad_s']!r} rad/s",
                }
            },
            bank={
                "A": {
                    "exhaust": {
                        "mechanism": crank(given["lower_crank_radius_m"], given["lower_rod_length_m"]),
                        "throws": [1],
                        "masses": end("lower") | {"crank": whole_crank},
                    },
                    "scavenge": {
                        "mechanism": crank(given["upper_crank_radius_m"], given["upper_rod_length_m"]),
                        "throws": [2],
                        "side_rods": True,
                        "masses": end("upper"),
                    },
                }
            },
        )
    )
    at = at_rows(case)
    lower, upper = (
        {name: [part[at] for part in joint(result, f"1.{end}.{name}")] for name in _JOINTS}
        for end in ("exhaust", "scavenge")
    )
    case.compare(
        {
            "F_wrist1_on_piston1_x_N": lower["wrist_pin"][0],
            "F_wrist1_on_piston1_y_N": lower["wrist_pin"][1],
            "F_wrist2_on_piston2_x_N": upper["wrist_pin"][0],
            "F_wrist2_on_piston2_y_N": upper["wrist_pin"][1],
            "F_main_on_crank_x_N": lower["main_bearing"][0] + upper["main_bearing"][0],
            "F_main_on_crank_y_N": lower["main_bearing"][1] + upper["main_bearing"][1],
            "F_pin1_on_crank_x_N": -lower["crank_pin"][0],
            "F_pin1_on_crank_y_N": -lower["crank_pin"][1],
            "F_pin2_on_crank_x_N": -upper["crank_pin"][0],
            "F_pin2_on_crank_y_N": -upper["crank_pin"][1],
            "N1_N": lower["guide"][1],
            "N2_N": upper["guide"][1],
            "T_drive_Nm": result.driving_torque[at],
        },
        rel_to_peak=1e-11,
    )
    # Crank 1 stands at φ and crank 2 opposite: the pin's load toward the shaft and in the sense of rotation.
    phi = case.crank_angle
    for row, (name, turned) in enumerate((("F_pin1_on_crank", phi), ("F_pin2_on_crank", phi + np.pi))):
        x, y = case.column(f"{name}_x_N"), case.column(f"{name}_y_N")
        peak = np.max(np.hypot(x, y))
        radial, tangential = -(x * np.cos(turned) + y * np.sin(turned)), y * np.cos(turned) - x * np.sin(turned)
        np.testing.assert_allclose(result.crankpin_load_radial[row, at], radial, atol=1e-11 * peak)
        np.testing.assert_allclose(result.crankpin_load_tangential[row, at], tangential, atol=1e-11 * peak)
        assert result.largest_crankpin_load[row] == pytest.approx(peak, rel=1e-11)
    assert np.all(result.journal_torque[0] == 0.0)
    np.testing.assert_array_equal(result.journal_torque[2], result.machine_torque)
    share = case.column("F_pin1_on_crank_y_N") * np.cos(phi) - case.column("F_pin1_on_crank_x_N") * np.sin(phi)
    between = share * given["lower_crank_radius_m"]
    np.testing.assert_allclose(result.journal_torque[1, at], between, atol=1e-11 * np.max(np.abs(between)))


_JOINTS = ("wrist_pin", "crank_pin", "main_bearing", "guide")
