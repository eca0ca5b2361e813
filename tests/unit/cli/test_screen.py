"""The answer on one screen: how long and wide, in which words, and how rows become columns."""

import itertools
import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from tests.told import line_of, texts_of

import cranktrain as ct
from cranktrain import cli
from cranktrain.all_questions import QUESTIONS
from cranktrain.cli.screen.answer import joined
from cranktrain.cli.screen.groups import group_lines
from cranktrain.io.examples import EXAMPLES_FOLDER
from cranktrain.language import _
from cranktrain.mechanisms import KINDS
from cranktrain.saying.amounts import Amount, Extent, filled, written
from cranktrain.saying.row_table import member_columns
from cranktrain.saying.row_words import name_of
from cranktrain.saying.rows import AnswerLine, valued, worded
from cranktrain.saying.typesetting import typeset

EXAMPLES = sorted(path.stem for path in EXAMPLES_FOLDER.glob("*.toml"))
MOST_LINES, MOST_ROWS = 45, 5
TODAY = {"motion": 9, "cylinders": 7, "gas": 6}
"""Questions of today that may have more rows than a later one."""

DRIVEN = ("compressor_start", "gas_compressor", "shaking_conveyor", "mud_pump_12p160", "two_throw_compressor")
WITHOUT_CYLINDERS = (
    "eccentric_press",
    "high_slip_press",
    "jaw_crusher",
    "pumping_unit_c57",
    "servo_press",
    "servo_press_rocking",
    "shaper",
    "shears",
    "tilting_table",
    "toggle_press",
)
VALVE_GEARS = ("eccentric", "stephenson")
ROCKERS = ("crank_rocker", "slotted_lever")

OF_ENGINES = (
    r"fir(ing|es)\b|(two|four)-stroke|brake (power|thermal|torque)|burn|diagram|backward|engine"
    r"|power -|power −|pressure [-−]"
)
OF_PISTONS = r"dead cent|iston|cylinder|wall|indicated|compression"


def file_of(typed, name: str) -> str:
    """An example, or the file that `new` writes for a kind."""
    if name in EXAMPLES:
        return name
    assert typed("new", name, "-o", "mine.toml").status == 0
    return "mine.toml"


def sentences(output: str) -> str:
    """What is said of the machine: without the table of results, whose names are not in words, and what it lacks."""
    others = ("Results", "By each method", "Largest values", "Checks", "What this", "To learn")
    parts = [part for part in re.split(r"\n\n(?=\S)", output) if not part.startswith(others)]
    return re.sub(r"(?m)^Textbook.*|^.*\[steam-engine\].*", "", "\n\n".join(parts))


def rows_below(lines, title):
    """The lines of a group of the answer, its title with them."""
    return (
        [title, *itertools.takewhile(lambda line: line.startswith("  "), lines[lines.index(title) + 1 :])]
        if title in lines
        else []
    )


LATER, MOST_ROWS = ("Main bearings", "Torsion"), 5
"""Questions that only some machines are asked, which may have so many rows beyond a screen's."""


@pytest.mark.parametrize("name", [*EXAMPLES, *(kind.name for kind in KINDS)])
def test_every_answer_is_one_screen(typed, name):
    answer = typed("run", file_of(typed, name))
    assert (answer.status, answer.errors) == (0, "")
    lines = answer.output.splitlines()
    assert len(lines) <= MOST_LINES + sum(len(rows_below(lines, title)) for title in LATER)
    assert all(len(rows_below(lines, title)) <= MOST_ROWS + 1 for title in LATER)
    assert max(map(len, lines)) <= 80
    assert answer.output.replace("\n", "").isprintable()
    assert re.findall(r"\d[eE][+-]?\d", answer.output) == []
    assert [line for line in lines if re.search(r"(?<![\w.)\]-])-\d", line)] == []
    assert [line for line in lines[1:] if re.search(r"N\*m|m/s\^2|\bdeg\b|\bPa\b", line)] == []


@pytest.mark.parametrize("options", [(), ("--full",)], ids=["answer", "full"])
@pytest.mark.parametrize("name", [*DRIVEN, *WITHOUT_CYLINDERS, *VALVE_GEARS, *ROCKERS])
def test_no_engine_is_spoken_of_where_there_is_none(typed, name, options):
    said = sentences(typed("run", file_of(typed, name), "--step", "5", *options).output)
    assert re.findall(OF_ENGINES, said) == []
    if name not in DRIVEN:
        assert re.findall(OF_PISTONS, said) == []


