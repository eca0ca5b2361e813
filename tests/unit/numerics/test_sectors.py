"""A vector's size by its direction: closed forms, fine grids, and what points along an edge."""

import itertools

import numpy as np
import pytest

from cranktrain.numerics.sectors import size_by_sector
from cranktrain.numerics.subintervals import subintervals

CUT = subintervals(np.array([0.3, 1.7]), np.pi / 9, 2 * np.pi)


def of(x, y, cut=CUT, n=36):
    found = size_by_sector(cut, *(np.atleast_2d(part) for part in np.broadcast_arrays(x, y, cut.angle)[:2]), n)
    return found.within[0], found.along[0]


def test_an_ellipse_that_is_gone_round_evenly():
    """The size is √(a² cos² t + b² sin² t), and the direction θ stands at t = atan2(sin θ / b, cos θ / a)."""
    a, b = 3.0, 1.0
    within, along = of(a * np.cos(CUT.angle), b * np.sin(CUT.angle))
    edges = np.arange(37) * 2 * np.pi / 36
    ends = np.unwrap(np.arctan2(np.sin(edges) / b, np.cos(edges) / a))
    node, weight = np.polynomial.legendre.leggauss(24)
    half, middle = np.diff(ends) / 2, (ends[1:] + ends[:-1]) / 2
    t = middle[:, np.newaxis] + half[:, np.newaxis] * node
    expected = half * np.sum(weight * np.hypot(a * np.cos(t), b * np.sin(t)), axis=-1)
    np.testing.assert_allclose(within, expected, rtol=1e-8)
    assert np.all(along == 0.0)


@pytest.mark.parametrize("edge", range(36))
def test_what_does_not_turn_points_along_an_edge_or_between_two(edge):
    for aside, is_along in ((0.0, True), (0.05, False), (-0.05, False)):
        direction = edge * np.pi / 18 + aside
        size = 2 + np.cos(CUT.angle)
        within, along = of(size * np.cos(direction), size * np.sin(direction))
        place = edge if is_along or aside > 0 else (edge - 1) % 36
        expected = np.zeros(36)
        expected[place] = 4 * np.pi
        np.testing.assert_allclose(along if is_along else within, expected, atol=1e-12)
        assert not np.any(within if is_along else along)


@pytest.mark.parametrize("seed", range(4))
def test_against_a_fine_grid(seed):
    draw = np.random.default_rng(seed)
    cut = subintervals(np.array([0.4]), np.pi / 9, 4 * np.pi)
    amplitude, phase = draw.normal(size=(2, 6)) * [2, 3, 1, 1, 0.3, 0.2], draw.uniform(0, 6, (2, 6))

    def curve(angle):
        return [
            sum(a * np.cos(k / 2 * angle - p) for k, (a, p) in enumerate(zip(*own, strict=True)))
            for own in zip(amplitude, phase, strict=True)
        ]

    within, along = of(*curve(cut.angle), cut)
    n = 400_000
    x, y = curve((np.arange(n) + 0.5) * (4 * np.pi / n))
    sector = np.floor(np.mod(np.arctan2(y, x), 2 * np.pi) * 18 / np.pi).astype(int) % 36
    expected = np.bincount(sector, np.hypot(x, y), 36) * 4 * np.pi / n
    # At every crossing the grid puts up to one of its steps on the wrong side.
    assert np.max(np.abs(within - expected)) <= 8 * np.max(np.hypot(x, y)) * 4 * np.pi / n
    # Where a vector comes near to nothing its size nearly has a kink.
    np.testing.assert_allclose(np.sum(within + along), np.sum(expected), rtol=1e-9)


def test_what_turns_back_just_beyond_an_edge_is_found():
    """For 2·acos(1 − s) of the angle the direction is beyond the edge at 0.

    The direction swings by 0.1 rad to 0.1·s beyond it, size 1.
    """
    for beyond in (0.2, 0.01, 1e-3, 1e-4):
        direction = 0.1 * (np.cos(CUT.angle - 1.0) - 1 + beyond)
        within, _along = of(np.cos(direction), np.sin(direction))
        assert within[0] == pytest.approx(2 * np.arccos(1 - beyond), abs=1e-7)


def test_what_is_not_known_stays_so():
    x = np.stack([np.cos(CUT.angle), np.full(CUT.angle.size, np.nan)])
    found = size_by_sector(CUT, x, np.stack([np.sin(CUT.angle)] * 2), 12)
    assert np.all(np.isfinite(found.within[0]))
    assert np.all(np.isnan(found.within[1]) & np.isnan(found.along[1]))


def test_what_is_nothing_is_on_no_ray():
    within, along = of(0.0, 0.0)
    assert not np.any(within) and not np.any(along)


@pytest.mark.parametrize("start", [np.pi / 2, np.pi / 2 + np.pi / 18, np.pi / 2 + 0.123])
def test_what_turns_round_through_nothing_points_nowhere_between(start):
    """cos φ along one line: half the time one way, half the other; the integral of its size is 4 over a turn.

    Where it is nothing is the end of a panel, its middle, and neither.
    """
    cut = subintervals(np.array([start]), np.pi / 9, 2 * np.pi)
    for direction in (0.0, np.pi / 2, np.pi / 18):
        size = np.cos(cut.angle)
        within, along = of(size * np.cos(direction), size * np.sin(direction), cut)
        edge = round(direction * 18 / np.pi)
        np.testing.assert_allclose(along[[edge, edge + 18]], 2.0, rtol=1e-9)
        np.testing.assert_allclose(np.delete(along, [edge, edge + 18]), 0.0, atol=1e-12)
        np.testing.assert_allclose(within, 0.0, atol=1e-12)


def parabola(t, aside, bend, turned):
    """Runs along x and passes nothing at t = 0 by some distance aside; turned about nothing."""
    return (t + 1j * (aside + bend * t * t)) * np.exp(1j * turned)


@pytest.mark.parametrize("aside", [0.0, *(sign * 10.0**n for n in (-13, -9, -6, -4, -2, -1, -0.3) for sign in (1, -1))])
@pytest.mark.parametrize("place", [0.0, 0.05, 0.111])
def test_what_passes_nothing_by_a_hair_turns_back_on_both_sides(aside, place):
    """Where a parabola crosses an edge is a quadratic's root, and between them its size is integrated at 400 points."""
    bend, turned, reach = 2.5, 0.3, 0.5
    cut = subintervals(np.array([0.0]), np.pi / 9, 2 * reach)
    vector = parabola(cut.angle - reach - place, aside, bend, turned)
    within, _along = of(vector.real, vector.imag, cut)
    lines = np.tan(np.arange(18) * np.pi / 18 - turned)
    ends = [-reach - place, 0.0, reach - place]
    marks = np.sort([*ends, *(t.real for slope in lines for t in np.roots([bend, -slope, aside]) if t.imag == 0)])
    marks = marks[(marks >= ends[0]) & (marks <= ends[2])]
    node, weight = np.polynomial.legendre.leggauss(400)
    expected = np.zeros(36)
    for low, high in itertools.pairwise(marks):
        middle = np.angle(parabola((low + high) / 2, aside, bend, turned))
        sizes = np.abs(parabola(low + (high - low) * (node + 1) / 2, aside, bend, turned))
        expected[int(np.floor(middle * 18 / np.pi)) % 36] += (high - low) / 2 * np.sum(weight * sizes)
    np.testing.assert_allclose(within, expected, rtol=0, atol=1e-8 * np.sum(expected))
