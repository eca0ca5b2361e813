"""Conventional pumping unit C-57D-109-48 of API 11E as a crank-rocker: rod position, stroke, torque factor.

The catalogue's only printed torque factor is 23.30 in at 90°; the table of every 15° was computed by a 40-digit solver.
"""

from typing import NamedTuple

import numpy as np
import pytest
from tests.exact.dead_centres import dead_centre
from tests.reference_case import ReferenceCase

from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker, crank_rocker
from cranktrain.motion import Coefficient


class Unit(NamedTuple):
    """The unit's linkage and, at its saddle, the beam to the horsehead. [in]

    θ is the API's crank angle, clockwise from twelve o'clock; the well is on the right, and the saddle stands above and
    to the right of the crankshaft, at `saddle_direction`. The mechanism's angles are clockwise, as the crank turns, and
    its x runs from crankshaft to saddle: so its y points to the right of that line, and the tail bearing, which lies to
    the left, is on the side −1.
    """

    linkage: CrankRocker
    saddle_direction: float
    beam: float

    @classmethod
    def of(cls, machine: dict[str, float]) -> "Unit":
        rise, run = machine["H_in"] - machine["G_in"], machine["I_in"]
        linkage = CrankRocker(machine["R_in"], machine["P_in"], machine["C_in"], np.hypot(run, rise), -1.0)
        return cls(linkage, np.arctan2(run, rise), machine["A_in"])

    def rod_position(self, angle) -> Coefficient:
        """Polished rod, up positive, from an arbitrary level: as the horsehead goes down the beam turns clockwise."""
        beam = crank_rocker(angle - self.saddle_direction, self.linkage).rocker.angle
        # Within 0…2π: the tail swings about the direction π from the saddle to the crankshaft.
        beam = beam._replace(value=np.mod(beam.value, 2 * np.pi))
        return Coefficient(*(-self.beam * part for part in beam))


@pytest.fixture(scope="module")
def case() -> ReferenceCase:
    return ReferenceCase.load("pumping_unit_C-57D-109-48")


@pytest.fixture(scope="module")
def unit(case) -> Unit:
    return Unit.of(case.machine)


def test_torque_factor(case, unit):
    torque_factor = unit.rod_position(case.crank_angle).first
    case.compare({"TF_in": torque_factor})
    case.compare_value("TF_at_90deg_in", float(unit.rod_position(np.pi / 2).first))
    assert float(unit.rod_position(np.pi / 2).first) == pytest.approx(
        case.document["published"]["TF_at_90deg_in"], abs=0.05
    )


def test_extremes_of_the_torque_factor(case, unit):
    torque_factor = unit.rod_position(np.deg2rad(np.arange(0, 360, 0.25))).first
    case.compare_value("TF_max_in", float(torque_factor.max()))
    case.compare_value("TF_min_in", float(torque_factor.min()))


def test_stroke_and_position_of_rods(case, unit):
    bottom = dead_centre(unit.rod_position, np.deg2rad(2), 0.3)
    top = dead_centre(unit.rod_position, np.deg2rad(187), 0.3)
    stroke = top.position - bottom.position
    case.compare_value("stroke_in", stroke)
    case.compare({"position_of_rods": (unit.rod_position(case.crank_angle).value - bottom.position) / stroke})
    assert np.rad2deg([bottom.angle, top.angle]) == pytest.approx([2.061976912, 186.684128160], abs=5e-10)
