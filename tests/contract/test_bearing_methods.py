"""A method for bearing loads says what it is: nobody else knows it by name, and a new one is a file and a line."""

import ast
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from cranktrain.questions.crankshaft import methods
from cranktrain.questions.crankshaft.methods import BEARING_METHODS
from cranktrain.questions.crankshaft.methods.bearing_method import BearingMethod
from cranktrain.spec import Spec

PACKAGE = Path(__file__).parents[2] / "src/cranktrain"
METHODS = PACKAGE / "questions/crankshaft/methods"
ROOM = "cranktrain.questions.crankshaft.methods"
MADE_UP = '''
"""A shaft whose bearings carry half as much again as if it were split."""

from cranktrain.questions.crankshaft.bending.bearing_loads import BearingLoads
from cranktrain.questions.crankshaft.methods.bearing_method import BearingMethod, TakenBearings
from cranktrain.questions.crankshaft.methods.split import split


def heavier(supports, loads):
    """Loads times 1.5."""
    return BearingLoads(*(1.5 * part for part in split(supports, loads)))


GUESSED = TakenBearings("on guessed bearings", "[crankshaft]", lambda declared: bool(declared.each))
HEAVIER = BearingMethod(
    "heavier", "split, and half more", heavier, "docs/theory/crankshaft", "a hinge, and haste", GUESSED, rank=2
)
'''
ASKED = """
import json
import sys

import cranktrain as ct
from cranktrain import viz
from cranktrain.cli.synthesis.requirements import requirements_of
from cranktrain.declared_types import words_of
from cranktrain.synthesis.counterweights import counterweights
from cranktrain.panels.sheets.crankshaft.panels import method_place
from cranktrain.viz.paper.polar import line_of_method

result = ct.run("vaz_21213")
names = result.labels["bearing_method"]
load = result.largest_bearing_load
sheet = viz.sheet_crankshaft(result)
method = next(one for one in requirements_of("counterweights") if one.name == "method")
drawn = [[str(line.get_color()), line.get_linewidth(), line.get_linestyle(), line._dash_pattern]
         for axes in sheet.axes for line in axes.lines]
json.dump(
    {
        "package": ct.__file__,
        "names": names,
        "loads": {name: load[place].tolist() for place, name in enumerate(names)},
        "summary": result.summary(),
        "written": [text.get_text() for axes in sheet.axes for text in axes.texts],
        "lines": [str(sorted(line_of_method(place).items())) for place in (0, *map(method_place, names[1:]))],
        "drawn": sorted({str(line) for line in drawn}),
        "words": words_of(method.annotation),
        "relieved": str(counterweights(ct.load("vaz_21213"), method="heavier").remarks[0]),
    },
    sys.stdout,
)
"""


@pytest.fixture(scope="module")
def with_made_up(tmp_path_factory):
    """What is said where the package has one file more, and in the line of the methods one name."""
    folder = tmp_path_factory.mktemp("package")
    shutil.copytree(PACKAGE, folder / "cranktrain", ignore=shutil.ignore_patterns("__pycache__"))
    room = folder / METHODS.relative_to(PACKAGE.parent)
    (room / "heavier.py").write_text(MADE_UP.lstrip(), "utf-8")
    line = (room / "__init__.py").read_text("utf-8")
    with_line = line.replace("(ELASTIC_FRAME, RIGID_FRAME,", "(ELASTIC_FRAME, RIGID_FRAME, HEAVIER,").replace(
        "import SPLIT\n", f"import SPLIT\nfrom {ROOM}.heavier import HEAVIER\n"
    )
    assert with_line.count("HEAVIER") == 2, "the line of the methods is written otherwise than this test knows"
    (room / "__init__.py").write_text(with_line, "utf-8")
    said = json.loads(told(folder, "-c", ASKED))
    assert Path(said["package"]).is_relative_to(folder)
    return said | {"screen": told(folder, "-m", "cranktrain", "run", "vaz_21213")}


