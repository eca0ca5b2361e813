"""Roots and extremes: against curves whose roots and extremes are known."""

import numpy as np
import pytest

from cranktrain.motion import Coefficient
from cranktrain.numerics import (
    bracketed_roots,
    derivatives_residual,
    extremes,
    largest,
    near_roots,
    smallest,
    spectral_derivative,
    turn_grid,
    turning_points,
    unwrapped,
)

PHASES = np.linspace(-3, 9, 17).reshape(-1, 1)


def shifted(function):
    """Curves that are alike but for their phase, as rows."""
    return lambda phi: function(phi - PHASES)


def away_from(angle, expected):
    """Difference of angles that count round."""
    return np.abs((angle - expected + np.pi) % (2 * np.pi) - np.pi)


def motion(phi):
    """5 + 2 sin φ + 0.3 sin 2φ, with extremes where 2 cos φ + 0.6 cos 2φ = 0."""
    phi = phi - PHASES
    return Coefficient(
        5 + 2 * np.sin(phi) + 0.3 * np.sin(2 * phi),
        2 * np.cos(phi) + 0.6 * np.cos(2 * phi),
        -2 * np.sin(phi) - 1.2 * np.sin(2 * phi),
    )


COSINE = (-2 + np.sqrt(4 + 4 * 1.2 * 0.6)) / (4 * 0.6)
"""Cosine of the extremes' angles, the root of 1.2 c² + 2 c − 0.6 = 0."""
TOP = np.arccos(COSINE)


@pytest.mark.parametrize(
    ("curve", "low", "high", "root"),
    [
        (lambda x: x - 0.25, 0.0, 1.0, 0.25),
        (lambda x: x**3 - 2, 0.0, 2.0, 2 ** (1 / 3)),
        (np.cos, 1.0, 2.0, np.pi / 2),
        (lambda x: np.exp(50 * x) - np.exp(5), -1.0, 1.0, 0.1),
        (lambda x: np.sign(x - 0.3), 0.0, 1.0, 0.3),
        (lambda x: 1e-200 * (x - 0.7), 0.0, 1.0, 0.7),
        (lambda x: x, 0.0, 1.0, 0.0),
    ],
)
def test_roots_to_rounding(curve, low, high, root):
    found = bracketed_roots(curve, np.array([low, high]), np.array([high, low]))
    np.testing.assert_allclose(found, root, rtol=4e-16, atol=1e-16)


def test_roots_of_many_curves_at_once():
    targets = np.geomspace(1e-9, 1e9, 19)
    found = bracketed_roots(lambda x: x**3 - targets, np.zeros(19), np.full(19, 2e3))
    np.testing.assert_allclose(found, np.cbrt(targets), rtol=1e-15)


def counted(curve):
    """The curve, and a list that grows with each call."""
    calls = []

    def each(x):
        calls.append(x)
        return curve(x)

    return each, calls


def test_roots_of_smooth_curves_take_few_trials():
    """The values are sums that round to whole 1e-16, and are never 0."""
    roots = np.linspace(0.01, 0.5, 30)
    curve, calls = counted(lambda x: np.sin(x + 1) - np.sin(roots + 1) + 1e-17)
    found = bracketed_roots(curve, roots - 0.013, roots - 0.013 + np.pi / 180)
    np.testing.assert_allclose(found, roots, rtol=0, atol=1e-15)
    assert len(calls) <= 8


def test_least_roots_alone_are_followed():
    """Of slopes 1, the second by far the least: what is still below 0 there is not looked for any farther."""
    roots = np.array([[0.9], [0.5], [0.7], [0.6]])
    bent = np.array([[30.0], [0.0], [0.0], [30.0]])
    curve, calls = counted(lambda x: x - roots + bent * (x - roots) ** 3)
    low, high = np.zeros((4, 1)), np.ones((4, 1))
    found = near_roots(curve, np.full((4, 1), 0.45), low, high, np.array([[0], [0], [0], [1]]))
    np.testing.assert_allclose(found[[1, 3]], roots[[1, 3]], rtol=1e-15)
    assert np.isnan(found[0])
    n_calls = len(calls)
    np.testing.assert_allclose(near_roots(curve, np.full((4, 1), 0.45), low, high), roots, rtol=1e-15)
    assert n_calls < len(calls) - n_calls


