"""Largest values and integrals of curves with known kinks and jumps, against closed forms."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad

from cranktrain.numerics import in_windows, integral_to, largest_between, subintervals
from cranktrain.numerics.subintervals import interpolation

CYCLE = 4 * np.pi
GRID = np.arange(720) * (CYCLE / 720)


def waves(angle):
    return np.sin(1.5 * angle + 0.3) + 0.2 * np.cos(4 * angle)


def sawtooth(angle):
    """Rises to 2 at 2, where it jumps to 1.2; bends at 2.5; jumps from −0.0155 to 0.9 at 9.0043."""
    inside = np.mod(angle, CYCLE)
    return np.select(
        [inside < 2.0, inside < 2.5, inside < 9.0043], [inside, 3.2 - inside, 0.7 - 0.11 * (inside - 2.5)], 0.9
    )


def level(angle):
    """Is 10 from 5 to 11."""
    inside = np.mod(angle, CYCLE)
    return np.minimum(np.where(inside > 9.0, 21.0 - inside, 2.0 * inside), 10.0)


def ended(angle):
    """Is not there before 6, and smooth after."""
    return np.where(np.mod(angle, CYCLE) < 6.0, np.nan, -np.cos(angle / 2))


CURVES = (waves, sawtooth, level, np.ones_like, ended, lambda angle: np.full_like(angle, np.nan))
BREAKS = np.full((len(CURVES), 4), np.nan)
BREAKS[1] = (0.0, 2.0, 2.5, 9.0043)
BREAKS[2] = (0.0, 5.0, 9.0, 11.0)
BREAKS[4, :2] = (0.0, 6.0)


def largest(sign=1.0):
    def curves(which, angle):
        return np.stack([sign * CURVES[one](own) for one, own in zip(which, angle, strict=True)])

    return largest_between(curves, GRID, sign * np.stack([curve(GRID) for curve in CURVES]), BREAKS)


def test_smooth_tops():
    """Where the derivative is 0, by Newton's method from a finer grid; the cosine's at 2π."""
    fine = np.linspace(0.0, CYCLE, 1_000_001)
    at = fine[np.argmax(waves(fine))]
    for _step in range(4):
        slope = 1.5 * np.cos(1.5 * at + 0.3) - 0.8 * np.sin(4 * at)
        at -= slope / (-2.25 * np.sin(1.5 * at + 0.3) - 3.2 * np.cos(4 * at))
    found = largest()
    assert found.angle[0] == pytest.approx(at, abs=1e-11)
    assert found.value[0] == pytest.approx(waves(at), rel=1e-14)
    assert (found.angle[4], found.value[4]) == pytest.approx((2 * np.pi, 1.0), abs=1e-9)


def test_a_jump_has_a_side():
    """The largest value is that just before 2, the smallest just before 9.0043; neither is a value of the grid."""
    found = largest()
    assert (found.angle[1], found.value[1], found.side[1]) == pytest.approx((2.0, 2.0, -1.0), abs=1e-12)
    assert np.max(sawtooth(GRID)) < 2.0 - 1e-3
    lowest = largest(-1.0)
    least = 0.7 - 0.11 * (9.0043 - 2.5)
    assert (lowest.angle[1], lowest.value[1], lowest.side[1]) == pytest.approx((9.0043, -least, -1.0), abs=1e-12)


def test_a_level_stretch_begins_where_it_begins():
    found = largest()
    assert (found.angle[2], found.value[2], found.side[2]) == pytest.approx((5.0, 10.0, 0.0), abs=1e-12)
    assert (found.angle[3], found.value[3]) == (0.0, 1.0)


def test_what_is_nowhere_known_has_no_largest_value():
    found = largest()
    assert np.all(np.isnan([part[5] for part in found]))


def test_of_alike_peaks_the_first_is_taken():
    """Seven pulses to two turns, which the grid meets at seven places: rounding does not choose among them."""
    found = largest_between(
        lambda _which, angle: np.cos(3.5 * angle - 0.4) ** 9,
        GRID,
        np.cos(3.5 * GRID - 0.4)[np.newaxis] ** 9,
        np.empty((1, 0)),
    )
    assert found.angle[0] == pytest.approx(0.4 / 3.5, abs=1e-9)
    assert found.value[0] == pytest.approx(1.0, abs=1e-12)


def test_what_stands_on_a_jump_hides_no_peak():
    """A curve at rest has 5 at its jump, and is −1 before and 1 after it; its own top is 3 at 4."""

    def curve(angle):
        inside = np.mod(angle, CYCLE)
        beside = np.where(np.mod(angle - GRID[40], CYCLE) < CYCLE / 2, 1.0, -1.0)
        return beside + 2.0 * np.exp(-((inside - 4.0) ** 2))

    samples = curve(GRID)
    samples[40] = 5.0
    found = largest_between(lambda _which, angle: curve(angle), GRID, samples[np.newaxis], GRID[np.newaxis, 40:41])
    assert (found.angle[0], found.value[0]) == pytest.approx((4.0, 3.0), abs=1e-9)


def test_a_top_between_breaks_beside_a_higher_point():
    """Between kinks a step apart the curve rises once more, to 2, where the grid falls from point to point."""
    step = GRID[1]
    kinks = 100 * step + step * np.array([[0.5, 1.5, 2.5]])

    def curve(angle):
        way = (angle - kinks[0, 0]) / step
        top = 2.0 - 2.0 * (way - 1.9) ** 2
        return np.where(way < 0, 1.8 + 0.2 * way, np.where(way < 1, 1.9 - 0.1 * way, np.where(way < 2, top, -way)))

    samples = curve(GRID)
    assert samples[101] > samples[102] > samples[103]
    found = largest_between(lambda _which, angle: curve(angle), GRID, samples[np.newaxis], kinks)
    assert (found.angle[0], found.value[0]) == pytest.approx((kinks[0, 0] + 1.9 * step, 2.0), abs=1e-9)


@pytest.mark.parametrize("narrow", (0.3, 0.7, 2.0))
def test_a_top_beside_a_pole(narrow):
    """A pulse no wider than a step or two, whose poles lie as near: nine points do not show its height."""
    step = GRID[1]
    at = 200.37 * step

    def curve(angle):
        return 1.0 / (1.0 + ((angle - at) / (narrow * step)) ** 2)

    found = largest_between(lambda _which, angle: curve(angle), GRID, curve(GRID)[np.newaxis], np.empty((1, 0)))
    assert found.value[0] == pytest.approx(1.0, abs=1e-12)
    assert found.angle[0] == pytest.approx(at, abs=1e-5 * step)


@pytest.mark.parametrize("way", np.linspace(-0.5, 0.5, 17))
def test_a_top_midway_between_places_that_are_tried(way):
    """Two of them are alike there, which is not yet level."""
    step = GRID[1]
    at = (200 + way * 1.2 / 32) * step

    def curve(angle):
        return 4.0 + np.cos(30.0 * (angle - at)) * np.cos((angle - at) / 4) ** 2

    found = largest_between(lambda _which, angle: curve(angle), GRID, curve(GRID)[np.newaxis], np.empty((1, 0)))
    assert (found.angle[0], found.value[0]) == pytest.approx((at, 5.0), abs=1e-11)


def test_a_flat_top_is_no_break_before_it():
    """A hundredth of a degree before it the curve is as high but for rounding."""
    breaks = np.deg2rad(np.arange(4.1, 720.0, 1.0))[np.newaxis]
    top = np.deg2rad(115.111)

    def curve(angle):
        return 1000.0 + 10.0 * np.cos((angle - top) / 2)

    found = largest_between(lambda _which, angle: curve(angle), GRID, curve(GRID)[np.newaxis], breaks)
    assert np.rad2deg(found.angle[0]) == pytest.approx(115.111, abs=3e-3)


def test_integrals_between_breaks():
    """To any angle, in the period or not, against adaptive quadrature between the breaks."""
    breaks = np.array([2.0, 2.5, 9.0043, 0.0, np.nan])
    cut = subintervals(breaks, np.pi / 9, CYCLE)
    values = sawtooth(cut.angle) * np.exp(np.sin(cut.angle))
    assert np.sum(cut.weight) == pytest.approx(CYCLE, rel=1e-14)
    for end in (0.7, 2.0, 2.2, 8.0, 9.5, 12.0, CYCLE + 2.2, -1.0):
        low, high = sorted((float(cut.start[0]), end))
        marks = [mark + turn * CYCLE for turn in (-1, 0, 1) for mark in breaks[:4] if low < mark + turn * CYCLE < high]
        edges = sorted([low, *marks, high])
        parts = [
            quad(lambda x: float(sawtooth(x) * np.exp(np.sin(x))), one + 1e-13, other - 1e-13, epsabs=1e-13)[0]
            for one, other in pairwise(edges)
        ]
        expected = sum(parts) * (1.0 if end > cut.start[0] else -1.0)
        assert integral_to(cut, values, np.array([end]))[0] == pytest.approx(expected, abs=1e-11)


@pytest.mark.parametrize("n_nodes", [3, 6, 15])
def test_interpolation_is_that_of_the_polynomial_at_its_points_too(n_nodes):
    node = np.polynomial.legendre.leggauss(n_nodes)[0]
    ways = np.concatenate([node, [-1.0, -0.123, 1.0, np.nextafter(node[0], 1.0)]])
    np.testing.assert_allclose(interpolation(node, n_nodes), np.eye(n_nodes), rtol=0, atol=1e-250)
    powers = np.arange(n_nodes)
    found = np.sum(interpolation(ways, n_nodes)[:, np.newaxis] * (node ** powers[:, np.newaxis]), axis=-1)
    np.testing.assert_allclose(found, ways[:, np.newaxis] ** powers, rtol=0, atol=1e-14)


def test_who_asks_at_the_same_angles_is_in_one_slot():
    angle = np.array([[1.0, 2.0], [3.0, 4.0], [1.0, 2.0], [1.0, 2.0]])
    laid, slot = in_windows(np.array([0, 0, 0, 1]), angle, 2)
    assert laid.shape == (2, 2, 2)
    assert slot.tolist() == [0, 1, 0, 0]
    np.testing.assert_array_equal(laid[[0, 0, 0, 1], slot], angle)
