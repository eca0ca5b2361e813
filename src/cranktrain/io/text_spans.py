"""Where paths stand in the text of a machine file, in bytes of its UTF-8 as tree-sitter counts them."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from cranktrain.paths import DEEPEST_NESTING, PathParts, unquoted

if TYPE_CHECKING:
    from tree_sitter import Node


@dataclass
class TextSpan:
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
    last_key, tail : int
        Of a table that takes pairs: where its last pair begins and ends; without pairs, its head.
    n_items : int
        Of a list.
    has_pairs : bool
    home : TextSpan or None
        Of a dotted table: the table in which its keys are written.
    """

    kind: Literal["scalar", "list", "inline", "section", "sections", "implied", "dotted"]
    path: PathParts
    start: int
    end: int
    key: int
    last_key: int = 0
    tail: int = 0
    n_items: int = 0
    has_pairs: bool = False
    home: "TextSpan | None" = None

    @property
    def is_value(self) -> bool:
        """Whether it is a value, not a table with a head or dotted keys of its own."""
        return self.kind in ("scalar", "list", "inline")


@dataclass
class TextSpans:
    """All places of a text.

    Attributes
    ----------
    root : TextSpan
        The file itself.
    by_path : dict of TextSpan
    repeated : list of (tuple, int, int)
        Keys and heads that are there already: the path, where it stands first, where again.
    first_head : int or None
    """

    root: TextSpan
    by_path: dict[PathParts, TextSpan]
    repeated: list[tuple[PathParts, int, int]]
    first_head: int | None = None

    def deepest(self, parts: PathParts) -> TextSpan:
        """Follow a path as far as the text has it."""
        return next(self.by_path[parts[:n]] for n in range(len(parts), -1, -1) if parts[:n] in self.by_path)


def places(source: bytes) -> TextSpans:
    """Find every table, key and value of a TOML text; a text that is not right as far as it can be made out."""
    import tree_sitter_toml
    from tree_sitter import Language, Parser

    tree = Parser(Language(tree_sitter_toml.language())).parse(source)
    root = TextSpan("section", (), 0, 0, 0)
    found = TextSpans(root, {(): root}, [])
    for node in tree.root_node.children:
        is_section = node.type in ("table", "table_array_element") and node.named_child_count > 0
        table = _add_section(found, node) if is_section else root
        for pair in node.children if is_section else [node]:
            if pair.type == "pair" and not pair.has_error:
                _add_pair(found, table, pair)
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


def _add_section(found: TextSpans, node: "Node") -> TextSpan:
    """Enter the head of a table and give the place that takes its pairs."""
    head_end = next((child.end_byte for child in node.children if child.type in ("]", "]]")), node.end_byte)
    if found.first_head is None:
        found.first_head = node.start_byte
    *above, (name, key) = _keys(node.children[1])
    owner = found.root
    for outer, outer_key in above:
        implied = TextSpan("implied", (*owner.path, outer), node.start_byte, head_end, outer_key)
        owner = found.by_path.setdefault(implied.path, implied)
        owner = found.by_path[*owner.path, owner.n_items - 1] if owner.kind == "sections" else owner
    section = TextSpan("section", (*owner.path, name), node.start_byte, head_end, key, node.start_byte, head_end)
    there = found.by_path.get(section.path, owner if owner.is_value else None)
    if node.type == "table_array_element" and (there is None or there.kind == "sections"):
        sections = TextSpan("sections", section.path, node.start_byte, head_end, key)
        there = found.by_path.setdefault(section.path, sections)
        section.path = (*section.path, there.n_items)
        there.n_items += 1
    elif there is not None and (node.type != "table" or there.kind != "implied"):
        found.repeated.append((there.path, there.key, key))
    found.by_path[section.path] = section
    return section


def _add_pair(found: TextSpans, table: TextSpan, node: "Node") -> None:
    """Enter `key = value` into the table in which it is written."""
    *above, (name, key) = _keys(node.children[0])
    owner = table
    for outer, outer_key in above:
        dotted = TextSpan("dotted", (*owner.path, outer), outer_key, outer_key + len(outer.encode()), outer_key)
        owner = found.by_path.setdefault(dotted.path, dotted)
        if owner.kind in ("dotted", "implied"):
            owner.kind, owner.home = "dotted", table
    path = (*owner.path, name)
    there = found.by_path.get(path, None if owner is table or owner.kind == "dotted" else owner)
    value = _add_value(found, node.children[2], path, key)
    if there is not None:
        found.repeated.append((there.path, there.key, key))
    table.last_key, table.tail, table.has_pairs = node.start_byte, value.end, True


def _add_value(found: TextSpans, node: "Node", path: PathParts, key: int) -> TextSpan:
    """Enter a value with all that is in it."""
    place = found.by_path[path] = TextSpan("scalar", path, node.start_byte, node.end_byte, key)
    if len(path) > DEEPEST_NESTING:
        return place
    if node.type == "array":
        place.kind = "list"
        for child in node.named_children:
            if child.type != "comment":
                _add_value(found, child, (*path, place.n_items), child.start_byte)
                place.n_items += 1
    elif node.type == "inline_table":
        place.kind = "inline"
        for child in node.named_children:
            if child.type == "pair":
                _add_pair(found, place, child)
    return place
