"""Articulated rods: a 60° V pair by a 40-digit multibody solver, and slave kinematics by the exact closed form."""

import numpy as np
import pytest
from tests.exact.dead_centres import dead_centre
from tests.reference_case import ReferenceCase

from cranktrain.mechanisms.articulated_rod.kinematics import ArticulatedRod, articulated_rod
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank
from cranktrain.motion import Coefficient


def test_v_pair_agrees_to_twelve_digits():
    case = ReferenceCase.load("articulated_v_inertia")
    machine = case.machine
    assert machine["crank_acceleration_rad_s2"] == 0
    speed = machine["crank_speed_rad_s"]
    bank_angle = np.deg2rad(machine["vee_angle_deg"])
    master = SliderCrank(machine["crank_radius_m"], machine["master_rod_length_m"], 0.0)
    geometry = ArticulatedRod(
        master,
        machine["knuckle_radius_m"],
        np.deg2rad(machine["knuckle_angle_deg"]),
        bank_angle,
        machine["link_rod_length_m"],
        0.0,
    )
    piston = slider_crank(case.crank_angle, master).slider
    motion = articulated_rod(case.crank_angle, geometry)
    case.compare(
        {
            "s1_m": piston.value,
            "v1_m_s": piston.first * speed,
            "a1_m_s2": piston.second * speed**2,
            "s2_m": motion.slider.value,
            "v2_m_s": motion.slider.first * speed,
            "a2_m_s2": motion.slider.second * speed**2,
            "master_angle_rad": motion.master_rod.angle.value,
            "master_alpha_rad_s2": motion.master_rod.angle.second * speed**2,
            "link_angle_rad": motion.rod.angle.value + bank_angle,
            "link_alpha_rad_s2": motion.rod.angle.second * speed**2,
        },
        rel_to_peak=1e-12,
    )


@pytest.fixture(scope="module")
def v2() -> tuple[ReferenceCase, ArticulatedRod]:
    """Lengths stay in the case's millimetres."""
    case = ReferenceCase.load("articulated_V2").selected("V2_recalled")
    machine = case.machine["V2_recalled"]
    return case, ArticulatedRod(
        SliderCrank(machine["crank_radius_mm"], machine["master_rod_length_mm"], 0.0),
        machine["articulation_radius_mm"],
        np.deg2rad(machine["zeta_deg"]),
        np.deg2rad(machine["gamma_deg"]),
        machine["slave_rod_length_mm"],
        0.0,
    )


def dead_centres_of(geometry: ArticulatedRod) -> tuple:
    def slider(angle: float) -> Coefficient:
        return articulated_rod(angle, geometry).slider

    bank_angle = float(geometry.bank_angle)
    return dead_centre(slider, bank_angle, 0.5), dead_centre(slider, bank_angle + np.pi, 0.5)


def test_v2_curves(v2):
    case, geometry = v2
    master = slider_crank(case.crank_angle, geometry.master)
    slave = articulated_rod(case.crank_angle, geometry)
    top, _ = dead_centres_of(geometry)
    case.compare(
        {
            "master_travel_mm": geometry.master.crank_radius + geometry.master.rod_length - master.slider.value,
            # Travel counts toward the shaft, the slider's position away from it.
            "master_dx_mm_per_rad": -master.slider.first,
            "master_d2x_mm_per_rad2": -master.slider.second,
            # The obliquity β is positive where the pin stands on the side of positive y: against the rod's direction.
            "beta_deg": -np.rad2deg(master.rod.angle.value),
            "slave_s_mm": slave.slider.value,
            "slave_travel_from_tdc_mm": top.position - slave.slider.value,
            "slave_ds_mm_per_rad": slave.slider.first,
            "slave_d2s_mm_per_rad2": slave.slider.second,
            "slave_obliquity_deg": -np.rad2deg(slave.rod.angle.value),
        },
        # Twelve digits are printed: half a unit of the last of the largest.
        rel_to_peak=6e-12,
    )


def test_v2_dead_centres(v2):
    case, geometry = v2
    top, bottom = dead_centres_of(geometry)
    for name, value in (
        ("stroke_mm", top.position - bottom.position),
        ("tdc_shift_deg", np.rad2deg(top.angle - geometry.bank_angle)),
        ("bdc_shift_deg", np.rad2deg(bottom.angle - geometry.bank_angle - np.pi)),
        ("H_mm", top.position),
        ("h_mm", bottom.position),
    ):
        case.compare_value(f"V2_recalled.{name}", value)
