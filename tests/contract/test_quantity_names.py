"""What is to be known of a quantity is declared with it: nobody reads it out of the spelling of its name."""

import ast
import re
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.analysis import every_stage
from cranktrain.analysis.comparison import compared
from cranktrain.analysis.designs_summary import summary_of_designs
from cranktrain.analysis.outcomes import Outcomes
from cranktrain.analysis.representations import result_html
from cranktrain.analysis.result_sections import number_sections
from cranktrain.analysis.stages import homes
from cranktrain.cli.screen.sections import page_lines
from cranktrain.motion import Array
from cranktrain.numerics import Extreme
from cranktrain.record import record
from cranktrain.saying import catalogue
from cranktrain.saying.catalogue import entries, extreme, quantity
from cranktrain.saying.checks import StageResult

PACKAGE = Path(ct.__file__).parent
EVERY = [entry for stage in every_stage() for entry in entries(stage.gives)]
WORDS = {word for entry in EVERY for word in entry.name.split("_")}
READING = {"startswith", "endswith", "removeprefix", "removesuffix", "split", "partition", "rpartition", "find"}
ASKS_IF_PRIVATE = re.compile(r"\.startswith\(\(?'_'").search
PATTERNS = {"compile", "search", "match", "fullmatch", "split", "sub", "subn", "findall"}

OTHERS = {
    "synthesis/radial.py": "strategies of a search",
    "quantities/heads.py": "heads of columns in a file of measured pressures",
    "cli/synthesis/requirements.py": "options of the terminal",
    "texts/throw_table.py": "columns of a table that a text has",
    "panels/formulas.py": "symbols, which have indices",
    "viz/plans/sketches.py": "pins of a drawing, which have indices",
}
"""Modules that read names of other things, which have words in common with quantities'."""

WRITING = ("cranktrain.saying.catalogue", "cranktrain.saying.names")
"""Who makes names of quantities, and who writes them in words."""

DO_INSTEAD = (
    "declare what the name is read for with the field, as shown=, worst=, of= or is_place= of quantity() and extreme() "
    "in saying/catalogue.py, and ask the Entry; if these are names of something else, say of what in OTHERS"
)


def readings(source):
    """Lines on which a text is compared with a part of a name of quantities, and what is read there."""
    tree = ast.parse(source)
    constants = {
        target.id: node.value
        for node in tree.body
        if isinstance(node, ast.Assign)
        for target in node.targets
        if isinstance(target, ast.Name)
    }
    for node in ast.walk(tree):
        match node:
            case ast.Call(func=ast.Attribute(value=ast.Name(id="re"), attr=method), args=[pattern, *_]) if (
                method in PATTERNS
            ):
                said = [pattern]
            case ast.Call(func=ast.Attribute(attr=method), args=args) if method in READING:
                said = args
            case ast.Compare(left=ast.Constant() as part, ops=[ast.In() | ast.NotIn()], comparators=[whole]) if (
                re.search(r"name$|^words$", ast.unparse(whole))
            ):
                said = [part]
            case _:
                continue
        meant = [constants.get(one.id, one) if isinstance(one, ast.Name) else one for one in said]
        texts = [part.value for one in meant for part in ast.walk(one) if isinstance(part, ast.Constant)]
        if any(isinstance(text, str) and is_of_names(text) for text in texts) and not ASKS_IF_PRIVATE(
            ast.unparse(node)
        ):
            yield node.lineno, ast.unparse(node)


def is_of_names(text):
    """Whether it is a part of names of quantities: words of theirs, or what stands between these."""
    words = re.findall("[a-z]+", text)
    return text == "_" or bool(re.fullmatch("[a-z_|]+", text) and words and WORDS.issuperset(words))


def test_nobody_reads_the_spelling_of_a_quantitys_name():
    found = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        where = path.relative_to(PACKAGE).as_posix()
        lines = list(readings(path.read_text(encoding="utf-8")))
        if lines and where not in {"saying/catalogue.py", *OTHERS}:
            found[where] = lines
    assert found == {}, DO_INSTEAD


@pytest.mark.parametrize(
    "read",
    [
        "entry.name.endswith(('_at', 'dead_centre'))",
        "name.startswith('largest_')",
        "stem = name.removeprefix('machine_')",
        "'speed' in entry.name",
        "words = name.split('_')\n'smallest' in words",
        "ENDS = ('angle', 'frequency')\nname.endswith(ENDS)",
        "re.compile('displacement|angle|position')",
    ],
)
def test_a_reading_is_found(read):
    assert len(list(readings(read))) >= 1


@pytest.mark.parametrize("where", OTHERS)
def test_who_reads_other_names_still_does(where):
    source = (PACKAGE / where).read_text(encoding="utf-8")
    assert list(readings(source)), f"{where} reads no names any more: strike it out of OTHERS"


class Unread(str):
    """A name that may be shown and compared as a whole; who takes it apart in the program is told not to."""

    __slots__ = ()


def _refusing(method):
    def refuse(self, *given):
        caller = sys._getframe(1).f_globals.get("__name__", "")
        is_private = (method, given) == ("startswith", ("_",))
        if caller.startswith("cranktrain.") and caller not in WRITING and not is_private:
            raise AssertionError(f"{caller} takes the name {self} apart by {method}: {DO_INSTEAD}")
        return getattr(str, method)(self, *given)

    return refuse


for _method in (*READING, "rsplit", "replace", "index", "lstrip", "rstrip", "strip", "__contains__", "__getitem__"):
    setattr(Unread, _method, _refusing(_method))


