"""What `textbook` shows is sections, and one function prints them: the command reads, refuses, asks, prints."""

import ast
from pathlib import Path

import pytest
from rich.cells import cell_len
from tests.example_runs import ran
from tests.pseudo_locale import PSEUDO, pseudo

import cranktrain
from cranktrain.cli.screen.sections import page_lines
from cranktrain.language import in_language
from cranktrain.textbook.shown.of_machine import TextOfMachine, texts_for
from cranktrain.texts.contents import TEXTS

__all__ = ["pseudo"]

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


@pytest.mark.parametrize("width", [80, 100, 120])
@pytest.mark.parametrize("name", cranktrain.example_names())
def test_no_line_is_wider_than_the_screen(name, width):
    """Of all that there is of a machine."""
    result = ran(name)
    with result.in_its_units():
        assert [line.plain for line in page_lines(result.sections(), width) if cell_len(line.plain) > width] == []


@pytest.mark.usefixtures("pseudo")
def test_sections_are_said_when_they_are_read():
    """One object, in two languages and in other units; of a result, a comparison, a start."""
    engine = ran("3d12")
    runs = (engine, cranktrain.compare(engine, ran("vaz_21213")), cranktrain.start("shears"))
    for run in runs:
        sections = list(run.sections())
        usual = [line.plain for line in page_lines(sections, 80)]
        with in_language(PSEUDO):
            said = [line.plain for line in page_lines(sections, 80)]
            assert said == [line.plain for line in page_lines(run.sections(), 80)] != usual
        assert [line.plain for line in page_lines(sections, 80)] == usual
        with cranktrain.units("in", "psi", "lbf", "lbf*ft"):
            assert [line.plain for line in page_lines(sections, 80)] != usual


def test_what_a_page_says_is_what_its_run_shows():
    comparison = cranktrain.compare("3d12", "kamaz_740", quantities="displacement")
    assert comparison.page().splitlines()[-1].split() == ["displacement", "38.88", "10.86", "L", "−28.0", "−72.1", "%"]
    assert "Largest values of the curves, in steps of 1°" in cranktrain.run("textbook_78x78").page()


def test_commands_show_runs_by_their_sections():
    """`run`, `compare`, `start` and `--why` lay nothing out but the answer, which is the terminal's own."""
    for name in ("compare", "start", "why", "curves"):
        imported = set(imports_of(PACKAGE / f"cli/{name}.py"))
        laid = {one for one in imported if one.startswith("cranktrain.cli.screen")} - PRINTERS
        assert laid <= {"cranktrain.cli.screen.text"}, name
