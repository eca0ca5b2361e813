"""The machine file as the user typed it: the truth for positions, `--set`, the page, undo and save."""

import codecs
import os
import re
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, cast

from cranktrain.errors import Position, Problem
from cranktrain.io.files import content_of, refusal
from cranktrain.io.syntax import parsed, text_position
from cranktrain.language import said as _
from cranktrain.one_line import LONGEST_SHOWN, one_line, short
from cranktrain.paths import item_at, parts_of, quantity_path, replaced

if TYPE_CHECKING:
    from cranktrain.io.text_spans import TextSpans

LARGEST_FILE = 2**20
"""Bytes; a machine file has some thousands."""


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

    def __repr__(self) -> str:
        """Show its name, and how much it is."""
        return f"<Document {self.name}, {len(self.text.splitlines())} lines>"

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
        content = content_of(
            Path(path),
            name,
            LARGEST_FILE,
            suffix=".toml",
            too_large=_("is larger than {limit} KiB, and no machine file is", limit=LARGEST_FILE // 1024),
            folder=_("is a folder, not a machine file"),
        )
        return cls(_text(content, name), name)

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
            raise refusal(name, _("half a character stands here"), _("delete it"), text_position(name, text, half))
        return cls(text, name)

    @cached_property
    def _parsed(self) -> dict[str, object]:
        return parsed(self.text, self.name)

    @property
    def data(self) -> dict[str, object]:
        """The tables, keys and values of the text; `InputError` where it is not TOML or says nothing."""
        data = self._parsed
        if not data:
            raise refusal(self.name, _("no machine in it"), _("start with `cranktrain new slider_crank`"))
        return data

    @cached_property
    def _source(self) -> bytes:
        return self.text.encode()

    @cached_property
    def _places(self) -> "TextSpans":
        from cranktrain.io.text_spans import places  # most files are right, and stay as they are

        return places(self._source)

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
        place = self._places.deepest(parts_of(path))
        above = self._source[: place.key if at_key else place.start]
        return text_position(self.name, above.decode())

    def located(self, problem: Problem) -> Problem:
        """Place a problem in the text, and add what was given where it does not say it.

        Parameters
        ----------
        problem : Problem

        Returns
        -------
        Problem
        """
        if problem.position is not None and problem.position.line is not None:
            return problem
        given = self._given(problem.path) if problem.given is None else problem.given
        return replace(problem, given=given, position=self.locate(problem.path))

    def _given(self, path: str) -> str | None:
        """Give the value at a path as it was typed, without its quotes; None where there is no value."""
        parts = parts_of(path)
        place = self._places.deepest(parts)
        if place.path != parts or not place.is_value:
            return None
        typed = self._source[place.start : place.end].decode()
        plain = re.fullmatch(r"""(["'])([^"'\\\n]*[^"'\\\s])\1""", typed)
        return short(plain[2]) if plain else _in_short(item_at(self.data, parts), typed)

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
        from cranktrain.io.editing import toml_value, with_value

        tables = self._parsed  # what is wrong already is said first
        for text in (path, given):
            Document.from_text(text, f"{path}={given}".encode(errors="backslashreplace").decode())
        changed = Document(with_value(self._source, path, given, self._places).decode(), self.name)
        parts = quantity_path(path)
        if not any(isinstance(part, int) for part in parts) and parts in self._places.by_path:
            value = parsed(f"value = {toml_value(given)}", self.name)["value"]
            if isinstance(value, str | int | float):  # the whole text need not be read again for it
                vars(changed)["_parsed"] = replaced(tables, parts, value)
        return changed


def _in_short(value: object, typed: str) -> str:
    """Say what is typed of a list or a number with its status as a person would; what is short stays as it is."""
    if isinstance(value, dict) and (number := _number_in(cast("dict[str, object]", value))) is not None:
        return short(number)
    if not isinstance(value, list) or (len(one_line(typed)) <= LONGEST_SHOWN and "{" not in typed):
        return short(typed)
    items = cast("list[object]", value)
    ends = [_number_in(item) for item in (items[0], items[-1])]
    if None in ends:
        return _("a list of {n}", n=len(items))
    return _("a list of {n}, from {first} to {last}", n=len(items), first=short(str(ends[0])), last=short(str(ends[1])))


def _number_in(value: object) -> str | None:
    """Give the number of a table that says where it is from, or of a list's item; None of anything else."""
    if isinstance(value, dict):
        return _number_in(cast("dict[str, object]", value).get("value"))
    return value if isinstance(value, str) else None


def _text(content: bytes, name: str) -> str:
    """Decode a file, or say what it is instead of UTF-8 text."""
    content = content.removeprefix(codecs.BOM_UTF8)
    wide = _wide_encoding(content)
    if wide:
        raise refusal(name, _("is written in {encoding}", encoding=wide), _("save it as UTF-8"))
    if b"\0" in content:
        allowed = _("is no text: it has NUL bytes")
        raise refusal(name, allowed, _("a machine file is TOML: see `cranktrain new slider_crank`"))
    try:
        return content.decode()
    except UnicodeDecodeError as error:
        byte = f"0x{content[error.start]:02X}"
        position = text_position(name, content[: error.start].decode())
        raise refusal(
            name, _("the byte {byte} here is not UTF-8", byte=byte), _("save it as UTF-8"), position
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
