import re
from pathlib import Path

import pytest

import cranktrain as ct
from cranktrain.analysis import stages_for
from cranktrain.analysis.grids import FACTS_STEP
from cranktrain.analysis.outcomes import run_stages
from cranktrain.analysis.parts import parts_of
from cranktrain.analysis.stages import lacking, leading_to
from cranktrain.how_far import listened_to
from cranktrain.questions.crankshaft.results.main_bearing_loads import MainBearingLoads

PACKAGE = Path(ct.__file__).parent


@pytest.fixture(scope="module")
def bearing_load():
    """What leads to the bearing loads of a V12 with gas, masses and a crankshaft."""
    return ct.behind("largest_bearing_load", "3d12")


def test_the_last_stage_gives_it_and_all_stand_behind_what_they_take(bearing_load):
    known = {part.name for part in bearing_load.declared}
    for stage in bearing_load.stages:
        assert known.issuperset(stage.takes)
        known.add(stage.gives)
    assert bearing_load.stages[-1].gives == "MainBearingLoads"
    taken = {name for stage in bearing_load.stages for name in stage.takes}
    assert taken == known - {"MainBearingLoads"}


def test_they_run_in_this_order(bearing_load):
    """As stages that are run together say how far they are: `3 of 40, dead centres`."""
    machine = ct.load("3d12")
    parts = parts_of((machine,), step=FACTS_STEP)
    absent = lacking(stages_for(machine), parts)
    there = [stage for stage in stages_for(machine) if stage.outcome not in absent]
    said: list[str] = []
    with listened_to(lambda words: said.append(str(words[-1]()).partition(", ")[2])):
        run_stages(leading_to(there, [MainBearingLoads]), parts, absent)
    assert said == [re.sub("(?<=[a-z])(?=[A-Z])", " ", stage.gives).lower() for stage in bearing_load.stages]


def test_a_run_runs_them_after_all_that_they_take(bearing_load):
    """What may refuse the machine is run first. Of another step of crank angles some are run again."""
    said: list[str] = []
    with listened_to(lambda words: said.append(str(words[-1]()).partition(", ")[2])):
        ct.run("3d12", quantities="largest_bearing_load").find_all()
    names = [re.sub("(?<=[a-z])(?=[A-Z])", " ", stage.gives).lower() for stage in bearing_load.stages]
    ran = list(dict.fromkeys(said))
    assert set(names) <= set(ran)
    for stage, name in zip(bearing_load.stages, names, strict=True):
        taken = [re.sub("(?<=[a-z])(?=[A-Z])", " ", one).lower() for one in stage.takes]
        assert all(
            ran.index(one) < ran.index(name) and names.index(one) < names.index(name) for one in taken if one in names
        )


def test_everything_stands_where_it_says(bearing_load):
    for found in (*bearing_load.declared, *bearing_load.stages):
        line = (PACKAGE / found.place.file).read_text(encoding="utf-8").splitlines()[found.place.line - 1]
        assert line.startswith((f"def {found.name}(", f"class {found.name}:", f"class {found.name}("))


def test_tables_are_those_of_the_file(bearing_load):
    tables = {part.name: set(part.tables) for part in bearing_load.declared}
    assert tables["DeclaredGas"] == {"[gas]"}
    assert tables["Masses"] >= {"[masses]", "[bank.L.masses]", "[bank.R.masses]"}
    assert tables["Masses"].isdisjoint({"[friction]", "[guide]", "[gravity]"})
    (gas,) = (stage for stage in bearing_load.stages if stage.gives == "GasInChambers")
    assert "[gas]" in gas.tables and "[crankshaft]" not in gas.tables


def test_tables_of_any_machine_have_names_for_all():
    (pistons,) = (part for part in ct.behind("gas_pressure").declared if part.name == "Pistons")
    assert set(pistons.tables) == {"[mechanism]", "[bank.NAME]", "[shaft.NAME]"}


def test_keys_above_all_tables_are_named():
    slider = {"kind": "slider_crank", "stroke": {"value": "80 mm", "status": "published"}, "rod_length": "136 mm"}
    file = {"crank_zero": "10 deg", "bank": {"A": {"angle": "5 deg", "mechanism": slider}}}
    tables = {part.name: part.tables for part in ct.behind("stroke", file).declared}
    assert tables["CrankAngle"] == ("crank_zero",)
    assert set(tables["Pistons"]) == {"[bank.A.mechanism]", "[bank.A]"}


def test_a_stage_names_its_equations():
    (stage,) = (one for one in ct.behind("shaking_couple_x").stages if one.name == "frame_forces")
    assert stage.sources == ("docs/theory/balance, eq. (16.15)",)


def test_a_stage_that_cites_nothing_names_the_equations_of_what_it_gives():
    assert ct.behind("rod_angle").stages[-1].sources == (
        "docs/theory/groups, eqs. (1.4) to (1.6)",
        "docs/theory/slider-crank, eq. (2.12)",
    )


@pytest.mark.parametrize(
    ("quantity", "said"),
    [
        ("gear_torque", "docs/theory/forces, eq. (13.39)"),
        ("side_force", "docs/theory/forces, eqs. (13.10), (13.31)"),
        ("firing_angle", "docs/conventions"),
    ],
)
def test_a_page_begins_with_the_equation(quantity, said):
    about, _blank, _rest = str(ct.behind(quantity)).partition("\n\n")
    assert about.splitlines()[-1].strip() == said


@pytest.mark.parametrize("width", [70, 80])
def test_a_page_keeps_its_width(bearing_load, width):
    lines = list(bearing_load.lines(width))
    assert max(map(len, lines)) <= width
    assert str(bearing_load).splitlines() == list(bearing_load.lines())


def test_unknown_quantity():
    with pytest.raises(ct.InputError) as raised:
        ct.behind("strok")
    (problem,) = raised.value.problems
    assert (problem.path, problem.given) == ("behind", "strok")
    assert "did you mean stroke?" in str(raised.value)


def test_a_machine_that_lacks_it():
    with pytest.raises(ct.InputError, match=r"it needs \[crankshaft\]"):
        ct.behind("largest_bearing_load", "tilting_table")
    with pytest.raises(ct.InputError, match="a result of other machines"):
        ct.behind("smallest_transmission_angle", "3d12")
