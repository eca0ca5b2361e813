"""What is said is data until it is read: in whose language and in which units is known only then."""

import ast
import copy
import pickle
import re
import traceback
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from tests.pseudo_locale import PSEUDO, is_marked, pseudo

import cranktrain as ct
from cranktrain import language
from cranktrain.language import Listed, Said
from cranktrain.saying.amounts import measured_in
from cranktrain.saying.row_words import row_words
from cranktrain.saying.rows import AnswerLine
from cranktrain.saying.wording import number

__all__ = ["pseudo"]

PACKAGE = Path(ct.__file__).parent
FACES = ("cli/", "viz/", "io/", "public.py")
RENDERERS = {
    "analysis/designs_summary.py": "writes the summary of many designs",
    "analysis/pipeline.py": "writes what stands behind a quantity",
    "analysis/representations.py": "writes what a notebook shows",
    "saying/amounts.py": "writes amounts when they are read",
    "saying/catalogue.py": "gives what a quantity is to whoever shows it",
    "saying/comments.py": "writes the comments of a file that is given to people",
    "saying/names.py": "gives names in words to whoever shows them",
    "saying/row_words.py": "writes rows when they are read",
}
"""Modules below the faces that write text when somebody asks for it, and what."""
LANGUAGES = ("a", "b", "c", "d")
UNITS = ("psi", "kPa", "MPa", "bar")
RUNS = 1000
FEW = ("peak_pressure", "largest_piston_speed", "stroke")
"""Quantities of a run in a thread, so that a thousand are quick."""


def test_only_those_who_show_say_at_once():
    """All others give messages."""
    eager = [
        path.relative_to(PACKAGE).as_posix()
        for path in PACKAGE.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.ImportFrom) and node.module == "cranktrain.language"
        if any(name.name == "said" for name in node.names)
    ]
    assert {path for path in eager if not path.startswith(FACES)} == set(RENDERERS)


@pytest.fixture
def speechless(monkeypatch):
    """Let nobody say anything."""

    def refuse(_of):
        ours = [frame for frame in traceback.extract_stack() if str(PACKAGE) in frame.filename]
        spoke = next(frame for frame in reversed(ours) if not frame.filename.endswith("language.py"))
        raise AssertionError(f"{spoke.filename}:{spoke.lineno} says something: {spoke.line}")

    def let_go():
        monkeypatch.setattr(language, "_catalogue", catalogue)

    catalogue = language._catalogue
    return SimpleNamespace(begin=lambda: monkeypatch.setattr(language, "_catalogue", refuse), end=let_go)


def test_who_says_something_is_caught(speechless):
    speechless.begin()
    with pytest.raises(AssertionError, match="says something"):
        ct.run("textbook_78x78").rows().__next__()[0].__str__()


@pytest.mark.parametrize("name", ct.example_names())
def test_nothing_is_said_while_a_machine_is_computed(speechless, name):
    """Nor when its checks, flags and what is missing are asked for: each is said by who reads it."""
    machine = ct.load(name)
    speechless.begin()
    result = ct.run(machine)
    for kind in result.computed.kinds:
        assert result.computed[kind] is not None
    found = (result.checks, result.flag_words, result.unused, result.missing, result.worth_asking)
    speechless.end()
    assert all(str(flag) for flag in found[1])
    assert all(str(check.sentence) and str(check.verdict()) for check in found[0])


def test_a_start_says_nothing_while_it_runs(speechless):
    machine = ct.load("tilting_table")
    speechless.begin()
    start = ct.start(machine)
    speechless.end()
    assert str(start.run.reason)


@pytest.mark.usefixtures("pseudo")
@pytest.mark.parametrize(
    "declared",
    [
        {"bank": {"1": {"mechanism": {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "40 mm"}}}},
        {"bank": {"1": {"mechanism": {"kind": "slider_crunk"}}}, "shaft": {"main": {"speed": "5 kg"}}},
    ],
)
def test_an_error_is_said_in_the_language_of_who_reads_it(declared):
    with language.in_language(PSEUDO), pytest.raises(ct.InputError) as caught:
        ct.Machine(**declared)
    assert not is_marked(str(caught.value))
    with language.in_language(PSEUDO):
        assert is_marked(str(caught.value))
        assert all(is_marked(str(problem.allowed)) for problem in caught.value.problems)


@pytest.mark.usefixtures("pseudo")
def test_a_result_is_read_in_two_languages():
    """One run serves two readers: flags, checks, rows, whatever one of them has read before."""
    result = ct.run("3d12")

    def read():
        rows = [str(row.name) for _title, rows in result.rows() for row in rows]
        return [*map(str, result.flags), *(str(check.sentence) for check in result.checks), *rows]

    usual = read()
    with language.in_language(PSEUDO):
        other = read()
    assert read() == usual
    assert not any(map(is_marked, usual))
    assert all(map(is_marked, other))


