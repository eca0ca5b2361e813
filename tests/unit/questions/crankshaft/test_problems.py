"""What is said of crankshafts and gears that cannot be."""

import pytest
from tests.sentences import NOT_POSITIVE
from tests.validation.test_crankshaft_arrangements import GEAR, PLAIN, SECTIONS, TWO_SHAFTS, machine
from tests.validation.test_examples import example

import cranktrain as ct

THREE = ["0 deg", "120 deg", "240 deg"]

WRONG = {
    "lists of other lengths": (
        {"pin_length": ["60 mm"] * 2, "journal_bore": ["1 mm"] * 3, "web_width": ["110 mm"] * 4},
        [
            "crankshaft.journal_bore = a list of 3: must be one value, or a list of as many as there are: 1, 4",
            "crankshaft.pin_length = a list of 2: must be one value, or a list of as many as there are: 1, 3",
            "crankshaft.web_width = a list of 4: must be one value, or a list of as many as there are: 1, 3, 6",
        ],
    ),
    "journals that are not there": (
        {"journals": [1, 5], "bearings": [1, 2], "thrust_bearing": 4},
        [
            "crankshaft.journals = 5: must be journals, 1 to 4",
            "crankshaft.bearings = 2: must be journals that there are, of which journals names 1, 5",
            "crankshaft.thrust_bearing = 4: must be one of: 1, 2",
        ],
    ),
    "a shaft that floats": (
        {"bearings": [2]},
        [
            "crankshaft.bearings = 2: must be two or more, or the shaft floats; "
            "name one more in [crankshaft.bearing.NAME]"
        ],
    ),
    "a bearing that stands nowhere": (
        {"bearing": {"out": {"width": "20 mm"}}},
        ["crankshaft.bearing.out.z: is missing; only bearings of journals have a place of their own: 1, 2, 3, 4"],
    ),
    "bearings and pulls in throws": (
        {
            "bearing": {"out": {"z": "150 mm"}, "1": {"z": "-40 mm"}},
            "pull": {"belt": {"z": "10 mm", "force": "1 kN", "direction": "0 deg"}},
        },
        [
            "crankshaft.bearing.1.z = -40 mm: must stand on a journal, clear of webs and pins, and is at -40 mm"
            " from throw 1",
            "crankshaft.bearing.out.z = 150 mm: must stand on a journal, clear of webs and pins, and is at 150 mm"
            " from throw 1",
            "crankshaft.pull.belt.z = 10 mm: must be on a journal, clear of webs and pins",
        ],
    ),
    "bearings at one place": (
        {"bearing": {"out": {"z": "75 mm"}}},
        ["crankshaft.bearing: must stand apart from one another along the shaft"],
    ),
    "bores that leave nothing": (
        {"journal_bore": "70 mm", "pin_bore": ["1 mm", "2 mm", "66 mm"]},
        [
            "crankshaft.journal_bore = 70 mm: must be less than journal_diameter = 70 mm",
            "crankshaft.pin_bore = 66 mm: must be less than pin_diameter = 65 mm",
        ],
    ),
    "no room for a journal": (
        {"pin_length": "100 mm"},
        [
            "crankshaft.pin_length = 100 mm: must leave room between pins 1 and 2 with their webs: more than 6 mm more",
            "crankshaft.pin_length = 100 mm: must leave room between pins 2 and 3 with their webs: more than 6 mm more",
        ],
    ),
    "a shaft that is not there": ({"upper": SECTIONS}, ["crankshaft.upper: must be one of: main"]),
    "three directions": (
        {
            "bearing_stiffness": ["1 kN/mm"] * 3,
        },
        ["crankshaft.bearing_stiffness: must be one, all round, or two: to the right, and up"],
    ),
    "three directions of one bearing": (
        {"bearing": {"1": {"stiffness": ["1 kN/mm"] * 3}}},
        ["crankshaft.bearing.1.stiffness: must be one, all round, or two: to the right, and up"],
    ),
    "no journal at all": ({"journals": []}, ["crankshaft.journals: must name each journal once, and one at least"]),
    "no stiffness": (
        {"bearing_stiffness": "0 N/mm"},
        [f"crankshaft.bearing_stiffness = 0 N/mm: {NOT_POSITIVE} N/mm"],
    ),
}


def said(make):
    with pytest.raises(ct.InputError) as refused:
        ct.run(make())
    return [str(problem) for problem in refused.value.problems]


