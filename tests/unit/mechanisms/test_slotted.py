"""Scotch yoke, oscillating cylinder and slotted lever: closed forms of their results, and what is refused."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.linkage import CrankAndPivot
from cranktrain.mechanisms.slotted_lever.kinematics import slotted_lever


def run(speed=None, **mechanism):
    shaft = {} if speed is None else {"shaft": {"main": {"speed": speed}}}
    return ct.run(ct.Machine(mechanism=mechanism, **shaft))


def refusal(**mechanism):
    with pytest.raises(InputError) as caught:
        run(**mechanism)
    (problem,) = caught.value.problems
    return problem


def test_scotch_yoke_moves_as_the_cosine():
    result = run("300 rpm", kind="scotch_yoke", crank_radius="40 mm")
    phi, omega = np.radians(result.crank_angle), 10 * np.pi
    np.testing.assert_allclose(result.piston_displacement[0], 0.04 * (1 - np.cos(phi)), atol=1e-16)
    np.testing.assert_allclose(result.piston_velocity[0], 0.04 * omega * np.sin(phi), atol=1e-14)
    np.testing.assert_allclose(result.piston_acceleration[0], 0.04 * omega**2 * np.cos(phi), atol=1e-12)
    np.testing.assert_allclose(result.slider_position[0], 0.04 * np.sin(phi), atol=1e-16)


@pytest.mark.parametrize("degrees", [60, 110])
def test_leaning_slot(degrees):
    """S = 2R/sin β, the dead centres at β ∓ 90°."""
    result = run(kind="scotch_yoke", crank_radius="40 mm", slot_angle=f"{degrees} deg", offset="10 mm")
    assert result.stroke[0] == pytest.approx(0.08 / np.sin(np.radians(degrees)), rel=1e-14)
    assert result.top_shift[0] == pytest.approx(degrees - 90, abs=1e-12)
    astern = ct.run(
        ct.Machine(
            running="astern",
            mechanism={"kind": "scotch_yoke", "crank_radius": "40 mm", "slot_angle": f"{degrees} deg"},
        )
    )
    assert astern.top_shift[0] == pytest.approx(90 - degrees, abs=1e-12)


def test_what_has_no_rod_has_no_rod_results():
    result = run("300 rpm", kind="scotch_yoke", crank_radius="40 mm")
    absent = {"rod_angle", "rod_angular_velocity", "largest_pressure_angle", "displacement_by_method"}
    assert not absent & set(result.catalogue)
    assert not any(absent & set(missing.results) for missing in result.missing)


def test_pistons_with_and_without_a_rod_in_one_machine():
    rod = {"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "150 mm"}
    yoke = {"kind": "scotch_yoke", "crank_radius": "40 mm"}
    result = ct.run(ct.Machine(bank={"L": {"mechanism": rod}, "R": {"angle": "60 deg", "mechanism": yoke}}))
    assert np.isnan(result.rod_angle).all(axis=1).tolist() == [False, True]
    assert np.isnan(result.largest_pressure_angle).tolist() == [False, True]
    assert result.stroke == pytest.approx(0.08, rel=1e-14)


def test_slot_along_the_guide_is_refused():
    problem = refusal(kind="scotch_yoke", crank_radius="40 mm", slot_angle="180 deg")
    assert (problem.path, problem.given) == ("mechanism.slot_angle", "180 deg")


@pytest.mark.parametrize("offset", [0.0, 0.02])
def test_oscillating_cylinder(offset):
    """Dead centres on the ground line; S = √((g + R)² − e²) − √((g − R)² − e²); rocks by asin((R ± e)/g)."""
    result = run(kind="oscillating_cylinder", crank_radius="20 mm", ground_length="90 mm", offset=f"{offset} m")
    assert result.stroke[0] == pytest.approx(np.sqrt(0.11**2 - offset**2) - np.sqrt(0.07**2 - offset**2), rel=1e-13)
    assert result.top_shift[0] == pytest.approx(0, abs=1e-9)
    assert result.bottom_shift[0] == pytest.approx(0, abs=1e-9)
    assert result.labels["link"] == ("1.cylinder",)
    assert result.closing_margin[0] == pytest.approx((0.07 - offset) / 0.09, rel=1e-9)
    if offset == 0.0:
        fine = ct.run(result.machines[0], step_degrees=0.1)
        assert np.ptp(fine.link_angle[0]) == pytest.approx(2 * np.arcsin(2 / 9), abs=1e-5)


def test_slotted_lever_swings():
    """ψ = 2 asin(R/g), dead where crank and lever are at right angles, k = (π + ψ)/(π − ψ)."""
    result = run(kind="slotted_lever", crank_radius="100 mm", ground_length="250 mm")
    swing = 2 * np.arcsin(0.4)
    assert result.swing[0] == pytest.approx(swing, rel=1e-13)
    assert result.time_ratio[0] == pytest.approx((np.pi + swing) / (np.pi - swing), rel=1e-13)
    dead = np.degrees(np.arccos(0.4))
    assert sorted((result.largest_rocker_angle_at[0], result.smallest_rocker_angle_at[0])) == pytest.approx(
        [dead, 360 - dead], abs=1e-10
    )
    assert result.closing_margin[0] == pytest.approx(0.6, rel=1e-9)


def test_whitworth_turns_all_round():
    """The lever is at right angles to the ground where cos φ = g/R: half a turn takes 2 acos(g/R) of the crank."""
    result = run(kind="slotted_lever", crank_radius="250 mm", ground_length="100 mm")
    assert np.isnan(result.swing[0])
    angle = result.rocker_angle[0]
    assert angle[-1] - angle[0] == pytest.approx(2 * np.pi, abs=0.1)
    quick = 2 * np.arccos(0.4)
    ends = slotted_lever(np.array([-quick / 2, quick / 2]), CrankAndPivot(0.25, 0.1, 0.0, -1.0)).rocker.angle.value
    np.testing.assert_allclose(ends, [-np.pi / 2, np.pi / 2], atol=1e-14)


@pytest.mark.parametrize(
    ("mechanism", "advice"),
    [
        (
            {"kind": "oscillating_cylinder", "crank_radius": "90 mm", "ground_length": "90 mm"},
            "ground_length must be more than crank_radius + |offset| = 90 mm",
        ),
        (
            {"kind": "slotted_lever", "crank_radius": "90 mm", "ground_length": "95 mm", "offset": "10 mm"},
            "ground_length must be more than 100 mm, or less than 80 mm for a lever that turns all round",
        ),
        (
            {"kind": "slotted_lever", "crank_radius": "9 mm", "ground_length": "15 mm", "offset": "10 mm"},
            "ground_length must be more than crank_radius + |offset| = 19 mm",
        ),
    ],
)
def test_what_cannot_close_is_refused(mechanism, advice):
    problem = refusal(**mechanism)
    assert problem.path == "mechanism.ground_length"
    assert advice in str(problem.allowed)
