"""The catalogue: unique names, known units and dimensions, arrays of the shape they declare, sources that exist."""

import ast
import copy
import random
import re
import string
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from tests.dimensions import DIMENSIONS
from tests.machines import ROCKER, V12, slave, slider, throws
from tests.told import texts_of

import cranktrain as ct
from cranktrain import texts
from cranktrain.all_questions import QUESTIONS
from cranktrain.analysis import every_stage, ordered
from cranktrain.analysis.outcomes import run_stages
from cranktrain.analysis.stages import lacking
from cranktrain.io.examples import example_names
from cranktrain.saying.catalogue import entries

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "src/cranktrain"
ENTRIES = [entry for stage in every_stage() for entry in entries(stage.gives)]
_TAKE_WHAT_THERE_IS = {stage.gives for stage in every_stage() if stage.gives.__name__.startswith("Unlikely")}
UNITS = {"m", "rad", "deg", "s", "kg", "N", "Pa", "J", "W", "K"}
POINTS = {"p": {"link": "rod", "along": "10 mm", "across": "5 mm"}}

EVERYTHING = {
    "shaft": throws(0, 120, speed="900 rpm", spacing="100 mm")
    | {"upper": {"throws": ["0 deg"], "ratio": -1, "place": ["0 mm", "600 mm"]}},
    "bank": {
        "L": {"angle": "-30 deg", "mechanism": slider()},
        "R": {"angle": "30 deg", "mechanism": slave("L")},
        "K": {"angle": "90 deg", "mechanism": ROCKER | {"load_radius": "1 m", "points": POINTS}},
        "W": {"mechanism": {"kind": "slotted_lever", "crank_radius": "40 mm", "ground_length": "90 mm"}},
        "Z": {"mechanism": {"kind": "oscillating_cylinder", "crank_radius": "40 mm", "ground_length": "190 mm"}},
        "O": {
            "exhaust": {"mechanism": slider(), "throws": [1]},
            "scavenge": {"mechanism": slider(), "shaft": "upper"},
            "lead": "12 deg",
        },
    },
    "cylinder": {
        "bore": "80 mm",
        "compression_ratio": 9,
        "chambers": ["head", "crank"],
        "cycle": "four-stroke",
        "firing_order": "1L-1O-2Z-2R-1Z-1R-2L",
        "exhaust_port": "20 mm",
        "scavenge_port": "15 mm",
        "mechanical_efficiency": 0.8,
        "O": {"chambers": ["head"], "compression_ratio": 9},
        "R": {"compression_ratio": 9},
        "Z": {"compression_ratio": 9},
    },
    "masses": {"piston": {"mass": "0.4 kg"}},
    "gravity": True,
    "guide": {"piston": {"length": "60 mm"}},
    "load": {
        "work": {"on": "rocker", "torque": "20 N*m"},
        "drag": {"on": "piston", "force": "20 N"},
        "on_shaft": {"on": "main", "file": "load.csv", "text": "angle;torque [N·m]\n0;100\n360;100"},
    },
    "gas": {
        "kind": "otto",
        "start_pressure": "95 kPa",
        "compression_exponent": 1.35,
        "expansion_exponent": 1.27,
        "pressure_ratio": 3.6,
    },
    "balance": {
        "counterweights": "rotating",
        "share": 0.5,
        "wheel": {"near": {"z": "-50 mm", "load": "9 kN"}, "off": {"z": "150 mm", "load": "9 kN"}},
        "weight": [{"mass": "1 kg", "radius": "40 mm", "throw": 2}],
        "shafts": [{"order": 2, "against": "both", "planes": ["0 mm", "100 mm"]}],
    },
    "evenness": {
        "flywheel": "2 kg·m²",
        "coefficient": 0.02,
        "rim": {"mean_diameter": "600 mm"},
    },
    "rod_load": {"compression": "40 kN"},
    "drive": {
        "motor": {"kind": "shunt", "torque": "100 N·m", "speed": "1750 rpm", "no_load_speed": "1800 rpm"},
        "stage": [{"ratio": 2}],
        "flywheel": {"on": 1, "fluctuation": 0.01},
    },
}
"""A machine of all kinds, which declares all there is for such a one."""


