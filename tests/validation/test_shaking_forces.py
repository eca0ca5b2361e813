"""Shaking forces and rolling moments of whole machines against the reactions of a 40-digit multibody solver.

Source: tests/golden, solved body by body, as the cases say. Their x is the first mechanism's, their angles and their
crank run anticlockwise. The frame gets the opposite of what it does to bearings, guides and pivots. About the first
shaft its moment is that of these forces where they act: guides hold pistons without moments.
"""

from typing import Any

import numpy as np
import pytest
from tests.reference_case import ReferenceCase

import cranktrain as ct

CLOSE = 1e-10
"""Of the peak."""


def body(mass: float, along: float, inertia: float, across: float = 0.0) -> dict[str, str]:
    return {
        "mass": f"{mass!r} kg",
        "along": f"{along!r} m",
        "across": f"{across!r} m",
        "inertia": f"{inertia!r} kg*m^2",
    }


def slider(given: dict[str, Any], rod: str = "rod_length_m") -> dict[str, str]:
    return {
        "kind": "slider_crank",
        "crank_radius": f"{given['crank_radius_m']!r} m",
        "rod_length": f"{given[rod]!r} m",
    }


def main(given: dict[str, Any]) -> dict[str, Any]:
    return {"main": {"speed": f"{given['crank_speed_rad_s']!r} rad/s"}}


def slider_masses(given: dict[str, Any]) -> dict[str, Any]:
    crank = given["crank_com_m"][0] if "crank_com_m" in given else given["crank_com_x_m"]
    return {
        "crank": body(given["crank_mass_kg"], crank, given["crank_inertia_about_com_kgm2"]),
        "rod": body(given["rod_mass_kg"], given["rod_com_from_crankpin_m"], given["rod_inertia_about_com_kgm2"]),
        "piston": {"mass": f"{given['piston_mass_kg']!r} kg"},
    }


def run(case: ReferenceCase, **declared: Any) -> tuple[ct.Result, np.ndarray]:
    result = ct.run(ct.Machine(rotation="anticlockwise", **declared))
    assert [check for check in result.checks if not np.all(check.passed)] == []
    return result, np.round(np.rad2deg(case.crank_angle)).astype(int) % 360


def assert_close(found: np.ndarray, expected: np.ndarray, scale: float) -> None:
    np.testing.assert_allclose(found, expected, rtol=0, atol=CLOSE * scale)


@pytest.mark.parametrize("with_gas", [False, True])
def test_slider_crank(with_gas):
    case = ReferenceCase.load("slider_crank_gas" if with_gas else "slider_crank_inertia")
    given = case.machine
    result, at = run(case, angle="-90 deg", shaft=main(given), mechanism=slider(given), masses=slider_masses(given))
    wall, position = case.column("N_wall_on_piston_y_N"), case.column("piston_x_m")
    roll = -position * wall
    if with_gas:
        # The gas rolls the frame by minus its torque, and shakes nothing.
        roll = roll - case.column("T_drive_Nm") + result.driving_torque[at]
    else:
        across = -case.column("F_main_on_crank_y_N") - wall
        assert_close(
            result.shaking_force_x[0, at], -case.column("F_main_on_crank_x_N"), case.peak("F_main_on_crank_x_N")
        )
        assert_close(result.shaking_force_y[0, at], across, case.peak("F_main_on_crank_x_N"))
    assert_close(result.rolling_moment[0, at], roll, np.max(np.abs(position * wall)))


def test_crank_rocker():
    case = ReferenceCase.load("crank_rocker_inertia")
    given = case.machine
    lengths = {
        f"{ours}_length": f"{given[f'{theirs}_length_m']!r} m"
        for ours, theirs in (("rod", "coupler"), ("rocker", "rocker"), ("ground", "ground"))
    }
    parts = {
        ours: body(
            given[f"{theirs}_mass_kg"],
            given[f"{theirs}_com_m"][0],
            given[f"{theirs}_inertia_about_com_kgm2"],
            given[f"{theirs}_com_m"][1],
        )
        for ours, theirs in (("crank", "crank"), ("rod", "coupler"), ("rocker", "rocker"))
    }
    result, at = run(
        case,
        angle="-90 deg",
        shaft=main(given),
        mechanism={"kind": "crank_rocker", "crank_radius": f"{given['crank_length_m']!r} m", **lengths},
        masses=parts,
    )
    pivot = case.column("F_O4_on_rocker_y_N")
    scale = case.peak("F_O4_on_rocker_y_N")
    for ours, axis in ((result.shaking_force_x, "x"), (result.shaking_force_y, "y")):
        expected = -case.column(f"F_O2_on_crank_{axis}_N") - case.column(f"F_O4_on_rocker_{axis}_N")
        assert_close(ours[0, at], expected, scale)
    assert_close(result.rolling_moment[0, at], -given["ground_length_m"] * pivot, given["ground_length_m"] * scale)


