"""A language that no one speaks: every message that translators are given comes out in letters with accents.

They are as wide as the plain ones. What a reader sees in plain letters is a name, a symbol, a unit, or a string that no
translator would be given.
"""

import ast
import contextlib
import io
import re
import struct
import tomllib
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path
from string import ascii_lowercase
from types import SimpleNamespace

import numpy as np
import pytest
import typer
from typer.testing import CliRunner

import cranktrain as ct
from cranktrain import language
from cranktrain.analysis import every_stage
from cranktrain.cli import main
from cranktrain.cli.app import commands
from cranktrain.cli.completing.names import names as completed
from cranktrain.cli.other_messages import other_messages
from cranktrain.cli.synthesis.command import app as synthesis
from cranktrain.cli.task import commands_of
from cranktrain.io.examples import example_document, example_names
from cranktrain.mechanisms import KINDS
from cranktrain.quantities.dimensions import Dimension
from cranktrain.references import REFERENCES
from cranktrain.saying.catalogue import entries
from cranktrain.texts.contents import TEXTS
from cranktrain.texts.example_tables import example_table
from cranktrain.viz import PICTURES

PSEUDO = "pseudo"

_SOURCES = Path(language.__file__).parent
_ACCENTED = "äḃčďëḟġḧïĵķľṁňöṗǫřšťüṽẅẋÿž"
_LETTERS = str.maketrans(ascii_lowercase + ascii_lowercase.upper(), _ACCENTED + _ACCENTED.upper())
_KEPT = re.compile(r"\{[^{}]*\}|\$[^$\n]*\$|\x08")
"""Pieces, formulas, and the sign that a paragraph of a help is not to be wrapped."""

_CITED = "|".join(map(re.escape, REFERENCES))
_FILE = r"\S*\.(?:toml|csv|json|xlsx|nc|png|svg|pdf)\b"
_TYPED = re.compile(rf"(?<!\w)--?[a-z][\w-]*|\[(?:{_CITED})\]|docs/[\w/-]+|{_FILE}|\w+…")
"""Options, sources, pages, files, names that are cut."""
_FORMULA = re.compile(r"\$[^$\n]*\$")
_WORD = re.compile(r"\w+")
_PLAIN = re.compile("[A-Za-z]{2,}")
_POINTS = re.compile("[A-Z]{2,3}")
"""What joins points, as the texts have it, AC; groups of links, RRP; numbers of shafts, III."""
_FUNCTIONS = {"sin", "cos", "tg", "const", "nan"}


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
    """All messages that translators are given."""
    return frozenset((*_messages(), *other_messages()))


def _messages() -> Iterator[str]:
    for path in _SOURCES.rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        if "_(" in text:
            for node in ast.walk(ast.parse(text)):
                match node:
                    case ast.Call(func=ast.Name(id="_" | "N_"), args=[ast.Constant(value=str(message)), *_rest]):
                        yield message


@pytest.fixture
def pseudo(monkeypatch):
    """Let `in_language(PSEUDO)` say in letters with accents what translators are given."""
    catalogue, there = language._catalogue, messages()
    of_pseudo = SimpleNamespace(gettext=lambda message: marked(message) if message in there else message)
    monkeypatch.setattr(language, "_catalogue", lambda of: of_pseudo if of == PSEUDO else catalogue(of))


def write_catalogue(locale: Path) -> None:
    """Write a catalogue of the language as gettext's tools do, into a folder of such."""
    said = {"": "Content-Type: text/plain; charset=UTF-8\n", **{one: marked(one) for one in messages() if one}}
    pairs = [(one.encode(), said[one].encode()) for one in sorted(said)]
    n, head = len(pairs), 7 * 4
    ends = np.cumsum([head + 16 * n, *(len(text) + 1 for side in (0, 1) for text in (pair[side] for pair in pairs))])
    lengths = [len(pair[side]) for side in (0, 1) for pair in pairs]
    table = np.stack((lengths, ends[:-1]), axis=1).astype("<u4")
    path = locale / PSEUDO / "LC_MESSAGES/cranktrain.mo"
    path.parent.mkdir(parents=True)
    words = b"".join(pair[side] + b"\0" for side in (0, 1) for pair in pairs)
    path.write_bytes(struct.pack("<7I", 0x950412DE, 0, n, head, head + 8 * n, 0, 0) + table.tobytes() + words)


