"""Alternatives of a JSON schema told apart by `if` and `then`, so that one slip is one error, where it was made.

An `anyOf` or `oneOf` of which nothing fits is wrong as a whole: editors mark all of the table, and every alternative.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, cast

Schema = dict[str, Any]

_ORDER = ("array", "object", "boolean", "integer", "number", "string")
"""What is asked first; the last alternative is what anything else is held against."""


def by_word(key: str, tables: Mapping[str, Schema], description: str) -> Schema:
    """Choose a table by the word that a key of it has; the description is the key's.

    Examples
    --------
    >>> by_word("kind", {"otto": {"$ref": "#/$defs/Otto"}}, "Kind of gas model.")["allOf"][0]["then"]
    {'$ref': '#/$defs/Otto'}
    """
    return {
        "type": "object",
        "properties": {key: {"description": description, "enum": list(tables)}},
        "required": [key],
        "allOf": [
            {"if": {"properties": {key: {"const": word}}, "required": [key]}, "then": table}
            for word, table in tables.items()
        ],
    }


def by_type(alternatives: Sequence[Schema], definitions: Mapping[str, Schema]) -> Schema:
    """Choose an alternative by what stands there: one of some words, a list, a table, text or a number.

    Parameters
    ----------
    alternatives : sequence of Schema
    definitions : mapping of Schema
        What their references mean.

    Returns
    -------
    Schema
        `anyOf` where two alternatives may be of one type and are neither words nor a table among tables by name.
    """
    words = [one for one in alternatives if "enum" in one]
    rest = [one for one in alternatives if "enum" not in one and one.get("type") != "null"]
    if words and rest:
        return {"if": words[0], "then": words[0], "else": by_type([*words[1:], *rest], definitions)}
    if len(rest) < 2:
        return (rest or words)[0]
    types = [set(_types(one, definitions)) for one in rest]
    if types[0] == types[1] == {"object"} and len(rest) == 2:
        return _one_or_named(*rest)
    if sum(map(len, types)) > len(set[str]().union(*types)):
        return {"anyOf": rest}
    pairs = sorted(zip(types, rest, strict=True), key=lambda pair: max(map(_ORDER.index, pair[0])))
    chosen = pairs[-1][1]
    for kinds, one in reversed(pairs[:-1]):
        chosen = {"if": {"type": sorted(kinds)}, "then": one, "else": chosen}
    return chosen


def _one_or_named(one: Schema, named: Schema) -> Schema:
    """Choose between a table and tables by names, which has tables alone and none of the keys that the one needs."""
    only_tables = {"additionalProperties": {"type": "object"}, "minProperties": 1}
    own = [{"required": [key]} for key in one.get("required", ())]
    return {"if": {**only_tables, "not": {"anyOf": own}} if own else only_tables, "then": named, "else": one}


def _types(schema: Schema, definitions: Mapping[str, Schema]) -> Iterator[str]:
    """Types of JSON that a schema takes."""
    if "$ref" in schema:
        yield from _types(definitions[schema["$ref"].removeprefix("#/$defs/")], definitions)
    elif "type" in schema:
        types = cast("str | list[str]", schema["type"])
        yield from [types] if isinstance(types, str) else types
    else:
        parts = [schema[key] for key in ("then", "else") if key in schema]
        for part in (*parts, *schema.get("anyOf", ())):
            yield from _types(part, definitions)
