"""A valve gear beside the rod of a throw: its return crank, clamped to the crank pin, loads the shaft's bearings."""

import re
import tomllib

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.io.starting import starting_file
from cranktrain.mechanisms import KINDS

SHAFT = {
    "journal_diameter": "200 mm",
    "pin_diameter": "140 mm",
    "pin_length": "150 mm",
    "web_thickness": "110 mm",
    "web_width": "260 mm",
    "bearing_distance": "250 mm",
}


def tables():
    """The machine that `new walschaerts` begins with, with its masses, and a crankshaft in two bearings."""
    text = starting_file(KINDS.named("walschaerts"), full=True)
    found = tomllib.loads(re.sub(r"^# (?=\[bank|\w+ = )", "", text.partition("[friction]")[0], flags=re.MULTILINE))
    return {**found, "crankshaft": SHAFT}


@pytest.fixture(scope="module")
def result():
    return ct.run(ct.Machine.model_validate(tables()))


def test_bearings_bear_what_both_mechanisms_give(result):
    """Both stand in the middle of the throw: each bearing has half of what the bearings of both cranks would have.

    Both banks stand upright, so that their axes are turned alike: x up, y to the left of a clockwise machine's.
    """
    labels = result.labels
    both = [labels["joint"].index(f"1{bank}.main_bearing") for bank in ("cylinder", "valve")]
    on_cranks = np.stack([np.sum(part[both], axis=0) for part in (result.joint_force_x, result.joint_force_y)])
    on_bearings = np.stack([result.main_bearing_load_x, result.main_bearing_load_y])[:, 0]
    size = np.hypot(*on_cranks)
    for bearing in (0, 1):
        np.testing.assert_allclose(np.hypot(*on_bearings[:, bearing]), 0.5 * size, rtol=0, atol=1e-12 * np.max(size))
    valve = np.hypot(result.joint_force_x[both[1]], result.joint_force_y[both[1]])
    assert np.max(valve) > 0.01 * np.max(size)  # without the gear it would not hold


def test_the_last_journal_has_the_torque_of_both(result):
    torque = np.sum(np.atleast_2d(result.driving_torque), axis=0)
    journal = result.section_torque[0, result.labels["section"].index("journal 2")]
    np.testing.assert_allclose(np.abs(journal), np.abs(torque), rtol=0, atol=1e-11 * np.max(np.abs(torque)))


def test_the_order_of_banks_is_no_matter(result):
    given = tables()
    given["bank"] = dict(reversed(given["bank"].items()))
    other = ct.run(ct.Machine.model_validate(given))
    for name in ("main_bearing_load_x", "main_bearing_load_y", "section_torque"):
        here, there = getattr(result, name), getattr(other, name)
        np.testing.assert_allclose(there, here, rtol=0, atol=1e-12 * np.max(np.abs(here)))


def test_its_checks_hold(result):
    assert all(np.all(one.residual <= one.limit) for one in result.checks)
