"""Forces of whole machines, from the file's words to every joint: cases computed by a multibody solver.

The cases' axes: x along the (first) cylinder, y anticlockwise from it; their machines turn anticlockwise.
"""

from typing import Any

import numpy as np
import pytest
from tests.reference_case import GOLDEN, ReferenceCase

import cranktrain as ct


def kg(mass: float) -> str:
    return f"{mass!r} kg"


def m(length: float) -> str:
    return f"{length!r} m"


def inertia(value: float) -> str:
    return f"{value!r} kg·m²"


def body(mass: float, along: float, about: float, across: float = 0.0) -> dict[str, Any]:
    return {"mass": kg(mass), "along": m(along), "across": m(across), "inertia": inertia(about)}


def joint(result: ct.Result, name: str) -> tuple[np.ndarray, np.ndarray]:
    """Force in a joint, in its mechanism's axes."""
    row = result.labels["joint"].index(name)
    return result.joint_force_x[row], result.joint_force_y[row]


def at_rows(case: ReferenceCase, cycle: float = 360.0) -> np.ndarray:
    return np.round(np.rad2deg(case.crank_angle)).astype(int) % round(cycle)


@pytest.mark.parametrize("name", ["slider_crank_inertia", "slider_crank_offset", "slider_crank_gas"])
def test_slider_crank(name):
    case = ReferenceCase.load(name)
    given = case.machine
    declared: dict[str, Any] = {
        "rotation": "anticlockwise",
        "angle": "-90 deg",
        "shaft": {"main": {"speed": f"{given['crank_speed_rad_s']!r} rad/s"}},
        "mechanism": {
            "kind": "slider_crank",
            "crank_radius": m(given["crank_radius_m"]),
            "rod_length": m(given["rod_length_m"]),
            "offset": m(given["offset_m"]),
        },
        "masses": {
            "crank": body(given["crank_mass_kg"], given["crank_com_x_m"], given["crank_inertia_about_com_kgm2"]),
            "rod": body(given["rod_mass_kg"], given["rod_com_from_crankpin_m"], given["rod_inertia_about_com_kgm2"]),
            "piston": {"mass": kg(given["piston_mass_kg"])},
        },
    }
    cycle = 360.0
    if "gas_table" in given:
        cycle = 720.0
        text = (GOLDEN / name / given["gas_table"]).read_text(encoding="utf-8")
        declared["cylinder"] = {"bore": m(given["bore_m"]), "cycle": "four-stroke", "compression_ratio": 16}
        declared["gas"] = {"kind": "indicator", "file": given["gas_table"], "text": text, "firing_angle": "0 deg"}
    result = ct.run(ct.Machine(**declared))
    at = at_rows(case, cycle)
    (wrist_x, wrist_y), (pin_x, pin_y), (main_x, main_y), (_guide_x, guide_y) = (
        tuple(part[at] for part in joint(result, f"1.{name}"))
        for name in ("wrist_pin", "crank_pin", "main_bearing", "guide")
    )
    case.compare(
        {
            "F_wrist_on_piston_x_N": wrist_x,
            "F_wrist_on_piston_y_N": wrist_y,
            "F_crankpin_on_crank_x_N": -pin_x,
            "F_crankpin_on_crank_y_N": -pin_y,
            "F_main_on_crank_x_N": main_x,
            "F_main_on_crank_y_N": main_y,
            "N_wall_on_piston_y_N": guide_y,
            "T_drive_Nm": result.driving_torque[at],
        },
        rel_to_peak=1e-11,
    )
    assert all(np.all(check.passed) for check in result.checks)


def articulated_pair(given: dict[str, Any]) -> ct.Result:
    """The case articulated_v_inertia: master in bank L, slave in bank R."""
    along, across = given["master_rod_com_m"]
    return ct.run(
        ct.Machine(
            rotation="anticlockwise",
            shaft={"main": {"speed": f"{given['crank_speed_rad_s']!r} rad/s"}},
            bank={
                "L": {
                    "angle": "-90 deg",
                    "mechanism": {
                        "kind": "slider_crank",
                        "crank_radius": m(given["crank_radius_m"]),
                        "rod_length": m(given["master_rod_length_m"]),
                    },
                    "masses": {
                        "rod": body(
                            given["master_rod_mass_kg"], along, given["master_rod_inertia_about_com_kgm2"], across
                        )
                    },
                },
                "R": {
                    "angle": f"{given['vee_angle_deg'] - 90!r} deg",
                    "mechanism": {
                        "kind": "articulated_rod",
                        "master": "L",
                        "knuckle_radius": m(given["knuckle_radius_m"]),
                        "rod_length": m(given["link_rod_length_m"]),
                        "articulation_angle": f"{given['knuckle_angle_deg']!r} deg",
                    },
                    "masses": {
                        "rod": body(
                            given["link_rod_mass_kg"],
                            given["link_rod_com_from_knuckle_m"],
                            given["link_rod_inertia_about_com_kgm2"],
                        )
                    },
                },
            },
            masses={
                "piston": {"mass": kg(given["piston_mass_kg"])},
                "crank": body(given["crank_mass_kg"], given["crank_com_x_m"], given["crank_inertia_about_com_kgm2"]),
            },
        )
    )


def test_articulated_pair():
    case = ReferenceCase.load("articulated_v_inertia")
    given = case.machine
    gamma = np.deg2rad(given["vee_angle_deg"])
    result = articulated_pair(given)
    at = at_rows(case)

    def in_case(name: str) -> tuple[np.ndarray, np.ndarray]:
        """A slave's forces stand in its own cylinder's axes."""
        x, y = (part[at] for part in joint(result, name))
        turn = gamma if name.startswith("1R") else 0.0
        return x * np.cos(turn) - y * np.sin(turn), x * np.sin(turn) + y * np.cos(turn)

    first, second, knuckle = (in_case(name) for name in ("1L.wrist_pin", "1R.wrist_pin", "1R.knuckle"))
    main, pin = in_case("1L.main_bearing"), in_case("1L.crank_pin")
    case.compare(
        {
            "F_wrist1_on_piston1_x_N": first[0],
            "F_wrist1_on_piston1_y_N": first[1],
            "F_wrist2_on_piston2_x_N": second[0],
            "F_wrist2_on_piston2_y_N": second[1],
            "F_knuckle_on_link_x_N": knuckle[0],
            "F_knuckle_on_link_y_N": knuckle[1],
            "F_main_on_crank_x_N": main[0],
            "F_main_on_crank_y_N": main[1],
            "F_crankpin_on_crank_x_N": -pin[0],
            "F_crankpin_on_crank_y_N": -pin[1],
            "N1_N": joint(result, "1L.guide")[1][at],
            "N2_N": joint(result, "1R.guide")[1][at],
            "T_drive_Nm": result.driving_torque[at],
        },
        rel_to_peak=1e-11,
    )
    assert all(np.all(check.passed) for check in result.checks)
