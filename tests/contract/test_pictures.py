"""What holds for every picture: its question has it, its name is its own, it is drawn; panels need no paper."""

import ast
import re
import subprocess
import sys
from functools import cache
from pathlib import Path
from pkgutil import iter_modules, walk_packages
from typing import get_args, get_type_hints

import pytest
from tests.loaded_machines import LOADED

import cranktrain as ct
from cranktrain import panels, viz
from cranktrain.all_questions import QUESTIONS
from cranktrain.analysis import every_stage
from cranktrain.io.examples import example_names
from cranktrain.panels import sheets
from cranktrain.saying.catalogue import entries
from cranktrain.viz.pictures import drawing_of

PACKAGE = Path(viz.__file__).parents[1]
FOLDERS = sorted(module.name for module in iter_modules(sheets.__path__))
ABOVE = ("panels", "viz", "cli", "__init__.py", "faces.py")
"""Folders whose modules may speak of pictures."""

DATA = [module.name for module in walk_packages(panels.__path__, f"{panels.__name__}.")]


@cache
def result_of(name):
    return ct.run(LOADED[name] if name in LOADED else ct.load(name))


def shown(picture):
    """Result of the first example that has what a picture needs; of an engine with cylinders, if that will do."""
    return next(
        found
        for name in dict.fromkeys(["vaz_21213", *example_names(), *LOADED])
        if set(picture.needs) <= set((found := result_of(name)).catalogue)
    )


def test_folders_are_named_after_questions():
    assert set(FOLDERS) <= {question.name for question in QUESTIONS}, (
        "a folder of panels/sheets has the name of the question whose pictures it has"
    )


def test_names_are_their_own():
    names = [(picture.kind, picture.name) for picture in viz.PICTURES]
    assert len(set(names)) == len(names), "give the picture a name that no other of its kind has"
    functions = [picture.home.partition(":")[2] for picture in viz.PICTURES]
    assert len(set(functions)) == len(functions), "a function draws one picture"
    assert set(functions) <= set(dir(viz)), "Picture.home names a function that is there: module:function"


SHEETS = {picture.name for picture in viz.PICTURES if picture.kind == "sheet"}


def test_a_result_names_its_sheets():
    """For the type checker, for `help`, and for who asks for another."""
    declared = get_args(get_type_hints(ct.Result.sheet)["name"])
    assert set(declared) == SHEETS, "name the sheet in `Sheet` of analysis/result.py, which the type checker reads"
    assert len(declared) == len(SHEETS)
    said = re.findall(r"`(\w+)`", ct.Result.sheet.__doc__)
    assert set(said) == SHEETS, "name the sheet in the docstring of `Result.sheet`, which help() shows"
    with pytest.raises(ct.InputError) as refused:
        result_of("vaz_21213").sheet("machines")
    assert set(re.findall(r"\w+", str(refused.value))) >= SHEETS


def test_what_is_needed_and_what_suffices_are_results():
    known = {entry.name for stage in every_stage() for entry in entries(stage.gives)}
    for picture in viz.PICTURES:
        assert set(picture.needs) <= known, f"{picture.name}: it needs quantities of the catalogue, which these are not"
        assert set(picture.quantities or ()) <= known, (
            f"{picture.name}: quantities are of the catalogue, which these are not"
        )


@pytest.mark.parametrize("picture", viz.PICTURES, ids=lambda picture: f"{picture.kind} {picture.name}")
def test_every_picture_is_drawn(tmp_path, picture):
    result = shown(picture)
    (engine,) = result.machines
    draw = getattr(viz, picture.home.partition(":")[2])
    options = {} if "size" in picture.refused else {"size": "A3"}
    if picture.name == ".dxf":
        draw(engine, [30.0], tmp_path / "a.dxf")
        assert (tmp_path / "a.dxf").stat().st_size > 0
    elif picture.name == ".gif":
        assert draw(result, n_frames=2).startswith(b"GIF")
    elif picture.over == "time":
        assert draw(ct.start("tilting_table"), **options).axes
    elif picture.over == "angles":
        speed = {} if "speed" in picture.refused else {"speed": "constant"}
        assert draw(engine, [30.0], **options, **speed).axes
    else:
        angle = {} if "at" in picture.refused else {"at": 30.0}
        assert draw(result, **options, **angle).axes


def test_a_picture_says_what_the_machine_lacks():
    pump = ct.run(ct.Machine(mechanism={"kind": "slider_crank", "stroke": "80 mm", "rod_length": "136 mm"}))
    for picture in viz.PICTURES:
        if picture.over == "cycle" and picture.needs:
            with pytest.raises(ct.InputError, match=r"needs .*\["):
                drawing_of(picture)(pump)


def test_panels_need_nothing_that_draws():
    code = f"import sys\nfrom importlib import import_module\nfor name in {DATA!r}: import_module(name)\n"
    code += "print([name for name in sys.modules if name == 'matplotlib' or name.startswith('cranktrain.viz')])"
    environment = {"PYTHONPATH": ":".join(filter(None, sys.path))}
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n", "panels are data, which a face draws"


RUNS = {"Result", "Comparison", "Start", "Proposal", "Statements", "run", "compared", "start"}
"""What computes, and what it gives: panels are made of these."""


def test_what_draws_reads_no_result():
    """A picture is drawn from its data alone, so that a page and a report show the same."""
    for path in (PACKAGE / "viz").rglob("*.py"):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        taken = {one.name for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) for one in node.names}
        assert not taken & RUNS, f"{path} takes {sorted(taken & RUNS)}: what it draws of these is data of panels/"


def test_nothing_below_names_pictures():
    """No string of a module below says where its pictures are: faces look for questions, and not the other way."""
    for path in PACKAGE.rglob("*.py"):
        if path.relative_to(PACKAGE).parts[0] in ABOVE:
            continue
        tree = ast.parse(path.read_text(encoding="utf-8"))
        constants = [node.value for node in ast.walk(tree) if isinstance(node, ast.Constant)]
        assert not any("viz" in word for word in constants if isinstance(word, str)), (
            f"{path}: a face finds it by name, in faces.py"
        )
