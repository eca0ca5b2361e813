"""`synthesise` as typed; the dimensions themselves are tested in tests/unit/study and tests/validation."""

import inspect
import re
import shlex
import tomllib

import numpy as np
import pytest
from tests.sentences import (
    A_LENGTH,
    A_NUMBER,
    A_SMALL_LENGTH,
    AN_ANGLE,
    BEYOND_ANY_SIZE,
    ENDS_IN,
    NOT_POSITIVE,
    WHOLE_NUMBER,
)

from cranktrain.cli.synthesis import requirements

SLIDER_CRANK = ("slider-crank", "--stroke", "160 mm", "--pressure-angle", "30 deg")
KNUCKLE = ("knuckle", "--crank-radius", "90 mm", "--master-rod-length", "320 mm", "--bank-angle", "60 deg")
RADIAL = (
    *("radial", "--crank-radius", "80 mm", "--rod-length", "310 mm", "--knuckle-radius", "75 mm"),
    *("--slave-rod-length", "235 mm", "--compression-ratio", "6.5", "--bore", "150 mm"),
)
PROBLEMS = {
    "slider-crank": (*SLIDER_CRANK, "--mean-speed", "6.3 m/s"),
    "offset free": (*SLIDER_CRANK[:3], "--pressure-angle", "20 deg", "--return-pressure-angle", "40 deg", "--offset",
                    "free", "--working-stroke", "Away"),
    "crank-rocker": ("crank-rocker", "--swing", "50 deg", "--time-ratio", "1.2", "--rocker-length", "0.4 m",
                     "--slow-swing", "backward", "--speed", "60 rpm"),
    "equal swings": ("crank-rocker", "--swing", "60 deg", "--time-ratio", "1", "--rocker-length", "400 mm",
                     "--transmission-angle", "50 deg"),
    "quick-return": ("quick-return", "--stroke", "300 mm", "--time-ratio", "1.2", "--slow-stroke", "away"),
    "knuckle": (*KNUCKLE, "--stroke", "186.7 mm", "--knuckle-radius", "85 mm", "--rod-length", "235 mm"),
    "knuckle of height": (*KNUCKLE, "--same-height", "--unshifted", "top", "--rod-length", "240 mm"),
    "knuckle of ratio": (*KNUCKLE, "--same-ratio", "14.5", "--knuckle-radius", "85 mm", "--articulation-angle",
                         "67 deg", "--bore", "150 mm"),
    "radial": (*RADIAL, "--cylinders", "9", "--strategy", "unshifted-equal-ratio", "--speed", "2000 rpm"),
    "counterweights": ("counterweights", "vaz_21213", "--bearing", "3", "--weights", "mirrored", "--throws", "1,4",
                       "--radius", "45 mm", "--largest-mass", "900 g"),
    "counterweights on webs": ("counterweights", "vaz_21213", "--aim", "mean", "--weights", "webs", "--angle", "free",
                               "--method", "split", "--largest-share", "1.5", "--afresh"),
}  # fmt: skip


def value_of(output: str, symbol: str) -> float:
    (line,) = (line for line in output.splitlines() if re.search(rf"\s{re.escape(symbol)}\s+-?[\d.]+", line))
    return float(re.search(rf"\s{re.escape(symbol)}\s+(-?[\d.]+)", line)[1])


@pytest.mark.parametrize("name", PROBLEMS)
def test_what_is_written_runs(typed, tmp_path, name):
    arguments = PROBLEMS[name]
    shown = typed("synthesise", *arguments)
    assert (shown.status, shown.errors) == (0, "")
    assert all(len(line) <= 80 for line in shown.output.splitlines())
    for heading in ("Proposed", "Also considered", "Mind"):
        assert f"\n{heading}\n" in shown.output
    assert shown.output.endswith("-o FILE.toml writes it as a machine file, for: cranktrain run FILE.toml\n")
    assert list(tmp_path.iterdir()) == []
    answer = typed("synthesise", *arguments, "-o", "made.toml")
    assert answer.output.endswith("\nwritten: made.toml; go on with: cranktrain run made.toml\n")
    result = typed("run", "made.toml", "--step", "10")
    assert (result.status, result.errors) == (0, "")
    assert "✗" not in result.output
    alone = typed("synthesise", *arguments, "-o", "-").output
    assert alone == (tmp_path / "made.toml").read_text(encoding="utf-8")
    assert tomllib.loads(alone)["name"] in " ".join(result.output.split())