def said_by(*arguments: str, of: str | None = PSEUDO) -> str:
    """All that a command says in a language."""
    said = io.StringIO()
    with language.in_language(of), contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        assert main(arguments) in (0, 2)
    return said.getvalue()


def unmarked(text: str, *names: Iterable[str]) -> list[str]:
    """Words in plain letters that are no names: neither one of those, nor of several parts, nor a symbol or a unit."""
    known = symbols().union(*names)
    return [
        word
        for word in _WORD.findall(_TYPED.sub(" ", _FORMULA.sub(" ", text)))
        if _PLAIN.fullmatch(word) and not _POINTS.fullmatch(word) and word not in known
    ]


def is_marked(text: str) -> bool:
    """Whether any message of the text was said in letters with accents."""
    return not set("äëïöü").isdisjoint(text)


def words_in(values: object) -> Iterator[str]:
    """Words of a table: its values, and names of the tables in it."""
    match values:
        case dict():
            yield from (word for key, value in values.items() if isinstance(value, dict) for word in words_in(key))
            for value in values.values():
                yield from words_in(value)
        case list() | tuple():
            for value in values:
                yield from words_in(value)
        case _:
            yield from re.findall(r"[^\W\d_]+", str(values))


@cache
def symbols() -> frozenset[str]:
    """Symbols of quantities, units, functions of mathematics."""
    every = [entry for stage in every_stage() for entry in entries(stage.gives)]
    units = [name for dimension in Dimension for unit in dimension.units for name in (unit.name, *unit.also)]
    written = (*units, *(word for entry in every for word in (entry.symbol, entry.unit)))
    return _FUNCTIONS | frozenset(part for name in written for part in (*words_in(name), *_WORD.findall(name)))


@cache
def names_of(example: str) -> frozenset[str]:
    """Names that an example gives, its own among them."""
    return frozenset((*words_in(example_document(example).data), *words_in(example), "main"))


@cache
def keys() -> frozenset[str]:
    """What people type: commands with what they take, kinds, keys of files, quantities, examples, formulas."""
    listed = completed()
    every = [
        "source",  # of `plot --at`
        *(listed[what] for what in ("results", "kinds", "units", "keys")),
        *listed["keys"].values(),
        *example_names(),
        *REFERENCES,
        *(picture.name for picture in PICTURES),
        *(formula.number for text in TEXTS for formula in text.formulas),
        "cranktrain",
        *(reaction.name for kind in KINDS for reaction in kind.dynamics.reactions),
        *(key for of in ("drive", "throw") for key in tomllib.loads(example_table(of))),
    ]
    for group in (commands(), commands_of(synthesis)):
        for name, command in group.commands.items():
            every += [name, *(option.metavar or option.name for option in command.params)]
    return frozenset(word for names in every for word in words_in([*names] if isinstance(names, dict) else names))


def joints_of(result: ct.Result) -> frozenset[str]:
    """Labels of joints, and of what has no balance weights."""
    labels = (*result.labels.get("joint", ()), *result.labels.get("balance", ()))
    return frozenset(word for label in labels for word in _WORD.findall(label))


@cache
def words_of_typer() -> frozenset[str]:
    """What Typer says itself in a help or of what it cannot read, which is no message of ours."""
    app = typer.Typer(rich_markup_mode=None, add_completion=False)

    @app.command()
    def one(needed: str, number: float = 1.0) -> None:
        pass

    @app.command()
    def other() -> None:
        pass

    asked = (["--help"], ["one", "--help"], ["othr"], ["one"], ["one", "--numbr", "2"], ["one", "x", "--number", "x"])
    said = [word for typed in asked for word in words_in(CliRunner().invoke(app, typed).output)]
    return frozenset((*said, *map(str.lower, said)))