@pytest.mark.parametrize("name", WRONG)
def test_of_crankshafts(name):
    table, sentences = WRONG[name]
    assert sorted(said(lambda: machine(THREE, crankshaft=table))) == sorted(sentences)


def test_of_nothing_that_is_needed():
    shaft = {"main": {"throws": THREE, "spacing": "150 mm"}}
    found = said(lambda: ct.Machine(shaft=shaft, bank={"A": {"mechanism": PLAIN}}, crankshaft={"pin_length": "60 mm"}))
    needed = ("journal_diameter", "pin_diameter", "web_thickness", "web_width")
    assert found == [f"crankshaft.{key}: is missing" for key in needed]


def test_of_one_throw_alone():
    made = {"shaft": {"main": {"throws": ["0 deg"]}}, "mechanism": PLAIN, "crankshaft": SECTIONS}
    assert said(lambda: ct.Machine(**made)) == [
        "crankshaft.bearing_distance: is missing: one pin alone does not say it"
    ]


def test_of_throws_at_one_place():
    found = said(
        lambda: machine(["0 deg", "30 deg"], shaft={"main": {"throws": ["0 deg", "30 deg"], "spacing": "0 mm"}})
    )
    assert found == [
        "shaft.main.spacing: must part throws 1 and 2, whose pins stand at one place; or leave [crankshaft] out"
    ]


def test_of_more_rods_than_places_on_a_pin():
    banks = {name: {"mechanism": PLAIN, "stagger": f"{z} mm"} for name, z in (("L", -15), ("R", 15), ("S", 45))}
    found = said(lambda: machine(["0 deg", "90 deg"], bank=banks))
    assert found == [
        "crankshaft.pin_length = 60 mm: must reach to the rod of 1S, which is 45 mm from the middle of its pin"
    ]


def test_of_shafts_of_which_one_does_not_say_where_its_throws_stand():
    table = example("deltic")
    table["shaft"]["right"].pop("spacing")
    assert said(lambda: ct.Machine(**table)) == [
        "shaft.right.spacing: is missing: either all shafts say where their throws stand, or none"
    ]


def test_of_bearings_that_are_too_wide_to_stand_beside_each_other():
    table = example("mill_engine")
    table["crankshaft"]["bearing"]["outboard"]["z"] = "6 in"
    assert said(lambda: ct.Machine(**table)) == [
        "crankshaft.bearing: must stand clear of one another: outboard and 2 are 82.55 mm apart, and wider"
    ]


GEARS = {
    "a shaft that is not there": (
        {"a": {**GEAR, "shafts": ["upper", "side"]}},
        ["gear.a.shafts = side: must be one of: main, upper"],
    ),
    "a shaft with itself": (
        {"a": {**GEAR, "shafts": ["main", "main"]}},
        ["gear.a.shafts: must be one shaft, or two different ones: from the first to the second"],
    ),
    "in a throw": (
        {"a": {**GEAR, "z": ["350 mm", "150 mm"]}},
        ["gear.a.z[1] = 150 mm: must be on a journal of the shaft main, clear of webs and pins"],
    ),
    "two ways": (
        {"a": GEAR, "b": {**GEAR, "shafts": ["upper"], "direction": "0 deg"}},
        ["gear.b.shafts = upper: must not hand on the torque of upper, as [gear.a] does"],
    ),
    "in a ring": (
        {"a": GEAR, "b": {**GEAR, "shafts": ["main", "upper"]}},
        ["gear.a.shafts = upper, main: must not hand torque on in a ring"],
    ),
    "of no direction": (
        {"a": {**GEAR, "shafts": "main"}},
        ["gear.a.direction: is missing: only between two shafts is it on the line of their centres"],
    ),
    "too many places": (
        {"a": {**GEAR, "z": ["1 mm", "2 mm", "3 mm"]}},
        ["gear.a.z: must be one, or one for each of the shafts: 2"],
    ),
}


@pytest.mark.parametrize("name", GEARS)
def test_of_gears(name):
    table, sentences = GEARS[name]
    assert said(lambda: ct.Machine(**TWO_SHAFTS, gear=table)) == sentences


def test_of_gears_between_shafts_that_turn_alike():
    shafts = {"main": TWO_SHAFTS["shaft"]["main"], "upper": {**TWO_SHAFTS["shaft"]["upper"], "ratio": 1}}
    [found] = said(lambda: ct.Machine(**{**TWO_SHAFTS, "shaft": shafts}, gear={"a": GEAR}))
    assert found == (
        "gear.a.direction: is missing: both shafts turn alike, so that there are gears between them; "
        "give one for each shaft"
    )