def test_numbers(typed):
    """r = S/2, l = r/sin 30° = S, ω = π v/S, side force tan 30°, and the source's rule r/tan 30°."""
    output = typed("synthesise", *PROBLEMS["slider-crank"]).output
    assert (value_of(output, "R"), value_of(output, "L")) == (80.00, 160.00)
    assert value_of(output, "n") == round(np.pi * 6.3 / 0.16 * 30 / np.pi, 1)
    assert value_of(output, "N/P") == round(np.tan(np.pi / 6), 3)
    rule = next(line for line in output.splitlines() if "the source's rule" in line)
    assert rule.split()[0] == f"{80 / np.tan(np.pi / 6):.2f}"
    assert "R crank radius" not in output  # the same in both, so it is no trade


def test_numbers_of_a_radial_stand_in_columns(typed):
    """tests/golden/radial9: strokes of the plain strategy."""
    output = typed("synthesise", *RADIAL, "--cylinders", "9", "--strategy", "plain").output
    rows = {line.split()[0]: line.split() for line in output.splitlines() if re.match(r"  [2-9]  ", line)}
    assert list(rows) == [str(i) for i in range(2, 10)]
    columns = re.search(r"Proposed\n(?P<heads>.+)\n", output)["heads"].split()
    first = next(line.split() for line in output.splitlines() if line.startswith("  4  "))
    assert first[1 + columns.index("S")] == "161.06"


def test_many_alternatives_are_numbered(typed):
    output = typed("synthesise", *PROBLEMS["knuckle"]).output
    assert re.search(r"^ +0  as proposed$", output, re.MULTILINE)
    assert re.search(r"^ +2  the same requirements with r = 76.50 mm$", output, re.MULTILINE)


