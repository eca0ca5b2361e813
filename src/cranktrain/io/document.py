"""The machine file as the user typed it: the truth for positions, `--set`, the page, undo and save."""

import codecs
import os
import re
import tomllib
from bisect import bisect_right
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import cast

from cranktrain.errors import InputError, Position, Problem
from cranktrain.io import editing
from cranktrain.io.files import Wanted, content_of, refusal
from cranktrain.io.long_keys import long_key
from cranktrain.language import N_, _
from cranktrain.one_line import short
from cranktrain.paths import DEEPEST_NESTING, PathParts, path_text, quantity_path, too_many_parts

LARGEST_FILE = 2**20
"""Bytes; a machine file has some thousands."""

MOST_KEYS = 20_000
"""In all tables of a file together; a machine file has some tens."""

# What tomllib's messages begin with, what is allowed there, and what to do.
_SYNTAX = (
    (
        r"Expected newline",
        N_("after the value nothing more may stand in the line"),
        N_("one line holds one key = value"),
    ),
    (r"Expected '='", N_("a key needs = and a value after it"), N_("write key = value")),
    (
        r"Invalid statement",
        N_("a line begins with a key, a [table] or #"),
        N_('put a key of other letters in quotes: "ключ"'),
    ),
    (r"Invalid initial", N_("a key has the letters A to Z, digits, _ and -"), N_('put other keys in quotes: "ключ"')),
    (r"Cannot|Duplicate", N_("this key or table is there already"), N_("keep one of the two")),
    (
        r"Unclosed array",
        N_("a comma or the closing ] is missing in the list"),
        N_('put text and quantities in quotes: ["0 deg"]'),
    ),
    (
        r"Unclosed inline",
        N_("a comma or the closing } is missing in the table, all of it in one line"),
        N_('put text and quantities in quotes: { value = "3 mm" }'),
    ),
    (r"Unescaped", N_("a single \\ in a text has a meaning of its own"), N_("write \\\\, or put the text in '…'")),
    (
        r"(Illegal|Found invalid) character '\\n'",
        N_("a text is not closed in this line"),
        N_("close it with the same quotes"),
    ),
    (r"Illegal|Found invalid", N_("a control character stands here"), N_("delete it")),
    (r"Invalid hex|Escaped", N_("\\u and \\U need the 4 or 8 hexadecimal digits of a character"), ""),
    (r"Invalid date", N_("there is no such date or time"), ""),
    (
        r"Invalid value",
        N_('no value: a number, true, false, a "text", a ["list"] or a { key = "table" } may stand here'),
        "",
    ),
    (
        r"Expected '\]",
        N_("the head of a table is not closed"),
        N_("write [name] or [name.inner], [[name]] for an item of a list"),
    ),
)


