"""Numbers in the prose of docs are tested as outputs are: each stands in a block of its page, or a command gives it.

Blocks run as tests, so that what stands in one is so. A page that says a number anew either shows it, or has a line
here with the command that does; or with the reason why nothing computes it.
"""

import re
import shlex
from itertools import takewhile
from pathlib import Path

import pytest

from cranktrain.cli import main
from cranktrain.quantities import Dimension, unit_names
from cranktrain.questions.crankshaft.spec import STEEL

ROOT = Path(__file__).parents[2]
PAGES = [
    path.relative_to(ROOT).as_posix()
    for pattern in (
        *("README.md", "docs/first-steps.md", "docs/tasks/*.md", "docs/lessons/*.md", "docs/mechanisms/*.md"),
        *("src/cranktrain/mechanisms/*/README.md", "src/cranktrain/questions/*/README.md"),
        "src/cranktrain/fluids/*/README.md",
    )
    for path in sorted(ROOT.glob(pattern))
]

BLOCK = re.compile(r"^```.*?^```\s*$", re.DOTALL | re.MULTILINE)
UNITS = sorted({"°", *(name for dimension in Dimension for name in unit_names(dimension))}, key=len, reverse=True)
SAID = re.compile(
    rf"(?<![\w.,/(–])(?P<number>\d+(?:\.\d+)?)[ \u00a0]?(?P<unit>{'|'.join(map(re.escape, UNITS))})(?![\w·/²³°])"
)
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d*)?(?:e[+-]?\d+)?")

IN_SI = {
    "mm": 1e-3,
    "cm": 1e-2,
    "kN": 1e3,
    "bar": 1e5,
    "kPa": 1e3,
    "MPa": 1e6,
    "kW": 1e3,
    "kJ": 1e3,
    "%": 1e-2,
    "L": 1e-3,
    "ms": 1e-3,
    "min": 60.0,
}
"""A block of Python shows SI: what one of a unit is there."""

BY_COMMAND = {
    ("docs/tasks/start.md", "30 kW"): "run jaw_crusher --inputs",
    ("src/cranktrain/mechanisms/articulated_rod/README.md", "186.7 mm"): "run 3d12",
}
"""Numbers that a command of the program says."""

TURNS = {"90°", "180°", "360°", "720°", "90 deg", "180 deg"}
"""A quarter of a turn and its multiples: how directions and cycles are said."""

NOT_COMPUTED = {
    "docs/tasks/counterweights.md": {"100 %": "all of it"},
    "docs/lessons/crank-rocker.md": {"40°": "a rule of the trade", "900 mm": "to try", "600 mm": "to try"},
    "docs/lessons/engine.md": {"25°": "drawn in the next block", "6000 rpm": "to try", "120 mm": "to try"},
    "docs/lessons/steam.md": {"5 %": "said by the command before it"},
    "src/cranktrain/mechanisms/articulated_rod/README.md": {"0 mm": "a default"},
    "src/cranktrain/mechanisms/slider_crank/README.md": {"6.9 m/s": "the book's", "124.91 m/s²": "the book's"},
    "src/cranktrain/mechanisms/slotted_lever/README.md": {"0 mm": "a default"},
    "src/cranktrain/questions/balance/README.md": {
        "1 rad/s": "the speed for which it is solved",
        "1 %": "a limit of the flag",
    },
    "src/cranktrain/questions/crankshaft/README.md": {
        "20°": "a default",
        **dict.fromkeys(("500 GPa", "1 %", "1 GPa"), "a limit of the flag"),
        **{one.text: "a default, of steel" for one in STEEL if " " in one.text},
    },
    "src/cranktrain/questions/gas/README.md": {"1 %": "a limit of the flag", "250 K": "a limit of the flag"},
    "src/cranktrain/questions/loads/README.md": {"2 %": "a limit"},
    "src/cranktrain/questions/pumping/README.md": {"1 %": "a limit of the flag"},
    "src/cranktrain/questions/wear/README.md": {"60°": "the rule"},
    "src/cranktrain/fluids/compressor/README.md": {
        "1.01325 bar": "one atmosphere",
        "20 °C": "a default",
        "1.9 %": "of the tests' case",
    },
    "src/cranktrain/fluids/dual/README.md": {"101.325 kPa": "the standard atmosphere", "50 kPa": "a limit of the flag"},
    "src/cranktrain/fluids/indicator/README.md": {
        "1 %": "a limit",
        "3 %": "a limit",
        "5 %": "of coarse tables, by the page of the theory",
        "101.325 kPa": "the standard atmosphere",
        "15°": "a limit",
        "60°": "a limit",
        "25°": "a limit",
    },
    "src/cranktrain/questions/rod_load/README.md": {"15°": "API 618", "3 %": "API 618"},
    "src/cranktrain/fluids/wiebe/README.md": {"99.9 %": "1 − 1/1000", "99.3 %": "1 − e⁻⁵"},
}
"""Numbers that nothing here has to show, and why: what is to be tried, chosen, or another's."""


