"""Nine-cylinder radial, five ways to choose the knuckle circle: strokes, dead-centre shifts, pin heights."""

import numpy as np
import pytest
from tests.exact.dead_centres import dead_centre
from tests.reference_case import ReferenceCase

from cranktrain.mechanisms.articulated_rod.kinematics import ArticulatedRod, articulated_rod
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank
from cranktrain.motion import Coefficient

MASTER_COMPRESSION_RATIO = 6.5  # in the name of the case's column


@pytest.mark.parametrize("strategy", ["S0", "S1", "S2", "S3", "S4"])
def test_dead_centres_of_the_slaves(strategy):
    case = ReferenceCase.load("radial9").selected(strategy)
    radius, rod_length = case.machine["crank_radius_mm"], case.machine["master_rod_length_mm"]
    found: dict[str, list[float]] = {column: [] for column in COLUMNS}
    for row in case.rows:
        is_master = row["cylinder"] == "1"
        geometry = ArticulatedRod(
            SliderCrank(radius, rod_length, 0.0),
            float(row["articulation_radius_mm"]),
            np.deg2rad(float(row["zeta_deg"])),
            np.deg2rad(float(row["gamma_deg"])),
            rod_length if is_master else float(row["slave_rod_length_mm"]),
            0.0,
        )
        for column, value in zip(COLUMNS, dead_centre_facts(geometry), strict=True):
            found[column].append(value)
    case.compare(found)


COLUMNS = (
    "stroke_mm",
    "tdc_shift_deg",
    "bdc_shift_deg",
    "pin_height_minus_master_mm",
    "compression_ratio_if_master_6p5",
    "crank_angle_of_25deg_before_own_TDC_deg",
)


def dead_centre_facts(geometry: ArticulatedRod) -> tuple[float, ...]:
    def slider(angle: float) -> Coefficient:
        return articulated_rod(angle, geometry).slider

    bank_angle = float(geometry.bank_angle)
    top, bottom = dead_centre(slider, bank_angle, 0.5), dead_centre(slider, bank_angle + np.pi, 0.5)
    stroke = top.position - bottom.position
    height = top.position - (geometry.master.crank_radius + geometry.master.rod_length)
    master_clearance = 2 * geometry.master.crank_radius / (MASTER_COMPRESSION_RATIO - 1)
    return (
        stroke,
        np.rad2deg(top.angle - bank_angle),
        np.rad2deg(bottom.angle - bank_angle - np.pi),
        height,
        1 + stroke / (master_clearance - height),
        np.rad2deg(top.angle) - 25,
    )
