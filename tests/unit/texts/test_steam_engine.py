import mpmath
import numpy as np
import pytest

from cranktrain.fluids.indicator.brix import brix_angle
from cranktrain.texts import steam_engine

ANGLES = np.radians([0.0, 1e-3, 17.0, 60.0, 90.0, 133.0, 180.0, 251.0, 270.0, 359.0, -40.0, 725.0])
RADIUS, RATIO = 0.2, 0.29

FORMULAS = {
    "infinite_rod": lambda phi, R, _: R * (1 - mpmath.cos(phi)),
    "two_harmonics": lambda phi, R, lam: R * (1 - mpmath.cos(phi) + lam / 2 * mpmath.sin(phi) ** 2),
    "two_harmonics_from_crank_side": lambda phi, R, lam: R * (1 - mpmath.cos(phi) - lam / 2 * mpmath.sin(phi) ** 2),
    "brix": lambda phi, R, lam: R * (1 - mpmath.cos(phi + mpmath.asin(lam / 2 * mpmath.sin(phi)))),
}


def motion_of(name, angle, radius, ratio):
    method = getattr(steam_engine, name)
    return method(angle, radius) if name == "infinite_rod" else method(angle, radius, ratio)


@pytest.mark.parametrize("name", FORMULAS)
def test_value_and_derivatives_against_the_printed_formula_in_40_digits(name):
    found = motion_of(name, ANGLES, RADIUS, RATIO)
    with mpmath.workdps(40):
        R, lam = mpmath.mpf(RADIUS), mpmath.mpf(RATIO)

        def formula(phi):
            return FORMULAS[name](phi, R, lam)

        expected = np.array(
            [[float(mpmath.diff(formula, mpmath.mpf(phi), order)) for phi in ANGLES] for order in range(3)]
        )
    for order in range(3):
        np.testing.assert_allclose(found[order], expected[order], rtol=0, atol=4e-16)
    # the small displacement at 0.001° keeps its relative digits too
    assert found.value[1] == pytest.approx(expected[0, 1], rel=1e-14)


def test_brix_is_the_drawn_construction():
    # pole Z from the shaft centre away from the cylinder (x < 0 here); ray at φ meets the circle; projection on x
    pole = -steam_engine.largest_difference(RADIUS, RATIO)
    for angle in ANGLES:
        # positive root t of |pole + t(cos φ, sin φ)|² = R²
        reach = np.roots([1.0, 2 * pole * np.cos(angle), pole**2 - RADIUS**2]).max()
        assert steam_engine.brix(angle, RADIUS, RATIO).value == pytest.approx(
            RADIUS - (pole + reach * np.cos(angle)), abs=1e-15
        )


def test_brix_backwards_returns_the_angle_of_either_stroke():
    outward = np.linspace(0.01, np.pi - 0.01, 50)
    displacement = steam_engine.brix(outward, RADIUS, RATIO).value
    np.testing.assert_allclose(brix_angle(displacement, RADIUS, RATIO), outward, rtol=0, atol=1e-13)
    homeward = steam_engine.brix(2 * np.pi - outward, RADIUS, RATIO).value
    np.testing.assert_allclose(brix_angle(homeward, RADIUS, RATIO), outward, rtol=0, atol=1e-13)


def test_brix_backwards_at_and_beyond_the_ends_of_the_stroke():
    ends = brix_angle(np.array([0.0, 2 * RADIUS]), RADIUS, RATIO)
    np.testing.assert_allclose(ends, [0.0, np.pi], rtol=0, atol=1e-15)
    with np.errstate(invalid="ignore"):
        assert np.isnan(brix_angle(np.array([-0.001, 2 * RADIUS + 0.001]), RADIUS, RATIO)).all()


def test_largest_difference_is_that_of_333_and_334_across_the_line_of_stroke():
    angle = np.radians(np.arange(0, 360, 0.5))
    difference = steam_engine.two_harmonics(angle, RADIUS, RATIO).value - steam_engine.infinite_rod(angle, RADIUS).value
    assert difference.max() == pytest.approx(steam_engine.largest_difference(RADIUS, RATIO), rel=1e-14)
    assert np.degrees(angle[np.isclose(difference, difference.max(), rtol=1e-12)]) == pytest.approx([90.0, 270.0])
    # Z = R²/(2L)
    assert steam_engine.largest_difference(RADIUS, RATIO) == pytest.approx(RADIUS**2 / (2 * RADIUS / RATIO), rel=1e-15)


def test_both_dead_centres_describe_one_motion():
    # the piston is where it is: distances from the two dead centres add up to the stroke
    head = steam_engine.two_harmonics(ANGLES, RADIUS, RATIO)
    crank = steam_engine.two_harmonics_from_crank_side(ANGLES - np.pi, RADIUS, RATIO)
    np.testing.assert_allclose(head.value + crank.value, 2 * RADIUS, rtol=1e-14)
    np.testing.assert_allclose(head.first, -crank.first, rtol=0, atol=1e-15)
    np.testing.assert_allclose(head.second, -crank.second, rtol=0, atol=1e-15)


@pytest.mark.parametrize("name", FORMULAS)
def test_designs_broadcast_before_the_crank_angle(name):
    radii, ratios = np.array([[0.1], [0.2], [0.3]]), np.array([[0.1], [0.2], [0.3]])
    together = motion_of(name, ANGLES, radii, ratios)
    for design in range(3):
        alone = motion_of(name, ANGLES, radii[design, 0], ratios[design, 0])
        for found, expected in zip(together, alone, strict=True):
            assert found.shape == (3, ANGLES.size)
            np.testing.assert_array_equal(found[design], expected)
