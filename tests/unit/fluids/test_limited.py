"""The curve of a card: exact where samples are smooth, flat on plateaus, tight in corners, and with its jumps."""

import numpy as np
import pytest
from scipy.interpolate import Akima1DInterpolator
from scipy.optimize import minimize_scalar

from cranktrain.fluids.indicator.curve import crest, curve_at
from cranktrain.fluids.indicator.limited import akima_slopes, limited_curve

TURN = 2 * np.pi
EVEN = np.arange(24) * (TURN / 24)


def between(curve, first, last, n_points=2001):
    """Values of a curve from one place to just before another."""
    return curve_at(curve, np.linspace(first, last - 1e-9, n_points))


def test_even_steps_have_scipys_modified_akima_slopes():
    """The values are noise: no two of them are equal."""
    values = np.random.default_rng(7).standard_normal(40)
    theirs = Akima1DInterpolator(np.arange(40.0), values, method="makima")(np.arange(2.0, 38.0), 1)
    assert akima_slopes(np.ones(39), np.diff(values)) == pytest.approx(theirs, rel=1e-12)


@pytest.mark.parametrize("spread", [0.0, 0.9])
def test_a_cubic_comes_back_exactly_between_jumps(spread):
    """A monotone cubic from 0 to the jump at the seam; but for the outer two steps, whose slopes parabolas continue."""
    places = np.linspace(0, TURN, 25)
    places[1:-1] += spread * np.random.default_rng(3).uniform(-0.4, 0.4, 23) * TURN / 24

    def cubic(angle):
        return 3 + angle + 0.2 * angle**2 + 0.05 * angle**3

    angles = np.append(0.0, places[:-1])
    curve = limited_curve(angles, np.append(cubic(TURN), cubic(places[:-1])), TURN)
    assert curve.jumps.tolist() == [0.0]
    inside = np.linspace(places[2], places[-3], 500)
    assert curve_at(curve, inside) == pytest.approx(cubic(inside), rel=1e-13)
    ends = np.linspace(0.0, TURN - 1e-9, 500)
    assert curve_at(curve, ends) == pytest.approx(cubic(ends), rel=1e-3)


def test_smooth_samples_are_met_to_the_fourth_order():
    """Twice as many samples leave a sixteenth of the error, a fifteenth at the least, round the whole turn."""

    def wave(angle):
        return 5 + np.sin(angle) + 0.3 * np.cos(angle)

    at = np.linspace(0, TURN, 3000)
    errors = []
    for n_points in (72, 144):
        angles = np.arange(n_points) * (TURN / n_points)
        curve = limited_curve(angles, wave(angles), TURN)
        # Where the wave has no curvature, 3 % of the turn, second differences of one sign end, and limits bite.
        curved = np.abs(wave(at) - 5) > 0.25
        errors.append(np.max(np.abs(curve_at(curve, at) - wave(at))[curved]))
    assert errors[0] / errors[1] > 15
    assert errors[1] < 1e-7


@pytest.mark.parametrize(
    "steps", [EVEN, np.sort(np.random.default_rng(5).uniform(0, TURN, 24))], ids=["even", "uneven"]
)
def test_a_plateau_stays_flat(steps):
    """Levels 1 and 12 with edges between samples: neither is passed anywhere."""
    values = np.where((steps > 1.0) & (steps < 3.5), 12.0, 1.0)
    curve = limited_curve(steps, values, TURN)
    found = between(curve, 0, TURN)
    assert np.max(found) <= 12.0 * (1 + 1e-14)
    assert np.min(found) >= 1.0 * (1 - 1e-14)


def test_a_corner_is_passed_by_less_than_a_hundredth_of_the_range():
    """A steep rise to the top, and a fall that begins at once and grows: 12.0, 11.7, 10, 8."""
    values = np.array(
        [1, 1, 1, 3, 12.0, 11.7, 10, 8, 6.5, 5.4, 4.6, 4, 3.5, 3.1, 2.8, 2.5, 2.2, 2, 1.7, 1.4, 1.2, 1, 1, 1]
    )
    curve = limited_curve(EVEN, values, TURN)
    assert crest(curve)[1] - 12 < 0.01 * 11
    straight = np.concatenate([np.linspace(1, 12, 12), np.linspace(12, 1, 13)[1:]])
    assert crest(limited_curve(EVEN, straight, TURN))[1] == pytest.approx(12, abs=1e-12)


def test_a_step_between_two_of_one_sign_is_no_wave():
    """A shoulder: 30, 30.1 between steps of 10; and one of two equal values."""
    for shoulder in (30.1, 30.0):
        values = np.array([0, 10, 20, 30, shoulder, 40, 50, 60, 40, 20, 0, 0])
        found = between(limited_curve(np.arange(12.0), values, 12.0), 2.0, 6.0)
        assert np.min(np.diff(found)) >= -1e-12


@pytest.mark.parametrize("n_between", [2, 3, 4, 9])
def test_nothing_reaches_across_a_jump(n_between):
    """What is beyond two jumps changes nothing between them, however few samples there are."""
    inner = 5 + np.arange(n_between, dtype=float) ** 2
    own = np.arange(n_between, dtype=float)
    found = []
    for beyond in (100.0, -3.0):
        angles = np.concatenate([[0.0], own, [own[-1], 10.0, 11.0, 15.0]])
        values = np.concatenate([[beyond], inner, [beyond, beyond + 1, beyond - 2, beyond]])
        curve = limited_curve(angles, values, 20.0)
        assert curve.jumps.tolist() == [0.0, n_between - 1.0]
        found.append(between(curve, 0.0, n_between - 1.0))
    np.testing.assert_array_equal(*found)
    assert np.all(np.diff(found[0]) >= 0)


def test_at_a_jump_the_value_is_the_one_just_after_it():
    """Also where the angle comes back from another count with an error of rounding; 1e-12 before it is before it."""
    angles = np.array([0.0, 0.0, 1.0, 2.0, 2.0, 3.0, 4.0, 5.0])
    curve = limited_curve(angles, np.array([1.0, 9.0, 8.0, 7.0, 2.0, 2.0, 2.0, 1.5]), TURN)
    for jump, before, after in ((0.0, 1.0, 9.0), (2.0, 7.0, 2.0)):
        for turns in (0, 3, -2):
            at = jump + turns * TURN
            for rounding in (0.0, 4e-15, -4e-15):
                assert curve_at(curve, np.array(at + rounding)) == pytest.approx(after, rel=1e-10)
            assert curve_at(curve, np.array(at - 1e-12)) == pytest.approx(before, rel=1e-10)


def test_crest_is_the_highest_point():
    """Against a search of each step by SciPy."""
    values = np.random.default_rng(11).uniform(1, 9, 24)
    for angles, levels in ((EVEN, values), (np.insert(EVEN, 8, EVEN[8]), np.insert(values, 8, 30.0))):
        curve = limited_curve(angles, levels, TURN)
        highest = max(
            -minimize_scalar(
                lambda at, curve=curve: -float(curve_at(curve, np.array(at))),
                bounds=(start, start + step - 1e-11),
                method="bounded",
                options={"xatol": 1e-11},
            ).fun
            for start, step in zip(curve.places, curve.steps, strict=True)
        )
        at, value = crest(curve)
        assert value == pytest.approx(max(highest, np.max(levels)), rel=1e-9)
        assert max(curve_at(curve, np.array([at, at - 1e-11]))) == pytest.approx(value, rel=1e-8)
