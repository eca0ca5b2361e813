"""The declared machine: what it takes, and how it says what is wrong, each time with the path that the file has."""

import pytest
from tests.machines import ROCKER, V12, banks, slave, slider, throws

import cranktrain as ct
from cranktrain.machine import machine_problems


def problems(**data):
    """Everything that is wrong, as (path, what was given)."""
    with pytest.raises(ct.InputError) as caught:
        ct.run(ct.Machine(**data))
    return {problem.path: problem for problem in caught.value.problems}


def bank(**table):
    return {"bank": {"L": {"mechanism": slider(), **table}}}


def test_values_are_strings_with_units_or_tables():
    machine = ct.Machine(
        mechanism={"kind": "slider_crank", "stroke": {"value": "12 in", "status": "published"}, "rod_length": "30 in"},
        crank_zero="0.5 rad",
        shaft={"main": {"speed": "10 rad/s"}},
    )
    assert machine.mechanism.stroke.si == 0.3048
    assert machine.mechanism.stroke.status == "published"
    assert machine.crank_zero.si == 0.5
    assert machine.main_shaft.speed.si == 10.0


def test_a_machine_is_frozen():
    machine = ct.Machine(mechanism=slider())
    with pytest.raises(ValueError, match="frozen"):
        machine.running = "astern"


def test_specs_are_taken_as_well_as_tables():
    first = ct.Machine(**V12)
    second = ct.Machine(shaft=first.shaft, bank={"L": {"angle": "-30 deg", "mechanism": first.bank["L"].mechanism[0]}})
    assert [place.geometry for place in second.places] == [place.geometry for place in first.places[:6]]


def test_one_value_for_all_angles_or_a_list():
    star = {"angle": ["60 deg", "120 deg"], "mechanism": slave("M", rod_length=["135 mm", "130 mm"])}
    machine = ct.Machine(bank={"M": {"mechanism": slider()}, "S": star})
    assert [place.geometry.rod_length for place in machine.places] == [0.18, 0.135, 0.13]
    assert [place.geometry.knuckle_radius for place in machine.places[1:]] == [0.045, 0.045]


@pytest.mark.parametrize(
    ("data", "path", "said"),
    [
        ({}, "mechanism", "is missing; a machine needs a [mechanism], or banks"),
        ({"bank": {}}, "mechanism", "is missing"),
        ({"mechanism": slider(), "bank": banks(L=0)}, "mechanism", "must not stand beside [bank]"),
        ({"mechanism": [slider()]}, "mechanism", "must be a table"),
        ({"mechanism": "slider_crank"}, "mechanism", "must be a table"),
        ({"mechanism": {"crank_radius": "1 mm"}}, "mechanism.kind", "is missing"),
        ({"mechanism": slider(rod_length=["180 mm"])}, "mechanism.rod_length", "must be a length"),
        ({"mechanism": slider(), "shaft": throws(0, 180)}, "shaft.main.throws", "make it a bank"),
        ({"bank": "L"}, "bank", "must be a table"),
        ({"bank": [{"mechanism": slider()}]}, "bank", "must be a table"),
        ({"bank": {"L": 5}}, "bank.L", "must be a table"),
        ({"bank": {"L": {}}}, "bank.L.mechanism", "is missing"),
        ({"bank": {"L": {"mechanism": "slider_crank"}}}, "bank.L.mechanism", "must be one table"),
        ({"bank": {"L": {"mechanism": [slider()]}}}, "bank.L.mechanism", "must be one table"),
        ({"bank": banks(L=0), "angle": "0 deg"}, "angle", "here each bank has its own"),
        ({"bank": {"1": {"mechanism": slider()}}}, "bank.1", "a letter first"),
        ({"bank": {"L-1": {"mechanism": slider()}}}, "bank.L-1", "letters, digits"),
        ({"bank": {"bore": {"mechanism": slider()}}}, "bank.bore", "no key of [cylinder]"),
        (bank(angle=[]), "bank.L.angle", "at least 1 items"),
        (bank(angle=["0 deg", "1"]), "bank.L.angle[1]", "must be an angle"),
        (bank(angle="1"), "bank.L.angle", "must be an angle"),
        (bank(throws=[]), "bank.L.throws", "at least 1 items"),
        (bank(throws=["1"]), "bank.L.throws[0]", "must be a whole number"),
        (bank(throws=[0]), "bank.L.throws[0]", "one of the shaft's throws, 1 to 1"),
        (bank(throws=[1, 1]), "bank.L.throws[1]", "each once"),
        ({"shaft": {"main": {"throws": []}}, "bank": banks(L=0)}, "shaft.main.throws", "at least 1 items"),
        ({"shaft": {"main": {"throws": "0 deg"}}, "bank": banks(L=0)}, "shaft.main.throws", "must be a list"),
        ({"shaft": {"main": {"throws": [0]}}, "bank": banks(L=0)}, "shaft.main.throws[0]", "must be an angle"),
        ({"mechanism": slider(), "shaft": {"second": {}}}, "shaft.second", "carries no bank"),
        ({"mechanism": slider(), "shaft": throws(0, speed="-1 rpm")}, "shaft.main.speed", "more than 0"),
        ({"mechanism": slave("L")}, "mechanism.master", "there is no other bank"),
        ({"bank": {"L": {"mechanism": slave("L")}}}, "bank.L.mechanism.master", "a slave rod cannot carry another"),
        ({"bank": banks(L=0, R={"mechanism": slave("X")})}, "bank.R.mechanism.master", "the other banks are: L"),
        (
            {"bank": banks(L=0, R={"mechanism": slave("L")}, T={"mechanism": slave("R")})},
            "bank.T.mechanism.master",
            "a slave rod cannot carry another",
        ),
        (
            {"bank": {"L": {"mechanism": ROCKER}, "R": {"mechanism": slave("L")}}},
            "bank.R.mechanism.master",
            "must be a bank of slider-cranks",
        ),
        (
            {"bank": banks(L={"angle": ["0 deg", "40 deg"], "mechanism": slider()}, R={"mechanism": slave("L")})},
            "bank.R.mechanism.master",
            "one slider-crank on throw 1, where this rod is; it has 2",
        ),
        (
            {
                "shaft": throws(0, 180),
                "bank": banks(L={"mechanism": slider(), "throws": [1]}, R={"mechanism": slave("L")}),
            },
            "bank.R.mechanism.master",
            "on throw 2, where this rod is; it has 0",
        ),
        ({"mechanism": ROCKER, "cylinder": {"cycle": "four-stroke"}}, "cylinder", "has no pistons"),
        ({"mechanism": slider(), "cylinder": 5}, "cylinder", "must be a table"),
        ({"mechanism": slider(), "cylinder": {"bor": "1 mm"}}, "cylinder.bor", "did you mean bore"),
        ({"mechanism": slider(), "cylinder": {"overrides": {"bore": "1 mm"}}}, "cylinder.overrides", "neither a key"),
        ({"mechanism": slider(), "cylinder": {"overrides": 1}}, "cylinder.overrides", "is not a key"),
        ({"bank": banks(R=0), "cylinder": {"R": {"bore": "3"}}}, "cylinder.R.bore", "must be a length"),
        ({"mechanism": slider(), "cylinder": {"1": {"bor": "3 mm"}}}, "cylinder.1.bor", "did you mean bore"),
        ({"mechanism": slider(), "cylinder": {"chambers": ["top"]}}, "cylinder.chambers[0]", "head, crank"),
        ({"mechanism": slider(), "cylinder": {"compression_ratio": -3}}, "cylinder.compression_ratio", "more than 1"),
        (
            {"mechanism": slider(points={"p": {"link": "rod", "along": "1 mm"}})},
            "mechanism.points.p.across",
            "is missing",
        ),
        ({"mechanism": slider(), "rotation": "left"}, "rotation", "clockwise, anticlockwise"),
    ],
)
def test_what_is_wrong_and_where(data, path, said):
    (problem,) = problems(**data).values()
    assert problem.path == path
    assert said in str(problem)


