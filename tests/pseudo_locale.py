"""A language that no one speaks: every message that is marked comes out in letters with accents, of the same width.

What a reader sees in plain letters is then a name, a symbol, a unit, or a string that no translator would be given.
"""

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from string import ascii_lowercase
from types import SimpleNamespace

import pytest

from cranktrain import language
from cranktrain.cli.said_names import said_names

PSEUDO = "pseudo"

_SOURCES = Path(language.__file__).parent
_ACCENTED = "äḃčďëḟġḧïĵķľṁňöṗꞯřšťüṽẅẋÿž"
_LETTERS = str.maketrans(ascii_lowercase + ascii_lowercase.upper(), _ACCENTED + _ACCENTED.upper())
_KEPT = re.compile(r"\{[^{}]*\}|\$[^$\n]*\$|\x08")
"""Pieces, formulas, and the sign that a paragraph of a help is not to be wrapped."""


def marked(message: str) -> str:
    """Say a message in letters with accents.

    Examples
    --------
    >>> marked("Peak {force:.3f}")
    'Ṗëäķ {force:.3f}'
    """
    kept = _KEPT.findall(message)
    said = [part.translate(_LETTERS) for part in _KEPT.split(message)]
    return "".join(part for pair in zip(said, [*kept, ""], strict=True) for part in pair)


@cache
def messages() -> frozenset[str]:
    """All messages that translators are given: what stands in `_()` and `N_()`, and names that are said in words."""
    return frozenset((*_messages(), *said_names()))


def _messages() -> Iterator[str]:
    for path in _SOURCES.rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        if "_(" in text:
            for node in ast.walk(ast.parse(text)):
                match node:
                    case ast.Call(func=ast.Name(id="_" | "N_"), args=[ast.Constant(value=str(message)), *_rest]):
                        yield message


def _said(message: str) -> str:
    return marked(message) if message in messages() else message


@pytest.fixture
def pseudo(monkeypatch):
    """Let `in_language(PSEUDO)` say what is marked in letters with accents."""
    catalogue = language._catalogue
    of_pseudo = SimpleNamespace(gettext=_said)
    monkeypatch.setattr(language, "_catalogue", lambda of: of_pseudo if of == PSEUDO else catalogue(of))
