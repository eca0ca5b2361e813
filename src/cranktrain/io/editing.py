"""Paths into a machine file: where they stand in its text, and the text with another value there.

Places are counted in bytes of the UTF-8 text, as tree-sitter counts them.
"""

import tomllib
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal, NoReturn

from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.paths import DEEPEST_NESTING, PathParts, path_text, quantity_path, quoted, unquoted

if TYPE_CHECKING:
    from tree_sitter import Node

_VALUES = ("scalar", "list", "inline")


@dataclass
class Place:
    """What the text has at one path.

    Attributes
    ----------
    kind : str
        `scalar`, `list`, `inline`: a value; `section`: a table with a head of its own, or the file itself;
        `sections`: a list of such; `implied`: a table named only in heads further in; `dotted`: only in dotted keys.
    path : tuple of str and int
    start, end : int
        The value; for a table its head, or where it is first named.
    key : int
        Where the key stands.
    fields, items : dict, list
        What is in it.
    last_key, tail : int
        Of a table that takes pairs: where its last pair begins and ends; without pairs, its head.
    has_pairs : bool
    home : Place or None
        Of a dotted table: the table in which its keys are written.
    """

    kind: Literal["scalar", "list", "inline", "section", "sections", "implied", "dotted"]
    path: PathParts
    start: int
    end: int
    key: int
    fields: "dict[str, Place]" = field(default_factory=dict[str, "Place"])
    items: "list[Place]" = field(default_factory=list["Place"])
    last_key: int = 0
    tail: int = 0
    has_pairs: bool = False
    home: "Place | None" = None

    def deepest(self, parts: Sequence[str | int]) -> "Place":
        """Follow the path from here as far as the text has it."""
        place = self
        for part in parts:
            if isinstance(part, str) and part in place.fields:
                place = place.fields[part]
            elif isinstance(part, int) and part < len(place.items):
                place = place.items[part]
            else:
                break
        return place


@dataclass
class Places:
    """All places of a text.

    Attributes
    ----------
    root : Place
    repeated : list of (tuple, int, int)
        Keys and heads that are there already: the path, where it stands first, where again.
    first_head : int or None
    """

    root: Place
    repeated: list[tuple[PathParts, int, int]]
    first_head: int | None = None


def places(source: bytes) -> Places:
    """Find every table, key and value of a TOML text; a text that is not right as far as it can be made out."""
    import tree_sitter_toml
    from tree_sitter import Language, Parser

    tree = Parser(Language(tree_sitter_toml.language())).parse(source)
    found = Places(Place("section", (), 0, 0, 0), [])
    for node in tree.root_node.children:
        if node.type == "pair" and not node.has_error:
            _add_pair(found, found.root, node)
        elif node.type in ("table", "table_array_element") and node.named_child_count:
            section = _add_section(found, node)
            for pair in node.children:
                if pair.type == "pair" and not pair.has_error:
                    _add_pair(found, section, pair)
    return found


def _keys(node: "Node") -> list[tuple[str, int]]:
    """Give the names of a key, dotted or not, and where each stands."""
    keys: list[tuple[str, int]] = []
    rest = [node]
    while rest:  # a dotted key nests to the left, as deep as it is long
        part = rest.pop()
        if part.type == "dotted_key":
            rest += part.named_children
        elif part.text is not None:
            written = part.text.decode()
            name = unquoted(written) if part.type == "quoted_key" else None
            keys.append((written if name is None else name, part.start_byte))
    return keys[::-1]


def _add_section(found: Places, node: "Node") -> Place:
    """Enter the head of a table and give the place that takes its pairs."""
    head_end = next((child.end_byte for child in node.children if child.type in ("]", "]]")), node.end_byte)
    if found.first_head is None:
        found.first_head = node.start_byte
    *above, (name, key) = _keys(node.children[1])
    owner = found.root
    for outer, outer_key in above:
        implied = Place("implied", (*owner.path, outer), node.start_byte, head_end, outer_key)
        owner = owner.fields.setdefault(outer, implied)
        owner = owner.items[-1] if owner.kind == "sections" else owner
    section = Place("section", (*owner.path, name), node.start_byte, head_end, key)
    section.last_key, section.tail = node.start_byte, head_end
    there = owner.fields.get(name, owner if owner.kind in _VALUES else None)
    if node.type == "table_array_element" and (there is None or there.kind == "sections"):
        there = owner.fields.setdefault(name, Place("sections", section.path, node.start_byte, head_end, key))
        section.path = (*section.path, len(there.items))
        there.items.append(section)
    elif node.type == "table" and (there is None or there.kind == "implied"):
        section.fields = there.fields if there else {}
        owner.fields[name] = section
    elif there is not None:
        found.repeated.append((there.path, there.key, key))
    return section