def text_of(page):
    return (ROOT / page).read_text(encoding="utf-8")


def numbers_of(text):
    """Numbers with units in the prose of a page: as they are written, with the number and the unit."""
    return {found[0]: (found["number"], found["unit"]) for found in SAID.finditer(BLOCK.sub("", text))}


def stands(number, unit, shown):
    """Whether a number, to the digits that it has, is among those of some blocks, in its unit or in SI."""
    last = 0.5 * 10.0 ** -len(number.partition(".")[2])
    each = [float(found.replace("−", "-")) for found in NUMBER.findall(shown.replace("_", ""))]
    scales = (1.0, IN_SI.get(unit, 1.0))
    return any(abs(abs(one) / scale - float(number)) <= last * 1.001 for one in each for scale in scales)


EXAMPLES = ROOT / "src" / "cranktrain" / "examples"
SET = re.compile(r"--set (?:\"[^\"]*\"|\S+)")


def head_of(example: str) -> str:
    """The comment with which an example begins, in one line."""
    lines = (EXAMPLES / f"{example}.toml").read_text(encoding="utf-8").splitlines()
    return " ".join(line.lstrip("# ") for line in takewhile(lambda line: line.startswith("#"), lines))


@pytest.mark.parametrize(
    "example", [path.stem for path in sorted(EXAMPLES.glob("*.toml")) if "cranktrain start" in head_of(path.stem)]
)
def test_how_long_starts_take_in_heads_of_examples(example, capsys):
    """Seconds of a head are when the start, or it with one of the settings there, has 98 % of its speed, or ends."""
    head = head_of(example)
    lacking = re.findall(r"(?<![\w.])\d+(?:\.\d+)?(?= s\b)", SET.sub("", head))
    for setting in ("", *SET.findall(head)):
        if not lacking:
            break
        main(shlex.split(f"start {example} {setting}"))
        times = re.findall(r"([\d.]+) s +98 %|ends after +([\d.]+) s", capsys.readouterr().out)
        there = [" ".join(time) for time in times[-1:]]
        lacking = [one for one in lacking if not any(stands(one, "s", time) for time in there)]
    assert not lacking, f"{example}: no start there takes so many seconds"


@pytest.mark.parametrize("page", PAGES)
def test_numbers_of_prose(page, capsys):
    text = text_of(page)
    blocks = "\n".join(BLOCK.findall(text))
    excused = TURNS | NOT_COMPUTED.get(page, {}).keys()
    lacking = []
    for said, (number, unit) in numbers_of(text).items():
        if command := BY_COMMAND.get((page, said)):
            main(shlex.split(command))
            assert said in " ".join(capsys.readouterr().out.split()), said
        elif said not in excused and not stands(number, unit, blocks):
            lacking.append(said)
    assert not lacking, f"{page}: show it in a block, or give its command in {Path(__file__).name}"


def test_nothing_is_excused_that_no_page_says():
    for page, excused in NOT_COMPUTED.items():
        assert excused.keys() <= numbers_of(text_of(page)).keys(), page
    for page, said in BY_COMMAND:
        assert said in numbers_of(text_of(page)), page


def test_a_wrong_number_is_found():
    """As the crusher's 55 kW was, which has a motor of 30 kW."""
    page = "A motor of 55 kW at 1500 rpm.\n\n```console\n$ cranktrain run\nmotor 30 kW, 1500 rpm, 1.136e6\n```\n"
    found = numbers_of(page)
    blocks = "\n".join(BLOCK.findall(page))
    assert set(found) == {"55 kW", "1500 rpm"}
    assert not stands(*found["55 kW"], blocks)
    assert stands(*found["1500 rpm"], blocks)
    assert stands("11.36", "bar", blocks)
    assert not stands("11.37", "bar", blocks)
