"""In a language that no one speaks, whatever people read is in it, but names, symbols and units.

Each command is asked in the usual language before, so that what keeps its words shows itself, and after.
"""

import ast
import json
import re
from pathlib import Path

import matplotlib.pyplot as plt
import pytest
from matplotlib.text import Text
from tests.pseudo_locale import (
    PSEUDO,
    is_marked,
    joints_of,
    keys,
    messages,
    names_of,
    pseudo,
    said_by,
    unmarked,
    words_in,
    words_of_typer,
)

import cranktrain as ct
from cranktrain import language, viz
from cranktrain.mechanisms import KINDS
from cranktrain.saying.comments import comments_in
from cranktrain.viz.pictures import drawing_of

__all__ = ["pseudo"]

pytestmark = pytest.mark.usefixtures("pseudo")

PACKAGE = Path(ct.__file__).parent
DRAWN = ("3d12", "10d100", "jaw_crusher", "pumping_unit_c57", "tilting_table", "shaper", "lms_class5", "vaz_21213")
HELPS = ("list", "new", "check", "run", "compare", "start", "plot", "synthesise", "textbook", "completion", "schema")
COMMANDS = (
    "list",
    "list kinds",
    "list results",
    "textbook 3d12",
    "textbook 3d12 --full",
    "textbook 3d12 --table",
    "textbook 3d12 --forces bar",
    "textbook 3d12 --harmonics",
    "textbook --source",
    *(f"textbook --source {letter} --full" for letter in "ABCDE"),
    "textbook --equation I.13",
    "textbook --throw example --full",
    "textbook --throw vaz_21213",
    "textbook --drive example --full",
    "textbook --drive tilting_table --full",
    "textbook errata --full",
    pytest.param("compare 3d12 kamaz_740", marks=pytest.mark.quick),
    "compare vaz_21213 --set shaft.main.speed=3000rpm",
    "run 3d12 --inputs --checks --missing",
    "run pumping_unit_c57 --full",
    "run deltic --full",
    "start tilting_table --full",
    "start shears --full",
    "synthesise slider-crank --stroke 160mm --pressure-angle 30deg",
    "synthesise slider-crank --textbook",
    "synthesise crank-rocker --swing 50deg --time-ratio 1.2 --rocker-length 400mm",
    "synthesise quick-return --stroke 300mm --time-ratio 1.2",
    "synthesise counterbalance pumping_unit_c57",
    "synthesise drive jaw_crusher",
)
REFUSED = (
    "rum",
    "run",
    "run nosuch",
    "run 3d12 --stpe 2",
    "run 3d12 --step fine",
    "run 3d12 --quantities point_x",
    "run 3d12 --set shaft.main.speed=fast",
    "run 3d12 --set shaft.main.speed=5kg",
    "run 3d12 --set bank.L.angles=5",
    "run 3d12 -o x.foo",
    "check wrong.toml",
    "run empty.toml",
    "compare 3d12",
    "plot 3d12",
    "plot 3d12 -o a.png --plan nosuch",
    "synthesise knuckle",
    "textbook",
    "textbook --equation nosuch",
    "list nosuch",
    "list --behind stroke",
    "new nosuch",
)
WRONG = """
name = 3
nosuch = 1
[shaft.main]
speed = "fast"
[mechanism]
kind = "slider_crank"
rod_length = "1 mm"
crank_radius = "5 kg"
[masses.piston]
mas = 3
"""


def typed(line: str) -> list[str]:
    """What a line of the terminal says in the language, once the same was asked in the usual one."""
    before = said_by(*line.split(), of=None)
    said = said_by(*line.split())
    assert said_by(*line.split(), of=None) == before
    assert not is_marked(before)
    return said.splitlines()


def nothing_plain(lines, *names):
    found = {line: words for line in lines if (words := unmarked(line, *names))}
    assert found == {}


def of_line(line: str):
    """Words that a line types, and those of the examples in it."""
    return [words_in(line), *(names_of(word) for word in line.split() if word in ct.example_names())]


