"""The oracles themselves: their links keep their lengths, to forty digits, in value and derivatives."""

import numpy as np
import pytest
from flint import arb, arb_series
from tests.exact import oracles
from tests.exact.geometries import articulated_rods, crank_rockers, slider_cranks
from tests.exact.oracles import Motion


def coordinates(motion: Motion, name: str) -> oracles.Vector:
    return motion[f"{name}.x"], motion[f"{name}.y"]


def apart(one: oracles.Vector, other: oracles.Vector, distance: float) -> arb_series:
    """Zero where two points keep their distance."""
    between = oracles.difference(one, other)
    return oracles.dot(between, between) - arb(distance) ** 2


def along_its_angle(motion: Motion, name: str) -> list[arb_series]:
    sin, cos = motion[f"{name}.angle"].sin_cos()
    return [cos - motion[f"{name}.cos"], sin - motion[f"{name}.sin"]]


def point(x: float | arb_series, y: float | arb_series) -> oracles.Vector:
    return oracles.constant(0) + x, oracles.constant(0) + y


def slider_crank_residuals(motion, angle, crank_radius, rod_length, offset):
    pin, slider = coordinates(motion, "pin"), point(motion["slider"], offset)
    return [
        apart(pin, point(0, 0), crank_radius),
        apart(slider, pin, rod_length),
        *along_its_angle(motion, "rod"),
    ]


def crank_rocker_residuals(motion, angle, crank_radius, rod_length, rocker_length, ground_length, side, radius, turn):
    pin, joint = coordinates(motion, "pin"), coordinates(motion, "joint")
    rod, to_coupler_point = (oracles.difference(end, pin) for end in (joint, coordinates(motion, "coupler_point")))
    pivot = point(ground_length, 0)
    is_left = oracles.dot(oracles.left_of(oracles.difference(pivot, pin)), rod)[0] > 0
    assert is_left == (side > 0)
    return [
        apart(joint, pin, rod_length),
        apart(joint, pivot, rocker_length),
        oracles.dot(rod, to_coupler_point) - rod_length * arb(radius) * arb(turn).cos(),
        oracles.dot(oracles.left_of(rod), to_coupler_point) - rod_length * arb(radius) * arb(turn).sin(),
        *along_its_angle(motion, "rod"),
        *along_its_angle(motion, "rocker"),
    ]


def articulated_rod_residuals(
    motion, angle, crank_radius, master_rod, master_offset, knuckle_radius, articulation, bank, rod_length, offset
):
    pin, knuckle = coordinates(motion, "pin"), coordinates(motion, "knuckle")
    to_knuckle = oracles.difference(oracles.turned(knuckle, -arb(bank)), pin)
    master = motion["master_rod.cos"], motion["master_rod.sin"]
    return [
        apart(pin, point(0, 0), crank_radius),
        pin[1] + arb(master_rod) * master[1] - arb(master_offset),
        oracles.dot(master, to_knuckle) - arb(knuckle_radius) * arb(articulation).cos(),
        oracles.dot(oracles.left_of(master), to_knuckle) - arb(knuckle_radius) * arb(articulation).sin(),
        apart(knuckle, point(motion["slider"], offset), rod_length),
        *along_its_angle(motion, "master_rod"),
        *along_its_angle(motion, "rod"),
    ]


def flat(geometry) -> list:
    return [part for field in geometry for part in (flat(field) if isinstance(field, tuple) else [field])]


@pytest.mark.parametrize(
    ("machines", "mechanism", "residuals", "further"),
    [
        (slider_cranks(100, seed=3), oracles.slider_crank, slider_crank_residuals, []),
        (crank_rockers(100, seed=3), oracles.crank_rocker, crank_rocker_residuals, [0.04, 1.2]),
        (articulated_rods(100, seed=3), oracles.articulated_rod, articulated_rod_residuals, []),
    ],
    ids=["slider_crank", "crank_rocker", "articulated_rod"],
)
def test_links_keep_their_lengths(machines, mechanism, residuals, further):
    angles = machines.tested_angles(np.random.default_rng(4))
    columns = np.hstack(flat(machines.geometry))
    with oracles.series_arithmetic():
        for row, angle in zip(columns.tolist(), angles[:, 1].tolist(), strict=True):
            numbers = [angle, *row, *further]
            for residual in residuals(mechanism(*numbers), *numbers):
                for order in range(oracles.ORDER):
                    assert residual[order].contains(0)
                    assert residual[order].abs_upper() < 1e-38


def test_derivatives_at_dead_centre_and_quarter():
    exact = oracles.coefficients(oracles.slider_crank, np.array([0.0, np.pi / 2]), 1.0, 2.0, 0.0)
    # At the dead centre s″ = −R(1 + λ); at the quarter s = √(L² − R²), s′ = −R, s″ = Rλ/√(1 − λ²).
    np.testing.assert_allclose(exact["slider"].value, [3.0, np.sqrt(3.0)], rtol=4e-16)
    np.testing.assert_allclose(exact["slider"].first, [0.0, -1.0], rtol=4e-16, atol=1e-16)
    np.testing.assert_allclose(exact["slider"].second, [-1.5, 1 / np.sqrt(3.0)], rtol=4e-16)