@dataclass(frozen=True)
class Document:
    """A machine file as text.

    Attributes
    ----------
    text : str
    name : str
        As shown in messages.
    """

    text: str
    name: str

    @classmethod
    def read(cls, path: "str | os.PathLike[str]") -> "Document":
        """Read a file.

        Parameters
        ----------
        path : str or path-like

        Returns
        -------
        Document

        Raises
        ------
        InputError
            If there is no such file, it cannot be read, or it is no UTF-8 text.
        """
        name = os.fspath(path).encode(errors="backslashreplace").decode()
        too_large = _("is larger than {limit} KiB, and no machine file is").format(limit=LARGEST_FILE // 1024)
        wanted = Wanted(LARGEST_FILE, too_large, _("is a folder, not a machine file"))
        return cls(_text(content_of(Path(path), name, wanted, suffix=".toml"), name), name)

    @classmethod
    def from_text(cls, text: str, name: str) -> "Document":
        """Take a text from elsewhere, e.g. from the page.

        Parameters
        ----------
        text, name : str

        Returns
        -------
        Document

        Raises
        ------
        InputError
            If the text has half characters (lone surrogates), which no file can hold.
        """
        text = text.removeprefix("\ufeff")
        half = next((i for i, character in enumerate(text) if "\ud800" <= character <= "\udfff"), None)
        if half is not None:
            raise refusal(name, _("half a character stands here"), _("delete it"), _position(name, text, half))
        return cls(text, name)

    @cached_property
    def data(self) -> dict[str, object]:
        """The tables, keys and values of the text; `InputError` where it is not TOML or says nothing."""
        data = _parsed(self.text, self.name)
        if not data:
            raise refusal(self.name, _("no machine in it"), _("start with `cranktrain new slider_crank`"))
        return data

    @cached_property
    def _source(self) -> bytes:
        return self.text.encode()

    @cached_property
    def _places(self) -> editing.Places:
        return editing.places(self._source)

    def locate(self, path: str, *, at_key: bool = False) -> Position:
        """Say where a path stands in the text.

        Parameters
        ----------
        path : str
            As `quantity_path` reads it; empty for the file itself.
        at_key : bool
            Where its key stands, not its value: for a key that should not be there.

        Returns
        -------
        Position
            Of the value, or of a table's head; where the text has no such path, of the nearest that encloses it.
        """
        if not path:
            return Position(self.name)
        try:
            parts = quantity_path(path)
        except InputError:
            parts = ()
        place = self._places.root.deepest(parts)
        return self._position(place.key if at_key else place.start)

    def located(self, problems: Iterable[Problem]) -> tuple[Problem, ...]:
        """Place problems in the text, and add what was given where they do not say it.

        Parameters
        ----------
        problems : iterable of Problem

        Returns
        -------
        tuple of Problem
        """
        return tuple(self._located(problem) for problem in problems)

    def _located(self, problem: Problem) -> Problem:
        if problem.position is not None and problem.position.line is not None:
            return problem
        given = self._given(problem.path) if problem.given is None else problem.given
        return replace(problem, given=given).at(self.locate(problem.path))

    def _given(self, path: str) -> str | None:
        """Give the value at a path as it was typed, without its quotes; None where there is no value."""
        try:
            parts = quantity_path(path)
        except InputError:
            return None
        place = self._places.root.deepest(parts)
        if place.path != parts or place.kind not in ("scalar", "list", "inline"):
            return None
        typed = self._source[place.start : place.end].decode()
        plain = re.fullmatch(r"""(["'])([^"'\\\n]*[^"'\\\s])\1""", typed)
        return short(plain[2] if plain else typed)

    def with_value(self, path: str, given: str) -> "Document":
        """Give the document with another value at a path; comments and layout stay.

        Parameters
        ----------
        path : str
            As `quantity_path` reads it.
        given : str
            As `toml_value` reads it: `320 mm`, `14.5`, `["0 deg", "90 deg"]`.

        Returns
        -------
        Document
            A value that is there is replaced together with its status and note, which were the old value's. A key
            that is not is added to its table, and a table that is not at the end.

        Raises
        ------
        InputError
            If the path cannot be read, names a table, or leads through what is no table or list.
        """
        _parsed(self.text, self.name)
        for text in (path, given):
            Document.from_text(text, f"{path}={given}".encode(errors="backslashreplace").decode())
        return Document(editing.with_value(self._source, path, given).decode(), self.name)

    @cached_property
    def _line_starts(self) -> tuple[int, ...]:
        """Where each line begins, in bytes."""
        return (0, *(found.end() for found in re.finditer(b"\n", self._source)))

    def _position(self, place: int) -> Position:
        """Turn a place in the bytes into line and column."""
        line = bisect_right(self._line_starts, place)
        start = self._line_starts[line - 1]
        return Position(self.name, line, len(self._source[start:place].decode()) + 1)


def _position(name: str, text: str, place: int | None = None) -> Position:
    """Give the line and column of a place in a text, of its end unless said."""
    above = text[:place]
    return Position(name, above.count("\n") + 1, len(above) - above.rfind("\n"))


def _text(content: bytes, name: str) -> str:
    """Decode a file, or say what it is instead of UTF-8 text."""
    content = content.removeprefix(codecs.BOM_UTF8)
    wide = _wide_encoding(content)
    if wide:
        raise refusal(name, _("is written in {encoding}").format(encoding=wide), _("save it as UTF-8"))
    if b"\0" in content:
        allowed = _("is no text: it has NUL bytes")
        raise refusal(name, allowed, _("a machine file is TOML: see `cranktrain new slider_crank`"))
    try:
        return content.decode()
    except UnicodeDecodeError as error:
        byte = f"0x{content[error.start]:02X}"
        position = _position(name, content[: error.start].decode())
        raise refusal(
            name, _("the byte {byte} here is not UTF-8").format(byte=byte), _("save it as UTF-8"), position
        ) from None


def _wide_encoding(content: bytes) -> str | None:
    """Name the encoding of a text in units of two or four bytes; None for any other file."""
    for name, encoding, mark in (
        ("UTF-32", "utf-32-le", codecs.BOM_UTF32_LE),
        ("UTF-32", "utf-32-be", codecs.BOM_UTF32_BE),
        ("UTF-16", "utf-16-le", codecs.BOM_UTF16_LE),
        ("UTF-16", "utf-16-be", codecs.BOM_UTF16_BE),
    ):
        if content.startswith(mark):
            return name
        if b"\0" in content:
            text = content.decode(encoding, errors="replace")
            if "=" in text and all(character.isprintable() or character.isspace() for character in text):
                return name
    return None


def _parsed(text: str, name: str) -> dict[str, object]:
    """Read TOML, or say in our words what is wrong with it."""
    long = long_key(text)
    if long is not None:
        raise InputError([Problem("", long.key, too_many_parts(), None, _position(name, text, long.place))])
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError([_syntax_problem(text, name, str(error))]) from None
    except ValueError:  # Python's limit for the digits of a whole number
        long = re.search("[0-9_]{4000,}", text)
        position = _position(name, text, long.start() if long else 0)
        raise refusal(name, _("a number of thousands of digits stands here"), None, position) from None
    except RecursionError:
        raise refusal(name, _nested_too_deep()) from None
    level: list[object] = [data]
    n_keys = 0
    for _depth in range(DEEPEST_NESTING):
        n_keys += sum(len(cast("dict[str, object]", table)) for table in level if isinstance(table, dict))
        level = [inner for outer in level for inner in _contents(outer)]
    if n_keys > MOST_KEYS:
        too_many = _("has {n} keys, and no machine needs more than {limit}")
        raise refusal(name, too_many.format(n=n_keys, limit=MOST_KEYS))
    if level:
        raise refusal(name, _nested_too_deep())
    return data


def _nested_too_deep() -> str:
    return _("lists and tables stand more than {limit} deep in one another").format(limit=DEEPEST_NESTING)


def _contents(value: object) -> Iterable[object]:
    """Give what is in a table or a list; nothing is in other values."""
    if isinstance(value, dict):
        return cast("dict[str, object]", value).values()
    return cast("list[object]", value) if isinstance(value, list) else ()


def _syntax_problem(text: str, name: str, message: str) -> Problem:
    """Turn what tomllib says into what is wrong where, and what to write."""
    said, line, column = _tomllib_message(message)
    lines = text.split("\n")
    position = Position(name, line, column) if line else _position(name, text)
    given = short(lines[position.line - 1] if position.line else "") or None
    if re.match("Cannot|Duplicate", said):
        repeated = editing.places(text.encode()).repeated
        if repeated:
            return _repeated_problem(text, name, *repeated[0])
    if not line and re.match("Unterminated|Expected [\"']['\"]", said):
        return _unclosed_problem(text, name)
    if said.startswith(("Invalid value", "Expected newline")):
        repair = _quoted_line(lines[(line or len(lines)) - 1])
        if repair:
            allowed = _("text and quantities stand in quotes")
            if '"' not in repair:
                allowed = _("this is no number and no true or false of TOML")
            return Problem("", given, allowed, _("write {line}").format(line=repair), position)
    for pattern, allowed, repair in _SYNTAX:
        if re.match(pattern, said):
            return Problem("", given, _(allowed), _(repair) or None, position)
    return Problem("", given, said, None, position)


def _tomllib_message(message: str) -> tuple[str, int | None, int | None]:
    """Split what tomllib says into the fault and where it is: line and column, or neither for the end."""
    found = re.fullmatch(r"(?s)(.*) \(at (?:line (\d+), column (\d+)|end of document)\)", message)
    if not found:
        return message, None, None
    return (found[1], int(found[2]), int(found[3])) if found[2] else (found[1], None, None)


def _repeated_problem(text: str, name: str, path: PathParts, first: int, again: int) -> Problem:
    """Say where a key or table stands for the first time and where again."""
    source = text.encode()
    line = _position(name, source[:first].decode()).line
    allowed = _("is given twice, first in line {line}").format(line=line)
    position = _position(name, source[:again].decode())
    return Problem(path_text(path), None, allowed, _("keep one of the two"), position)


def _unclosed_problem(text: str, name: str) -> Problem:
    """Say where a text begins that runs to the end of the file."""
    three = next((quotes for quotes in ('"""', "'''") if text.count(quotes) % 2), None)
    start = text.rfind(three) if three else max(text.rfind('"'), text.rfind("'"))
    position = _position(name, text[:start])
    given = short(text[start:].partition("\n")[0])
    return Problem("", given, _("this text is not closed"), _("close it with the same quotes"), position)


def _quoted_line(line: str) -> str | None:
    """Write a line right that lacks quotes, has curly ones, a decimal comma, or True for true; None for others."""
    found = re.fullmatch(r"""\s*([\w.\-]+)\s*=\s*([^"'\[{=#]*[^"'\[{=#\s])\s*(?:#.*)?""", line)
    if not found:
        return None
    key, value = found[1], found[2].strip("“”„‟«»‘’‚`")
    if value.lower() in ("true", "false"):
        return f"{key} = {value.lower()}"
    value = re.sub(r"^([+-]?[0-9]+),([0-9]+)\b", r"\1.\2", value)
    if re.fullmatch(r"[+-]?[0-9]+\.[0-9]+", value):
        return f"{key} = {value}"
    return f'{key} = "{value}"' if any(character.isalpha() or character in "°%" for character in value) else None