def test_no_sign_change_and_nan_are_no_roots():
    def curve(x):
        return np.stack([x[0] ** 2 + 1, np.where(x[1] > 0.4, np.nan, x[1] - 1), x[2] - 0.5])

    found = bracketed_roots(curve, np.zeros(3), np.ones(3))
    assert np.isnan(found).tolist() == [True, True, False]
    assert found[2] == 0.5


def test_a_root_at_an_end_does_not_hide_the_one_within():
    found = bracketed_roots(lambda x: (x - 0.3) * (1 - x), np.array([0.0]), np.array([1.0]))
    np.testing.assert_allclose(found, 0.3, rtol=1e-15)


def test_turn_grid_is_open_at_its_end():
    grid = turn_grid(8)
    np.testing.assert_allclose(grid, np.arange(8) * np.pi / 4)


def test_extremes_with_a_slope_are_exact():
    least, most = extremes(lambda phi: motion(phi).value, lambda phi: motion(phi).first)
    height = 2 * np.sin(TOP) + 0.3 * np.sin(2 * TOP)
    np.testing.assert_allclose(most.value, 5 + height, rtol=1e-15)
    np.testing.assert_allclose(least.value, 5 - height, rtol=1e-15)
    assert np.max(away_from(most.angle, PHASES + TOP)) < 4e-15
    assert np.max(away_from(least.angle, PHASES - TOP)) < 4e-15


def test_extremes_without_a_slope_have_exact_values():
    most = largest(lambda phi: motion(phi).value)
    np.testing.assert_allclose(most.value, 5 + 2 * np.sin(TOP) + 0.3 * np.sin(2 * TOP), rtol=4e-16)
    assert np.max(away_from(most.angle, PHASES + TOP)) < 1e-9


def test_turning_points_are_exact():
    calls = []

    def counted(phi):
        calls.append(phi)
        return motion(phi)

    least, most = turning_points(counted, motion(turn_grid()).value)
    assert len(calls) <= 6
    assert np.max(away_from(most.angle, PHASES + TOP)) < 4e-15
    assert np.max(away_from(least.angle, PHASES - TOP)) < 4e-15
    np.testing.assert_allclose(most.value - least.value, 2 * (2 * np.sin(TOP) + 0.3 * np.sin(2 * TOP)), rtol=1e-15)


def test_turning_points_where_newton_fails():
    """|sin|-like: sharp enough that Newton leaves the grid's step; the bracket still finds the point."""
    width = 1e-4

    def sharp(phi):
        x = np.sin(phi - 1.0007)
        root = np.sqrt(x**2 + width**2)
        cos = np.cos(phi - 1.0007)
        return Coefficient(-root, -x * cos / root, -(cos**2 - x**2) / root + (x * cos) ** 2 / root**3)

    _least, most = turning_points(
        lambda phi: Coefficient(*(part[np.newaxis] for part in sharp(phi))), sharp(turn_grid())[0][np.newaxis]
    )
    assert np.min(away_from(most.angle, np.array([1.0007, 1.0007 + np.pi]))) < 1e-13
    np.testing.assert_allclose(most.value, -width, rtol=1e-9)


def test_smallest_is_the_largest_of_the_negative():
    curve = shifted(lambda phi: np.exp(np.cos(phi)))
    np.testing.assert_allclose(smallest(curve).value, np.exp(-1), rtol=1e-15)
    np.testing.assert_allclose(largest(lambda phi: -curve(phi)).value, -np.exp(-1), rtol=1e-15)


def test_of_two_peaks_nearly_alike_the_higher_one_is_found():
    """On the grid the lower one looks higher: it stands on a grid point and the other halfway between two."""
    step = 2 * np.pi / 720

    def curve(phi):
        return np.exp(-20 * (1 - np.cos(phi - 100 * step))) + (1 + 1e-6) * np.exp(
            -20 * (1 - np.cos(phi - 400.5 * step))
        )

    samples = curve(turn_grid())
    assert samples[100] > samples[400]
    assert largest(curve).angle[0] == pytest.approx(400.5 * step, abs=1e-9)
    assert largest(curve).value[0] == pytest.approx(1 + 1e-6, rel=1e-12)