def test_the_source_and_its_errors(typed):
    """Printed and right, as docs/theory/synthesis has them."""
    output = typed("synthesise", "slider-crank", "--textbook").output
    assert all(len(line) <= 80 for line in output.splitlines())
    assert value_of(output, "L") == 160.00
    assert value_of(output, "n") == 1181.2
    assert "[slider-crank-synthesis]" in output
    assert len(output.splitlines()) <= 45
    assert re.search(r"3\.  Tangent of 30° +0\.3 +0\.5774\n", output)
    (whole,) = re.findall(r"`cranktrain (textbook errata --source C --full)`", output)
    output = typed(*whole.split()).output
    assert re.search(r"printed +0,08/tg 30° = 0,08/0,3\n +gives +0\.3\n +right +0\.5774\n", output)
    assert re.search(r"^ +60° +9\.990 +10\.007 +10\.036$", output, re.MULTILINE)
    own = typed("synthesise", *SLIDER_CRANK[:2], "200 mm", *SLIDER_CRANK[3:], "--textbook").output
    assert value_of(own, "L") == 200.00
    assert "[slider-crank-synthesis]" in own


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (
            ["slider-crank", "--stroke", "1,6 m", "--pressure-angle", "30 mm", "--offset", "fre", "--working-stroke",
             "towards"],
            [
                f'--stroke = 1,6 m: {A_LENGTH}; write "1.6 m"',
                f"--pressure-angle = 30 mm: mm measures a length; {AN_ANGLE}",
                '--working-stroke = towards: must be one of: toward, away; write "toward"',
                f"--offset = fre: {A_SMALL_LENGTH}",
            ],
        ),
        (
            ["quick-return"],
            [
                f"--stroke: is missing; {A_LENGTH}",
                f"--time-ratio: is missing; {A_NUMBER}, such as 1.2",
            ],
        ),
        (
            ["quick-return", "--stroke", "0.3 m", "--time-ratio", "3.2", "--speed", "-1 rpm"],
            [f"--speed = -1 rpm: {NOT_POSITIVE} rpm"],
        ),
        (
            ["quick-return", "--stroke", "-1 mm", "--time-ratio", "1"],
            [
                f"--stroke = -1 mm: {NOT_POSITIVE}",
                "--time-ratio = 1: must lie between 1 and 3 for an offset slider-crank",
            ],
        ),
        (
            ["slider-crank", "--stroke", "0.16 m"],
            ["--pressure-angle: is missing; without a --rod-length it decides how long the rod must be"],
        ),
        (
            ["slider-crank", "--stroke", "160 mm", "--pressure-angle", "10 deg", "--rod-length", "160 mm"],
            [
                "--pressure-angle = 10 deg: must be at least 30.00 deg with a rod of 160.00 mm and an offset of "
                "0.00 mm; give a longer rod, or leave --rod-length out"
            ],
        ),
        (
            [*KNUCKLE, "--stroke", "186.7 mm"],
            [
                "cranktrain synthesise knuckle  each requirement decides one dimension; requirements: 1, "
                "free dimensions: 3; "
                "give more of --articulation-angle, --knuckle-radius, --rod-length"
            ],
        ),
        (
            [*RADIAL, "--cylinders", "2.5", "--strategy", "equal"],
            [
                f"--cylinders = 2.5: {WHOLE_NUMBER} up to 99",
                "--strategy = equal: must be one of: plain, unshifted, equal_ratio, equal_stroke, "
                'unshifted_equal_ratio; write "equal_ratio"',
            ],
        ),
        (
            [*RADIAL, "--cylinders", "2", "--strategy", "plain"],
            ["--cylinders = 2: must be at least 3"],
        ),
        (
            ["slider-crank", "--stroke", "1e300 m", "--pressure-angle", "30 deg"],
            [f"--stroke = 1e300 m: {BEYOND_ANY_SIZE}"],
        ),
        (
            ["slidercrank"],
            ["cranktrain synthesise  no such command 'slidercrank'*; see `cranktrain synthesise --help`"],
        ),
        (
            ["quick-return", "--strok", "1 m"],
            ["cranktrain synthesise quick-return  no such option: --strok*; see "
             "`cranktrain synthesise quick-return --help`"],
        ),
    ],
)  # fmt: skip
def test_refused_with_everything_that_is_wrong(typed, tmp_path, arguments, said):
    answer = typed("synthesise", *arguments, *(["-o", "a.toml"] if len(arguments) > 1 else []))
    assert (answer.status, answer.output) == (2, "")
    for line, expected in zip(answer.errors.splitlines(), said, strict=True):
        start, _star, end = expected.partition("*")  # versions of Typer differ in what they add
        assert line.lower().startswith(start.lower()) and line.endswith(end)
    assert list(tmp_path.iterdir()) == []


def test_a_file_is_kept_unless_forced(typed, written):
    path = written("old\n")
    assert typed("synthesise", *SLIDER_CRANK, "-o", path.name).errors.startswith("machine.toml  is there already")
    assert path.read_text(encoding="utf-8") == "old\n"
    assert typed("synthesise", *SLIDER_CRANK, "-o", path.name, "--force").status == 0
    assert "slider_crank" in path.read_text(encoding="utf-8")


def test_every_parameter_of_every_synthesis_can_be_typed(typed):
    for problem, synthesis in requirements.SYNTHESES.items():
        options = set(re.findall(r"--[a-z-]+", typed("synthesise", problem, "--help").output))
        named = set(inspect.signature(synthesis).parameters) - {"machine", "progress"}  # the FILE, and what is shown
        assert {requirements.option_of(name) for name in named} <= options