@pytest.mark.parametrize("example", ct.example_names())
def test_answers(example):
    nothing_plain(typed(f"run {example}"), names_of(example), {"cranktrain", "textbook", "plot"})
    nothing_plain(typed(f"check {example}"), names_of(example), keys())


@pytest.mark.parametrize("line", COMMANDS)
def test_screens(line):
    examples = [names_of(name) for name in ct.example_names()] if line == "list" else []
    nothing_plain(typed(line), keys(), *of_line(line), *examples)


@pytest.mark.parametrize("line", ["", *HELPS, *(f"synthesise {name}" for name in ("knuckle", "drive"))])
def test_helps(line):
    nothing_plain(typed(f"{line} --help"), keys(), words_of_typer())


@pytest.mark.parametrize("line", REFUSED)
def test_what_is_refused(line, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("wrong.toml").write_text(WRONG, encoding="utf-8")
    Path("empty.toml").write_text("", encoding="utf-8")
    nothing_plain(typed(line), keys(), words_of_typer(), re.findall(r"\w+", WRONG), *of_line(line))


@pytest.mark.parametrize("example", DRAWN)
def test_pictures(example):
    result = ct.run(example)
    with language.in_language(PSEUDO):
        for picture in (one for one in viz.PICTURES if one.kind != "file"):
            of = {"angles": lambda: result.machines[0], "cycle": lambda: result, "time": lambda: ct.start(example)}
            try:
                figure = drawing_of(picture)(of[picture.over]())
            except ct.InputError:
                continue
            words = {text.get_text() for text in figure.findobj(Text) if text.get_visible()}
            nothing_plain(words, names_of(example), joints_of(result))
            plt.close(figure)


@pytest.mark.parametrize("kind", KINDS.names)
def test_comments_of_a_file_to_start_from(kind):
    said = re.sub(r"\{.*?\}", "", "\n".join(typed(f"new {kind} --full")))
    nothing_plain(comments_in(said), {"my", "schema"})


@pytest.mark.parametrize("of", ["throw", "drive"])
def test_comments_of_the_tables_of_texts(of, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    said_by("textbook", f"--{of}", "example", "-o", "a.toml")
    nothing_plain(comments_in(Path("a.toml").read_text(encoding="utf-8")))


def test_files(tmp_path, monkeypatch):
    """Names of columns and keys are the same in every language; sentences in them are the reader's."""
    monkeypatch.chdir(tmp_path)
    said_by("run", "3d12", "--step", "30", "-o", "a.json")
    said_by("run", "3d12", "--step", "30", "-o", "a.csv")
    said_by("start", "tilting_table", "-o", "b.csv")
    whole = json.loads(Path("a.json").read_text(encoding="utf-8"))
    sentences = [one["sentence"] for part in ("quantities", "facts") for one in whole[part].values()]
    nothing_plain((*sentences, *whole["flags"], *(one["sentence"] for one in whole["checks"])), names_of("3d12"))
    for name, example in (("a.csv", "3d12"), ("b.csv", "tilting_table")):
        lines = Path(name).read_text(encoding="utf-8").splitlines()
        heads = [line.partition(": ")[2] for line in lines if line.startswith("# ")]
        nothing_plain(heads, names_of(example))


def test_no_message_is_said_when_a_module_is_loaded():
    for path in PACKAGE.rglob("*.py"):
        found = list(said_when_loaded(ast.parse(path.read_text(encoding="utf-8"))))
        assert not found, f"{path}:{found}: mark it by N_() here, and say it by _() where it is shown"


def said_when_loaded(node):
    """Lines of messages that are said outside of functions: at the top, in classes, as defaults, by decorators."""
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
        decorators = getattr(node, "decorator_list", [])
        within = [*decorators, *node.args.defaults, *filter(None, node.args.kw_defaults)]
    else:
        within = ast.iter_child_nodes(node)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "_":
        yield node.lineno
    for inner in within:
        yield from said_when_loaded(inner)


def test_translators_are_given_the_messages():
    assert {"Stroke, between the true dead centres", "mean piston speed", "dead centres"} <= messages()
