"""Campbell's diagram as data: how far it reaches, its rays, and the speeds at which they cross the levels."""

import numpy as np
import pytest
from tests.unit.questions.torsion.test_modes import FLYWHEEL, four, run

import cranktrain as ct
from cranktrain.questions.torsion.campbell import campbell
from cranktrain.questions.torsion.critical import CriticalSpeeds, ModeVectorSums
from cranktrain.questions.torsion.modes import TorsionalModes


def diagram(machine, *, design=0):
    result = ct.run(machine, step_degrees=90)
    found = {type(gift): gift for gift in result.gifts}
    return campbell(*(found.get(kind) for kind in (TorsionalModes, CriticalSpeeds, ModeVectorSums)), design=design)


def test_a_crossing_is_on_its_ray_and_on_its_level():
    found = diagram(four())
    assert found.crossings
    for one in found.crossings:
        assert one.frequency == pytest.approx(one.order * one.speed, rel=1e-14)
        assert one.frequency == found.frequency[one.mode - 1]
        assert 0 < one.speed <= found.largest_speed
        assert one.frequency <= found.highest_frequency


def test_all_crossings_in_sight_are_there():
    found = diagram(four())
    in_sight = {
        (mode, order)
        for mode, frequency in enumerate(found.frequency, start=1)
        for order in found.order
        if frequency <= found.highest_frequency and frequency / order <= found.largest_speed
    }
    assert {(one.mode, one.order) for one in found.crossings} == in_sight
    assert [one.speed for one in found.crossings] == sorted(one.speed for one in found.crossings)


def test_it_reaches_beyond_the_declared_speed():
    assert diagram(four()).largest_speed == pytest.approx(1.25 * 100 * np.pi)


def test_without_a_speed_it_reaches_the_third_order():
    found = diagram(four(shaft__main__speed=None))
    assert found.largest_speed > found.frequency[0] / 3
    assert 3.0 in {one.order for one in found.crossings if one.mode == 1}


def test_rays_are_by_a_half_in_a_four_stroke():
    np.testing.assert_array_equal(diagram(four()).order, np.arange(1, 25) / 2)
    pump = four(cylinder__cycle=None, cylinder__firing_order=None)
    np.testing.assert_array_equal(diagram(pump).order, np.arange(1, 13))


def test_vector_sums_are_those_of_the_result():
    result = run(four())
    for one in diagram(four()).crossings:
        order = result.labels["order"].index(f"{one.order:g}")
        assert one.vector_sum == result.mode_vector_sum[one.mode - 1, order]
        assert one.weight == pytest.approx(one.vector_sum / np.max(np.abs(result.mode_shape[one.mode - 1])))
        assert one.weight <= 4


def test_without_a_firing_order_there_are_no_vector_sums():
    found = diagram(four(cylinder__firing_order=None))
    assert found.crossings
    assert all(np.isnan(one.vector_sum) and np.isnan(one.weight) for one in found.crossings)


def test_of_one_of_several_designs():
    heavy = four(torsion__disc__flywheel=FLYWHEEL | {"inertia": "20 kg·m²"})
    np.testing.assert_array_equal(diagram([four(), heavy], design=1).frequency, diagram(heavy).frequency)