@pytest.fixture(scope="module")
def everything():
    return ct.run(ct.Machine(**EVERYTHING))


def test_names_are_unique():
    names = [entry.name for entry in ENTRIES]
    assert sorted({name for name in names if names.count(name) > 1}) == [], (
        "give one of the two quantities another name"
    )


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.name)
def test_entry(entry):
    factors = [re.fullmatch(r"([A-Za-z]+)(\^[23])?", part) for part in re.split(r"[*/]", entry.unit)]
    assert entry.unit == "1" or all(found and found[1] in UNITS for found in factors), (
        f"{entry.unit}: write it as products and powers of {UNITS}, or 1"
    )
    assert set(entry.dimensions) <= DIMENSIONS.keys(), "declare these as dimensions of the Question"
    assert entry.dimensions.count("crank_angle") == 0 or entry.dimensions[-1] == "crank_angle", (
        "the crank angle is the last dimension"
    )
    assert re.fullmatch(r"[a-z]+(_[a-z]+)*", entry.name), (
        "a name is of small letters with underscores between its words"
    )
    assert entry.sentence[0].isupper(), f"begin it with a capital letter: {entry.sentence}"
    assert not entry.sentence.endswith("."), f"leave out the full stop: {entry.sentence}"
    assert (ROOT / f"{entry.source}.md").is_file(), f"write {entry.source}.md, the page of theory that it names"


def test_no_dimension_has_the_name_of_a_quantity():
    """A dataset has both under their names."""
    twice = sorted(DIMENSIONS.keys() & {entry.name for entry in ENTRIES})
    assert twice == [], "give the dimension, or the quantity, a name of its own: a dataset cannot hold both"


@pytest.fixture(scope="module")
def examples():
    """What every example gives, by its name."""
    return cache(lambda name: set(ct.run(ct.load(name), step_degrees=10).catalogue))


GROUPS = {question.name: question.stages for question in QUESTIONS} | {
    "kinds": [stage for stage in every_stage() if stage.gives.__module__.startswith("cranktrain.mechanisms.")],
    "textbook": texts.STAGES,
}
"""Stages by what they answer."""


def test_every_stage_is_of_a_question_a_kind_or_the_textbook():
    assert {stage.gives for group in GROUPS.values() for stage in group} == {stage.gives for stage in every_stage()}


@pytest.fixture(scope="module")
def stuck():
    """A machine that does not turn all round, as no example does."""
    mechanism = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "40 mm", "points": POINTS}
    return ct.run(ct.Machine(mechanism=mechanism), partial=True)


@pytest.fixture(scope="module")
def tried():
    """A crankshaft of which Holzer's table is asked at a frequency of its own, as of no example."""
    disc = {"inertia": "2 kg·m²", "beside": 1, "stiffness": "900 N·m/rad"}
    torsion = {"throw_inertia": "2 kg·m²", "disc": {"flywheel": disc}, "holzer_at": "5 Hz"}
    return ct.run(ct.Machine(mechanism=slider(), torsion=torsion))


@pytest.mark.parametrize("group", GROUPS)
def test_every_result_is_given_by_the_machine_with_everything_or_by_an_example(
    everything, stuck, tried, examples, group
):
    """The examples are asked for what is of machines that are not of all kinds."""
    left = {entry.name for stage in GROUPS[group] for entry in entries(stage.gives)} - set(everything.catalogue)
    left -= set(stuck.catalogue) | set(tried.catalogue)
    for name in example_names():
        if left:
            left -= examples(name)
    assert left == set(), "declare what they need in EVERYTHING above, or bring an example in examples/ that has them"


def test_a_machine_with_everything_misses_nothing_that_it_declares(everything):
    assert missing_of_declared(everything, {*EVERYTHING, "mechanism"}) == {}, "add these keys to EVERYTHING above"


