"""What `textbook` shows is sections, and one function prints them: the command reads, refuses, asks, prints."""

import ast
from pathlib import Path

import pytest

import cranktrain
from cranktrain.textbook.shown.of_machine import TextOfMachine, texts_for
from cranktrain.texts.contents import TEXTS

PACKAGE = Path(cranktrain.__file__).parent
COMMANDS = sorted((PACKAGE / "cli/textbook").glob("*.py"))
MAKERS = sorted((PACKAGE / "textbook").rglob("*.py"))
PRINTERS = {"cranktrain.cli.screen.sections", "cranktrain.cli.screen.title"}
"""All of the screen that the commands may ask: to show a page, and what a machine is called."""


def imports_of(path):
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom):
            yield node.module or ""
        elif isinstance(node, ast.Import):
            yield from (name.name for name in node.names)


@pytest.mark.parametrize("path", COMMANDS, ids=lambda path: path.name)
def test_commands_lay_nothing_out(path):
    imported = set(imports_of(path))
    assert {name for name in imported if name.startswith("cranktrain.cli.screen")} <= PRINTERS
    assert not any(name.startswith("rich") for name in imported)
    assert "saying.section_texts" not in path.read_text(encoding="utf-8")


@pytest.mark.parametrize("path", MAKERS, ids=lambda path: path.relative_to(PACKAGE).as_posix())
def test_who_makes_sections_knows_no_screen(path):
    assert not any(name.startswith(("rich", "cranktrain.cli", "textwrap")) for name in imports_of(path))


def test_a_text_says_itself_what_it_has_for_a_machine():
    machine = cranktrain.load("3d12")
    found = texts_for(machine)
    assert [text.name for text in found] == ["steam-engine", "bolotin"]
    assert all(isinstance(has, TextOfMachine) for has in found.values())
    homes = {path.stem for path in (PACKAGE / "textbook/shown").glob("*.py")}
    assert {text.of_machine for text in TEXTS if text.of_machine} <= homes