@pytest.mark.parametrize("name", [*WITHOUT_CYLINDERS, *ROCKERS])
def test_what_has_no_cylinder_is_not_asked_when_it_fires(typed, name):
    """A slider might get a bore, and with it all that cylinders have, but not one that works against a load."""
    file = file_of(typed, name)
    machine, asked = ct.load(file), re.findall(r"\[cylinder\] \w+", typed("run", file, "--missing").output)
    may = any(place.kind.output == "slider" for place in machine.places) and not any(machine.loads.values())
    assert asked == (["[cylinder] bore"] if may else [])


def test_what_works_against_a_load_is_not_asked_for_a_bore():
    pressed = {"load": {"die": {"on": "piston", "force": "5 kN"}}}
    ram = ct.Machine(mechanism={"kind": "slider_crank", "stroke": "80 mm", "rod_length": "136 mm"}, **pressed)
    result = ct.run(ram)
    assert not any("[cylinder]" in str(need) for one in result.worth_asking for need in one.needs)
    assert "[cylinder] bore" in texts_of(result.needs_of("gas_pressure"))  # whoever asks is told


def test_every_example_is_an_engine_or_none():
    """A new example of a press or pump has to be named here."""
    with_firing = {name for name in EXAMPLES if ct.load(name).cylinder.cycle or "locomotive" in ct.load(name).name}
    steam = {"great_northern", "lms_class5", "traction_engine", "m_503"}  # of the last no firing order is known
    assert sorted(with_firing | steam) == sorted(set(EXAMPLES) - {*DRIVEN, *WITHOUT_CYLINDERS})


def test_the_screen_knows_no_question():
    """A new question changes nothing here."""
    screen = Path(cli.__file__).parent / "screen"
    named = {
        name
        for path in screen.glob("*.py")
        for name in re.findall(r"cranktrain\.questions\.[\w.]+", path.read_text("utf-8"))
    }
    assert named == set()


@cache
def rows_of(name):
    """The groups of the answer of an example, which every question looks through."""
    return tuple(ct.run(ct.load(name), step_degrees=5).rows())


@pytest.mark.parametrize("question", QUESTIONS, ids=lambda question: question.name)
def test_a_question_has_few_rows(question):
    for name in ("3d12", "10d100", "r_1340", "gas_compressor", "burning_cylinder", "inline_six", "lms_class5"):
        for title, rows in rows_of(name):
            if title == question.title:
                assert len(rows) <= TODAY.get(question.name, MOST_ROWS), name


def test_all_questions_together_are_little_more_than_a_screen(typed, written):
    text = (EXAMPLES_FOLDER / "r_1340.toml").read_text(encoding="utf-8")
    answer = typed("run", str(written(text + EVERY_QUESTION)))
    assert "Torsion" in answer.output and "its rim" in answer.output and "edge of a guide" in answer.output
    assert len(answer.output.splitlines()) <= 60


EVERY_QUESTION = """
[evenness.rim]
mean_diameter = "500 mm"
[guide.piston]
length = "60 mm"
[torsion]
throw_inertia = "0.1 kg·m²"
[torsion.disc.propeller]
inertia = "12 kg·m²"
beside = 1
stiffness = "1 MN·m/rad"
"""


def test_all_numbers_are_behind_one_option(typed):
    output = typed("run", "3d12", "--full").output
    assert [name for name in ct.run(ct.load("3d12"), step_degrees=5).catalogue if name not in output] == []


def test_the_answer_of_a_v12(typed):
    """Two columns for twelve cylinders; strokes as the rods were fitted, 180 and 186.7 mm; 300 PS at the shaft."""
    lines = typed("run", "3d12").output.splitlines()
    assert lines[:3] == [
        "3D12 marine diesel, 60° V12 with articulated rods",
        "12 pistons, 6 throws, banks L and R · four-stroke · 1500 rpm, clockwise",
        "",
    ]
    said = {line[2:25].rstrip(): line[25:].split() for line in lines if line.startswith("  ")}
    assert said["stroke"] == ["180.0", "186.7", "mm"]
    assert float(said["brake power"][0]) == pytest.approx(300 * 0.73549875, rel=0.02)
    assert said["firing order"] == ["1L-6R-5L-2R-3L-4R-6L-1R-2L-5R-4L-3R,", "every", "60°"]
    heads = [line for line in lines if line.startswith("Motion")]
    assert heads[0].split() == ["Motion", "L", "R"]


