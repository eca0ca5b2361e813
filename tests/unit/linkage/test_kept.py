"""What is compiled is kept: found again by what it is made of, anew where that is another or cannot be read."""

import os
import subprocess
import sys
from types import SimpleNamespace
from typing import NamedTuple

import pytest

from cranktrain.linkage.kept import folder, is_kept
from cranktrain.transient.compiling import kept

pytest.importorskip("numba")

TEXT = """
FACTOR = 2.0

def inner(x):
    return FACTOR * x

def joined(inner):
    def outer(x):
        return inner(x) + 1.0
    return outer

def passing(inner):
    def outer(x):
        return passed(inner, x) + 1.0
    return outer

def passed(inner, x):
    total = 0.0
    for _ in range(3):
        total += inner(x)
    return total
"""


@pytest.fixture(autouse=True)
def _own_folder(tmp_path, monkeypatch):
    monkeypatch.setenv("CRANKTRAIN_CACHE", str(tmp_path / "kept"))


def names_of(text):
    names = {"__name__": "made_up"}
    exec(compile(text, "made_up.py", "exec"), names)
    return SimpleNamespace(**names)


def outcome(text=TEXT, how="joined", x=3.0):
    """What a function gives that was just written, and whether it had to be compiled."""
    names = names_of(text)
    made = kept(getattr(names, how)(names.inner))
    found = made(x)
    return found, bool(made.stats.cache_misses)


@pytest.mark.parametrize(("how", "once"), [("joined", 7.0), ("passing", 19.0)])
def test_it_is_compiled_once(how, once):
    """A function that is joined into another, and one that is passed on to others, which leaves its address there."""
    assert outcome(how=how) == (once, True)
    assert outcome(how=how) == (once, False)


@pytest.mark.parametrize("how", ["joined", "passing"])
def test_what_is_edited_is_compiled_anew(how):
    """A number, the function itself, and one that was joined into it; whose names in the kept code are others."""
    first, _is_new = outcome(how=how)
    for before, after in (("2.0", "2.5"), ("FACTOR * x", "FACTOR + x"), ("+ 1.0", "+ 1.5")):
        edited = TEXT.replace(before, after)
        names = names_of(edited)
        assert outcome(edited, how) == (getattr(names, how)(names.inner)(3.0), True)
    assert outcome(how=how) == (first, False)


class Pair(NamedTuple):
    one: float
    other: float


class Turned(NamedTuple):
    other: float
    one: float


Turned.__module__, Turned.__qualname__, Turned.__name__ = Pair.__module__, Pair.__qualname__, Pair.__name__
"""So `Pair` says after an edit."""


def test_fields_are_known_by_their_names(monkeypatch):
    """In another order they are other numbers to the same code."""
    text = TEXT.replace("FACTOR * x", "x.one").replace("+ 1.0", "")
    assert outcome(text, x=Pair(1.0, 2.0)) == (1.0, True)
    assert outcome(text, x=Pair(1.0, 2.0)) == (1.0, False)
    monkeypatch.setitem(globals(), "Pair", Turned)
    assert outcome(text, x=Turned(1.0, 2.0)) == (2.0, True)


def test_what_cannot_be_read_is_made_anew():
    """A file that was cut, one of somebody else, an empty one; each is replaced."""
    first, _is_new = outcome()
    for of in ("*.nbi", "*.nbc"):
        for written in (b"", b"nonsense", None):
            (path,) = folder().rglob(of)
            path.write_bytes(path.read_bytes()[: path.stat().st_size // 2] if written is None else written)
            assert outcome() == (first, True)
            assert outcome() == (first, False)


def test_a_folder_that_cannot_be_written_is_no_error(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("CRANKTRAIN_CACHE", str(tmp_path / "file" / "below"))
    assert outcome() == (7.0, True)
    assert outcome() == (7.0, True)


def test_whether_anything_is_kept_is_known_before_it_is_loaded():
    names = names_of(TEXT)
    made = kept(names.joined(names.inner))
    assert not is_kept(made)
    made(3.0)
    assert is_kept(made)
    (path,) = folder().rglob("*.nbi")
    path.write_bytes(b"nonsense")
    assert not is_kept(made)


LONG = """
import math

def times(factor):
    def inner(x):
        total = x
        {lines}
        return factor * total
    return inner

def joined(inner):
    def outer(x):
        return inner(x) + inner(x + 1.0) + inner(x + 2.0)
    return outer
""".format(lines="\n        ".join(f"total += math.sin(total + {number}.0)" for number in range(200)))


OF_FACTORS = """
import sys
from numba.core import event
import made_up
from cranktrain.transient.compiling import kept

with event.install_recorder("numba:compile") as compilations:
    for factor in map(float, sys.argv[1:]):
        plain = made_up.joined(made_up.times(factor))
        found = kept(plain)(0.5)
        assert abs(found - plain(0.5)) <= 1e-9 * abs(found), (found, plain(0.5))
print(len(compilations.buffer) > 0)
"""


def test_what_two_processes_made_stands_side_by_side(tmp_path):
    """Numba counts names in each process anew: two functions made of others would have one name, and be one."""
    (tmp_path / "made_up.py").write_text(LONG)

    def has_compiled(*factors: str) -> bool:
        line = [sys.executable, "-c", OF_FACTORS, *factors]
        environment = {**os.environ, "PYTHONPATH": str(tmp_path)}
        ended = subprocess.run(line, env=environment, check=True, capture_output=True, text=True)
        return ended.stdout.strip() == "True"

    assert has_compiled("1")
    assert has_compiled("3")
    assert not has_compiled("1", "3")