def _add_pair(found: Places, table: Place, node: "Node") -> None:
    """Enter `key = value` into the table in which it is written."""
    *above, (name, key) = _keys(node.children[0])
    owner = table
    for outer, outer_key in above:
        dotted = Place("dotted", (*owner.path, outer), outer_key, outer_key + len(outer.encode()), outer_key)
        owner = owner.fields.setdefault(outer, dotted)
        if owner.kind in ("dotted", "implied"):
            owner.kind, owner.home = "dotted", table
    value = _value(found, node.children[2], (*owner.path, name), key)
    there = owner.fields.get(name, None if owner is table or owner.kind == "dotted" else owner)
    if there is None:
        owner.fields[name] = value
    else:
        found.repeated.append((there.path, there.key, key))
    table.last_key, table.tail, table.has_pairs = node.start_byte, value.end, True


def _value(found: Places, node: "Node", path: PathParts, key: int) -> Place:
    """Give the place of a value with all that is in it."""
    place = Place("scalar", path, node.start_byte, node.end_byte, key)
    if len(path) > DEEPEST_NESTING:
        return place
    if node.type == "array":
        place.kind = "list"
        for child in node.named_children:
            if child.type != "comment":
                place.items.append(_value(found, child, (*path, len(place.items)), child.start_byte))
    elif node.type == "inline_table":
        place.kind = "inline"
        for child in node.named_children:
            if child.type == "pair":
                _add_pair(found, place, child)
    return place


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


def with_value(source: bytes, path: str, given: str) -> bytes:
    """Give the text with another value at a path, and all else as it was.

    Parameters
    ----------
    source : bytes
        A TOML text that can be read.
    path, given : str
        As `quantity_path` and `toml_value` read them.

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
    found = places(source)
    place = found.root.deepest(parts)
    rest = parts[len(place.path) :]
    if not rest and place.kind in _VALUES:
        return source[: place.start] + value + source[place.end :]
    names = tuple(part for part in rest if isinstance(part, str))
    if not rest or place.kind in ("scalar", "list", "sections") or len(names) < len(rest):
        _refuse(place, parts)
    return _with_key(source, found, place, names, value)


def _refuse(place: Place, parts: PathParts) -> NoReturn:
    """Say why nothing can be set at the path."""
    here = path_text(place.path)
    rest = parts[len(place.path) :]
    repair = None
    if place.kind == "scalar":
        allowed = _("{path} is a plain value, with nothing under it").format(path=here)
        repair = _('set it whole: {path}={{ value = "…", status = "…", note = "…" }}').format(path=here)
    elif place.kind in ("list", "sections"):
        last = len(place.items) - 1
        items = _("only {path}[0] to {path}[{last}]") if last else _("only {path}[0]")
        allowed = _("{path} is a list: ").format(path=here) + items.format(path=here, last=last)
        if not place.items:
            allowed = _("{path} is an empty list").format(path=here)
        if place.kind == "list":
            repair = _("or set the whole list: {path}=[…]").format(path=here)
    elif not rest or isinstance(rest[0], int):
        allowed = _("{path} is a table: set one of the keys in it").format(path=here)
        repair = ", ".join(path_text((*place.path, name)) for name in place.fields) or None
    else:
        n_names = next(i for i, part in enumerate(rest) if isinstance(part, int))
        missing = path_text((*place.path, *rest[:n_names]))
        allowed = _("there is no list {path}").format(path=missing)
        repair = _("set the whole list: {path}=[…]").format(path=missing)
    raise InputError([Problem(path_text(parts), None, allowed, repair)])


def _with_key(source: bytes, found: Places, place: Place, names: tuple[str, ...], value: bytes) -> bytes:
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


def _with_pair_in_line(source: bytes, table: Place, pair: bytes) -> bytes:
    """Give the text with one more pair in an inline table."""
    if table.has_pairs:
        return source[: table.tail] + b", " + pair + source[table.tail :]
    return source[: table.start] + b"{ " + pair + b" }" + source[table.end :]


def _with_lines_above(source: bytes, place: int, lines: bytes) -> bytes:
    """Give the text with lines above the one in which the place is."""
    start = source.rfind(b"\n", 0, place) + 1
    return source[:start] + lines + source[start:]


def _with_pair_below(source: bytes, table: Place, pair: bytes, newline: bytes) -> bytes:
    """Give the text with a pair in a line of its own below the table's last, as far indented as that."""
    indent = source[source.rfind(b"\n", 0, table.last_key) + 1 : table.last_key]
    end = source.find(b"\n", table.tail) + 1
    if not end:
        return source + newline + indent + pair
    return source[:end] + indent + pair + newline + source[end:]