def test_what_comes_next_is_of_this_machine(typed, written):
    """A press is not asked for a compression ratio, an engine with a bore for gas, a machine without speed for that."""

    def following(file: str) -> str:
        return typed("run", file, "--step", "5").output.rpartition("Next: ")[2]

    assert "[cylinder]" not in following("eccentric_press")
    assert "[gas] pressures and power" in following("textbook_78x78")
    still = '[mechanism]\nkind = "slider_crank"\nstroke = "80 mm"\nrod_length = "136 mm"\n'
    assert following(str(written(still))).startswith("[shaft.main] speed speeds and accelerations")


def test_room_is_said_as_the_file_says_it(typed):
    """15 % of the swept volume is a ratio of 1 + 1/0.15 = 7.667; the other of the two is behind --full."""
    answer = typed("run", "gas_compressor", "--step", "5").output
    assert re.search(r"(?m)^  clearance +15\.00 %$", answer)
    assert "compression ratio" not in answer
    assert re.search(r"(?m)^ +compression_ratio .* 7\.667 ", typed("run", "gas_compressor", "--full").output)
    assert "clearance" not in typed("run", "3d12", "--step", "5").output
    assert line_of(ct.run("gas_compressor"), "Cylinders", "clearance") == "15.00 %"


def test_a_table_is_quoted_where_a_file_has_blanks(typed, written):
    path = written('[mechanism]\nkind = "slider_crank"\nstroke = "80 mm"\nrod_length = "136 mm"\n', "my press.toml")
    assert f"plot '{path.name}' -o sheet.pdf" in typed("run", path.name).output


class TestAmounts:
    @pytest.mark.parametrize(
        ("values", "unit", "texts", "label"),
        [
            ([0.18, 0.1867], "m", ("180.0", "186.7"), "mm"),
            ([5.678e5], "Pa", ("5.678",), "bar"),
            ([666.6], "N", ("666.6",), "N"),
            ([71310.0], "N", ("71.31",), "kN"),
            ([12.0, 71310.0], "N", ("0.01200", "71.31"), "kN"),
            ([2.451, 19.632], "1", ("2.451", "19.63"), ""),
            ([-261e3], "W", ("−261.0",), "kW"),
            ([5e-5], "m^3", ("50.00",), "cm³"),
            ([17235.0], "m/s^2", ("17240",), "m/s²"),
            ([9.9996], "m/s", ("10.00",), "m/s"),
            ([3.648e-5], "1", ("0.00003648",), ""),
            ([np.radians(-4.264)], "rad", ("−4.26",), "°"),
            ([np.radians(438.296)], "position", ("438.3",), "°"),
            ([0.0], "m", ("0",), "mm"),
            ([-1e-20, 1.0], "J", ("0.000", "1.000"), "J"),
            ([np.nan, 1.0], "J", ("–", "1.000"), "J"),
            ([0.0092], "error", ("0.92",), "%"),
            ([-0.1067], "off", ("−11",), "%"),
            ([1500 * np.pi / 30], "rpm", ("1500",), "rpm"),
        ],
    )
    def test_four_figures_in_one_sensible_unit(self, values, unit, texts, label):
        assert written(np.array(values), unit) == (texts, label)

    def test_a_range_has_the_digits_that_tell_its_ends_apart(self):
        speed = Extent(1497.5 * np.pi / 30, 1502.8 * np.pi / 30, "rpm")
        assert filled(speed).replace("\xa0", " ") == "1497.5 to 1502.8 rpm"
        where = Extent(-581.6, 6256.0, "N*m", (1.0, 2.0))
        assert filled(where).replace("\xa0", " ") == "−581.6 at 57.3° to 6256 N·m at 114.6°"

    def test_values_in_words_have_one_unit(self):
        words = _("{mean}, {most}", mean=Amount(9642.0, "N*m"), most=Amount(10190.0, "N*m"))
        assert filled(words).replace("\xa0", " ") == "9.642 kN·m, 10.19 kN·m"

    def test_sentences_are_typeset(self):
        said = typeset("C-57: from -3.5 N*m at 4.25 deg, 9 m/s^2 and 1-2").replace("\xa0", " ")
        assert said == "C-57: from −3.5 N·m at 4.25°, 9 m/s² and 1-2"


