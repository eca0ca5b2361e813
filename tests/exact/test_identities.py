"""Identities of articulated rods, mirrors, and the slave strokes of a V engine."""

import numpy as np
import pytest
from tests.exact.agreement import allowance, flattened
from tests.exact.dead_centres import dead_centre
from tests.exact.geometries import articulated_rods, crank_rockers, slider_cranks

from cranktrain.linkage import Crank, Slide, crank, slide
from cranktrain.mechanisms.articulated_rod.kinematics import ArticulatedRod, articulated_rod
from cranktrain.mechanisms.crank_rocker.kinematics import crank_rocker
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank
from cranktrain.motion import Coefficient

TURN = np.arange(-180, 180) * (np.pi / 180)
N = 500


def assert_same(one: Coefficient, other: Coefficient, margin) -> None:
    for order in Coefficient._fields:
        expected = getattr(other, order)
        peak = np.max(np.abs(expected), axis=-1, keepdims=True)
        # Both sides are computed.
        assert np.all(np.abs(getattr(one, order) - expected) <= 2 * allowance(margin) * peak), order


def test_a_slave_rod_on_the_crank_pin_is_a_plain_slider_crank():
    slave = slider_cranks(N, seed=11)
    random = np.random.default_rng(12)
    # Angles on a binary grid, so that α − γ is exact.
    bank_angle = random.integers(-(2**12), 2**12, size=(N, 1)) * 2.0**-10
    angle = np.arange(-(2**8), 2**8) * 2.0**-6
    geometry = ArticulatedRod(
        SliderCrank(slave.geometry.crank_radius, 3.0 * slave.geometry.crank_radius, 0.0 * bank_angle),
        0.0 * bank_angle,
        random.uniform(-np.pi, np.pi, size=(N, 1)),
        bank_angle,
        slave.geometry.rod_length,
        slave.geometry.offset,
    )
    on_pin = articulated_rod(angle, geometry)
    plain = slider_crank(angle - bank_angle, slave.geometry)
    assert_same(on_pin.slider, plain.slider, slave.margin)
    assert_same(on_pin.rod.angle, plain.rod.angle, slave.margin)


def engine_rods(articulation_shift: float) -> ArticulatedRod:
    """Random engines without offsets, the knuckle turned from the bank by so many master obliquities at α = γ."""
    random = np.random.default_rng(13)
    crank_radius = random.uniform(0.02, 0.5, size=(N, 1))
    rod_length = crank_radius * random.uniform(3.0, 5.0, size=(N, 1))
    knuckle_radius = crank_radius * random.uniform(0.3, 0.9, size=(N, 1))
    bank_angle = random.uniform(-np.pi, np.pi, size=(N, 1))
    lean = np.arcsin(crank_radius * np.sin(bank_angle) / rod_length)
    return ArticulatedRod(
        SliderCrank(crank_radius, rod_length, 0.0 * crank_radius),
        knuckle_radius,
        bank_angle + articulation_shift * lean,
        bank_angle,
        rod_length - knuckle_radius * random.uniform(0.9, 1.1, size=(N, 1)),
        0.0 * crank_radius,
    )


def test_no_shift_of_top_dead_centre_with_the_knuckle_ahead_by_the_obliquity():
    geometry = engine_rods(1.0)
    crank_radius = geometry.master.crank_radius
    slider = articulated_rod(geometry.bank_angle, geometry).slider
    height = crank_radius + geometry.knuckle_radius + geometry.rod_length
    assert np.all(np.abs(slider.first) <= 2e-14 * crank_radius)
    np.testing.assert_allclose(slider.value, height, rtol=1e-15)
    assert np.all(articulated_rod(TURN, geometry).slider.value <= height * (1 + 1e-15))


def test_no_shift_of_bottom_dead_centre_with_the_knuckle_behind_by_the_obliquity():
    geometry = engine_rods(-1.0)
    crank_radius = geometry.master.crank_radius
    slider = articulated_rod(geometry.bank_angle + np.pi, geometry).slider
    height = geometry.knuckle_radius + geometry.rod_length - crank_radius
    assert np.all(np.abs(slider.first) <= 2e-14 * crank_radius)
    np.testing.assert_allclose(slider.value, height, rtol=1e-14)


