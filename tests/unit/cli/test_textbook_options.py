"""Each option of `textbook` beside each thing that may be asked of it: it changes the answer, or it is refused."""

from pathlib import Path

import pytest
import typer
from typer.main import get_command

from cranktrain.cli.texts import add_textbook

ROADS = {
    "engine": ("3d12",),
    "crank-rocker": ("tilting_table",),
    "errata": ("errata",),
    "texts": ("--source",),
    "text": ("--source", "D"),
    "formula": ("--equation", "337"),
    "forces": ("3d12", "--forces", "kN"),
    "harmonics": ("3d12", "--harmonics"),
    "series": ("--crank-to-rod-ratio", "0.25"),
    "throw": ("--throw", "example"),
    "throw of a machine": ("--throw", "kamaz_740"),
    "drive": ("--drive", "example"),
    "drive of a machine": ("--drive", "tilting_table"),
}
VALUES = {
    "--set": ("shaft.main.speed=601 rpm",),
    "--source": ("steam-engine",),
    "--equation": ("335",),
    "--table": (),
    "--full": (),
    "--errata": (),
    "--forces": ("kgf",),
    "--step": ("10",),
    "--piston": ("2L",),
    "--harmonics": (),
    "--crank-to-rod-ratio": ("0.2",),
    "--throw": ("vaz_21213",),
    "--throw-number": ("3",),
    "--crank-masses": ("sizes",),
    "--drive": ("tilting_table",),
    "--at": ("31",),
    "--output": ("out.svg",),
    "--force": (),
}
"""Of every option a value that is none of those taken unless given."""
SAME = {
    ("crank-rocker", "--set"): "its angles and ratios have no speed",
    ("drive of a machine", "--set"): "nor have its torques, which are static",
    ("errata", "--errata"): "the very same",
    ("series", "--harmonics"): "the very same",
    ("formula", "--source"): "no other text has one of that number",
}


def options():
    """Every option of the command by its long name, as the terminal has them."""
    app = typer.Typer(add_completion=False)
    add_textbook(app)
    command = get_command(app)
    return {max(one.opts, key=len) for one in command.params if one.opts[0].startswith("-")} - {"--help"}


def test_every_option_is_among_these():
    assert options() == set(VALUES)


@pytest.mark.parametrize("option", VALUES)
@pytest.mark.parametrize("road", ROADS)
def test_an_option_is_never_without_effect(typed, plain, road, option):
    if option in ROADS[road] or (road, option) in SAME:
        return
    answer = typed("textbook", *ROADS[road], option, *VALUES[option])
    assert answer.status in {0, 2}
    if answer.status == 0:
        assert answer.output != plain(road) or Path("out.svg").is_file()
    else:
        assert answer.errors


@pytest.fixture
def plain(typed):
    """The answer without the option."""
    known = {}

    def answered(road):
        if road not in known:
            known[road] = typed("textbook", *ROADS[road]).output
        return known[road]

    return answered
