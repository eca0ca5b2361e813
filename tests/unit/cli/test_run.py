import dataclasses
import re

import numpy as np
import pytest
from tests.sentences import (
    A_LENGTH,
    ALREADY_THERE,
    ENDS_IN,
    FOLDER_NOT_THERE,
    KEEP_ONE,
    NO_PATH,
    NOT_A_KEY,
    OF_INERTIA_ALONE,
    RUNNING_SPEED_NEEDS,
    SET_TWICE,
    STEADY_RUNNING,
    STEP_FROM_TO,
)

import cranktrain as ct
from cranktrain.analysis.outcomes import Outcomes
from cranktrain.cli.screen.answer import answer_lines
from cranktrain.cli.screen.sections import show_page
from cranktrain.io.machine_file import read_machine
from cranktrain.record import record
from cranktrain.saying.checks import Check, Checked, Flagged

CENTRAL = """
name = "small"
[shaft.main]
speed = { value = "1500 rpm", status = "assumed", note = "as usual" }
[mechanism]
kind = "slider_crank"
stroke = { value = "80 mm", status = "published" }
rod_length = "136 mm"
"""
SHORT_ROD = CENTRAL.replace("136 mm", "30 mm")


def rows(output: str) -> dict[str, list[str]]:
    """Lines of the page's tables by their first word."""
    return {words[0]: words[1:] for line in output.splitlines() if line.startswith("  ") and (words := line.split())}


def sections(output: str) -> dict[str, str]:
    heads = re.split(r"\n\n(?=\S)", output)
    return {part.partition("\n")[0]: part.partition("\n")[2] for part in heads}


def test_all_of_it_answers_first_then_the_numbers(typed):
    output = typed("run", "3d12", "--full").output
    lines = output.splitlines()
    assert lines[0].startswith("3D12 marine diesel")
    assert "12 pistons, 6 throws, banks L, R; 1500 rpm; clockwise, ahead" in " ".join(lines[:2])
    # strokes of the fit, to which the example's rods were fitted: 180 and 186.7 mm
    assert re.match(r"\nMotion +L +R\n  stroke +180\.0 +186\.7 mm$", "\n".join(lines[2:5]))
    table = rows(output)
    assert table["stroke"] == ["S", "mm", "180.0", "186.7"]
    assert re.search("1L–6L +1R–6R", output)
    assert list(sections(output)) == [
        output.split("\n\n")[0].partition("\n")[0],
        lines[3],
        "Results",
        "Largest values of the curves, in steps of 1°",
        "By each method, with --quantities",
        "Checks",
        "Mind",
        "What this rests on",
        "To learn more",
    ]


def test_facts_of_a_radial_have_a_row_for_each_cylinder(typed):
    output = typed("run", "r-1340", "--full").output
    results = sections(output)["Results"]
    for name in ("1M", *(f"{i}S" for i in range(1, 9))):
        assert sum(line.split()[0] == name for line in results.splitlines() if line) >= 3
    assert "S stroke, φ_T top_dead_centre" in results


def test_numbers_of_orders_and_journals_are_no_pistons(typed):
    """Piston 2, order 2 and journal 2 have tables of their own, of which two say what they are of."""
    results = sections(typed("run", "vaz_21213", "--full").output)["Results"]
    assert re.search(r"^ +1, 4 +2, 3$", results, re.MULTILINE)
    assert re.search(r"^  order +T_k +ψ_k +S_k$", results, re.MULTILINE)
    assert re.search(r"^  journal +T_J,max +φ\(T_J,max\)$", results, re.MULTILINE)
    assert not re.search(r"^  [0-9.]+$", results, re.MULTILINE)
    assert not re.search(r"e-1[2-9]", results)


def test_numbers_are_aligned(typed):
    results = sections(typed("run", "3d12", "--full").output)["Results"]
    first = results.partition("\n\n")[0].splitlines()
    assert len({len(line) for line in first}) == 1


def test_only_what_is_asked(typed):
    output = typed("run", "3d12", "--quantities", "stroke,piston_displacement, displacement_error").output
    table = rows(output)
    assert "stroke" in table and "piston_displacement" in table
    assert "top_shift" not in table and "piston_velocity" not in table
    assert "two_harmonics 1L–6L" in output
    assert "firing order" not in output