def told(folder, *arguments):
    """What a program says that finds the package in a folder."""
    environment = {**os.environ, "PYTHONPATH": str(folder), "MPLBACKEND": "agg"}
    done = subprocess.run(
        [sys.executable, *arguments], env=environment, capture_output=True, encoding="utf-8", check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_it_is_computed(with_made_up):
    """In its place by rank: with that of another method behind it in the line of the methods."""
    assert with_made_up["names"] == [
        "frame_elastic",
        "frame_rigid",
        "heavier",
        "five_moment",
        "three_moment",
        "split",
    ]
    split, heavier = (np.array(with_made_up["loads"][name]) for name in ("split", "heavier"))
    np.testing.assert_allclose(heavier, 1.5 * split, rtol=1e-9)


def test_it_is_titled(with_made_up):
    largest = max(with_made_up["loads"]["heavier"]) / 1000
    assert re.search(rf"on guessed bearings +{largest:.2f} kN in bearing \d", with_made_up["screen"])
    assert f"on guessed bearings: {largest:.2f} kN in bearing" in with_made_up["summary"]
    assert "split, and half more" in with_made_up["written"]


def test_it_has_a_pen_of_its_own(with_made_up):
    lines = with_made_up["lines"]
    assert len(set(lines)) == len(lines) == 6
    assert len(with_made_up["drawn"]) >= len(lines)


def test_it_can_be_named(with_made_up):
    assert with_made_up["words"] == [*with_made_up["names"], "clearance"]
    assert with_made_up["relieved"].startswith("By split, and half more: ")


def test_methods_stand_in_the_order_of_trust():
    ranks = [method.rank for method in BEARING_METHODS]
    assert ranks == sorted(ranks), "the most trusted method comes first: `rank` of each"
    assert len({method.name for method in BEARING_METHODS}) == len(BEARING_METHODS), "each method has a name of its own"


@pytest.mark.parametrize("method", BEARING_METHODS, ids=lambda method: method.name)
def test_what_it_says_of_itself(method):
    """What it is, where its equations stand, and in the line that it shares what is said in it."""
    assert method.title
    assert method.range
    assert (PACKAGE.parents[1] / f"{method.source}.md").is_file(), "`source` names a page of the theory"
    assert {"{bearing}", "{range}"} <= set(re.findall(r"\{\w+\}", method.trust)), "`trust` says where and how much"
    if method.beside is not None:
        said = set(re.findall(r"\{\w+\}", method.beside))
        assert said == {"{load}", "{other}", "{bearing}"}, "`beside` says both loads, and where"


def keys_of(spec):
    yield from (field.alias or name for name, field in spec.model_fields.items())
    for below in spec.__subclasses__():
        yield from keys_of(below)


NAMES = {method.name for method in BEARING_METHODS} - set(keys_of(Spec))
"""But for those that are keys of the machine file, too."""
OBJECTS = {name for name, value in vars(methods).items() if isinstance(value, BearingMethod)}


def known_by_name(text):
    """Names of methods in a module, and methods that it imports by name; words for people, `_("split")`, are none."""
    tree = ast.parse(text)
    words = {
        id(argument)
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in {"_", "N_"}
        for argument in node.args
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and node.value in NAMES and id(node) not in words:
            yield f'line {node.lineno}: "{node.value}"'
        elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith(ROOM):
            by_name = [alias.name for alias in node.names if alias.name in OBJECTS]
            if by_name:
                yield f"line {node.lineno}: from {node.module} import {', '.join(by_name)}"


def test_nobody_else_asks_for_its_name():
    found = {
        path.relative_to(PACKAGE).as_posix(): names
        for path in PACKAGE.rglob("*.py")
        if METHODS not in path.parents and (names := list(known_by_name(path.read_text("utf-8"))))
    }
    assert found == {}, "what is to be known of a method stands with it, as a field of `BearingMethod`; ask for that"


def test_a_name_elsewhere_would_be_found():
    assert len(NAMES) >= 5
    assert list(known_by_name('PENS = {"frame_rigid": 1, _("split"): 2}')) == ['line 1: "frame_rigid"']
    assert list(known_by_name(f"from {ROOM}.split import SPLIT"))
    assert list(known_by_name(f"from {ROOM} import SPLIT"))
    assert not list(known_by_name(f"from {ROOM} import BEARING_METHODS, methods_for"))
