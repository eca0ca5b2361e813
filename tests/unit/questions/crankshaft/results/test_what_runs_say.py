"""Specific pressures, the worst journal, and what the answer says of bearings; shafts that do not turn evenly."""

import numpy as np
import pytest
from tests.told import row_of, texts_of

import cranktrain as ct

FOUR = ct.load("vaz_21213")


@pytest.fixture(scope="module")
def four():
    return ct.run(FOUR)


def said(result, name):
    return row_of(result, "Main bearings", name).words


def test_specific_pressures(four):
    """The example's pins are 47.8 mm by 21 mm, its journals 50.8 mm by 23 mm."""
    np.testing.assert_allclose(
        four.largest_crankpin_pressure, four.largest_crankpin_load / (0.0478 * 0.021), rtol=1e-12
    )
    np.testing.assert_allclose(four.mean_crankpin_pressure, four.mean_crankpin_load / (0.0478 * 0.021), rtol=1e-12)
    np.testing.assert_allclose(four.largest_bearing_pressure, four.largest_bearing_load / (0.0508 * 0.023), rtol=1e-12)
    np.testing.assert_allclose(four.mean_bearing_pressure, four.mean_bearing_load / (0.0508 * 0.023), rtol=1e-12)


def test_a_bearing_may_be_as_wide_as_no_other():
    result = ct.run(FOUR.with_({"crankshaft.bearing.3.width": "28 mm"}))
    np.testing.assert_allclose(
        result.largest_bearing_pressure * [0.023, 0.023, 0.028, 0.023, 0.023] * 0.0508, result.largest_bearing_load
    )


def without(machine, *keys):
    data = {name: dict(table) if name == "crankshaft" else table for name, table in machine.declared.items()}
    for key in keys:
        del data["crankshaft"][key]
    return ct.Machine(**data)


def test_no_width_is_guessed():
    result = ct.run(without(FOUR, "bearing_width", "rod_bearing_width"))
    assert not {"largest_bearing_pressure", "largest_crankpin_pressure"} & set(result.catalogue)
    assert texts_of(result.needs_of("mean_bearing_pressure")) == ("[crankshaft] bearing_width",)
    assert texts_of(result.needs_of("mean_crankpin_pressure")) == ("[crankshaft] rod_bearing_width",)
    np.testing.assert_array_equal(result.crankpin_wear, ct.run(FOUR).crankpin_wear)


def test_one_width_alone_leaves_the_others_unknown():
    machine = without(FOUR, "bearing_width").with_({"crankshaft.bearing.2.width": "25 mm"})
    known = np.isfinite(ct.run(machine).largest_bearing_pressure)
    assert known.tolist() == [[False, True, False, False, False]] * 5


def test_the_answer_says_which_method_to_trust(four):
    most = four.largest_bearing_load
    widest = int(np.argmax(np.ptp(most, axis=0)))
    words = said(four, "to trust")
    assert str(words).startswith("elastic frame")
    assert words.pieces["bearing"] == four.labels["bearing"][widest]
    extent = words.pieces["range"]
    assert (extent.least, extent.most) == (np.min(most[:, widest]), np.max(most[:, widest]))
    rigid = ct.run(without(FOUR, "bearing_stiffness"))
    assert str(said(rigid, "to trust")).startswith("between both")
    loose = ct.run(FOUR.with_({"crankshaft.bearing_clearance": "0.05 mm"}))
    assert said(loose, "with clearance").pieces["bearing"] in four.labels["bearing"]


def test_on_two_bearings_all_methods_are_right():
    one = ct.Machine(
        shaft={"main": {"speed": "1500 rpm"}},
        mechanism={"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "140 mm"},
        masses={"piston": {"mass": "1 kg"}},
        crankshaft={
            "journal_diameter": "50 mm",
            "pin_diameter": "45 mm",
            "pin_length": "30 mm",
            "web_thickness": "15 mm",
            "web_width": "70 mm",
            "bearing_distance": "50 mm",
        },
    )
    result = ct.run(one)
    assert str(said(result, "to trust")) == "any: all methods give the same"
    assert result.labels["section"] == ("journal 1", "pin 1", "journal 2")


def test_the_worst_journal_has_the_widest_range(four):
    """Not the largest torque, which the last has."""
    journals = [i for i, name in enumerate(four.labels["section"]) if "journal" in name]
    words = said(four, "range of torque")
    assert str(words.pieces["in_journal"]) == "journal 4"
    assert words.pieces["journal"].value == max(four.section_torque_range[0, journals])
    assert journals[int(np.argmax(four.largest_section_torque[0, journals]))] == journals[-1]


@pytest.mark.parametrize(
    "changes",
    [
        {"shaft.main.acceleration": "500 rad/s²"},
        {"gravity": True},
        {"shaft.main.acceleration": "-200 rad/s²", "gravity": True, "rotation": "anticlockwise"},
    ],
    ids=["accelerating", "weight", "both, anticlockwise"],
)
def test_a_crank_s_own_torque_goes_along_the_shaft(changes):
    """Of a shaft that speeds up, and of weight beside the middle of its webs; the last journal has the whole torque."""
    crank = {"masses.crank.mass": "4 kg", "masses.crank.along": "30 mm", "masses.crank.inertia": "0.01 kg·m²"}
    result = ct.run(FOUR.with_(crank | changes))
    torque = np.ravel(result.shaft_torque)
    for by_method in result.section_torque:
        np.testing.assert_allclose(by_method[-1], torque, rtol=0, atol=1e-10 * np.max(np.abs(torque)))
    (check,) = (check for check in result.checks if check.name == "section_torque")
    assert np.all(check.passed)


def test_several_shafts_have_sections_of_their_own():
    """Each shaft's last journal hands on that shaft's torque in its own sense; the lower one turns the other way."""
    mechanism = {"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "150 mm"}
    gear = ct.Machine(
        shaft={
            "main": {"throws": ["0 deg", "180 deg"], "spacing": "100 mm", "speed": "1200 rpm"},
            "upper": {"throws": ["0 deg", "180 deg"], "spacing": "100 mm", "ratio": -1, "place": ["0 mm", "500 mm"]},
        },
        bank={"A": {"mechanism": mechanism}, "B": {"mechanism": mechanism, "shaft": "upper", "angle": "180 deg"}},
        masses={"piston": {"mass": "1 kg"}, "rod": {"mass": "1.2 kg", "along": "50 mm", "inertia": "0.004 kg·m²"}},
        crankshaft={
            "journal_diameter": "50 mm",
            "pin_diameter": "45 mm",
            "pin_length": "30 mm",
            "web_thickness": "15 mm",
            "web_width": "70 mm",
        },
    )
    result = ct.run(gear)
    names = result.labels["section"]
    assert names[:2] == ("main.journal 1", "main.pin 1") and names[-1] == "upper.journal 3"
    for shaft, torque in zip(result.labels["shaft"], result.shaft_torque, strict=True):
        own = result.section_torque[0, names.index(f"{shaft}.journal 3")]
        np.testing.assert_allclose(own, torque, rtol=0, atol=1e-10 * np.max(np.abs(torque)))
    fixed = np.hypot(result.main_bearing_load_x, result.main_bearing_load_y)
    turning = np.hypot(result.journal_load_along, result.journal_load_across)
    np.testing.assert_allclose(turning, fixed, rtol=0, atol=1e-9 * np.max(fixed))
    wear = 3 * np.mean(result.journal_wear, axis=-1)
    np.testing.assert_allclose(wear, result.mean_bearing_load, rtol=1e-8)
