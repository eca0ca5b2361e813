"""Modes and Campbell's diagram as data: how far it reaches, its rays, and where they cross the levels."""

import numpy as np
import pytest
from tests.unit.questions.torsion.test_modes import FLYWHEEL, four, run

import cranktrain as ct
from cranktrain.panels.sheets.torsion.panels import campbell, mode_shapes, trial_shapes


def diagram(machine, *, design=0):
    return campbell(ct.run(machine, step_degrees=90), design)


def test_what_is_tried_has_nodes_where_it_changes_its_sign():
    """By straight lines along each shaft."""
    result = ct.run(four(torsion__holzer_at=["50 Hz", "170 Hz"]), step_degrees=90)
    for trial, one in enumerate(trial_shapes(result)):
        assert one.residual == result.trial_residual[trial]
        at = np.interp(one.nodes, np.arange(one.amplitude.size), one.amplitude)
        np.testing.assert_allclose(at, 0.0, atol=1e-12 * np.max(np.abs(one.amplitude)))
        assert one.nodes.size == np.sum(one.amplitude[1:] * one.amplitude[:-1] < 0)


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


def test_nodes_of_a_mode_lie_between_amplitudes_of_different_signs():
    result = run(four())
    for shape, mode in zip(mode_shapes(result), range(4), strict=True):
        np.testing.assert_array_equal(shape.amplitude, result.mode_shape[mode])
        signs = np.sign(shape.amplitude)
        assert [int(node) for node in shape.nodes] == np.flatnonzero(signs[:-1] != signs[1:]).tolist()
        np.testing.assert_allclose(np.interp(shape.nodes, np.arange(5), shape.amplitude), 0.0, atol=1e-12)


def test_a_node_of_a_branch_lies_on_the_way_to_what_it_stands_on():
    """Rows 1, 2, 3, rotor, 4, flywheel: the shaft of throw 3 passes the rotor."""
    rotor = {"inertia": "1 kg·m²", "beside": 4, "stiffness": "1 MN·m/rad"}
    result = run(four(torsion__disc={"rotor": rotor, "flywheel": FLYWHEEL}))
    assert result.labels["disc"] == ("1", "2", "3", "rotor", "4", "flywheel")
    for shape in mode_shapes(result):
        for node in shape.nodes:
            ends = [(one, other) for one, other in enumerate(shape.following) if one <= node <= other]
            assert any(shape.amplitude[one] * shape.amplitude[other] <= 0 for one, other in ends)
