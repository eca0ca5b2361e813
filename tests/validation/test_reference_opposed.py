"""Opposed pistons on two shafts and on one: cases computed by a multibody solver and by closed forms."""

import numpy as np
import pytest
from tests.reference_case import ReferenceCase

import cranktrain as ct


def crank(radius, rod, unit="m"):
    return {"kind": "slider_crank", "crank_radius": f"{radius!r} {unit}", "rod_length": f"{rod!r} {unit}"}


@pytest.mark.parametrize("name", ["Jumo205", "unequal_rods"])
def test_kinematics_and_volumetric_dead_centres(name):
    case = ReferenceCase.load("opposed_kinematics")
    given, rows = case.machine[name], case.selected(name)
    ends = {
        end: {"mechanism": crank(given[f"{end}_crank_radius_mm"], given[f"{end}_rod_length_mm"], "mm")}
        for end in ("exhaust", "scavenge")
    }
    bank = {"A": {**ends, "lead": f"{given['lead_deg']!r} deg"}}
    bank["A"]["scavenge"]["shaft"] = "upper"
    result = ct.run(ct.Machine(shaft={"upper": {}}, bank=bank))
    at = np.round(np.rad2deg(rows.crank_angle)).astype(int) % 360
    travel, slope, bend = (
        1e3 * values[:, at]
        for values in (
            result.piston_displacement,
            result.piston_velocity_coefficient,
            result.piston_acceleration_coefficient,
        )
    )
    rows.compare(
        {
            "s_exhaust_mm": travel[0],
            "s_scavenge_mm": travel[1],
            "sum_mm": travel[0] + travel[1],
            "sum_minus_min_mm": 1e3 * result.combined_displacement[0, at],
            "ds_exhaust_mm_per_rad": slope[0],
            "ds_scavenge_mm_per_rad": slope[1],
            "dsum_mm_per_rad": 1e3 * result.combined_velocity_coefficient[0, at],
            "d2s_exhaust_mm_per_rad2": bend[0],
            "d2s_scavenge_mm_per_rad2": bend[1],
            "d2sum_mm_per_rad2": 1e3 * result.combined_acceleration_coefficient[0, at],
        },
        rel_to_peak=1e-11,
    )
    case.compare_value(f"{name}.inner_volume_dead_centre_deg", result.inner_volumetric_dead_centre[0])
    case.compare_value(f"{name}.outer_volume_dead_centre_deg", result.outer_volumetric_dead_centre[0])
    least = 1e3 * result.least_combined_travel[0]
    case.compare_value(f"{name}.sum_min_mm", least)
    case.compare_value(f"{name}.combined_stroke_mm", 1e3 * result.combined_stroke[0])
    case.compare_value(f"{name}.sum_max_mm", least + 1e3 * result.combined_stroke[0])


def test_two_shafts():
    """The case counts from its first crank, which is behind: the scavenge crank, on the main shaft."""
    case = ReferenceCase.load("opposed_two_shafts")
    given = case.machine
    mechanism = crank(given["crank_radius_m"], given["rod_length_m"])
    bank = {
        "angle": "90 deg",
        "scavenge": {"mechanism": mechanism},
        "exhaust": {"mechanism": mechanism, "shaft": "second"},
        "lead": f"{given['lead_deg']!r} deg",
    }
    speed = f"{given['crank_speed_rad_s']!r} rad/s"
    result = ct.run(
        ct.Machine(rotation="anticlockwise", shaft={"main": {"speed": speed}, "second": {}}, bank={"A": bank})
    )
    assert result.labels["piston"] == ("1.exhaust", "1.scavenge")
    at = np.round(np.rad2deg(case.crank_angle)).astype(int) % 360
    farthest = given["crank_radius_m"] + given["rod_length_m"]
    second, first = (farthest - result.piston_displacement[i, at] for i in (0, 1))
    distance = given["shaft_distance_m"]
    # Both cases' x runs from shaft 1 to shaft 2.
    case.compare(
        {
            "x1_m": first,
            "v1_m_s": -result.piston_velocity[1, at],
            "a1_m_s2": -result.piston_acceleration[1, at],
            "x2_m": distance - second,
            "v2_m_s": result.piston_velocity[0, at],
            "a2_m_s2": result.piston_acceleration[0, at],
            "gap_m": distance - first - second,
        },
        rel_to_peak=1e-12,
    )
    gap = case.column("gap_m")
    np.testing.assert_allclose(
        result.combined_displacement[0, at] - result.combined_displacement[0, at][0], gap - gap[0], atol=1e-13
    )


def test_one_shaft():
    case = ReferenceCase.load("opposed_one_shaft")
    given = case.machine
    machine = ct.Machine(
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
                },
                "scavenge": {
                    "mechanism": crank(given["upper_crank_radius_m"], given["upper_rod_length_m"]),
                    "throws": [2],
                    "side_rods": True,
                },
            }
        },
        cylinder={"bore": f"{given['bore_m']!r} m", "compression_ratio": 10},
    )
    result = ct.run(machine)
    at = np.round(np.rad2deg(case.crank_angle)).astype(int) % 360
    lower, upper = result.top_position[:, np.newaxis] - result.piston_displacement[:, at]
    case.compare(
        {
            "s1_m": lower,
            "v1_m_s": -result.piston_velocity[0, at],
            "a1_m_s2": -result.piston_acceleration[0, at],
            "s2_m": upper,
            "v2_m_s": -result.piston_velocity[1, at],
            "a2_m_s2": -result.piston_acceleration[1, at],
            "gap_m": upper - lower,
        },
        rel_to_peak=1e-12,
    )
    gap = case.column("gap_m")
    stroke = np.max(gap) - np.min(gap)
    assert result.lead[0] == pytest.approx(0, abs=1e-12)
    assert result.combined_stroke[0] == pytest.approx(stroke, rel=1e-12)
    area = np.pi / 4 * given["bore_m"] ** 2
    np.testing.assert_allclose(
        result.chamber_volume[0, at], area * (stroke / 9 + gap - np.min(gap)), rtol=0, atol=1e-12 * area
    )
