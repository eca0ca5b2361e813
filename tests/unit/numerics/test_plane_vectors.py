"""Vectors that turn with the crank and against it."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.vectors_by_order import turned_vectors

from cranktrain.numerics import largest, turn_grid
from cranktrain.numerics.plane_vectors import (
    PlaneVectors,
    added,
    curve_vectors,
    delayed_vectors,
    hodograph,
    machine_axes,
    vector_curve,
)

FEW = settings(max_examples=40, deadline=None, derandomize=True)

PHI = np.arange(360) * (2 * np.pi / 360)
PART = st.complex_numbers(max_magnitude=5)


def random_vectors(seed=0, n_orders=4):
    parts = np.random.default_rng(seed).normal(size=(4, n_orders))
    parts[2:, 0] = 0.0
    return PlaneVectors(np.arange(float(n_orders)), parts[0] + 1j * parts[1], parts[2] + 1j * parts[3])


@pytest.mark.parametrize("cycle", [2 * np.pi, 4 * np.pi])
def test_orders_of_a_curve_and_back(cycle):
    rng = np.random.default_rng(0)
    order = np.arange(7) * (2 * np.pi / cycle)
    known = PlaneVectors(order, *(rng.normal(size=(2, 7)) + 1j * rng.normal(size=(2, 7))))
    known.backward[0] = 0
    at = np.arange(30) * cycle / 30
    point = vector_curve(known, at)
    found = curve_vectors(point.real, point.imag, round(order[-1]), cycle)
    for ours, given_ in zip(found, known, strict=True):
        np.testing.assert_allclose(ours, given_, atol=1e-14)


def test_highest_order_of_an_even_grid_is_shared():
    wave = np.cos(4 * np.arange(8) * np.pi / 4)
    found = curve_vectors(wave, 0 * wave, 4)
    assert found.forward[4] == found.backward[4] == 0.5


@FEW
@given(PART, PART)
def test_ellipse_bounds_the_vector(forward, backward):
    one = PlaneVectors(np.array([3.0]), np.array([forward]), np.array([backward]))
    length = np.abs(vector_curve(one, PHI))
    found = hodograph(one)
    size = found.major[0] + 1e-12
    assert length.max() <= found.major[0] + 1e-12 * size
    assert length.min() >= found.minor[0] - 1e-12 * size
    # 120 points to its turn: the extremes are met to (3π/360)²/2 of the axis
    assert length.max() >= found.major[0] * (1 - 4e-4) - 1e-12
    along = vector_curve(one, PHI) * np.exp(-1j * found.direction[0])
    assert np.abs(along.imag).max() <= found.minor[0] + 1e-9 * size


def test_sense_of_the_tip():
    vectors = PlaneVectors(np.ones(3), np.array([1.0, 0.5, 0.2 + 0j]), np.array([0.2, 0.5, 1.0 + 0j]))
    np.testing.assert_array_equal(hodograph(vectors).sense, [1, 0, -1])


@FEW
@given(st.floats(-7, 7))
def test_turned_and_delayed(angle):
    known = random_vectors()
    np.testing.assert_allclose(
        vector_curve(turned_vectors(known, angle), PHI), vector_curve(known, PHI) * np.exp(1j * angle), atol=1e-12
    )
    np.testing.assert_allclose(
        vector_curve(delayed_vectors(known, angle), PHI), vector_curve(known, PHI - angle), atol=1e-12
    )


@pytest.mark.parametrize(("clockwise", "right"), [(True, 1.0), (False, -1.0)])
def test_axes_of_the_machine(clockwise, right):
    # bank angle 0 points up; a quarter turn of a clockwise machine on, the axis points to the right
    assert machine_axes(1.0 + 0j, clockwise=clockwise) == 1j
    assert machine_axes(np.exp(0.5j * np.pi), clockwise=clockwise) == pytest.approx(right, abs=1e-15)


def test_added():
    parts = [random_vectors(seed) for seed in range(3)]
    expected = sum(vector_curve(part, PHI) for part in parts)
    np.testing.assert_allclose(vector_curve(added(*parts), PHI), expected, atol=1e-13)


def test_largest_length_lies_between_the_points():
    # |1 + 0.5 e^{i(φ − 0.0123)}| is largest at 0.0123, where it is 1.5
    known = PlaneVectors(np.array([0.0, 1.0]), np.array([1.0, 0.5 * np.exp(-0.0123j)]), np.zeros(2, dtype=complex))
    found = largest(lambda angle: np.abs(vector_curve(known, angle)), grid=turn_grid(36))
    assert found.value[0] == pytest.approx(1.5, abs=1e-15)
    assert found.angle[0] == pytest.approx(0.0123, abs=1e-8)
