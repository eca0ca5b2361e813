"""What holds for loads of journals, pins and bearings over the cycle, whatever the step, the units and the rotation."""

import numpy as np
import pytest

import cranktrain as ct

MACHINE = ct.load("vaz_21213")
WEAR = ("crankpin_wear", "rod_bearing_wear", "journal_wear", "bearing_wear")
HOLES = ("crankpin_oil_hole", "journal_oil_hole", "bearing_oil_hole")
FACTS = (*WEAR, *HOLES, "mean_crankpin_load", "largest_section_torque", "least_section_torque", "section_torque_range")
CURVES = (
    "rod_bearing_load_along",
    "rod_bearing_load_across",
    "journal_load_along",
    "journal_load_across",
    "section_torque",
)


INCHES = {
    "shaft.main.spacing": 95,
    "bank.line.mechanism.rod_length": 136,
    "crankshaft.journal_diameter": 50.8,
    "crankshaft.pin_diameter": 47.8,
    "crankshaft.pin_length": 28,
    "crankshaft.web_width": 75,
}


@pytest.fixture(scope="module")
def engine():
    return ct.run(MACHINE)


@pytest.fixture(scope="module")
def coarse():
    return ct.run(MACHINE, step_degrees=7.5)


@pytest.fixture(scope="module")
def mirrored():
    return ct.run(MACHINE.with_({"rotation": "anticlockwise"}))


@pytest.fixture(scope="module")
def in_inches():
    return ct.run(MACHINE.with_({path: f"{number / 25.4!r} in" for path, number in INCHES.items()}))


def scale(values):
    return np.nanmax(np.abs(values))


@pytest.mark.parametrize("name", FACTS)
def test_no_fact_depends_on_the_step(engine, coarse, name):
    other = getattr(coarse, name)
    np.testing.assert_allclose(other, getattr(engine, name), rtol=0, atol=1e-9 * scale(other))


@pytest.mark.parametrize("name", [*FACTS, *CURVES])
def test_the_mirror_image_of_a_machine_has_the_same_loads(engine, mirrored, name):
    """Angles count in the sense of rotation; only X is another."""
    one, other = (getattr(result, name) for result in (engine, mirrored))
    np.testing.assert_allclose(other, one, rtol=0, atol=1e-9 * scale(one))
    np.testing.assert_allclose(mirrored.main_bearing_load_x, -engine.main_bearing_load_x, rtol=0, atol=1e-5)


@pytest.mark.parametrize("name", FACTS)
def test_a_machine_in_inches_is_the_same(engine, in_inches, name):
    other = getattr(in_inches, name)
    np.testing.assert_allclose(other, getattr(engine, name), rtol=0, atol=1e-9 * scale(other))


def test_axes_change_no_size(engine):
    fixed = np.hypot(engine.main_bearing_load_x, engine.main_bearing_load_y)
    turning = np.hypot(engine.journal_load_along, engine.journal_load_across)
    np.testing.assert_allclose(turning, fixed, rtol=1e-12, atol=1e-9 * scale(fixed))
    pin = np.hypot(engine.crankpin_load_radial, engine.crankpin_load_tangential)
    rod = np.hypot(engine.rod_bearing_load_along, engine.rod_bearing_load_across)
    np.testing.assert_allclose(rod, pin, rtol=1e-12, atol=1e-9 * scale(pin))


def test_a_third_of_the_mean_load_is_on_a_ray(engine):
    for wear, mean in zip(WEAR, ["mean_crankpin_load"] * 2 + ["mean_bearing_load"] * 2, strict=True):
        np.testing.assert_allclose(3 * np.mean(getattr(engine, wear), axis=-1), getattr(engine, mean), rtol=1e-8)


def test_journals_hand_on_what_the_throws_before_them_give(engine):
    """By every method alike; the last one the torque of the whole shaft."""
    journals = [i for i, name in enumerate(engine.labels["section"]) if "journal" in name]
    for by_method in engine.section_torque:
        np.testing.assert_allclose(by_method[journals], engine.journal_torque, rtol=0, atol=1e-9)
        np.testing.assert_allclose(by_method[-1], np.ravel(engine.shaft_torque), rtol=0, atol=1e-9)


def test_ranges_are_of_largest_and_least(engine):
    ranges = engine.largest_section_torque - engine.least_section_torque
    np.testing.assert_allclose(engine.section_torque_range, ranges, rtol=1e-12)
    assert np.all(engine.section_torque_range >= np.ptp(engine.section_torque, axis=-1) - 1e-9)