@pytest.mark.usefixtures("pseudo")
def test_members_are_called_as_who_reads_calls_them():
    """Rows and amounts that are made hold the titles of members, and not their words in one language."""
    result = ct.run("shears")
    rows = [row for _title, rows in result.rows() for row in rows]
    amounts = [one for row in rows for one in measured_in(row.words)]
    named = {member for one in amounts for member in getattr(one, "member", ())}
    titles = [member for member in named if isinstance(member, Said)]
    assert {"motor", "effective torque", "smallest that passes"} <= set(map(str, titles))
    with language.in_language(PSEUDO):
        assert all(is_marked(str(title)) for title in titles)
    shaft = AnswerLine("torque", np.array([1.0, 2.0]), "N*m", result.titles["drive_shaft"][:2])
    usual = row_words(shaft)
    with language.in_language(PSEUDO):
        assert row_words(shaft) != usual


def test_units_are_those_of_who_reads():
    """The same words, with their length in millimetres and in inches."""
    words = language._("short by {length}", length=number(0.0254, "mm"))
    assert str(words) == "short by 25.40 mm"
    with ct.units("in"):
        assert str(words) == "short by 1.000 in"


def test_words_are_values():
    """They are compared and sent as what they are, not as what somebody would read."""
    words = Listed((language._("{n} of {length}", n=3, length=number(0.5, "mm")), "x"), "; ")
    assert pickle.loads(pickle.dumps(words)) == words == copy.deepcopy(words)
    assert hash(words) == hash(copy.deepcopy(words))
    assert words != Listed((language._("{n} of {length}", n=4, length=number(0.5, "mm")), "x"), "; ")
    assert str(words) == "3 of 500.00 mm; x"
    assert repr(words) == "'3 of 500.00 mm; x'"
    assert words != str(words)
    assert number(0.1 + 0.2, "deg") == number(0.3, "deg") != number(0.31, "deg")  # rounding tells no words apart


def test_threads_read_in_their_own_languages_and_units(monkeypatch):
    """A pool serves many readers at once, each of its own result and of one that all read: no word of another."""
    marks = {name: SimpleNamespace(gettext=lambda message, name=name: f"‹{name}›{message}") for name in LANGUAGES}
    monkeypatch.setattr(language, "_catalogue", lambda of: marks.get(of, SimpleNamespace(gettext=str)))
    machine = ct.load("burning_cylinder")
    shared = ct.run(machine)

    def read(number_of_run):
        of, unit = LANGUAGES[number_of_run % 4], UNITS[number_of_run // 4 % 4]
        with language.in_language(of), ct.units(unit):
            speed = f"{1000 + number_of_run} rpm"
            own = shared if number_of_run % 2 else ct.run(machine, set={"shaft.main.speed": speed}, quantities=FEW)
            told = [own.summary(), *map(str, own.flags), *(str(check.sentence) for check in own.checks)]
        return of, unit, "\n".join(told)

    with ThreadPoolExecutor(8) as pool:
        for of, unit, told in pool.map(read, range(RUNS)):
            assert set(re.findall("‹(.)›", told)) == {of}
            assert {one for one in UNITS if re.search(rf"\d {one}\b", told)} == {unit}


WHOLE = re.compile(r"(?![,;:.) ]).*[^ ]", re.DOTALL)
"""A message that stands alone: it begins with no comma and no blank, and ends with no blank."""
OF_LINES = {"Next: ", " … (--full)"}
"""What stands before and behind lines of a screen, and in no sentence."""


def messages_in(path):
    """All messages that are marked for translators in a file, with their lines."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in ("_", "N_") and node.args:
            text = node.args[0]
            if isinstance(text, ast.Constant) and isinstance(text.value, str):
                yield node.lineno, text.value


@pytest.mark.parametrize("path", sorted(PACKAGE.rglob("*.py")), ids=lambda path: path.relative_to(PACKAGE).as_posix())
def test_no_message_hangs_on_another(path):
    """A piece of a sentence that begins with a comma, or with a blank, is a sentence that no language can turn."""
    hanging = [one for one in messages_in(path) if one[1] and not WHOLE.fullmatch(one[1]) and one[1] not in OF_LINES]
    assert hanging == [], "make whole sentences of these, each with what it says more as a piece of it"


@pytest.mark.parametrize("text", [", in the head", "; none in {designs}", " and {n} more", "named {name}, "])
def test_a_hanging_message_is_found(text):
    assert not WHOLE.fullmatch(text)