def test_nothing_is_given_that_no_stage_declares(everything):
    assert set(everything.catalogue) <= {entry.name for entry in ENTRIES}, (
        "a result class is given by a Stage of a Question"
    )


def missing_of_declared(result, tables):
    """Results that are missing although the file has the table of all that they need, by what they need."""
    return {
        texts_of(missing.needs): set(missing.results)
        for missing in result.missing
        if all(re.match(r"\[(\w+)", need)[1] in tables for need in texts_of(missing.needs))
    }


def test_arrays_have_the_shape_that_they_declare(everything):
    lengths = {name: len(labels) for name, labels in everything.labels.items()}
    lengths["crank_angle"] = everything.crank_angle.size
    assert set(everything.labels) <= DIMENSIONS.keys()
    for name, entry in everything.catalogue.items():
        expected = tuple(lengths[dimension] for dimension in entry.dimensions)
        assert np.shape(getattr(everything, name)) == expected, name


def test_labels_are_unique(everything):
    for dimension, labels in everything.labels.items():
        assert len(set(labels)) == len(labels), dimension


def test_checks_have_names_of_their_own(everything):
    names = [check.name for check in everything.checks]
    assert len(set(names)) == len(names), "give every check a name of its own"
    assert all(check.sentence and check.limit > 0 for check in everything.checks), (
        "a check has a sentence, and a limit that rounding explains"
    )


@pytest.mark.parametrize("seed", range(20))
def test_stages_can_be_declared_in_any_order(seed):
    shuffled = random.Random(seed).sample(every_stage(), len(every_stage()))
    known: set[type] = set()
    outcomes = {stage.gives for stage in every_stage()}
    for stage in ordered(tuple(shuffled)):
        assert {need for need in stage.needs.values() if need in outcomes} <= known, (
            "stages need each other in a circle"
        )
        known.add(stage.gives)
    assert known == outcomes


def test_results_come_in_the_order_of_the_declaration():
    from cranktrain.analysis.parts import parts_of

    parts = parts_of([ct.Machine(**V12)], step=np.radians(10))
    absent = lacking(every_stage(), parts)
    forward = run_stages(every_stage(), parts, absent)
    backward = run_stages(every_stage()[::-1], parts, absent)
    assert list(backward) == list(forward)[::-1]


@pytest.mark.parametrize("n_designs", [1, 2])
def test_needed_stages_are_those_that_are_run(n_designs):
    """Every quantity, asked for alone, comes with nothing that it does not need; doubts take what there is."""
    machines = [ct.Machine(**V12)] * n_designs
    by_outcome = {stage.gives: stage for stage in every_stage()}
    for stage in every_stage():
        for entry in entries(stage.gives)[:1]:
            needed, left = set(), [stage.gives]
            while left:
                outcome = left.pop()
                if outcome in by_outcome:
                    needed.add(outcome)
                    left += by_outcome[outcome].needs.values()
            result = ct.run(machines, quantities=[entry.name], step_degrees=10)
            assert {type(outcome) for outcome in result.outcomes} <= needed | _TAKE_WHAT_THERE_IS, entry.name


