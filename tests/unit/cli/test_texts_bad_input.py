"""A machine that a text does not speak of, or that lacks a number: what is said leads on when it is typed."""

import ast
import re
import shlex

import pytest

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.io.examples import example_document

NO_TEXT = "none of the texts speaks of this machine"


def commands_in(text):
    return [shlex.split(one) for one in re.findall(r"`cranktrain ([^`]+)`", " ".join(text.split()))]


def leads_on(typed, told):
    """Whether every command that was told shows something, and whether there was one."""
    commands = commands_in(told)
    for command in commands:
        answer = typed(*command)
        assert (answer.status, answer.errors) == (0, ""), command
        assert "speaks of" not in answer.output
        assert "nan" not in answer.output.lower().split()
    return bool(commands)


def without(name, *tables):
    """An example without some of its tables, whose heads are alone on a line."""
    parts = re.split(r"(?m)^(?=\[)", example_document(name).text)
    return "".join(one for one in parts if not one.lstrip("[").startswith(tables))


@pytest.mark.parametrize("name", ["3d12", "10d100", "great_northern", "kamaz_740", "mill_engine"])
def test_a_drive_of_an_engine_is_told_which_texts_speak_of_it(typed, name):
    wrong = typed("textbook", "--drive", name)
    assert (wrong.status, wrong.output) == (2, "")
    assert "mechanism: must have a crank-rocker" in wrong.errors
    assert "--set" not in wrong.errors
    assert leads_on(typed, wrong.errors)


def test_settings_stay_in_what_is_told(typed):
    wrong = typed("textbook", "--drive", "3d12", "--set", "shaft.main.speed=900 rpm")
    assert [one[-2:] for one in commands_in(wrong.errors)] == 3 * [["--set", "shaft.main.speed=900 rpm"]]
    assert leads_on(typed, wrong.errors)


@pytest.mark.parametrize("road", [["--drive"], []])
def test_what_no_text_speaks_of_is_told_so(typed, road):
    answer = typed("textbook", *road, "shaper")
    said = answer.errors + " ".join(answer.output.split())
    assert NO_TEXT in said or "None of the texts" in said


@pytest.mark.parametrize(
    ("name", "cut", "paths"),
    [
        (
            "pumping_unit_c57",
            (),
            ["drive.stage.ratio", "drive.stage.efficiency", "drive.stage", "load", "drive.part", "masses.rocker"],
        ),
        ("jaw_crusher", (), ["load", "masses.rocker"]),
        ("tilting_table", ("drive",), ["drive.stage.ratio", "drive.stage.efficiency", "drive.stage", "drive.part"]),
        ("tilting_table", ("load",), ["load"]),
        ("tilting_table", ("masses.rocker",), ["masses.rocker"]),
        ("tilting_table", ("drive.motor", "drive.part"), ["drive.part"]),
    ],
)
def test_what_a_drive_lacks_is_told_by_its_path_and_the_settings_lead_on(typed, written, name, cut, paths):
    path = str(written(without(name, *cut)))
    wrong = typed("textbook", "--drive", path)
    assert (wrong.status, wrong.output) == (2, "")
    lines = wrong.errors.splitlines()
    assert [line.split("  ")[1].split(":")[0] for line in lines] == paths
    settings = [word for line in lines for word in shlex.split(line.rpartition("; or ")[2])]
    assert len(settings) == 2 * len(paths)
    answer = typed("textbook", "--drive", path, *settings)
    assert (answer.status, answer.errors) == (0, "")
    with pytest.raises(InputError) as refused:
        ct.textbook.drive(path)
    assert [one.path for one in refused.value.problems] == paths
    given = {
        symbol: value
        for one in refused.value.problems
        for symbol, value in ast.literal_eval(str(one.repair).partition("=")[2]).items()
    }
    assert len(ct.textbook.drive(path, set=given)) > 50


@pytest.mark.parametrize("road", ["--drive", "--throw"])
@pytest.mark.parametrize(("name", "cut"), [("tilting_table", "mechanism"), ("kamaz_740", "bank")])
def test_a_machine_without_mechanisms_is_a_machine(typed, written, road, name, cut):
    wrong = typed("textbook", road, str(written(without(name, cut))))
    assert wrong.status == 2
    assert "mechanism: is missing; a machine needs a [mechanism]" in wrong.errors
    assert len(wrong.errors.splitlines()) == 1  # and not each key, as one of a drive's or throw's table


