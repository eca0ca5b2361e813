"""Trains of discs: closed forms, what a scaled mode and Holzer's table hold, nodes."""

import numpy as np
import pytest

from cranktrain.questions.torsion.train import (
    Train,
    cross_inertia,
    holzer_remainder,
    holzer_table,
    natural_modes,
    nodes,
    scaled,
)

ROUNDING = 1e-13


def chain(inertia, stiffness):
    """A train without branches."""
    return Train(np.array(inertia, dtype=float), np.array(stiffness, dtype=float), np.arange(1, len(inertia)))


BRANCHED = Train(
    np.array([0.3, 0.2, 0.2, 0.5, 4.0, 2.0]),
    np.array([1e5, 3e5, 3e5, 2e4, 5e3]),
    np.array([1, 2, 4, 4, 5]),
)
"""Pulley and two throws on a flywheel, on which a rotor stands as well, and then a propeller."""


def test_two_discs():
    train = chain([2.0, 5.0], [700.0])
    modes = natural_modes(train)
    np.testing.assert_allclose(modes.speed, [np.sqrt(700 * (1 / 2 + 1 / 5))], rtol=ROUNDING)
    np.testing.assert_allclose(scaled(modes.shape, 0)[0], [[1.0, -2 / 5]], rtol=ROUNDING)


@pytest.mark.parametrize("n", [2, 3, 6, 13])
def test_equal_discs_free_at_both_ends(n):
    modes = natural_modes(chain([0.04] * n, [1.2e6] * (n - 1)))
    half = np.arange(1, n)[:, np.newaxis] * np.pi / (2 * n)
    np.testing.assert_allclose(modes.speed, 2 * np.sqrt(1.2e6 / 0.04) * np.sin(half[:, 0]), rtol=ROUNDING)
    shape = np.cos((2 * np.arange(1, n + 1) - 1) * half) / np.cos(half)
    np.testing.assert_allclose(scaled(modes.shape, 0)[0], shape, rtol=1e-11, atol=1e-11)


def test_three_discs_by_their_quadratic():
    (one, two, three), (k, m) = (0.8, 0.3, 2.0), (4000.0, 9000.0)
    total = k * (1 / one + 1 / two) + m * (1 / two + 1 / three)
    product = k * m * (one + two + three) / (one * two * three)
    squares = np.roots([1.0, -total, product])[::-1]
    np.testing.assert_allclose(natural_modes(chain([one, two, three], [k, m])).speed ** 2, squares, rtol=1e-12)


def test_shaft_with_equal_ends_is_each_half_on_a_wall():
    """A disc between two equal ones stays still in the first mode, as a wall would."""
    modes = natural_modes(chain([0.5, 3.0, 0.5], [200.0, 200.0]))
    np.testing.assert_allclose(modes.speed[0], np.sqrt(200 / 0.5), rtol=ROUNDING)
    assert abs(scaled(modes.shape, 0)[0][0, 1]) < ROUNDING


def test_designs_are_computed_one_by_one():
    trains = [([1.0, 2.0, 3.0], [10.0, 20.0]), ([3.0, 1.0, 5.0], [40.0, 2.0])]
    both = natural_modes(Train(*(np.array(part) for part in zip(*trains, strict=True)), np.array([1, 2])))
    for design, (inertia, stiffness) in enumerate(trains):
        np.testing.assert_array_equal(both.speed[design], natural_modes(chain(inertia, stiffness)).speed)


@pytest.mark.parametrize("wrong", [np.nan, 0.0, -1.0, np.inf])
def test_a_design_without_inertia_has_no_modes_and_the_others_do(wrong):
    train = Train(np.array([[1.0, wrong], [1.0, 1.0]]), np.array([[2.0], [2.0]]), np.array([1]))
    modes = natural_modes(train)
    assert np.isnan(modes.speed[0]).all()
    assert np.isnan(modes.shape[0]).all()
    np.testing.assert_allclose(modes.speed[1], [2.0], rtol=ROUNDING)


def test_a_mode_whose_free_end_stays_is_measured_where_it_moves_most():
    """Two equal rotors on a flywheel swing against each other without it, and without the throw before it."""
    train = Train(np.array([0.1, 0.7, 0.7, 5.0]), np.array([1e5, 300.0, 300.0]), np.array([3, 3, 3]))
    modes = natural_modes(train)
    shape, unit = scaled(modes.shape, 0)
    still = int(np.argmin(np.abs(modes.speed - np.sqrt(300 / 0.7))))
    np.testing.assert_allclose(modes.speed[still], np.sqrt(300 / 0.7), rtol=ROUNDING)
    assert unit[still] in (1, 2)
    np.testing.assert_allclose(shape[still][[1, 2]], np.array([1.0, -1.0])[:: 3 - 2 * unit[still]], rtol=1e-12)
    assert [int(unit) for mode, unit in enumerate(unit) if mode != still] == [0, 0]


def test_holzer_table_of_two_discs():
    train = chain([2.0, 5.0], [700.0])
    speed = np.array([np.sqrt(490.0)])
    table = holzer_table(train, speed, np.array([[1.0, -0.4]]))
    np.testing.assert_allclose(table.torque, [[980.0, -980.0]])
    np.testing.assert_allclose(table.total, [[980.0, 0.0]], atol=1e-9)
    np.testing.assert_allclose(table.twist, [[1.4, np.nan]])


def test_holzer_table_closes_at_natural_frequencies_alone():
    modes = natural_modes(BRANCHED)
    shape = scaled(modes.shape, 0)[0]
    assert holzer_remainder(BRANCHED, holzer_table(BRANCHED, modes.speed, shape), shape) < 1e-14
    off = holzer_table(BRANCHED, modes.speed * (1 + 1e-9), shape)
    assert holzer_remainder(BRANCHED, off, shape) > 1e-10


def test_holzer_sums_what_a_branch_carries():
    """At the flywheel the throws' shaft and the rotor's meet."""
    table = holzer_table(BRANCHED, np.array([300.0]), np.ones((1, 6)))
    np.testing.assert_allclose(table.total / 300.0**2, [[0.3, 0.5, 0.7, 0.5, 5.2, 7.2]])


def test_modes_share_no_energy():
    modes = natural_modes(BRANCHED)
    assert cross_inertia(BRANCHED, modes.shape) < 1e-14
    bent = modes.shape + 1e-9 * np.max(np.abs(modes.shape)) * np.eye(*modes.shape.shape)
    assert cross_inertia(BRANCHED, bent) > 1e-11


@pytest.mark.parametrize("n", [3, 8])
def test_an_unbranched_train_has_as_many_nodes_as_its_mode_has_a_number(n):
    draw = np.random.default_rng(n)
    train = chain(draw.uniform(0.1, 3.0, n), draw.uniform(1e3, 1e6, n - 1))
    found = np.isfinite(nodes(train, scaled(natural_modes(train).shape, 0)[0]))
    np.testing.assert_array_equal(np.sum(found, axis=-1), np.arange(1, n))


def test_a_node_lies_where_the_straight_line_between_two_amplitudes_is_zero():
    train = chain([2.0, 5.0, 1.0], [700.0, 1.0])
    np.testing.assert_allclose(nodes(train, np.array([[1.0, -0.25, -3.0]])), [[0.8, np.nan, np.nan]])
    np.testing.assert_allclose(nodes(train, np.array([[1.0, 0.0, -1.0]])), [[1.0, np.nan, np.nan]])