@pytest.mark.parametrize(
    ("names", "said"),
    [
        ("strok", "quantities = strok: is not a quantity of the catalogue"),
        ("stroke,rocker_angle", "quantities = rocker_angle: is no result of this machine"),
        ("piston_velocity", "quantities = piston_velocity: needs [shaft.main] speed in the file"),
    ],
)
def test_quantities_that_there_are_not(typed, written, names, said):
    written(CENTRAL.replace("speed", "# speed"))
    answer = typed("run", "machine.toml", "--quantities", names)
    assert (answer.status, answer.output) == (2, "")
    assert answer.errors.startswith(said)


def test_peaks_say_whose_and_where(typed, written):
    """x has its largest value, the stroke, at 180°; j of a central slider-crank at its top: R ω² (1 + λ)."""
    written(CENTRAL)
    table = rows(typed("run", "machine.toml", "--full").output)
    assert table["piston_displacement"] == ["x", "80.00", "mm", "180"]
    acceleration = 0.04 * (1500 * np.pi / 30) ** 2 * (1 + 40 / 136)
    assert table["piston_acceleration"] == ["j", f"{acceleration:.0f}", "m/s²", "0.0"]


def test_provenance(typed, written):
    written(CENTRAL)
    rests = sections(typed("run", "machine.toml", "--full").output)["What this rests on"]
    assert rests.startswith("  3 numbers of the file: 1 published, 1 assumed, 1 without a status\n")
    assert "shaft.main.speed  1500 rpm  assumed  as usual" in rests
    assert "stroke" not in rests
    every = sections(typed("run", "machine.toml", "--inputs").output)["What this rests on"]
    assert every.splitlines()[1].split() == ["mechanism.stroke", "80", "mm", "published"]


def test_what_is_missing_and_what_it_would_give(typed, written):
    written(CENTRAL.replace("speed", "# speed"))
    more = " ".join(sections(typed("run", "machine.toml", "--missing").output)["To learn more"].split())
    assert "[shaft.main] speed: gives piston_velocity, piston_acceleration" in more
    assert "[cylinder] bore: gives swept_volume, bank_swept_volume, displacement" in more
    assert "rocker" not in more


def test_check_tells_what_can_be_computed(typed, written):
    written(CENTRAL.replace("speed", "# speed"))
    lines = typed("check", "machine.toml").output.splitlines()
    assert lines[0] == "machine.toml: nothing wrong"
    assert re.match(r"can compute \d+ results: .*dead centres", lines[1])
    assert any(line.endswith(": [cylinder] bore") for line in lines[2:])


def test_failed_check_is_shown(typed, capsys):
    @record
    class Doubtful(Checked, Flagged):
        pass

    doubtful = Doubtful(
        checks=(
            Check("a", "something against something else", np.array([0.5]), 1e-9),
            Check("b", "something at every angle", np.array([np.nan]), 1e-9),
        ),
        flags=("outside its range",),
    )
    file = read_machine("vaz-21213")
    result = ct.run(file.machine, step_degrees=10)
    found = {type(one): one for one in (*result.outcomes, doubtful)}
    result = dataclasses.replace(result, computed=Outcomes(found, dict(result.labels)))
    show_page("", result.sections())
    output = " ".join(capsys.readouterr().out.split())
    assert "✗ does not hold (residual 5.0e-01, limit 1e-09): something against something else" in output
    assert "– needs a full turn: something at every angle" in output
    assert "Mind" in output and "outside its range" in output
    answer = [line.plain for line in answer_lines(file, result, "vaz-21213", 80)]
    assert "! A check does not hold: something against something else" in answer
    assert "! outside its range" in answer
    assert any(line.startswith("✗ 1 of 13 checks do not hold, 1 not judged · ") for line in answer)


def test_step(typed, written):
    written(CENTRAL)
    assert "in steps of 0.5°" in typed("run", "machine.toml", "--full", "--step", "0.5").output
    assert typed("run", "machine.toml", "--step", "0.7").errors.startswith(f"step = 0.7 deg: {STEP_FROM_TO}")
    assert "nan must be a number of degrees" in typed("run", "machine.toml", "--step", "nan").errors


def test_set_for_one_run(typed):
    output = typed(
        "run", "3D12", "--set", "shaft.main.speed=3000 rpm", "--set", "cylinder.bore = 160 mm", "--full"
    ).output
    assert "3000 rpm" in " ".join(output.partition("\n\n")[0].split())
    assert re.search(r"(?m)^  mean piston speed +18\.00 ", output)
    assert rows(output)["swept_volume"][2] == f"{np.pi / 4 * 1.6**2 * 1.8:.3f}"


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ("cylinder.bore", "--set  cylinder.bore: must be PATH=VALUE"),
        (
            "cylinder.bore=150",
            f'--set  cylinder.bore = 150: {A_LENGTH}; write "150 mm"',
        ),
        ("cylinder.bor=150 mm", f"--set  cylinder.bor = 150 mm: {NOT_A_KEY}"),
        ("bank.R.mechanism.rod_length=45 mm", "--set  bank.R.mechanism.rod_length = 45 mm: the links cannot close"),
        ("a..b=3", f"--set  a..b: {NO_PATH}"),
        ("bank=3", "--set  bank: bank is a table"),
    ],
)
def test_problems_of_a_setting_say_so(typed, setting, said):
    answer = typed("run", "3d12", "--set", setting)
    assert (answer.status, answer.output) == (2, "")
    assert answer.errors.startswith(said)


