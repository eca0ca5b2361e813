"""The sheet of forces of what has no piston's forces: reactions in joints, each once, and what is drawn of them."""

import numpy as np
import pytest
from tests.unit.viz.test_pictures import assert_words_are_readable, words_of

import cranktrain as ct
from cranktrain.viz import sheet_forces
from cranktrain.viz.panel import OneDesign
from cranktrain.viz.sheets.forces.joints import joint_forces, joint_panels

ROCKERS = ("tilting_table", "jaw_crusher", "pumping_unit_c57", "shaper", "toggle_press")


@pytest.fixture(scope="module")
def results():
    return {name: ct.run(ct.load(name)) for name in ROCKERS}


@pytest.mark.parametrize("name", ROCKERS)
def test_every_joint_that_bears_is_drawn_once(results, name):
    result = results[name]
    sizes = {
        label.removeprefix("1."): float(np.max(np.hypot(x, y)))
        for label, x, y in zip(result.labels["joint"], result.joint_force_x, result.joint_force_y, strict=True)
    }
    joints = joint_forces(OneDesign(result, 0), "1")
    named = [joint for one in joints for joint in one.names]
    assert sorted(named) == sorted(label for label, size in sizes.items() if size > 1e-9 * max(sizes.values()))
    largest = [float(np.max(one.size)) for one in joints]
    assert largest == sorted(largest, reverse=True)
    for one in joints:
        assert one.size.max() == pytest.approx(sizes[one.names[0]], rel=1e-12)


@pytest.mark.parametrize("name", ROCKERS)
def test_sheet(results, name):
    """Whatever it drives, half of its sheet is not blank."""
    shown = OneDesign(results[name], 0)
    joints = joint_forces(shown, "1")
    panels = list(joint_panels(shown, joints))
    assert panels[0].title == "Reactions in the joints"
    assert all(np.all(np.isfinite(panel.values)) and np.any(panel.values) for panel in panels)
    drawn = sheet_forces(results[name])
    assert_words_are_readable(drawn)
    words = [text for text, _box in words_of(drawn)]
    for one in joints:
        assert {f"R{one.number}  {name}" for name in one.names} <= set(words)


def test_inertia_and_static_torque(results):
    table = results["tilting_table"]
    by_title = {panel.title: panel for panel in joint_panels(OneDesign(table, 0), [])}
    static = by_title["Static torque at the crank"].curves[0].values
    np.testing.assert_array_equal(static[:-1], table.static_torque[-1])
    inertia, slope = by_title["Reduced inertia, and its slope by the angle"].curves
    np.testing.assert_array_equal(inertia.values[:-1], table.reduced_inertia)
    np.testing.assert_array_equal(slope.values[:-1], table.reduced_inertia_slope)


def test_a_piston_with_a_rod_keeps_its_own(results):
    words = [text for text, _box in words_of(sheet_forces(ct.run(ct.load("eccentric_press"))))]
    assert any(text.startswith("Forces at piston") for text in words)
    assert not any(text.startswith("Reactions in the joints") for text in words)
    assert not any(text.startswith("Reduced inertia") for text in words)


@pytest.mark.parametrize("name", ["shaper", "toggle_press", "pumping_unit_c57"])
def test_what_is_left_out_is_said_before_what_lines_mean(results, name):
    """There is no room for all notes."""
    words = [text for text, _box in words_of(sheet_forces(results[name]))]
    assert "No masses are given: forces and torque are of the loads alone." in words
