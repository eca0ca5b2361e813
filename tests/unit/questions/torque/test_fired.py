"""Pistons laid over each other and gathered along the shaft; stars of phase vectors against their closed forms."""

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from cranktrain.numerics.harmonics import curve, harmonics
from cranktrain.questions.forces.torque_curves import journal_torque
from cranktrain.questions.torque.fired import fired, firing_angles
from cranktrain.questions.torque.stars import phase_stars, shaft_harmonics

FEW = settings(max_examples=40, deadline=None, derandomize=True)

LAYOUTS = json.loads((Path(__file__).parents[3] / "golden/theory/balance_layouts.json").read_text(encoding="utf-8"))
SUMS = LAYOUTS["phase_vector_sums"]
FOUR_STROKE = 4 * np.pi
ODD_FIRE = "odd-fire 90/150 six"


def linear_mode(position):
    """Weights of a mode that falls in a straight line along the shaft, from +1 at the first position to −1."""
    return 1 - 2 * (position - position[0]) / (position[-1] - position[0])


def even_firing_sum(order, n_cylinders, interval):
    """Star at equal intervals Δ: |sin(zkΔ/2)/sin(kΔ/2)|; docs/theory/harmonics-and-orders, eq. (15.15)."""
    half = order * interval / 2
    whole = np.abs(half / np.pi - np.rint(half / np.pi)) < 1e-9
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(whole, float(n_cylinders), np.abs(np.sin(n_cylinders * half) / np.sin(half)))


def firing_of(name):
    """Firing angles from the order in the name, "I4 1-3-4-2 weighted …"."""
    order = np.array([int(cylinder) - 1 for cylinder in name.split()[1].split("-")])
    return firing_angles(order, FOUR_STROKE)


@pytest.mark.parametrize("name", [name for name in SUMS if name != ODD_FIRE])
def test_sums_of_the_table(name):
    firing = firing_of(name)
    weight = linear_mode(np.arange(float(len(firing)))) if "weighted" in name else None
    orders = np.array([float(order) for order in SUMS[name]])
    np.testing.assert_allclose(phase_stars(orders, firing, weight).length, list(SUMS[name].values()), atol=1e-13)


def test_sums_of_an_odd_firing_six():
    firing = np.radians(np.cumsum([0, 90, 150, 90, 150, 90]))
    orders = np.array([float(order) for order in SUMS[ODD_FIRE]])
    found = phase_stars(orders, firing)
    np.testing.assert_allclose(found.length, list(SUMS[ODD_FIRE].values()), atol=1e-13)
    # none is whole below order 12: 90° and 150° have no common multiple of turns
    assert not np.any(found.is_major[orders < 12])


@pytest.mark.parametrize("n_cylinders", [1, 2, 3, 4, 5, 6, 8, 12])
def test_even_firing_adds_up_at_multiples_of_half_the_cylinders(n_cylinders):
    orders = np.arange(1, 49) / 2
    firing = firing_angles(np.arange(n_cylinders), FOUR_STROKE)
    found = phase_stars(orders, firing)
    np.testing.assert_array_equal(found.is_major, (2 * orders) % n_cylinders == 0)
    np.testing.assert_allclose(
        even_firing_sum(orders, n_cylinders, FOUR_STROKE / n_cylinders), found.length, atol=1e-12
    )


@FEW
@given(st.integers(1, 9), st.floats(0.01, 6))
def test_firing_at_any_equal_interval_has_a_closed_sum(n_cylinders, interval):
    orders = np.arange(1, 13) / 2
    found = phase_stars(orders, interval * np.arange(n_cylinders)).length
    np.testing.assert_allclose(even_firing_sum(orders, n_cylinders, interval), found, atol=1e-9)


def test_weighted_stars_can_be_major_without_adding_up():
    found = phase_stars(np.array([2.0]), np.radians([0.0, 180.0]), np.array([1.0, -1.0]))
    assert not found.is_major[0]
    assert phase_stars(np.array([1.0]), np.radians([0.0, 180.0]), np.array([1.0, -1.0])).is_major[0]


@FEW
@given(st.lists(st.floats(-7, 7), min_size=1, max_size=5).map(np.array))
def test_the_shafts_harmonics_are_those_of_the_sum_of_curves(firing):
    samples = np.random.default_rng(0).normal(size=(1, 45))
    total = np.sum(fired(samples, firing, FOUR_STROKE), axis=-2)
    by_stars = shaft_harmonics(harmonics(samples[0], FOUR_STROKE), firing)
    np.testing.assert_allclose(harmonics(total, FOUR_STROKE).vectors, by_stars.vectors, atol=1e-12)


def test_a_shift_by_whole_steps_keeps_a_jump_as_it_is():
    samples = np.zeros((1, 8))
    samples[0, 0] = 1.0
    found = fired(samples, np.array([0.0, np.pi / 2, -np.pi / 4]), 2 * np.pi)
    np.testing.assert_array_equal(np.argmax(found, axis=-1), [0, 2, 7])
    np.testing.assert_array_equal(np.sort(found, axis=-1)[:, :-1], 0.0)


def test_a_shift_between_steps_goes_through_the_series():
    cycle = FOUR_STROKE
    phi = np.arange(30) * cycle / 30
    samples = 1 + np.cos(phi / 2) + np.sin(3.5 * phi)
    shifted = fired(samples[np.newaxis], np.array([0.1]), cycle)[0]
    np.testing.assert_allclose(shifted, 1 + np.cos((phi - 0.1) / 2) + np.sin(3.5 * (phi - 0.1)), atol=1e-13)


def test_pistons_and_designs_have_axes_of_their_own():
    samples = np.random.default_rng(0).normal(size=(2, 3, 21))
    firing = np.array([0.0, 2.0, 4.0])
    found = fired(samples, firing, FOUR_STROKE)
    phi = np.arange(21) * FOUR_STROKE / 21
    for design in range(2):
        for piston in range(3):
            one = harmonics(samples[design, piston], FOUR_STROKE)
            np.testing.assert_allclose(found[design, piston], curve(one, phi - firing[piston]), atol=1e-12)


def test_journals_pass_on_what_stands_before_them():
    throws = np.random.default_rng(0).normal(size=(2, 4, 6))
    found = journal_torque(throws)
    assert found.shape == (2, 5, 6)
    np.testing.assert_array_equal(found[:, 0], 0)
    np.testing.assert_allclose(np.diff(found, axis=-2), throws, atol=1e-15)
    np.testing.assert_allclose(found[:, -1], throws.sum(axis=-2), atol=1e-15)
