"""All keys of the machine file in tables, from the schema that editors complete by, and an index."""

import math
import re
from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any, NamedTuple

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from cranktrain.io.schema import machine_schema

_HEADS = ("key", "what it is", "value", "unless given")
_SIGNS = {"above": ">", "from": "≥", "below": "<", "to": "≤"}
_LIMIT = re.compile(rf"-({'|'.join(_SIGNS)})-(-?\d[\d.]*(?:e-?\d+)?)")
_NAME = "NAME"
TOP = "top"
_IN_BANK = "InBank"

Schema = Mapping[str, Any]


class Fields(SphinxDirective):
    """What may stand under one key at the top of the file, its tables; of `top`, all keys there without a table."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Give what the page would say in Markdown."""
        self.env.note_reread()
        return self.parse_text_to_nodes("\n".join(told_tables()[self.arguments[0]].lines), allow_section_headings=True)


class Index(SphinxDirective):
    """Where every table stands, and every key."""

    def run(self) -> list[nodes.Node]:
        """Give what the page would say in Markdown."""
        self.env.note_reread()
        return self.parse_text_to_nodes("\n".join(index_lines()), allow_section_headings=True)


class Listed(NamedTuple):
    """A table as the index has it: its head in the file, the label of its section, its keys."""

    head: str
    label: str
    keys: tuple[str, ...]

    @property
    def link(self) -> str:
        """Link to its section."""
        head = self.head.replace("[", r"\[").replace("]", r"\]")
        return f"[{head}](#{self.label})"


class Told(NamedTuple):
    """What a page says of one key at the top of the file, line by line, and the tables there."""

    lines: list[str]
    tables: list[Listed]


class _Table(NamedTuple):
    """A table of the file: where it stands, its schema, which kind it is of several, whether it is one of a list."""

    path: str
    schema: Schema
    kind: str = ""
    is_listed: bool = False


class _Value(NamedTuple):
    """What a key holds in words, and the tables that may stand there."""

    words: str
    tables: tuple[_Table, ...] = ()


@cache
def told_tables() -> Mapping[str, Told]:
    """Give the tables in Markdown, by the keys at the top of the file; those that are no table stand under `top`."""
    whole = machine_schema()
    reader = _Reader(whole["$defs"])
    values = {key: reader.value(schema, key) for key, schema in whole["properties"].items()}
    for value in values.values():
        reader.told |= {table.schema["title"]: table.path for table in value.tables if "title" in table.schema}
    alone = {key: schema for key, schema in whole["properties"].items() if not values[key].tables}
    at_top = Listed("the top of the file", _label(TOP), tuple(alone))
    found = {TOP: Told([f"({at_top.label})=", *reader.rows(_Table("", {"properties": alone}))], [at_top])}
    for key, schema in whole["properties"].items():
        reader.listed = []
        lines: list[str] = []
        for table in values[key].tables:
            # Sections stand before whatever else a directive gives: what is said of the key stands in the first.
            lines += reader.section(table, "" if lines else schema["description"])
        found[key] = Told(lines, reader.listed)
    return found


def index_lines() -> Iterator[str]:
    """Give all tables in their order, and then all keys in that of letters, each with the tables that have it."""
    tables = [table for told in told_tables().values() for table in told.tables]
    yield from ("## All tables", "", _line(("table", "keys")), "|---|---|")
    for table in tables:
        yield _line((table.link, ", ".join(f"`{key}`" for key in table.keys)))
    yield from ("", "## All keys", "", _line(("key", "stands in")), "|---|---|")
    for key in sorted({key for table in tables for key in table.keys}, key=str.lower):
        yield _line((f"`{key}`", ", ".join(table.link for table in tables if key in table.keys)))


def _label(name: str) -> str:
    """Label of a table's section, for links."""
    return "table-" + re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")