@pytest.mark.parametrize(
    ("function", "name"),
    [
        *((function, "great_northern") for function in ("drive", "opposed", "constants")),
        *((function, "jaw_crusher") for function in ("opposed", "constants")),
        *((function, "shaper") for function in ("drive", "opposed", "constants", "motion")),
    ],
)
def test_functions_name_the_one_that_speaks_of_the_machine(function, name):
    with pytest.raises(InputError) as refused:
        getattr(ct.textbook, function)(name)
    (problem,) = refused.value.problems
    if name == "shaper":
        assert str(problem.repair) == "none of the texts speaks of its motion"
    else:
        assert "`cranktrain.textbook.motion`" in str(problem.repair)
        assert len(ct.textbook.motion(name)) > 0


@pytest.mark.parametrize(
    ("name", "paths"),
    [
        ("tilting_table", ["crankshaft"]),
        ("great_northern", ["masses", "crankshaft"]),
        ("inline_six", ["crankshaft", "shaft.main.spacing"]),
        ("10d100", ["crankshaft"]),
    ],
)
def test_all_that_a_throw_lacks_is_told_at_once_by_its_path(typed, name, paths):
    wrong = typed("textbook", "--throw", name)
    assert (wrong.status, wrong.output) == (2, "")
    assert [line.split("  ")[1].split(":")[0] for line in wrong.errors.splitlines()] == paths
    assert leads_on(typed, wrong.errors)
    with pytest.raises(InputError) as refused:
        ct.textbook.throw(name)
    assert [one.path for one in refused.value.problems] == paths
    assert "FILE" not in str(refused.value)


def test_a_machine_that_can_have_no_throw_is_told_so(typed):
    wrong = typed("textbook", "--throw", "shaper")
    assert f"mechanism: must be pistons on a crankshaft: the text speaks of no other machine; {NO_TEXT}" in wrong.errors


@pytest.mark.parametrize("name", ["tilting_table", "pumping_unit_c57", "shaper"])
@pytest.mark.parametrize(
    "road",
    [
        *(("plot", "--plan", plan, "-o", "x.svg") for plan in ("arc", "brix", "brix-backward", "projection", "klein")),
        ("textbook", "--forces", "kN"),
        ("textbook", "--harmonics"),
    ],
    ids=lambda road: road[2] if road[0] == "plot" else road[1],
)
def test_roads_of_pistons_tell_which_texts_speak_of_what_has_none(typed, road, name):
    answer = typed(road[0], name, *road[1:])
    said = " ".join((answer.output + answer.errors).split())
    assert answer.status == (0 if "--harmonics" in road else 2)
    assert leads_on(typed, said) == (name != "shaper")
    assert (NO_TEXT in said) == (name == "shaper" and "--harmonics" not in road)
    assert "--piston" not in said


def test_a_mechanism_that_has_no_construction_is_told_which_has(typed):
    wrong = typed("plot", "lms_class5", "--plan", "arc", "--mechanism", "1valve", "-o", "x.svg")
    repair = wrong.errors.strip().rpartition("such as: ")[2]
    assert "--mechanism = 1valve: is no slider-crank or eccentric" in wrong.errors
    assert typed("plot", "lms_class5", "--plan", "arc", "--mechanism", repair, "-o", "x.svg").status == 0


def test_forces_at_a_speed_that_follows_from_a_wanted_motion(typed):
    """The press presses with 400 kN at 330°, whatever its inertia adds; `run` has them by another road."""
    shown = typed("textbook", "servo_press", "--forces", "kN")
    assert (shown.status, shown.errors) == (0, "")
    (row,) = (line.split() for line in shown.output.splitlines() if line.strip().startswith("330°"))
    assert float(row[1]) == pytest.approx(400, rel=1e-3)
    result = ct.run("servo_press")
    at = result.crank_angle.tolist().index(330)
    methods, pistons = result.labels["force_method"], result.labels["piston"]
    exact = result.side_force[methods.index("exact"), pistons.index("1"), at]
    assert float(row[2].replace("−", "-")) == pytest.approx(exact / 1e3, abs=6e-4)
    assert typed("plot", "servo_press", "--plan", "polar", "-o", "x.svg").status == 0


def test_the_first_throw_is_meant_unless_another_is_named(typed):
    """Of several shafts, too, whose throws have the shafts' names; where it hangs over, other texts are named."""
    (first, *_more) = ct.textbook.throw("deltic")
    assert first.of == "main.1"
    assert [one.value for one in ct.textbook.throw("vaz_21213")] == [
        one.value for one in ct.textbook.throw("vaz_21213", 1)
    ]
    wrong = typed("textbook", "--throw", "mill_engine")
    assert "hangs over" in wrong.errors
    assert leads_on(typed, wrong.errors)