def mirrored(coefficient: Coefficient, sign: float) -> Coefficient:
    """The coefficient at −φ, in mirrored axes: `sign` −1 for what the mirror reverses (y, angles), else +1."""
    return Coefficient(sign * coefficient.value, -sign * coefficient.first, sign * coefficient.second)


def assert_mirrored(ahead, astern, margin) -> None:
    """Assert that `astern`, at −φ, is the mirror image of `ahead`: x as it was, y and angles reversed."""
    coefficients = dict(flattened(astern))
    for name, coefficient in flattened(ahead):
        if isinstance(coefficient, Coefficient):
            sign = 1.0 if name == "slider" or name.endswith(".x") else -1.0
            assert_same(coefficients[name], mirrored(coefficient, sign), margin)


def test_slider_crank_astern():
    machines = slider_cranks(N, seed=14)
    geometry = machines.geometry
    assert_mirrored(
        slider_crank(TURN, geometry), slider_crank(-TURN, geometry._replace(offset=-geometry.offset)), machines.margin
    )


def test_crank_rocker_astern():
    machines = crank_rockers(N, seed=15)
    geometry = machines.geometry
    assert_mirrored(
        crank_rocker(TURN, geometry), crank_rocker(-TURN, geometry._replace(side=-geometry.side)), machines.margin
    )


def test_articulated_rod_astern():
    machines = articulated_rods(N, seed=16)
    geometry = machines.geometry
    astern = ArticulatedRod(
        geometry.master._replace(offset=-geometry.master.offset),
        geometry.knuckle_radius,
        -geometry.articulation_angle,
        -geometry.bank_angle,
        geometry.rod_length,
        -geometry.offset,
    )
    assert_mirrored(articulated_rod(TURN, geometry), articulated_rod(-TURN, astern), machines.margin)


def test_a_slider_behind_is_one_ahead_seen_from_the_other_end():
    machines = slider_cranks(N, seed=17)
    radius, rod_length, offset = machines.geometry
    behind = slide(crank(TURN, Crank(radius)), Slide(rod_length, offset, -1.0)).slider
    ahead = slider_crank(TURN, SliderCrank(-radius, rod_length, -offset)).slider
    assert_same(behind, Coefficient(-ahead.value, -ahead.first, -ahead.second), machines.margin)


@pytest.mark.parametrize(
    ("knuckle_radius", "rod_length", "articulation_angle", "stroke", "height", "shifts"),
    [
        # Fitted to the published slave stroke 186.7 mm of the V-2 and to equal pin height.
        (0.078256, 0.242426, 67.458, 0.18670, 0.410000, (0.82, -4.26)),
        # Often quoted for the same engine; does not give the published stroke.
        (0.085, 0.235, 67.0, 0.18707, 0.409131, (0.98, -4.66)),
    ],
)
def test_slave_stroke_of_a_v_engine(knuckle_radius, rod_length, articulation_angle, stroke, height, shifts):
    bank_angle = np.deg2rad(60.0)
    geometry = ArticulatedRod(
        SliderCrank(0.090, 0.320, 0.0), knuckle_radius, np.deg2rad(articulation_angle), bank_angle, rod_length, 0.0
    )

    def slider(angle: float) -> Coefficient:
        return articulated_rod(angle, geometry).slider

    top = dead_centre(slider, near=bank_angle, within=0.5)
    bottom = dead_centre(slider, near=bank_angle + np.pi, within=0.5)
    assert top.position - bottom.position == pytest.approx(stroke, abs=5e-6)
    assert top.position == pytest.approx(height, abs=5e-7)
    assert np.rad2deg(top.angle - bank_angle) == pytest.approx(shifts[0], abs=0.005)
    assert np.rad2deg(bottom.angle - bank_angle - np.pi) == pytest.approx(shifts[1], abs=0.005)