class _Reader:
    """Reads the schema; a table that was told is not told again."""

    def __init__(self, definitions: Mapping[str, Schema]) -> None:
        self.definitions = definitions
        self.told: dict[str, str] = {}
        self.shown: set[str] = set()
        self.listed: list[Listed] = []

    def section(self, table: _Table, about: str = "") -> Iterator[str]:
        """A table of the file, with what is said of its key, and then those below it."""
        name = table.schema.get("title", table.path + table.kind)
        if self.told.setdefault(name, table.path) != table.path or name in self.shown:
            return
        self.shown.add(name)
        head = f"[[{table.path}]]" if table.is_listed else f"[{table.path}]"
        title, label = f"{head}{table.kind}", _label(name + table.kind)
        self.listed.append(Listed(title, label, tuple(table.schema["properties"])))
        said = (f"({label})=", about or table.schema.get("description", "") or title, "")
        more = (table.schema.get("description", ""), "") if about else ()
        yield from (f"### {title}", "", *said, *more, *self.rows(table), "")
        for below in self.below(table):
            yield from self.section(below)

    def rows(self, table: _Table) -> Iterator[str]:
        """The keys of a table."""
        yield _line(_HEADS)
        yield "|" + "---|" * len(_HEADS)
        needed = table.schema.get("required", ())
        for key, schema in table.schema["properties"].items():
            default = "needed" if key in needed else _default(schema)
            value = self.value(schema, _below(table.path, key))
            yield _line((f"`{key}`", schema.get("description", ""), value.words, default))

    def below(self, table: _Table) -> Iterator[_Table]:
        """Tables below a table: under its keys, and under keys of the user's own."""
        for key, schema in table.schema["properties"].items():
            yield from self.value(schema, _below(table.path, key)).tables
        others = table.schema.get("additionalProperties")
        if isinstance(others, Mapping):
            yield from self.value(others, _below(table.path, _NAME)).tables

    def value(self, schema: Schema, path: str) -> _Value:
        """What may stand under a key."""
        example = schema.get("examples", ())
        if "$ref" in schema:
            return self._named(schema["$ref"].rpartition("/")[2], path, example)
        if "allOf" in schema:
            return self._of_kinds(schema, path)
        if "if" in schema:
            return _either([self.value(schema[part], path) for part in ("then", "else") if part in schema])
        if "enum" in schema:
            return _Value(", ".join(f"`{_written(word)}`" for word in schema["enum"]))
        match schema.get("type"):
            case "array":
                inner = self.value(schema["items"], path)
                listed = tuple(table._replace(is_listed=True) for table in inner.tables)
                return _Value("list of tables" if listed else f"list of {inner.words}", listed)
            case "object" if isinstance(schema.get("additionalProperties"), Mapping):
                inner = self.value(schema["additionalProperties"], _below(path, _NAME))
                return _Value("tables by name" if inner.tables else f"{inner.words} by name", inner.tables)
            case "object" if "properties" in schema:
                return _Value("table", (_Table(path, schema),))
            case "string":
                return _Value("text")
            case "boolean":
                return _Value("`true` or `false`")
            case "integer":
                return _Value("whole number")
            case "number":
                return _Value("number")
            case _:
                return _Value("")

    def _named(self, name: str, path: str, example: tuple[str, ...]) -> _Value:
        """What a definition means: a table, or a quantity with its limits."""
        meant = self.definitions[name]
        if "properties" in meant:
            if name.endswith(_IN_BANK):
                return _Value("as [mechanism], with lists of one value for each angle of the bank")
            elsewhere = self.told.get(name, path)
            words = "table" if elsewhere == path else f"table, as [{elsewhere}]"
            return _Value(words, (_Table(path, {**meant, "title": name}),))
        if name[0].isupper():
            return self.value(meant, path)
        shown = [*example, *meant.get("examples", ())][:1]
        return _Value(f"{_quantity(name)}, such as `{shown[0]}`" if shown else _quantity(name))

    def _of_kinds(self, schema: Schema, path: str) -> _Value:
        """Tables of which one key says which it is."""
        found: list[_Table] = []
        for case in schema["allOf"]:
            ((key, word),) = case["if"]["properties"].items()
            for table in self.value(case["then"], path).tables:
                own = {other: part for other, part in table.schema["properties"].items() if other != key}
                said = {"description": schema["properties"][key]["description"], "enum": [word["const"]]}
                kind = f", {key} = {_written(word['const'])}"
                found.append(_Table(path, {**table.schema, "properties": {key: said, **own}}, kind))
        return _Value("table" if found else "as [mechanism], with lists of one value for each angle", tuple(found))


def _either(parts: list[_Value]) -> _Value:
    """What may stand in either way; of one or a list of such it is said once."""
    words = list(dict.fromkeys(part.words for part in parts if part.words))
    tables = tuple(table for part in parts for table in part.tables)
    if len(words) == 2 and words[0] == f"list of {words[1]}":
        return _Value(f"{words[1]}, or a list of such", tables)
    return _Value(" or ".join(words), tables)


def _below(path: str, key: str) -> str:
    """Path of a key in a table."""
    return f"{path}.{key}" if path else key


def _quantity(name: str) -> str:
    """A quantity by the name of its definition: `length-above-0` is a length > 0."""
    what = _LIMIT.sub("", name)
    turn, unit = (math.degrees(1), "°") if what == "angle" else (1.0, "")
    limits = [f"{_SIGNS[word]} {float(limit) * turn:.4g}{unit}" for word, limit in _LIMIT.findall(name)]
    return f"{what.replace('-', ' ')} {', '.join(limits)}".rstrip()


def _default(schema: Schema) -> str:
    """What stands there unless given; nothing of none."""
    default = schema.get("default")
    return "" if default in (None, "", []) else f"`{_written(default)}`"


def _written(value: object) -> str:
    """A value as the file has it."""
    if isinstance(value, bool):
        return str(value).lower()
    return f'"{value}"' if isinstance(value, str) else str(value).replace("'", '"')


def _line(cells: tuple[str, ...]) -> str:
    """Give a row."""
    return "| " + " | ".join(cell.replace("|", "\\|").replace("\n", " ") for cell in cells) + " |"


def setup(app: Sphinx) -> dict[str, bool]:
    """Join Sphinx."""
    app.add_directive("machine-file", Fields)
    app.add_directive("machine-file-index", Index)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
