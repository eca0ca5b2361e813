"""The text of a machine file with another value at a path, and all else as it was."""

import tomllib
from typing import NoReturn

from cranktrain.errors import InputError, Problem
from cranktrain.io.text_spans import TextSpan, TextSpans, places
from cranktrain.language import said as _
from cranktrain.paths import PathParts, path_text, quantity_path, quoted


def toml_value(given: str) -> str:
    """Write a value as TOML has it: numbers, true, false, lists, tables and quoted text as given, the rest as text.

    Parameters
    ----------
    given : str
        As typed on the command line: `320 mm`, `14.5`, `["0 deg", "90 deg"]`.

    Returns
    -------
    str

    Examples
    --------
    >>> toml_value("320 mm"), toml_value("14.5"), toml_value("true")
    ('"320 mm"', '14.5', 'true')
    """
    text = given.strip()
    if not text:
        raise InputError(
            [Problem("", None, _("no value is given"), _('write PATH=VALUE, or PATH="" for an empty text'))]
        )
    if _is_value(text):
        return text
    if text[0] in "[{\"'":
        allowed = _('is no value: a "text", a ["list"] or a { key = "table" } of TOML, closed, with text in quotes')
        raise InputError([Problem("", text, allowed)])
    return quoted(text)


def _is_value(text: str) -> bool:
    """Tell whether the text is one TOML value, no date, that can stand wherever a value can."""
    try:
        alone = tomllib.loads(f"value = {text}")
        inside = tomllib.loads(f"table = {{ value = {text} }}")  # not so with a comment or a second key behind it
    except (ValueError, RecursionError):
        return False
    of_kind = isinstance(alone.get("value"), bool | int | float | str | list | dict)
    return of_kind and list(alone) == ["value"] and list(inside) == ["table"] and list(inside["table"]) == ["value"]


def with_value(source: bytes, path: str, given: str, found: TextSpans | None = None) -> bytes:
    """Give the text with another value at a path, and all else as it was.

    Parameters
    ----------
    source : bytes
        A TOML text that can be read.
    path, given : str
        As `quantity_path` and `toml_value` read them.
    found : TextSpans, optional
        The `places` of the text, where somebody has them.

    Returns
    -------
    bytes
        A value that is there is replaced, with its status and note; a key that is not is added to its table,
        and a table that is not at the end.

    Raises
    ------
    InputError
        If the path cannot be read, names a table, or leads through what is no table.
    """
    parts = quantity_path(path)
    value = toml_value(given).encode()
    found = places(source) if found is None else found
    place = found.deepest(parts)
    rest = parts[len(place.path) :]
    if not rest and place.is_value:
        return source[: place.start] + value + source[place.end :]
    names = tuple(part for part in rest if isinstance(part, str))
    if not rest or place.kind in ("scalar", "list", "sections") or len(names) < len(rest):
        _refuse(found, place, parts)
    return _with_key(source, found, place, names, value)


def _refuse(found: TextSpans, place: TextSpan, parts: PathParts) -> NoReturn:
    """Say why nothing can be set at the path."""
    here = path_text(place.path)
    rest = parts[len(place.path) :]
    repair = None
    if place.kind == "scalar":
        allowed = _("{path} is a plain value, with nothing under it", path=here)
        repair = _('set it whole: {path}={{ value = "…", status = "…", note = "…" }}', path=here)
    elif place.kind in ("list", "sections"):
        last = place.n_items - 1
        allowed = _("{path} is a list: only {path}[0]", path=here)
        if last:
            allowed = _("{path} is a list: only {path}[0] to {path}[{last}]", path=here, last=last)
        if not place.n_items:
            allowed = _("{path} is an empty list", path=here)
        if place.kind == "list":
            repair = _("or set the whole list: {path}=[…]", path=here)
    elif not rest or isinstance(rest[0], int):
        allowed = _("{path} is a table: set one of the keys in it", path=here)
        repair = ", ".join(path_text(path) for path in found.by_path if path and path[:-1] == place.path) or None
    else:
        n_names = next(i for i, part in enumerate(rest) if isinstance(part, int))
        missing = path_text((*place.path, *rest[:n_names]))
        allowed = _("there is no list {path}", path=missing)
        repair = _("set the whole list: {path}=[…]", path=missing)
    raise InputError([Problem(path_text(parts), None, allowed, repair)])


def _with_key(source: bytes, found: TextSpans, place: TextSpan, names: tuple[str, ...], value: bytes) -> bytes:
    """Give the text with a key that it does not have, under the deepest table that it has."""
    home = place.home or place
    pair = path_text((*place.path[len(home.path) :], *names)).encode() + b" = " + value
    if home.kind == "inline":
        return _with_pair_in_line(source, home, pair)
    newline = b"\r\n" if b"\r\n" in source else b"\n"
    in_list = any(isinstance(part, int) for part in home.path)
    if len(names) > 1 and not in_list and place.kind != "dotted":
        head = b"[" + path_text((*place.path, *names[:-1])).encode() + b"]" + newline
        pair = path_text(names[-1:]).encode() + b" = " + value + newline
        return _with_line_end(source, newline) + (newline if source.strip() else b"") + head + pair
    if home.kind == "implied":
        # TOML means the last item of a list by the list's name, so the heads under it have no places.
        head = b"[" + path_text(part for part in home.path if isinstance(part, str)).encode() + b"]" + newline
        return _with_lines_above(source, home.start, head + pair + newline * 2)
    if home is found.root and not home.has_pairs:
        if found.first_head is None:
            return _with_line_end(source, newline) + pair + newline
        return _with_lines_above(source, found.first_head, pair + newline * 2)
    return _with_pair_below(source, home, pair, newline)


def _with_line_end(source: bytes, newline: bytes) -> bytes:
    """Give the text with its last line ended."""
    return source if not source or source.endswith(b"\n") else source + newline


def _with_pair_in_line(source: bytes, table: TextSpan, pair: bytes) -> bytes:
    """Give the text with one more pair in an inline table."""
    if table.has_pairs:
        return source[: table.tail] + b", " + pair + source[table.tail :]
    return source[: table.start] + b"{ " + pair + b" }" + source[table.end :]


def _with_lines_above(source: bytes, place: int, lines: bytes) -> bytes:
    """Give the text with lines above the one in which the place is."""
    start = source.rfind(b"\n", 0, place) + 1
    return source[:start] + lines + source[start:]


def _with_pair_below(source: bytes, table: TextSpan, pair: bytes, newline: bytes) -> bytes:
    """Give the text with a pair in a line of its own below the table's last, as far indented as that."""
    indent = source[source.rfind(b"\n", 0, table.last_key) + 1 : table.last_key]
    end = source.find(b"\n", table.tail) + 1
    if not end:
        return source + newline + indent + pair
    return source[:end] + indent + pair + newline + source[end:]
