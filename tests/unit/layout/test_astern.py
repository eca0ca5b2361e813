"""Astern is the same metal at −φ; `crank_zero` moves the scale of angles, not the metal."""

import copy

import numpy as np
import pytest
from tests.machines import ROCKER, V12, banks, of, slider, throws

import cranktrain as ct

OFFSET = slider(offset="12 mm", points={"p": {"link": "rod", "along": "70 mm", "across": "20 mm"}})
MACHINES = {
    "offset slider-crank": {"mechanism": OFFSET, "shaft": throws(0, speed="900 rpm")},
    "crank-rocker": {"mechanism": ROCKER | {"load_radius": "1 m"}, "shaft": throws(0, speed="900 rpm")},
    "crank-rocker, right": {"mechanism": ROCKER | {"side": "right"}},
    "V12 with articulated rods": V12,
    "uneven V": {
        "shaft": throws(0, 100, speed="900 rpm"),
        "bank": banks(L=-20, R=35),
        "cylinder": {"cycle": "four-stroke", "firing_order": "1L-2L-1R-2R"},
    },
}
EVEN = ("piston_displacement", "piston_acceleration_coefficient", "piston_acceleration", "chamber_volume", "point_x")
ODD = (
    "piston_velocity_coefficient",
    "piston_velocity",
    "rod_angle",
    "point_y",
    "rocker_angle",
    "rod_angular_acceleration",
)


def backwards(values):
    """A curve at −φ."""
    return np.roll(values[..., ::-1], 1, axis=-1)


@pytest.fixture(scope="module", params=MACHINES)
def both_ways(request):
    data = MACHINES[request.param]
    return ct.run(ct.Machine(**data)), ct.run(ct.Machine(running="astern", **data))


def test_curves_are_those_of_minus_phi(both_ways):
    ahead, astern = both_ways
    for name in (*EVEN, *ODD):
        if name in ahead.catalogue:
            sign = -1.0 if name in ODD else 1.0
            expected = sign * backwards(getattr(ahead, name))
            scale = np.max(np.abs(expected))
            np.testing.assert_allclose(getattr(astern, name), expected, atol=1e-13 * scale, err_msg=name)


def test_rotary_coefficients(both_ways):
    ahead, astern = both_ways
    for name, sign in (("rocker_velocity_coefficient", 1), ("rocker_acceleration_coefficient", -1)):
        if name in ahead.catalogue:
            np.testing.assert_allclose(getattr(astern, name), sign * backwards(getattr(ahead, name)), atol=1e-12)


def test_facts_are_mirrored(both_ways):
    ahead, astern = both_ways
    for name in ("stroke", "swing", "time_ratio", "closing_margin", "compression_ratio", "smallest_transmission_angle"):
        if name in ahead.catalogue:
            np.testing.assert_allclose(getattr(astern, name), getattr(ahead, name), rtol=1e-12, err_msg=name)
    for name in ("top_dead_centre", "bottom_dead_centre"):
        if name in ahead.catalogue:
            total = getattr(astern, name) + getattr(ahead, name)
            np.testing.assert_allclose(np.sin(np.radians(total) / 2), 0, atol=1e-12, err_msg=name)
    for name in ("top_shift", "bottom_shift", "offset_angle"):
        if name in ahead.catalogue:
            np.testing.assert_allclose(getattr(astern, name), -getattr(ahead, name), atol=1e-11, err_msg=name)
    if "swing" in ahead.catalogue:
        np.testing.assert_allclose(astern.largest_rocker_angle, -ahead.smallest_rocker_angle, rtol=1e-12)


def test_firing_order_is_read_backwards_from_the_same_piston():
    order = V12["cylinder"]["firing_order"].split("-")
    astern = ct.run(ct.Machine(running="astern", **V12))
    fires = dict(zip(astern.labels["piston"], astern.firing_angle, strict=True))
    assert sorted(fires, key=fires.__getitem__) == [order[0], *order[:0:-1]]
    np.testing.assert_allclose(sorted(fires.values()), np.arange(0, 720, 60), atol=1e-9)


