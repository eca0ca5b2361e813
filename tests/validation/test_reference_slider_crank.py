"""Central and offset slider-cranks of 65/220 mm, 2100 rpm: motion by a 40-digit multibody solver, checked by MuJoCo."""

import numpy as np
import pytest
from tests.reference_case import ReferenceCase

from cranktrain.linkage import LinkPoint, point
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank


@pytest.mark.parametrize("name", ["slider_crank_inertia", "slider_crank_offset", "slider_crank_gas"])
def test_motion_agrees_to_twelve_digits(name):
    case = ReferenceCase.load(name)
    machine = case.machine
    assert machine["crank_acceleration_rad_s2"] == 0
    speed = machine["crank_speed_rad_s"]
    geometry = SliderCrank(machine["crank_radius_m"], machine["rod_length_m"], machine["offset_m"])
    motion = slider_crank(case.crank_angle, geometry)
    centre = point(motion.rod, LinkPoint(machine["rod_com_from_crankpin_m"], 0.0))
    case.compare(
        {
            "piston_x_m": motion.slider.value,
            "piston_v_m_s": motion.slider.first * speed,
            "piston_a_m_s2": motion.slider.second * speed**2,
            "rod_angle_rad": motion.rod.angle.value,
            "rod_omega_rad_s": motion.rod.angle.first * speed,
            "rod_alpha_rad_s2": motion.rod.angle.second * speed**2,
            "rod_com_x_m": centre.x.value,
            "rod_com_y_m": centre.y.value,
            "rod_com_ax_m_s2": centre.x.second * speed**2,
            "rod_com_ay_m_s2": centre.y.second * speed**2,
        },
        rel_to_peak=1e-12,
    )
    assert np.all(np.isfinite(motion.slider.second))
