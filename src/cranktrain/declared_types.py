"""Declared types of a spec's fields, taken apart: unions and what marks them, quantities, words, tables."""

import re
import types
from collections.abc import Iterator
from typing import Annotated, Literal, NamedTuple, Union, get_args, get_origin

from pydantic import BaseModel, Discriminator, Tag
from pydantic.fields import FieldInfo

from cranktrain.quantities import Quantity
from cranktrain.when_given import meant


class Bare(NamedTuple):
    """A declared type without `Annotated` and `| None`, what marks it, and of a union its alternatives."""

    annotation: object
    marks: tuple[object, ...]
    alternatives: tuple[object, ...] = ()

    @property
    def tag(self) -> str | None:
        """Key that tells the alternatives of a union; None where none does."""
        tags = [mark.discriminator for mark in self.marks if isinstance(mark, FieldInfo | Discriminator)]
        return next((tag for tag in tags if isinstance(tag, str)), None)


def bare(annotation: object, marks: tuple[object, ...] = ()) -> Bare:
    """Take a declared type apart as far as pydantic's locations do; `marks` are those that stood around it."""
    if get_origin(annotation) is Annotated:
        inner, *own = get_args(annotation)
        within = [part for mark in own for part in (mark, *(mark.metadata if isinstance(mark, FieldInfo) else ()))]
        return bare(meant(inner, within), (*marks, *within))
    if get_origin(annotation) in (Union, types.UnionType):
        alternatives = [part for part in get_args(annotation) if part is not types.NoneType]
        return Bare(annotation, marks, tuple(alternatives)) if len(alternatives) > 1 else bare(alternatives[0], marks)
    return Bare(annotation, marks)


def alternative_of(union: Bare, label: str) -> object:
    """Find the alternative of a union that pydantic means by its tag, class or type."""
    for alternative in union.alternatives:
        marks = get_args(alternative)[1:] if get_origin(alternative) is Annotated else ()
        if any(isinstance(mark, Tag) and mark.tag == label for mark in marks):
            return alternative
    kind = re.sub(r"^(?:function-\w+\[[^,]*, )+", "", label)  # what wraps its validators round it
    for alternative in union.alternatives:
        declared = bare(alternative)
        table = table_of(declared.annotation)
        if table is not None and union.tag is not None:
            if label in map(str, words_of(table.model_fields[union.tag].annotation)):
                return alternative
        elif re.match(rf"{_type_name(declared)}\b", kind):
            return alternative
    return object


def _type_name(declared: Bare) -> str:
    """Name a type as pydantic begins to."""
    if declared.alternatives:
        return "tagged-union"
    origin = get_origin(declared.annotation) or declared.annotation
    return "literal" if origin is Literal else str(getattr(origin, "__name__", origin))


def inner_of(annotation: object, item: str | int) -> object:
    """Declared type of an item of a table, dictionary or list; `object` where it has none."""
    table = table_of(annotation)
    arguments = get_args(annotation)
    if table is not None:
        field = next((field for name, field in table.model_fields.items() if item == key_of(name, field)), None)
        return object if field is None else Annotated[field.annotation, field]
    if not arguments:
        return object
    if isinstance(item, int) and len(arguments) > item and Ellipsis not in arguments:
        return arguments[item]
    return arguments[0] if isinstance(item, int) else arguments[-1]


def table_of(annotation: object) -> type[BaseModel] | None:
    """Take a declared type for a table of fixed keys, if it is one."""
    return annotation if isinstance(annotation, type) and issubclass(annotation, BaseModel) else None


def key_of(name: str, field: FieldInfo) -> str:
    """Key of a field in the machine file."""
    return field.alias or name


def parts_of(annotation: object) -> Iterator[object]:
    """Simple types of a declared one, and what marks them."""
    if get_origin(annotation) is Annotated:
        inner, *marks = get_args(annotation)
        own = [part for mark in marks for part in (mark.metadata if isinstance(mark, FieldInfo) else (mark,))]
        yield from own
        yield from parts_of(meant(inner, own))
    elif get_origin(annotation) in (Union, types.UnionType):
        for part in get_args(annotation):
            yield from parts_of(part)
    else:
        yield annotation


def quantity_of(annotation: object) -> Quantity | None:
    """Give the quantity as which a value of a declared type is read; None where it is none."""
    return next((part for part in parts_of(annotation) if isinstance(part, Quantity)), None)


def words_of(annotation: object) -> list[object]:
    """Words that a declared type allows: a `Literal`, or a tuple of words that marks it."""
    found: list[object] = []
    for part in parts_of(annotation):
        found += part if type(part) is tuple else get_args(part) if get_origin(part) is Literal else ()
    return found
