"""The JSON schema of the machine file as it is written: what editors complete and check while one types."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Annotated, Any, Literal, cast, get_args, get_origin

from pydantic import BeforeValidator, TypeAdapter
from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from cranktrain.declared_types import bare, quantity_of, words_of
from cranktrain.io.choices import Schema, by_type, by_word
from cranktrain.language import said as _
from cranktrain.layout.specs import BankSpec
from cranktrain.machine import Machine
from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms.spec import MechanismSpec
from cranktrain.quantities import Given, Quantity
from cranktrain.spec import Spec

_ONCE = ("kind", "points", "output", "fixed", "crank", "part")
"""Keys of a mechanism that are the same for all angles of a bank."""


def schema_text() -> str:
    """Give the schema as the text of a file."""
    return json.dumps(machine_schema(), ensure_ascii=False, indent=1) + "\n"


def machine_schema() -> Schema:
    """Describe the machine file.

    Returns
    -------
    dict
        A JSON schema, draft 2020-12. What only several values together show to be wrong, it cannot know.
    """
    definitions: dict[str, Schema] = {}
    top = _Writer(definitions).table(Machine)
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": _("machine file of cranktrain"),
        **top,
        "$defs": dict(sorted(definitions.items())),
    }


def described(spec: type[Spec], field: str) -> str:
    """Say what a key of the machine file is: what its declaration says, or that of a base class which it narrows."""
    homes = (base.model_fields[field] for base in spec.__mro__ if issubclass(base, Spec) and field in base.model_fields)
    return _(next(home.description for home in homes if home.description))


class _Writer:
    """Writes schemas of specs; what is used more than once goes into the definitions."""

    def __init__(self, definitions: dict[str, Schema]) -> None:
        self.definitions = definitions

    def table(self, spec: type[Spec]) -> Schema:
        """Describe a table: its keys, and what stands under keys of the user's own."""
        fields = {field.alias or name: self._field(spec, name) for name, field in spec.model_fields.items()}
        schema: Schema = {"type": "object", "description": _summary(spec), "properties": fields}
        required = [field.alias or name for name, field in spec.model_fields.items() if field.is_required()]
        others: Schema | bool = False
        if spec.others is not None:
            named = fields.pop(spec.model_fields[spec.others].alias or spec.others)
            others = {"description": named["description"], **named["additionalProperties"]}
        return schema | ({"required": required} if required else {}) | {"additionalProperties": others}

    def _field(self, spec: type[Spec], name: str) -> Schema:
        """Describe a key: its sentence, what may stand there, and what stands there unless given."""
        field = spec.model_fields[name]
        if spec is BankSpec and name == "mechanism":
            tables = {kind.name: self._in_bank(kind.spec) for kind in KINDS}
            allowed: Schema = by_word("kind", tables, described(MechanismSpec, "kind"))
        else:
            allowed = self.of(Annotated[field.annotation, *field.metadata] if field.metadata else field.annotation)
        schema: Schema = {"description": described(spec, name), **allowed, **_example(spec, name, allowed)}
        default = _default(field)
        return schema if default is None else schema | {"default": default}

    def of(self, annotation: object) -> Schema:
        """Describe what an annotation allows."""
        inner, marks, alternatives = bare(annotation)
        quantity = next((mark for mark in marks if isinstance(mark, Quantity)), None)
        if quantity is not None:
            return self._reference(_quantity_name(quantity), replace(quantity, example=None).schema())
        origin, arguments = get_origin(inner), get_args(inner)
        if alternatives:
            specs = [spec for part in alternatives if (spec := _spec(part)) is not None]
            if len(specs) == len(alternatives) and (key := _telling(specs)) is not None:
                tables = {_word(spec, key): self.of(part) for spec, part in zip(specs, alternatives, strict=True)}
                return by_word(key, tables, described(specs[0], key))
            return by_type([self.of(part) for part in alternatives], self.definitions)
        if origin is tuple:
            return self._list(arguments[0], marks)
        if origin is not None and isinstance(origin, type) and issubclass(origin, Mapping):
            return {"type": "object", "additionalProperties": self.of(arguments[1])}
        if origin is Literal:
            return {"enum": list(arguments)}
        if isinstance(inner, type) and issubclass(inner, Spec):
            return self._reference(inner.__name__.removesuffix("Spec"), self.table(inner))
        schema = TypeAdapter[Any](cast("Any", annotation)).json_schema()
        return by_type(schema["anyOf"], self.definitions) if "anyOf" in schema else schema  # a file has no null

    def _list(self, item: object, marks: tuple[object, ...]) -> Schema:
        """Describe a list, or one value or a list where that may stand instead."""
        one = self.of(item)
        listed: Schema = {"type": "array", "items": one}
        for mark in marks:
            limits = {"minItems": getattr(mark, "min_length", None), "maxItems": getattr(mark, "max_length", None)}
            listed |= {key: limit for key, limit in limits.items() if limit is not None}
        is_either = any(isinstance(mark, BeforeValidator) for mark in marks)
        return by_type([one, listed], self.definitions) if is_either else listed

    def _in_bank(self, spec: type[Spec]) -> Schema:
        """Describe a mechanism in a bank, whose fields may be lists with one value for each angle of the bank."""
        table = self.table(spec)
        fields: dict[str, Schema] = table["properties"]
        several = {name: field if name in _ONCE else self._one_or_many(field) for name, field in fields.items()}
        return self._reference(f"{spec.__name__.removesuffix('Spec')}InBank", table | {"properties": several})

    def _one_or_many(self, field: Schema) -> Schema:
        """Allow a list of what a key of a mechanism may hold."""
        about = {key: part for key, part in field.items() if key in ("description", "default", "examples")}
        one = {key: part for key, part in field.items() if key not in about}
        return {**about, **by_type([{"type": "array", "items": one, "minItems": 1}, one], self.definitions)}

    def _reference(self, name: str, schema: Schema) -> Schema:
        """Put a schema among the definitions and refer to it."""
        self.definitions[name] = schema
        return {"$ref": f"#/$defs/{name}"}


