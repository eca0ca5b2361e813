"""The declared machine: what it takes, and how it says what is wrong, each time with the path that the file has."""

import pytest
from tests.machines import ROCKER, V12, banks, slave, slider, throws
from tests.sentences import HOLDS_NOTHING, KEEP_ONE, NO_PATH, SET_TWICE, TOO_DEEP, WHOLE_NUMBER

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
        (bank(throws=["1"]), "bank.L.throws[0]", WHOLE_NUMBER),
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
    assert str(short.given) == "a list of 1"
    assert "one for each angle of the bank: 2" in str(short.allowed)


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
        "shaft.main.throws",
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


class TestWith:
    def test_values_at_paths_are_replaced_and_checked(self):
        rod = {"value": "136 mm", "status": "published"}
        machine = ct.Machine(mechanism=slider(rod_length=rod), shaft={"main": {"throws": ["0 deg"]}})
        other = machine.with_({"mechanism.rod_length": "140 mm", "shaft.main.throws[0]": "10 deg", "name": "other"})
        assert other.mechanism.rod_length.si == 0.14
        assert other.mechanism.rod_length.status is None
        assert (other.name, other.main_shaft.throws[0].text) == ("other", "10 deg")
        assert (machine.mechanism.rod_length.status, machine.name) == ("published", "")
        assert other == ct.Machine(
            name="other", mechanism=slider(rod_length="140 mm"), shaft={"main": {"throws": ["10 deg"]}}
        )

    def test_tables_are_made_and_taken_whole(self):
        machine = ct.Machine(**V12).with_({"evenness": {}, "cylinder.1L.bore": "100 mm"})
        assert machine.evenness is not None
        assert machine.cylinder.overrides["1L"].bore.si == 0.1

    def test_all_errors_are_told_at_once_each_with_its_path(self):
        values = {"mechanism.rod_length": "140 kg", "mechanism.strok": "1 mm", "shaft.main.speed": "fast"}
        with pytest.raises(ct.InputError) as caught:
            ct.Machine(mechanism=slider()).with_(values)
        assert {problem.path for problem in caught.value.problems} == set(values)

    @pytest.mark.parametrize(
        ("values", "said"),
        [
            ({"shaft.main.throws[9]": "0 deg"}, "shaft.main.throws is a list of 6"),
            ({"name.first": "x"}, "name is no table or list; set it whole"),
            ({"bank[0]": 1}, "bank is a table, whose keys are names"),
            ({"bank..x": 1}, NO_PATH),
            ({"bank.L": {}, "bank.L.angle": "0 deg"}, f"{SET_TWICE}; {KEEP_ONE}"),
            ({".".join(["a"] * 40): 1}, TOO_DEEP),
        ],
    )
    def test_a_path_that_leads_nowhere_is_refused(self, values, said):
        with pytest.raises(ct.InputError, match=said.replace("[", r"\[")):
            ct.Machine(**V12, name="x").with_(values)

    def test_what_a_caller_does_with_its_data_is_no_matter(self):
        mechanism = slider()
        machine = ct.Machine(mechanism=mechanism)
        mechanism["rod_length"] = "1 m"
        assert machine.with_({"name": "x"}).mechanism == machine.mechanism

    def test_another_file_of_a_curve_is_not_the_old_ones_text(self):
        gas = {"kind": "indicator", "file": "old.csv", "text": "".join(f"{angle},1\n" for angle in range(0, 720, 10))}
        gas |= {"pressure_unit": "bar"}
        other = ct.Machine(mechanism=slider(), gas=gas).with_({"gas.file": "new.csv"})
        assert other.gas.text is None

    def test_a_copy_with_other_values_is_refused(self):
        with pytest.raises(ct.InputError, match=r"model_copy = name: cannot be changed .* machine.with_"):
            ct.Machine(mechanism=slider()).model_copy(update={"name": "x"})
        assert ct.Machine(mechanism=slider()).model_copy() == ct.Machine(mechanism=slider())


def test_a_machine_has_at_most_a_thousand_mechanisms():
    found = problems(shaft={"main": {"throws": ["0 deg"] * 1001}}, **bank())
    assert str(found["shaft.main.throws"].allowed) == "must have at most 1000 items"
    found = problems(shaft={"main": {"throws": ["0 deg"] * 40}}, **bank(angle=["0 deg"] * 30))
    assert str(found["bank"].allowed) == "gives 1200 mechanisms; a machine may have at most 1000"


def test_an_empty_balance_is_refused():
    found = problems(mechanism=slider(), balance={})
    assert str(found["balance"].allowed) == HOLDS_NOTHING


def test_an_empty_key_has_a_path():
    assert problems(mechanism={**slider(), "": 1})['mechanism.""'].given == "1"
