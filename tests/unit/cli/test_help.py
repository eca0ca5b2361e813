import re
import shlex
import tomllib
from pathlib import Path

import pytest

import cranktrain
from cranktrain.cli import main

COMMANDS = ("list", "new", "check", "run", "compare", "plot", "synthesise", "textbook", "schema")
PROJECT = tomllib.loads((Path(__file__).parents[3] / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def examples(help_text: str) -> list[list[str]]:
    """Command lines in a help text, without what explains them or searches their output."""
    lines = re.findall(r"^ +(cranktrain .+)$", help_text, re.MULTILINE)
    return [shlex.split(re.split(r" {2,}| \| ", line)[0]) for line in lines]


@pytest.mark.parametrize("command", ["", *COMMANDS])
def test_examples_in_help_work(typed, command):
    shown = typed(*filter(None, [command, "--help"]))
    assert (shown.status, shown.errors) == (0, "")
    lines = examples(shown.output)
    assert lines
    for program, *arguments in lines:
        answer = typed(*arguments)
        assert program == "cranktrain"
        assert (answer.status, answer.errors) == (0, ""), arguments


def test_nothing_typed_shows_how_to_start(typed):
    alone = typed()
    assert alone == typed("--help") == typed("-h")
    assert [line[1] for line in examples(alone.output)] == ["list", "run", "new"]


@pytest.mark.parametrize("command", COMMANDS)
def test_h_is_help(typed, command):
    assert typed(command, "-h") == typed(command, "--help")


def test_version(typed):
    assert typed("--version") == (0, f"cranktrain {PROJECT['version']}\n", "")
    assert cranktrain.__version__ == PROJECT["version"]


def test_console_entry():
    assert PROJECT["scripts"] == {"cranktrain": f"{main.__module__}:{main.__name__}"}


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["rum"], "cranktrain  no such command 'rum'"),
        (["run"], "cranktrain run  missing argument 'FILE'"),
        (["run", "3d12", "--stpe", "2"], "cranktrain run  no such option: --stpe"),
        (["run", "3d12", "--step", "fine"], "cranktrain run  invalid value for '--step'"),
    ],
)
def test_usage_errors_in_our_style(typed, arguments, said):
    answer = typed(*arguments)
    assert (answer.status, answer.output) == (2, "")
    assert answer.errors.lower().startswith(said.lower())
    assert answer.errors.count("\n") == 1
    assert "--help`" in answer.errors