def test_a_setting_above_the_banks_is_led_to_the_bank(typed):
    errors = typed("run", "vaz_21213", "--set", "mechanism.offset=2 mm").errors
    assert errors.rstrip().endswith("the file alone may be right; did you mean bank.line.mechanism.offset?")


def test_a_setting_is_made_once(typed):
    twice = typed("run", "3d12", "--set", "shaft.main.speed=1 rpm", "--set", "shaft.main.speed=2 rpm")
    assert (twice.status, twice.output) == (2, "")
    assert twice.errors == f"--set  shaft.main.speed = 2 rpm: {SET_TWICE}; {KEEP_ONE}\n"


def test_a_setting_may_spoil_another_value(typed):
    answer = typed("run", "3d12", "--set", "cylinder.cycle=two-stroke")
    first, last = answer.errors.splitlines()
    assert re.match(r"example 3d12:\d+:\d+  cylinder.firing_order = .*: cannot fire so", first)
    assert last == "--set  cylinder.cycle=two-stroke: was set for this run; the file alone may be right"


def test_links_that_cannot_close(typed, written):
    written(SHORT_ROD)
    answer = typed("run", "machine.toml")
    assert answer.status == 2
    # the pin is farther from the line of stroke than the rod is long where sin φ > 30/40
    limit = np.degrees(np.arcsin(30 / 40))
    assert f"cannot close at crank angles {limit:.2f} deg to {180 - limit:.2f} deg" in answer.errors
    assert answer.errors.startswith("machine.toml:8:14  mechanism.rod_length = 30 mm")


def test_partial_turn(typed, written):
    written(SHORT_ROD)
    answer = typed("run", "machine.toml", "--partial", "--full", "-o", "out.csv")
    assert (answer.status, answer.errors) == (0, "")
    assert rows(answer.output)["stroke"] == ["S", "mm", "–"]
    assert "– needs a full turn: " in answer.output


@pytest.mark.parametrize("name", ["out", "out.txt", "out.xls", "out.csv.gz"])
def test_unknown_suffix_is_refused_before_anything_else(typed, name):
    answer = typed("run", "no-such-file.toml", "-o", name)
    assert answer == (2, "", f"-o = {name}: {ENDS_IN}.csv, .json, .xlsx, .nc\n")


@pytest.mark.parametrize("name", ["out.csv", "OUT.JSON"])
def test_output_is_kept_unless_forced(typed, tmp_path, name):
    path = tmp_path / name
    path.write_text("old\n", encoding="utf-8")
    # a step that would be refused is never looked at
    answer = typed("run", "3d12", "-o", name, "--step", "-1")
    assert answer == (2, "", f"{name}  {ALREADY_THERE}, or replace it with --force\n")
    assert path.read_text(encoding="utf-8") == "old\n"
    answer = typed("run", "3d12", "-o", name, "--force", "--step", "10")
    assert (answer.status, answer.errors) == (0, "")
    assert answer.output.endswith(f"written: {name}\n")
    assert path.stat().st_size > 10_000


def test_unwritable_output(typed, tmp_path):
    assert typed("run", "3d12", "-o", "no/such/folder.csv").errors.startswith(f"no/such/folder.csv  {FOLDER_NOT_THERE}")
    (tmp_path / "folder.csv").mkdir()
    assert typed("run", "3d12", "-o", "folder.csv").errors.startswith("folder.csv  is a folder")
    assert list((tmp_path / "folder.csv").iterdir()) == []


def test_a_table_holds_no_facts(typed, tmp_path):
    answer = typed("run", "3d12", "-o", "out.csv", "--quantities", "stroke,piston_displacement")
    assert (
        answer.errors == "quantities = stroke: has one value for the whole cycle, and a .csv holds curves; "
        "write a .json or .xlsx, or with --facts a .csv of facts alone\n"
    )
    assert list(tmp_path.iterdir()) == []