def test_fields_of_a_star_that_are_lists():
    """The path names the item, whether the item itself is wrong or only the machine shows it."""
    angles = ["60 deg", "120 deg"]
    master = {"M": {"mechanism": slider()}}

    def star(**fields):
        return {"bank": master | {"S": {"angle": angles, "mechanism": slave("M") | fields}}}

    assert set(problems(**star(rod_length=["135 mm", "5"]))) == {"bank.S.mechanism.rod_length[1]"}
    assert set(problems(**star(rod_length="5"))) == {"bank.S.mechanism.rod_length"}
    found = problems(**star(articulation_angle=["60 deg", "120 deg"], rod_length=["135 mm", "20 mm"]))
    assert set(found) == {"bank.S.mechanism.rod_length[1]"}
    assert found["bank.S.mechanism.rod_length[1]"].given == "20 mm"
    assert set(problems(**star(articulation_angle=["60 deg", "120 deg"], rod_length="20 mm"))) == {
        "bank.S.mechanism.rod_length"
    }
    assert set(problems(**star(master=["M", "X"]))) == {"bank.S.mechanism.master[1]"}
    (short,) = problems(**star(rod_length=["135 mm"])).values()
    assert short.path == "bank.S.mechanism.rod_length"
    assert short.given == "a list of 1"
    assert "one for each angle of the bank: 2" in short.allowed


def test_provenance_in_a_list():
    values = [{"value": "60 deg", "status": "assumed"}, "118 deg"]
    star = {"angle": ["60 deg", "120 deg"], "mechanism": slave("M", articulation_angle=values)}
    machine = ct.Machine(bank={"M": {"mechanism": slider()}, "S": star})
    assert [one.articulation_angle.status for one in machine.bank["S"].mechanism] == ["assumed", None]


def test_everything_wrong_is_told_at_once():
    found = problems(
        rotation="left",
        mechanism=slider(rod_length="5", strok="1 mm"),
        cylinder={"bore": "x", "chambers": ["head", "top"]},
    )
    assert set(found) == {
        "rotation",
        "mechanism.rod_length",
        "mechanism.strok",
        "cylinder.bore",
        "cylinder.chambers[1]",
    }


def test_what_only_the_machine_shows_is_told_at_once():
    found = problems(
        mechanism=slider(rod_length="40 mm", points={"p": {"link": "x", "along": "1 mm", "across": "1 mm"}}),
        cylinder={"firing_order": "1-2", "cycle": "four-stroke", "Q": {"bore": "1 mm"}},
    )
    assert set(found) == {
        "mechanism.points.p.link",
        "cylinder.Q",
        "cylinder.firing_order",
        "mechanism.rod_length",
    }


def test_the_same_problem_of_six_cylinders_is_told_once():
    data = {"shaft": throws(0, 120, 240), "bank": banks(A={"mechanism": slider(rod_length="40 mm")})}
    assert len(problems(**data)) == 1
    assert len(machine_problems(ct.Machine(**data))) == 1
    assert machine_problems(ct.Machine(**data), partial=True) == ()


def test_places_of_a_machine_that_cannot_be_arranged():
    machine = ct.Machine(bank={"L": {"mechanism": slave("X")}})
    assert machine.places == ()
    assert [problem.path for problem in machine_problems(machine)] == ["bank.L.mechanism.master"]
