"""Roots by Newton's method within brackets, against closed forms."""

import numpy as np

from cranktrain.numerics.polynomials import polynomial, polynomial_value
from cranktrain.numerics.roots import newton_roots, secant_share


def roots_of(powers, low, high, sense, share):
    return newton_roots(lambda way: polynomial(powers, way)[:2], low, high, sense, share)


def test_roots_of_parabolas():
    """t² − q² falls and rises again: one root in each half, both signs of it."""
    where = np.array([1e-3, 0.01, 0.3, 0.999])
    powers = np.stack([-(where**2), np.zeros(4), np.ones(4)])
    zero, one = np.zeros(4), np.ones(4)
    for share in (0.0, 0.5, 1.0):
        np.testing.assert_allclose(roots_of(powers, zero, one, one, share * one), where, rtol=0, atol=1e-9)
        np.testing.assert_allclose(roots_of(powers, -one, zero, -one, share * one), -where, rtol=0, atol=1e-9)


def test_a_root_without_a_slope():
    found = roots_of(np.array([[0.0], [0.0], [0.0], [1.0]]), -np.ones(1), np.ones(1) * 0.7, np.ones(1), np.full(1, 0.5))
    assert abs(found[0]) < 1e-5


def test_what_changed_before_the_bracket_gives_its_start_and_after_it_its_end():
    powers, zero, one = np.array([[1e-17, -1.0 - 1e-17], [1.0, 1.0]]), np.zeros(2), np.ones(2)
    np.testing.assert_allclose(roots_of(powers, zero, one, one, 0.5 * one), [0.0, 1.0], atol=1e-9)


def test_secants():
    assert secant_share(np.array([-1.0, 0.0, 3.0, 0.0]), np.array([3.0, 2.0, -1.0, 0.0])).tolist() == [
        0.25,
        0.0,
        0.75,
        0.0,
    ]


def test_a_value_alone():
    powers, x = np.random.default_rng(0).normal(size=(7, 2, 5)), np.linspace(-1.0, 1.0, 5)
    np.testing.assert_array_equal(polynomial_value(powers, x), polynomial(powers, x).value)