@pytest.fixture
def unread(monkeypatch):
    """Names of all quantities as those that nobody can read."""
    named = catalogue._name
    monkeypatch.setattr(catalogue, "_name", lambda held, part: Unread(named(held, part)))
    caches = (entries, homes)
    for one in caches:
        one.cache_clear()
    yield
    for one in caches:
        one.cache_clear()


def screens_of(name):
    """What is shown of a machine: numbers in the terminal, a notebook's page, two side by side, designs, a dataset."""
    machine = ct.load(name)
    result = ct.run(machine, step_degrees=10)
    yield "\n".join(
        line.plain for line in page_lines(number_sections(result, tuple(result.catalogue), is_all=True), 80)
    )
    yield result_html(result)
    yield str(compared((result, result), ("one", "other"), tuple(result.catalogue)))
    yield "\n".join(summary_of_designs(ct.run([machine, machine], step_degrees=10)))
    yield str(result.dataset)
    curves = [name for name, entry in result.catalogue.items() if not entry.is_fact]
    result.plot(*curves[:3])
    result.sheet()


@pytest.mark.parametrize("name", ["3d12", "pumping_unit_c57"])
def test_screens_are_made_of_names_that_cannot_be_read(unread, name):
    assert all(screens_of(name))


def test_a_name_that_is_read_is_refused(unread):
    (entry,) = (one for one in entries(Paces) if one.name == "pace")
    read = {"__name__": "cranktrain.analysis.made_up", "name": entry.name}
    assert isinstance(entry.name, Unread)
    with pytest.raises(AssertionError, match="takes the name pace apart by endswith"):
        exec("name.endswith('ace')", read)


@record
class Paces(StageResult):
    """A result that has a speed, a frequency, a place and an end, none of which is called so."""

    pace: Array = quantity(
        "n_p", "rad/s", ("piston",), "Pace", "docs/conventions", "definition", shown="rpm", worst="smallest"
    )
    beat: Array = quantity("f_b", "rad/s", (), "Beat", "docs/conventions", "definition", shown="Hz")
    doors: Array = quantity(
        "φ_d", "deg", (), "Crank angle at which doors open", "docs/conventions", "definition", is_place=True
    )
    width: Array = quantity("γ_w", "deg", (), "How long they are open", "docs/conventions", "definition")
    hum: Array = quantity("h", "N", ("crank_angle",), "Hum", "docs/conventions", "definition")
    din: Extreme = extreme("h_d", "N", (), "Din", "Crank angle of the din", "docs/conventions", "definition", of="hum")


def made_up(factor=1.0):
    """A result with that, of a machine whose six pistons have paces of 60, 120, … 360 rpm times a factor."""
    bank = {"A": {"mechanism": {"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "140 mm"}}}
    shaft = {"main": {"throws": [f"{60 * i} deg" for i in range(6)]}}
    result = ct.run(ct.Machine(bank=bank, shaft=shaft), step_degrees=90)
    paces = Paces(
        factor * 2 * np.pi * np.arange(1.0, 7.0)[np.newaxis],
        factor * 2 * np.pi * np.array([3.0]),
        factor * np.radians([30.0]),
        factor * np.radians([60.0]),
        np.array([[1.0, -2.0, 3.0, -5.0]]),
        Extreme(angle=np.radians([272.0]), value=np.array([-7.0])),
    )
    return replace(result, computed=Outcomes({Paces: paces}, dict(result.labels)))


def test_a_made_up_result_is_shown_as_it_declares():
    """Paces in rpm, the smallest of them, by none of their names; of places no percent; the curve by its end."""
    asked = ("pace", "beat", "doors", "width")
    lines = str(compared((made_up(), made_up(2.0)), ("one", "other"), asked)).splitlines()
    shown = {line.split()[0]: line.split()[1:] for line in lines if line.split()[0] in asked}
    assert shown == {
        "pace": ["60.00", "120.0", "rpm", "+60.0", "+100.0", "%"],
        "beat": ["3.000", "6.000", "Hz", "+3.00", "+100.0", "%"],
        "doors": ["30.00", "60.00", "°", "+30.0", "—"],
        "width": ["60.00", "120.0", "°", "+60.0", "+100.0", "%"],
    }


def test_a_curve_is_told_by_the_end_that_is_declared_for_it():
    lines = (line.plain.split() for line in page_lines(number_sections(made_up(), ("hum",), is_all=False), 80))
    (line,) = (one for one in lines if one[:1] == ["hum"])
    assert line == ["hum", "h", "−7.000", "N", "272.0"]  # not −5, which is the largest of its four points


def test_the_worst_of_designs_is_the_end_that_is_declared():
    one = made_up()
    paces = one[Paces].pace
    both = replace(one[Paces], pace=np.concatenate([paces, 2 * paces]))
    several = replace(
        one,
        computed=Outcomes({Paces: both}, dict(one.labels)),
        has_designs=True,
        machines=one.machines * 2,
        asked=("pace",),
    )
    assert list(summary_of_designs(several))[1:] == ["pace: 60.00 rpm (design 1) to 120.0 rpm (design 2)"]


@pytest.mark.parametrize("entry", [entry for entry in EVERY if entry.of], ids=lambda entry: entry.name)
def test_an_end_is_of_a_curve_that_there_is(entry):
    (curve,) = (one for one in EVERY if one.name == entry.of)
    assert curve.dimensions == (*entry.dimensions, "crank_angle"), "an end stands for the same members as its curve"
    assert curve.unit == entry.unit
    assert entry.at in {one.name for one in EVERY}


def test_a_worst_end_is_of_several():
    """Of a quantity that has one value there is nothing to choose from."""
    assert [entry.name for entry in EVERY if entry.worst is not None and not entry.dimensions] == []
