"""What a machine file says as TOML; where it is none, in our words what is wrong, where, and what to write."""

import re
import tomllib
from collections.abc import Iterable
from typing import cast

from cranktrain.errors import InputError, Position, Problem
from cranktrain.io.files import refusal
from cranktrain.language import N_
from cranktrain.language import said as _
from cranktrain.one_line import short
from cranktrain.paths import DEEPEST_NESTING, PathParts, path_text, too_many_parts

_KEY_PART = re.compile(r"""[A-Za-z0-9_-]+|"(?:[^"\\\n]|\\.)*"?|'[^'\n]*'?""")
_TEXTS_AND_KEYS = re.compile(
    rf"""
    "{{3}} (?: [^"\\] | \\[\s\S] | "(?!"") )* (?:"{{3}})?
    | '{{3}} (?: [^'] | '(?!'') )* (?:'{{3}})?
    | \#[^\n]*
    | (?P<key> (?:{_KEY_PART.pattern}) (?: [ \t]* \. [ \t]* (?:{_KEY_PART.pattern}) )* )
    """,
    re.VERBOSE,
)
"""Texts of several lines, comments, keys with dots; a text of one line, or a number, looks like a key of few parts."""

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


def text_position(name: str, text: str, place: int | None = None) -> Position:
    """Give the line and column of a place in a text, of its end unless said."""
    above = text[:place]
    return Position(name, above.count("\n") + 1, len(above) - above.rfind("\n"))


def parsed(text: str, name: str) -> dict[str, object]:
    """Read TOML, or say in our words what is wrong with it."""
    long = long_key(text)
    if long is not None:
        raise InputError([Problem("", long["key"], too_many_parts(), None, text_position(name, text, long.start()))])
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError([_syntax_problem(text, name, str(error))]) from None
    except ValueError:  # Python's limit for the digits of a whole number
        long = re.search("[0-9_]{4000,}", text)
        position = text_position(name, text, long.start() if long else 0)
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
    return _("lists and tables stand more than {limit} deep in one another", limit=DEEPEST_NESTING)


def _contents(value: object) -> Iterable[object]:
    """Give what is in a table or a list; nothing is in other values."""
    if isinstance(value, dict):
        return cast("dict[str, object]", value).values()
    return cast("list[object]", value) if isinstance(value, list) else ()


def _syntax_problem(text: str, name: str, message: str) -> Problem:
    """Turn what tomllib says into what is wrong where, and what to write."""
    said, line, column = _tomllib_message(message)
    lines = text.split("\n")
    position = Position(name, line, column) if line else text_position(name, text)
    given = short(lines[position.line - 1] if position.line else "") or None
    if re.match("Cannot|Duplicate", said):
        from cranktrain.io.text_spans import places

        repeated = places(text.encode()).repeated
        if repeated:
            return _repeated_problem(text, name, *repeated[0])
    if not line and re.match("Unterminated|Expected [\"']['\"]", said):
        return _unclosed_problem(text, name)
    if said.startswith(("Invalid value", "Expected newline")):
        repair = _quoted_line(lines[(line or len(lines)) - 1])
        if repair:
            allowed = (
                _("text and quantities stand in quotes")
                if '"' in repair
                else _("this is no number and no true or false of TOML")
            )
            return Problem("", given, allowed, _("write {line}", line=repair), position)
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
    line = text_position(name, source[:first].decode()).line
    allowed = _("is given twice, first in line {line}", line=line)
    position = text_position(name, source[:again].decode())
    return Problem(path_text(path), None, allowed, _("keep one of the two"), position)


def _unclosed_problem(text: str, name: str) -> Problem:
    """Say where a text begins that runs to the end of the file."""
    three = next((quotes for quotes in ('"""', "'''") if text.count(quotes) % 2), None)
    start = text.rfind(three) if three else max(text.rfind('"'), text.rfind("'"))
    position = text_position(name, text[:start])
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


def long_key(text: str) -> re.Match[str] | None:
    """Find the first key of more parts than a machine file may have; one in a text or a comment is none.

    Parameters
    ----------
    text : str

    Returns
    -------
    re.Match or None
        Its group `key` is the key as it is written.
    """
    for found in _TEXTS_AND_KEYS.finditer(text):
        key = found["key"] or ""
        if key.count(".") >= DEEPEST_NESTING and len(_KEY_PART.findall(key)) > DEEPEST_NESTING:
            return found
    return None