def test_articulated_pair():
    case = ReferenceCase.load("articulated_v_inertia")
    given = case.machine
    along, across = given["master_rod_com_m"]
    gamma = np.deg2rad(given["vee_angle_deg"])
    master = body(given["master_rod_mass_kg"], along, given["master_rod_inertia_about_com_kgm2"], across)
    slave = body(
        given["link_rod_mass_kg"], given["link_rod_com_from_knuckle_m"], given["link_rod_inertia_about_com_kgm2"]
    )
    slave_mechanism = {
        "kind": "articulated_rod",
        "master": "L",
        "knuckle_radius": f"{given['knuckle_radius_m']!r} m",
        "rod_length": f"{given['link_rod_length_m']!r} m",
        "articulation_angle": f"{given['knuckle_angle_deg']!r} deg",
    }
    result, at = run(
        case,
        shaft=main(given),
        bank={
            "L": {
                "angle": "-90 deg",
                "mechanism": slider(given, "master_rod_length_m"),
                "masses": {"rod": master},
            },
            "R": {
                "angle": f"{given['vee_angle_deg'] - 90!r} deg",
                "mechanism": slave_mechanism,
                "masses": {"rod": slave},
            },
        },
        masses={
            "piston": {"mass": f"{given['piston_mass_kg']!r} kg"},
            "crank": body(given["crank_mass_kg"], given["crank_com_x_m"], given["crank_inertia_about_com_kgm2"]),
        },
    )
    first, second = case.column("N1_N"), case.column("N2_N")
    scale = case.peak("F_main_on_crank_x_N")
    assert_close(result.shaking_force_x[0, at], -case.column("F_main_on_crank_x_N") + second * np.sin(gamma), scale)
    expected = -case.column("F_main_on_crank_y_N") - first - second * np.cos(gamma)
    assert_close(result.shaking_force_y[0, at], expected, scale)
    # Articulated rods break the symmetry of plain ones: the third order appears.
    assert result.shaking_force_largest[0, 2] > 1e-3 * result.shaking_force_largest[0, 0]


def test_opposed_pistons_on_two_shafts():
    case = ReferenceCase.load("opposed_two_shafts")
    given = case.machine
    mechanism = {"mechanism": slider(given)}
    result, at = run(
        case,
        shaft=main(given) | {"second": {"place": [f"{given['shaft_distance_m']!r} m", "0 m"]}},
        bank={
            "A": {
                "angle": "90 deg",
                "lead": f"{given['lead_deg']!r} deg",
                "exhaust": mechanism | {"shaft": "second"},
                "scavenge": mechanism,
            }
        },
        masses=slider_masses(given),
    )
    # A piston's wall takes what its pin gives it; the gas pushes both pistons apart, and shakes nothing.
    walls = [-case.column(f"F_wrist{i}_on_piston{i}_y_N") for i in (1, 2)]
    second = case.column("F_main2_on_crank2_y_N")
    scale = case.peak("F_main1_on_crank_x_N")
    along = -case.column("F_main1_on_crank_x_N") - case.column("F_main2_on_crank2_x_N")
    assert_close(result.shaking_force_x[0, at], along, scale)
    across = -case.column("F_main1_on_crank_y_N") - second - walls[0] - walls[1]
    assert_close(result.shaking_force_y[0, at], across, scale)
    roll = -case.column("x1_m") * walls[0] - case.column("x2_m") * walls[1] - given["shaft_distance_m"] * second
    gas = case.column("T_drive_total_on_crank1_Nm") - result.driving_torque[at]
    assert_close(result.rolling_moment[0, at], roll - gas, scale)