class TestColumns:
    V12 = tuple(f"{i}{bank}" for bank in "LR" for i in range(1, 7))

    def test_a_bank_is_a_column(self):
        texts = {member: "1" if "L" in member else "2" for member in self.V12}
        assert member_columns([texts]) == (("L", "R"), ("1L", "1R"))

    def test_more_than_are_read_are_none(self):
        assert member_columns([{member: member for member in self.V12}]) == ((), ())
        assert member_columns([]) == ((), ())

    @pytest.mark.parametrize(
        ("some", "of", "name"),
        [
            (["1.head"], ["1.head", "1.crank"], "head"),
            (["1A.exhaust", "1B.exhaust"], ["1A.exhaust", "1B.exhaust", "1A.scavenge", "1B.scavenge"], "exhaust"),
            (["1", "3"], ["1", "2", "3"], "1, 3"),
            (["1S", "7S", "13S", "19S"], [f"{i}S" for i in range(1, 25)], "1S +3"),
        ],
    )
    def test_names(self, some, of, name):
        assert name_of(some, of) == name


class TestGroups:
    def lines(self, *rows: AnswerLine, width: int = 80) -> list[str]:
        return [line.plain for line in group_lines([("Motion", rows)], width)]

    def test_alike_members_share_a_value(self):
        assert self.lines(valued("stroke", [0.08, 0.08], "m", ("1", "2")))[1:] == ["  stroke  80.00 mm"]

    def test_two_columns_with_units_and_words_behind(self):
        together = _("{values}, {all} in all", all=Amount(0.0388, "m^3"))
        row = valued("swept volume", [0.019, 0.0198], "m^3", ("L", "R"), together)
        single = valued("bore", 0.15, "m")
        assert self.lines(row, single) == [
            "Motion              L      R",
            "  swept volume  19.00  19.80 L, 38.80 L in all",
            "  bore                 150.0 mm",
        ]

    def test_many_members_give_a_range_and_who_has_it(self):
        row = valued("speed", [1.0, 2.0, 3.0, 4.0, 5.0], "m/s", "abcde")
        assert self.lines(row)[1] == "  speed  1.000 (a) to 5.000 m/s (e)"

    def test_long_words_go_on_below_them(self):
        first, *more = self.lines(worded("order", "1A-2B-3C-4D-5E-6F, every 20°"), width=24)[1:]
        assert first == "  order  1A-2B-3C-4D-5E-"
        assert more == ["         6F, every 20°"]

    def test_what_is_not_known_is_not_said(self):
        assert not valued("x", [np.nan, np.nan], "m", "ab").says
        assert not worded("x", Amount(np.nan, "m")).says
        assert not worded("x", _("{y} at most", y=Amount(np.nan, "m"))).says
        assert valued("x", [np.nan, 1.0], "m", "ab").says


def test_like_warnings_are_one():
    assert list(joined(["a: 1; 2.", "b.", "a: 3."])) == ["a … (--full)", "b."]


WITHOUT_RODS_ON_PINS = """
[masses.pitman]
mass = "20 kg"
along = "200 mm"
inertia = "1 kg m2"
[load.tool]
on = "ram"
force = "5 kN"
[balance]
counterweights = "least_force"
[evenness]
coefficient = 0.05
[guide.ram]
length = "200 mm"
[crankshaft]
journals = [1, 2]
journal_diameter = "50 mm"
pin_diameter = "40 mm"
pin_length = "40 mm"
web_thickness = "20 mm"
web_width = "80 mm"
bearing_distance = "140 mm"
[shaft.main]
speed = "40 rpm"
"""


def test_what_no_table_can_say_is_not_asked_for(typed, written):
    """Bearings of a crankshaft need a rod on every crank pin, which is no key: "rod on every throw's crank pin]"."""
    said = typed("run", str(written(KINDS.named("chain").example + WITHOUT_RODS_ON_PINS))).output.rpartition("Next: ")[
        2
    ]
    assert said
    assert "crank pin" not in said
    assert said.count("[") == said.count("]")