def _spec(annotation: object) -> type[Spec] | None:
    """Take a declared type for a table, if it is one."""
    inner = bare(annotation).annotation
    return inner if isinstance(inner, type) and issubclass(inner, Spec) else None


def _telling(specs: Sequence[type[Spec]]) -> str | None:
    """Find the key whose one word tells which of some tables it is."""
    return next((key for key in ("kind", "type") if all(_word(spec, key) for spec in specs)), None)


def _word(spec: type[Spec], key: str) -> str:
    """Give the one word that a key of a table may have; empty where it has none or several."""
    words = words_of(spec.model_fields[key].annotation) if key in spec.model_fields else []
    return str(words[0]) if len(words) == 1 else ""


def _example(spec: type[Spec], name: str, allowed: Schema) -> Schema:
    """Give the example that suits a key better than that of its dimension."""
    field = spec.model_fields[name]
    quantity = quantity_of(Annotated[field.annotation, field])
    example = None if quantity is None else quantity.of_field(field.alias or name).example
    return {} if example is None or "$ref" not in allowed else {"examples": [example]}


def _quantity_name(quantity: Quantity) -> str:
    """Name a quantity and its range among the definitions."""
    limits = {
        "above": quantity.above,
        "from": quantity.at_least,
        "below": quantity.below,
        "to": quantity.at_most,
    }
    range_ = "".join(f"-{word}-{limit:g}" for word, limit in limits.items() if limit is not None)
    of_vibration = "-of-vibration" if quantity.is_of_vibration else ""
    return quantity.dimension.name.lower().replace("_", "-") + of_vibration + range_


def _default(field: FieldInfo) -> object:
    """Give the default as a file would write it; None where there is none to tell."""
    default = field.default
    if default is PydanticUndefined or default is None or isinstance(default, Spec | Mapping):
        return None
    if isinstance(default, tuple):
        items = [item.text for item in cast("tuple[object, ...]", default) if isinstance(item, Given)]
        one_or_many = any(isinstance(mark, BeforeValidator) for mark in bare(field.rebuild_annotation()).marks)
        return items[0] if one_or_many and len(items) == 1 else items
    return default.text if isinstance(default, Given) else default


def _summary(spec: type[Spec]) -> str:
    """First sentence of a spec's docstring."""
    return _(" ".join((spec.__doc__ or "").partition("\n\n")[0].split()))
