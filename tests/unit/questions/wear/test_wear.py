"""The rule of ±60°, and where an oil hole goes."""

import sys

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.numerics import one_way_steps, sectors
from cranktrain.numerics.sectors import size_by_sector
from cranktrain.numerics.subintervals import subintervals
from cranktrain.questions.crankshaft.results.journal_loads import in_turning_axes
from cranktrain.questions.wear.cycle_points import CyclePoints
from cranktrain.questions.wear.rays import RAYS, oil_hole, wear_of, wear_sums


def test_a_load_counts_on_all_rays_within_60_degrees_of_it():
    """13 rays of 10° when it is on one, 12 between two."""
    for degrees, n in ((0.0, 13), (200.0, 13), (3.0, 12), (359.0, 12)):
        sums = wear_sums(np.radians([degrees]), np.array([5.0]))
        apart = np.abs((np.degrees(RAYS) - degrees + 180) % 360 - 180)
        np.testing.assert_array_equal(sums, np.where(apart <= 60 + 1e-9, 5.0, 0.0))
        assert np.count_nonzero(sums) == n


@pytest.mark.parametrize("radius", [1.0, 2.5])
def test_a_load_that_goes_round_wears_evenly(radius):
    """A third of the turn is within 60° of any ray."""
    cut = subintervals(np.array([0.1]), 0.5, 4 * np.pi)
    around = size_by_sector(cut, radius * np.cos(cut.angle)[np.newaxis], radius * np.sin(cut.angle)[np.newaxis], 36)
    wear = wear_of(around, 4 * np.pi)
    np.testing.assert_allclose(wear, radius / 3, rtol=1e-9)
    assert np.isnan(oil_hole(wear)[0])


def test_a_load_that_stands_still_is_on_thirteen_rays():
    cut = subintervals(np.array([0.1]), 0.5, 2 * np.pi)
    held = size_by_sector(cut, np.full((1, cut.angle.size), -3.0), np.zeros((1, cut.angle.size)), 36)
    wear = wear_of(held, 2 * np.pi)[0]
    np.testing.assert_allclose(wear[12:25], 3.0, rtol=1e-12)
    assert np.count_nonzero(wear) == 13
    assert np.degrees(oil_hole(wear)) == pytest.approx(0.0)  # the middle of the 23 rays from 250° to 110°


@pytest.mark.parametrize(
    ("least", "place"),
    [
        ([7], 70.0),
        ([7, 8], 75.0),
        ([35, 0, 1], 0.0),
        ([34, 35, 0], 350.0),
        ([3, 20, 21], 205.0),  # the wider sector
        ([3, 4, 20, 21], 35.0),  # of two alike the one that begins first
        ([34, 35, 0, 10, 11, 12], 110.0),  # which is not the one that ray 0 lies in
    ],
)
def test_the_hole_is_in_the_middle_of_the_widest_sector_of_least_load(least, place):
    wear = np.full(36, 4.0)
    wear[least] = 1.0
    assert np.degrees(oil_hole(wear)) == pytest.approx(place)
    assert np.degrees(oil_hole(wear * (1 + 1e-12 * np.arange(36)))) == pytest.approx(place)  # rounding chooses nothing


def test_nothing_known_has_no_hole():
    assert np.all(np.isnan(oil_hole(np.full((2, 36), np.nan))))


def test_turning_axes():
    """Clockwise, throw 1 to the right: along it is to the right, ahead of it downward; and the mirror image."""
    along, across = in_turning_axes(np.array([1.0]), np.array([-2.0]), np.array([0.0]), -1.0)
    assert (along[0], across[0]) == (1.0, 2.0)
    along, across = in_turning_axes(np.array([-1.0]), np.array([-2.0]), np.array([np.pi]), 1.0)
    np.testing.assert_allclose([along[0], across[0]], [1.0, 2.0], atol=1e-15)


@pytest.mark.parametrize(
    ("name", "n_stages"), [("3d12", 2), ("kamaz_740", 2), ("mill_engine", 2), ("burning_cylinder", 1)]
)
def test_wear_takes_few_points_beside_those_that_means_take(monkeypatch, name, n_stages):
    """Pins with shells, journals with bearings; at most four times as many points as the loads have, roots and all."""
    cycle_points, given, tried = sys.modules[CyclePoints.__module__], [], []

    def counted_sectors(of, x, y, n):
        given.append(np.count_nonzero(np.isfinite(x)))
        return size_by_sector(of, x, y, n)

    def counted(own):
        def one_more(powers, way):
            tried.append(way.size)
            return own(powers, way)

        return one_more

    monkeypatch.setattr(cycle_points, "size_by_sector", counted_sectors)
    for module, helper in (
        (sectors, "polynomial_value"),
        (one_way_steps, "polynomial_value"),
        (one_way_steps, "polynomial"),
    ):
        monkeypatch.setattr(module, helper, counted(getattr(module, helper)))
    ct.run(name).find_all()
    assert len(given) == n_stages
    assert sum(tried) <= 4 * sum(given)