class TestMissing:
    """What a machine file lacks, taken away one by one."""

    def missing(self, **changes):
        data = copy.deepcopy(V12)
        for path, value in changes.items():
            *tables, key = path.split("__")
            table = data
            for name in tables:
                table = table[name]
            if value is None:
                del table[key]
            else:
                table[key] = value
        return missing_of_declared(ct.run(ct.Machine(**data), step_degrees=10), data)

    def test_nothing(self):
        assert self.missing() == {}

    def test_speed(self):
        (results,) = (found := self.missing(shaft__main__speed=None)).values()
        assert list(found) == [("[shaft.main] speed",)]
        assert {"piston_velocity", "mean_piston_speed"} <= results

    def test_spacing(self):
        found = self.missing(shaft__main__spacing=None)
        assert list(found) == [("[shaft.main] spacing",)]
        assert found["[shaft.main] spacing",] >= {"axial_position"}

    def test_bore(self):
        found = self.missing(cylinder__bore=None)
        assert found[("[cylinder] bore",)] >= {"displacement", "chamber_volume"}
        assert list(found) == [("[cylinder] bore",)]

    def test_ratio(self):
        found = self.missing(cylinder__compression_ratio=None)
        assert list(found) == [("[cylinder] compression_ratio or clearance",)]
        assert found["[cylinder] compression_ratio or clearance",] >= {
            "chamber_volume",
            "clearance_volume",
            "compression_ratio",
        }

    def test_bore_and_ratio(self):
        found = self.missing(cylinder__bore=None, cylinder__compression_ratio=None)
        assert "compression_ratio" in found["[cylinder] bore", "[cylinder] compression_ratio or clearance"]

    def test_firing_order(self):
        found = self.missing(cylinder__firing_order=None)
        assert list(found) == [("[cylinder] firing_order or firing_angles",)]
        (results,) = found.values()
        assert results >= {"firing_angle", "firing_dead_centre", "firing_interval", "phase_star_sum"}

    def test_cycle(self):
        assert list(self.missing(cylinder__cycle=None)) == [("[cylinder] cycle",)]

    def test_what_is_for_another_kind_of_machine_is_not_spoken_of(self):
        result = ct.run(ct.Machine(mechanism=ROCKER))
        needs = {need for missing in result.missing for need in texts_of(missing.needs)}
        assert not {need for need in needs if need.startswith(("[cylinder", "[gas", "[guide", "[friction", "[gravity"))}
        assert needs >= {
            "[balance]",
            "[evenness.rim] mean_diameter",
            "[evenness]",
            "[evenness] coefficient",
            "[evenness] flywheel or flywheel_moment",
            "[masses]",
            "[mechanism.points.NAME] link, along, across",
            "[mechanism] load_radius",
            "[shaft.main] speed",
        }


def placeholders(text):
    return {name for _literal, name, _format, _conversion in string.Formatter().parse(text) if name is not None}


def test_every_placeholder_of_a_sentence_is_filled():
    """`_("… {x}").format(x=…)`: the names in the sentence are those that are given, no more and no less."""
    for path in PACKAGE.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            match node:
                case ast.Call(
                    func=ast.Attribute(
                        value=ast.Call(func=ast.Name(id="_"), args=[ast.Constant(value=str(text))]), attr="format"
                    ),
                    args=[],
                    keywords=keywords,
                ) if all(keyword.arg for keyword in keywords):
                    given = {keyword.arg for keyword in keywords}
                    assert placeholders(text) == given, (
                        f"{path}:{node.lineno}: give format() just what the sentence has in {{ }}"
                    )
                case _:
                    continue


def test_sentences_of_the_catalogue_have_no_placeholders():
    assert [entry.name for entry in ENTRIES if placeholders(entry.sentence)] == [], (
        "a sentence of the catalogue is shown as it stands: take { } out"
    )


def test_flywheels_are_told_by_their_inertia_and_flywheel_moments_as_such():
    """Both are in kg·m²: a GD² without its name is taken for an inertia, four times too large."""
    every = [entry for stage in every_stage() for entry in entries(stage.gives)]
    moments = {entry.name: entry for entry in every if "flywheel_moment" in entry.name}
    assert moments
    assert not moments.keys() & {name for question in QUESTIONS for name in question.headline}
    for entry in moments.values():
        assert "GD²" in entry.symbol, "a flywheel moment has GD² in its symbol, by which screens call it so"
        assert "GD²" in entry.sentence, "say GD² in the sentence, too: its kg·m² are taken for an inertia's"
        assert "GD²" in entry.words
    others = [entry for entry in every if entry.name not in moments]
    assert not [entry.name for entry in others if "GD²" in entry.symbol or "GD²" in entry.words]
