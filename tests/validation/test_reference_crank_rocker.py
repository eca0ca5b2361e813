"""Crank-rocker 400/100/360/280 mm at 120 rpm: motion by a 40-digit multibody solver, checked by MuJoCo."""

import numpy as np
import pytest
from tests.reference_case import ReferenceCase

from cranktrain.linkage import LinkPoint, point
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker, crank_rocker
from cranktrain.motion import Point

CASES = ["crank_rocker_inertia", "crank_rocker_loaded"]


def crank_rocker_of(machine) -> CrankRocker:
    assert machine["assembly"].startswith("open (B above")
    return CrankRocker(
        machine["crank_length_m"],
        machine["coupler_length_m"],
        machine["rocker_length_m"],
        machine["ground_length_m"],
        1.0,
    )


@pytest.mark.parametrize("name", CASES)
def test_motion_agrees_to_twelve_digits(name):
    case = ReferenceCase.load(name)
    assert case.machine["crank_acceleration_rad_s2"] == 0
    speed = case.machine["crank_speed_rad_s"]
    motion = crank_rocker(case.crank_angle, crank_rocker_of(case.machine))
    case.compare(
        {
            f"{column}_{quantity}": values
            for column, link in (("coupler", motion.rod), ("rocker", motion.rocker))
            for quantity, values in (
                ("angle_rad", link.angle.value),
                ("omega_rad_s", link.angle.first * speed),
                ("alpha_rad_s2", link.angle.second * speed**2),
            )
        },
        rel_to_peak=1e-12,
    )


def squared_speed(point: Point) -> tuple[np.ndarray, np.ndarray]:
    """r′² and its derivative."""
    return (
        point.x.first**2 + point.y.first**2,
        2 * (point.x.first * point.x.second + point.y.first * point.y.second),
    )


@pytest.mark.parametrize("name", CASES)
def test_points_of_the_links_carry_the_reduced_inertia(name):
    # J = Σ m r′² + I θ′² of the three links, so the mass centres' motion is in the reference's inertia.
    case = ReferenceCase.load(name)
    machine = case.machine
    motion = crank_rocker(case.crank_angle, crank_rocker_of(machine))
    inertia = (
        machine["crank_inertia_about_com_kgm2"] + machine["crank_mass_kg"] * np.hypot(*machine["crank_com_m"]) ** 2
    )
    slope = 0.0
    for column, link in (("coupler", motion.rod), ("rocker", motion.rocker)):
        x, y = machine[f"{column}_com_m"]
        centre, centre_slope = squared_speed(point(link, LinkPoint(np.hypot(x, y), np.arctan2(y, x))))
        mass, own = machine[f"{column}_mass_kg"], machine[f"{column}_inertia_about_com_kgm2"]
        inertia = inertia + mass * centre + own * link.angle.first**2
        slope = slope + mass * centre_slope + 2 * own * link.angle.first * link.angle.second
    case.compare({"J_red_kgm2": inertia, "dJ_red_dphi_kgm2_per_rad": slope}, rel_to_peak=1e-12)