@pytest.mark.parametrize("rounding", [-1e-14, 0.0, 1e-14])
def test_of_two_peaks_alike_the_first_is_taken(rounding):
    """Rounding does not choose the angle; the value is still the larger one's."""

    def curve(phi):
        return np.cos(phi - 0.4) ** 2 * (1 + rounding * np.sign(np.cos(phi - 0.4)))

    found = largest(curve)
    assert found.angle[0] == pytest.approx(0.4, abs=1e-9)
    assert found.value[0] == max(curve(np.array([0.4, 0.4 + np.pi])))


def test_known_samples_and_grids():
    grid = turn_grid(36)
    curve = shifted(np.cos)
    np.testing.assert_allclose(largest(curve, grid=grid).value, 1.0, rtol=1e-15)
    np.testing.assert_allclose(largest(curve, grid=grid, samples=curve(grid)).value, 1.0, rtol=1e-15)


@pytest.mark.parametrize("kind", ["values", "slope", "newton"])
def test_a_curve_that_ends_has_no_extreme_at_its_end(kind):
    """One cosine is cut off before its top, the other is whole."""

    def cut(phi):
        value, first, second = np.cos(phi), -np.sin(phi), -np.cos(phi)
        ended = np.where(np.cos(phi - 2.0) > 0.2, 0.0, np.nan)
        return Coefficient(*(np.stack([part + ended, part]) for part in (value, first, second)))

    def rows(phi):
        found = cut(phi)
        if phi.ndim == 1:
            return found
        return Coefficient(*(np.stack([part[0, 0], part[1, 1]]) for part in found))

    if kind == "newton":
        least, most = turning_points(rows, rows(turn_grid()).value)
    elif kind == "slope":
        least, most = extremes(lambda phi: rows(phi).value, lambda phi: rows(phi).first)
    else:
        least, most = extremes(lambda phi: rows(phi).value)
    # The cut curve runs from 0.63 to 3.37 rad: its bottom, at π, is a turning point; its top is an end.
    np.testing.assert_allclose(most.value[:, 0], [np.nan, 1.0])
    np.testing.assert_allclose(least.value[:, 0], [-1.0, -1.0])
    assert np.isnan(most.angle[0, 0])


def test_nothing_but_nan():
    least, most = extremes(lambda phi: np.full((1, phi.shape[-1]), np.nan))
    assert np.isnan([least.value, most.value]).all()


def test_unwrapped():
    turning = np.linspace(0.5, 20, 200)
    principal = np.angle(np.exp(1j * turning))
    np.testing.assert_allclose(unwrapped(np.stack([principal, -principal])), np.stack([turning, -turning]), atol=1e-14)


def test_unwrapped_across_nan():
    turning = np.linspace(0.5, 8, 100)
    principal = np.angle(np.exp(1j * turning))
    principal[:3] = principal[30:45] = np.nan
    expected = np.where(np.isnan(principal), np.nan, turning)
    np.testing.assert_allclose(unwrapped(principal), expected, atol=1e-14)


@pytest.mark.parametrize("n_points", [64, 65])
def test_spectral_derivative(n_points):
    phi = turn_grid(n_points)
    found = spectral_derivative(np.stack([np.exp(np.sin(phi)), np.cos(3 * phi)]))
    np.testing.assert_allclose(found, np.stack([np.cos(phi) * np.exp(np.sin(phi)), -3 * np.sin(3 * phi)]), atol=1e-13)


def test_residual_of_derivatives():
    def wrong(phi):
        value, first, second = motion(phi)
        return Coefficient(value, first, second + 1e-5 * np.sin(7 * phi))

    assert np.max(derivatives_residual(motion)) < 1e-12
    assert np.min(derivatives_residual(wrong)) == pytest.approx(
        1e-5 / np.max(np.abs(motion(turn_grid()).second)), rel=0.1
    )


def test_residual_of_sharp_curves_uses_a_longer_series():
    lengths = []

    def sharp(phi):
        lengths.append(phi.size)
        root = np.sqrt(1.0001 - np.sin(phi) ** 2)
        double = np.sin(2 * phi)
        first = -double / (2 * root)
        second = -np.cos(2 * phi) / root - double**2 / (4 * root**3)
        return Coefficient(root, first, second)

    assert derivatives_residual(sharp)[0] < 1e-9
    assert lengths[-1] > 720