@pytest.mark.parametrize("problem", ["", *requirements.SYNTHESES])
def test_examples_in_help_work(typed, problem):
    shown = typed("synthesise", *filter(None, [problem, "--help"]))
    assert (shown.status, shown.errors) == (0, "")
    assert shown == typed("synthesise", *filter(None, [problem, "-h"]))
    text = re.sub(r"\\\n +", "", shown.output)
    lines = re.findall(r"^ +(cranktrain .+)$", text, re.MULTILINE)
    assert lines
    for line in lines:
        answer = typed(*shlex.split(line)[1:])
        assert (answer.status, answer.errors) == (0, ""), line


def test_alone_it_shows_its_problems(typed):
    alone = typed("synthesise")
    assert alone == typed("synthesise", "--help")
    for problem in requirements.SYNTHESES:
        assert f"\n  {problem} " in alone.output


def test_a_picture_is_the_plan_of_positions(typed, tmp_path):
    """The text's own rod of 0.27 m at its pressure angle of 30°, twelve positions at its scale of 4 mm/mm."""
    wanted = ("--stroke", "160 mm", "--pressure-angle", "30 deg", "--rod-length", "270 mm", "--mean-speed", "6.3 m/s")
    answer = typed("synthesise", "slider-crank", *wanted, "-o", "own.svg")
    assert (answer.status, answer.errors) == (0, "")
    assert answer.output.endswith("\nwritten: own.svg\n")
    drawn = (tmp_path / "own.svg").read_text(encoding="utf-8")
    assert "scale 1:4" in drawn
    assert "301.0" in drawn  # x at 60°: 40 + √(270² − 4800) mm
    assert typed("synthesise", "slider-crank", *wanted, "-o", "own.svg").status == 2
    refused = typed("synthesise", "counterweights", "vaz_21213", "--bearing", "3", "-o", "own.png")
    assert f"{ENDS_IN}.csv, .json, .xlsx, .nc, .toml" in refused.errors


def test_steps_of_the_source_with_requirements_that_are_typed(typed):
    """r = 60 mm, l = r/tan 15.5°, T = 0.24/10.4 s; at 90° v = rω = π/2 · 10.4 m/s. Not of an offset line of stroke."""
    wanted = ("--stroke", "120 mm", "--pressure-angle", "15.5 deg", "--mean-speed", "10.4 m/s", "--textbook")
    done = typed("synthesise", "slider-crank", *wanted)
    assert (done.status, done.errors) == (0, "")
    steps = done.output[done.output.index("Its steps with these requirements") :]
    assert re.search(r"rod by the rule +l +216\.35 +224\.52  mm", steps)
    assert re.search(r"period of a turn +Tц +0\.0231 ", steps)
    assert re.search(r"^  90° .* 16\.3363 +16\.3363$", steps, re.MULTILINE)
    assert all(len(line) <= 80 for line in steps.splitlines())
    offset = typed("synthesise", "slider-crank", *wanted, "--offset", "1 mm").output
    assert re.search(r"central slider-crank with one pressure angle both ways, and nothing\s+of --offset", offset)
    assert "rod by the rule" not in offset
    without = typed("synthesise", "slider-crank", *wanted[:4], "--textbook").output
    assert re.search(r"a stroke, a mean speed and a pressure angle; --mean-speed: not\s+given", without)


@pytest.mark.parametrize("more", [("--friction", "0.1"), ("--speed", "1000 rpm"), ("--rod-length", "270 mm")])
def test_the_sources_example_with_what_it_does_not_say(typed, more):
    done = typed("synthesise", "slider-crank", "--textbook", *more)
    assert (done.status, done.errors) == (0, "")
    assert value_of(done.output, "S") == 160.00


def test_velocities_by_the_formula_are_no_printed_ones(typed):
    """The text's own requirements typed: rω(sin φ + (r/2l) sin 2φ), rω = 10.048 m/s, r/2l = 0.15; it prints 6.3."""
    output = typed("synthesise", *PROBLEMS["slider-crank"], "--textbook").output
    steps = output[output.index("Place and velocity of the slider") :]
    row = next(line.split() for line in steps.splitlines() if line.startswith("  30°"))
    by_formula = 10.048 * (0.5 + 0.15 * np.sqrt(3) / 2)
    assert row[3] == f"{by_formula:.4f}"