def test_names_cannot_upset_the_terminal(typed, written):
    written(CENTRAL.replace('"small"', r'"a\u001b[31mred\nline [bold]"'))
    output = typed("run", "machine.toml").output
    assert output.startswith(r"a\x1b[31mred line [bold]" + "\nslider-crank")


def test_bug_is_reported_in_a_sentence(typed, monkeypatch):
    monkeypatch.setattr("cranktrain.cli.asked.read_machine", lambda *_arguments, **_settings: 1 / 0)
    answer = typed("run", "some file.toml")
    assert (answer.status, answer.output) == (70, "")
    assert answer.errors.startswith("This is a bug of cranktrain. Please report it")
    assert "cranktrain run 'some file.toml'" in answer.errors
    assert "Traceback" not in answer.errors
    monkeypatch.setenv("CRANKTRAIN_TRACEBACK", "1")
    assert "ZeroDivisionError" in typed("run", "some file.toml").errors


def test_a_notch_from_the_terminal(typed):
    """Another notch for one run: 164.77 and 88.95 mm, in inches as its file is."""
    for notch, travel in (("1", "6.487"), ("0", "3.502")):
        answer = typed("run", "lms_class5", "--set", f"bank.valve.mechanism.notch={notch}", "--quantities", "stroke")
        assert answer.status == 0, answer.errors
        assert travel in answer.output


def test_at_the_running_speed(typed, tmp_path):
    """The answer and the file's head say so; what is missing for it is told."""
    said = f"All of this is {STEADY_RUNNING}, 1497.5 rpm to 1502.8 rpm over the cycle, 1500.0 rpm over time."
    for full in ((), ("--full",)):
        assert said in " ".join(typed("run", "3d12", "--running-speed", *full).output.split())
    output = typed("run", "3d12", "--running-speed", "-o", str(tmp_path / "a.csv"), "--quantities", "piston_velocity")
    assert output.status == 0
    assert f"# crank_speed: {said}" in (tmp_path / "a.csv").read_text(encoding="utf-8")
    (tmp_path / "small.toml").write_text(CENTRAL, encoding="utf-8")
    refused = typed("run", str(tmp_path / "small.toml"), "--running-speed")
    assert refused.status != 0
    said = f"{RUNNING_SPEED_NEEDS}\n"
    assert refused.errors == said


UNUSED = """
[cylinder]
bore = "80 mm"
cycle = "four-stroke"
[masses.piston]
mass = "1 kg"
[gas]
kind = "dual"
start_pressure = "0.9 bar"
compression_exponent = 1.35
expansion_exponent = 1.3
pressure_ratio = 1.8
cut_off_ratio = 1.3
"""


def test_a_table_that_is_not_used_stands_before_all_numbers(typed, written):
    written(CENTRAL + UNUSED)
    said = [
        "! [gas] is not used: [cylinder] compression_ratio or clearance is missing;",
        f"  {OF_INERTIA_ALONE}",
    ]
    lines = typed("run", "machine.toml").output.splitlines()
    assert lines[0] == "small"
    assert lines[1:5] == ["slider-crank, central or offset · four-stroke · 1500 rpm, clockwise", "", *said]
    assert typed("run", "machine.toml", "--full").output.splitlines()[1:4] == [*said, ""]
    assert typed("run", "machine.toml", "--quantities", "stroke").output.splitlines()[:2] == said
    minded = [*said, "! Without mass: 1.rod."]
    assert typed("run", "machine.toml", "-o", "out.csv").output.splitlines() == [*minded, "written: out.csv"]
    lines = typed("check", "machine.toml").output.splitlines()
    assert lines[:2] == ["machine.toml: nothing wrong", " ".join([said[0], said[1].strip()])]
    assert "is not used" not in typed("run", "machine.toml", "--set", "cylinder.compression_ratio=9").output


def test_a_quantity_alone(typed, written):
    written(CENTRAL)
    assert typed("run", "machine.toml", "--quantities", "stroke").output == "Results\n  stroke  S  mm  80.00\n"


def test_what_is_written_is_said_and_little_else(typed, written):
    written(CENTRAL)
    assert typed("run", "machine.toml", "-o", "out.json").output == "written: out.json\n"


def test_parts_are_shown_by_their_options(typed):
    """Each alone, and together in the order of all of it."""
    heads = {"--checks": "Checks", "--inputs": "What this rests on", "--missing": "To learn more"}
    for option, head in heads.items():
        first, *others = sections(typed("run", "vaz_21213", option).output)
        assert first.startswith("VAZ-21213")
        assert others == [head]
    assert list(sections(typed("run", "vaz_21213", *heads).output))[1:] == [*heads.values()]