def test_intervals_stay_between_the_same_pistons():
    """Whatever fires 260° after 1L ahead fires 260° before it astern."""
    data = MACHINES["uneven V"]
    ahead, astern = ct.run(ct.Machine(**data)), ct.run(ct.Machine(running="astern", **data))
    order = data["cylinder"]["firing_order"].split("-")
    for first, second in zip(order, [*order[1:], order[0]], strict=True):
        assert of(astern, second, astern.firing_interval) == pytest.approx(of(ahead, first, ahead.firing_interval))


@pytest.mark.parametrize("running", ["ahead", "astern"])
def test_crank_zero_moves_the_scale(running):
    """Astern the file's angle counts in the normal sense too, so that φ there is −30°."""
    plain = ct.run(ct.Machine(running=running, **V12))
    moved = ct.run(ct.Machine(running=running, crank_zero="30 deg", **V12))
    shift = 30 if running == "ahead" else -30
    np.testing.assert_array_equal(moved.crank_angle, plain.crank_angle)
    for name in ("piston_displacement", "rod_angle", "chamber_volume", "displacement_by_method"):
        expected = np.roll(getattr(plain, name), -shift, axis=-1)
        np.testing.assert_allclose(getattr(moved, name), expected, atol=1e-13, err_msg=name)
    for name, period in (("top_dead_centre", 360), ("largest_piston_speed_at", 360), ("firing_angle", 720)):
        expected = np.mod(getattr(plain, name) - shift, period)
        np.testing.assert_allclose(getattr(moved, name), expected, atol=1e-10, err_msg=name)
    for name in (
        "stroke",
        "top_shift",
        "largest_piston_speed",
        "closing_margin",
        "displacement_error",
        "firing_interval",
    ):
        np.testing.assert_allclose(getattr(moved, name), getattr(plain, name), atol=1e-12, err_msg=name)


@pytest.mark.parametrize("running", ["ahead", "astern"])
@pytest.mark.parametrize(("data", "first"), [(V12, -30), ({"mechanism": slider(), "angle": "50 deg"}, 50)])
def test_crank_zero_at_twelve_o_clock(running, data, first):
    """Shown as 0 where the crank of throw 1 points along Y: an angle of the first axis before φ = 0."""
    plain = ct.run(ct.Machine(running=running, **data))
    moved = ct.run(ct.Machine(running=running, crank_zero="Y", **data))
    shift = first if running == "ahead" else -first
    expected = np.roll(plain.piston_displacement, shift, axis=-1)
    np.testing.assert_allclose(moved.piston_displacement, expected, atol=1e-13)


def test_crank_zero_leaves_rocker_angles_as_they_are():
    """A rocker is counted the same way wherever the grid begins."""
    plain = ct.run(ct.Machine(mechanism=ROCKER))
    for zero in (50, 130, 200, 310):
        moved = ct.run(ct.Machine(mechanism=ROCKER, crank_zero=f"{zero} deg"))
        np.testing.assert_allclose(moved.rocker_angle, np.roll(plain.rocker_angle, -zero, axis=-1), atol=1e-12)
        assert np.min(moved.rocker_angle) >= moved.smallest_rocker_angle - 1e-12
        assert np.max(moved.rocker_angle) <= moved.largest_rocker_angle + 1e-12


def test_offset_astern_lies_to_the_other_side():
    """asin(e/(L ± R)), by hand, with the sign that the sense of running gives it."""
    data = copy.deepcopy(MACHINES["offset slider-crank"])
    for running, sign in (("ahead", 1), ("astern", -1)):
        result = ct.run(ct.Machine(running=running, **data))
        assert result.top_shift[0] == pytest.approx(sign * np.degrees(np.arcsin(12 / 230)), abs=1e-12)
        assert result.bottom_shift[0] == pytest.approx(sign * np.degrees(np.arcsin(12 / 130)), abs=1e-12)
