"""A machine of which a part cannot be read: each table with what can be read of it, and what that shows to be wrong."""

from collections.abc import Mapping
from functools import cache
from typing import Annotated, Any, cast, get_args, get_origin

from pydantic import Field, TypeAdapter, ValidationError
from pydantic.fields import FieldInfo

from cranktrain.declared_types import Bare, alternative_of, bare, inner_of, key_of, table_of
from cranktrain.errors import UNREAD, InputError, Problem
from cranktrain.paths import PathParts, parts_of, path_text
from cranktrain.quantities import nearest
from cranktrain.spec import Spec, SpecType, problems_within, with_tuples


class HalfReader:
    """Reads tables as far as they can be read, and gathers what their fields show together to be wrong.

    `UNREAD` stands in place of what cannot be read, and of what is at odds with something beside it.
    """

    def __init__(self) -> None:
        self.problems: list[Problem] = []

    def read(self, model: type[SpecType], data: Mapping[str, Any], path: PathParts = ()) -> SpecType:
        """Read a table in which something is wrong."""
        try:
            table = cast("Mapping[str, Any]", model.as_fields(data))
        except InputError:
            return UNREAD
        fields = {key_of(name, field): name for name, field in model.model_fields.items()}
        strange = [key for key in table if key not in fields]
        meant = {fields[near] for key in strange if (near := nearest(key, [*fields])) is not None}
        # Of a word from elsewhere nobody knows for which key it stands; at the top of the file it is another table's.
        is_unclear = bool(path) and any(key in model.elsewhere for key in strange)
        values: dict[str, object] = {}
        for key, name in fields.items():
            field = model.model_fields[name]
            if key in table:
                values[name] = self._value(_declared(field), table[key], (*path, key), _reading_of(model, name))
            elif field.is_required() or name in meant or is_unclear:
                values[name] = UNREAD
        half = model.model_construct(_fields_set={fields[key] for key in table if key in fields})
        vars(half).update(values)
        for problem in problems_within(half, path_text(path) if path else "", data):
            self.problems.append(problem)
            half = without(half, parts_of(problem.path)[len(path) :])
        return half

    def _value(self, declared: object, data: object, path: PathParts, right: TypeAdapter[object] | None = None) -> Any:
        """Read a value of a declared type; `right` reads what is right."""
        known = bare(declared)
        table = table_of(known.annotation)
        reading = right or TypeAdapter[object](cast("Any", table or declared))
        try:
            return reading.validate_python(with_tuples(data), strict=True)
        except ValidationError:
            pass
        if known.alternatives:
            chosen = _chosen(known, data)
            return UNREAD if chosen is None else self._value(chosen, data, path)
        if isinstance(data, Mapping):
            return self._of_mapping(known, cast("Mapping[str, object]", data), path)
        return self._of_list(known, data, path) if get_origin(known.annotation) is tuple else UNREAD

    def _of_list(self, known: Bare, data: object, path: PathParts) -> object:
        """Read a list, for which one value may stand; not one of a wrong length, or with tables of unknown kind."""
        items = cast("tuple[object, ...]", data) if isinstance(data, list | tuple) else (data,)
        types, n = get_args(known.annotation), len(items)
        least = max((getattr(mark, "min_length", None) or 0 for mark in known.marks), default=0)
        most = min((getattr(mark, "max_length", None) or n for mark in known.marks), default=n)
        if not least <= n <= most or (Ellipsis not in types and n != len(types)):
            return UNREAD
        read = tuple(self._value(inner_of(known.annotation, i), item, (*path, i)) for i, item in enumerate(items))
        is_of_tables = any(isinstance(item, Mapping) for item in items)
        return UNREAD if is_of_tables and any(item is UNREAD for item in read) else read

    def _of_mapping(self, known: Bare, data: Mapping[str, object], path: PathParts) -> object:
        """Read a table, of fixed keys or of the user's own."""
        table = table_of(known.annotation)
        if table is not None and issubclass(table, Spec):
            return self.read(table, data, path)
        if get_origin(known.annotation) is Mapping or get_origin(known.annotation) is dict:
            return self._named(known, data, path)
        return UNREAD

    def _named(self, known: Bare, data: Mapping[str, object], path: PathParts) -> object:
        """Read tables, or values, by names of the user's own."""
        read = {name: self._value(inner_of(known.annotation, name), each, (*path, name)) for name, each in data.items()}
        # What is no table stands for none.
        is_of_tables = any(isinstance(each, Spec) for each in read.values())
        strays = {name for name in read if is_of_tables and not isinstance(data[name], Mapping | Spec)}
        return _HalfNamed({name: each for name, each in read.items() if name not in strays}, frozenset(strays))


@cache
def _reading_of(model: type[Spec], name: str) -> TypeAdapter[object]:
    """What reads a field of a table."""
    return TypeAdapter[object](cast("Any", _declared(model.model_fields[name])))


def _declared(field: FieldInfo) -> object:
    """Declared type of a field, with what bounds it, without its key."""
    marks = (*field.metadata, *([Field(discriminator=field.discriminator)] if field.discriminator else ()))
    return Annotated[(field.annotation, *marks)] if marks else field.annotation


class _HalfNamed(dict[str, object]):
    """Tables by name; of a name under which there is none nobody knows what it should have been."""

    def __init__(self, read: Mapping[str, object], strays: frozenset[str]) -> None:
        super().__init__(read)
        self._strays = strays

    def __contains__(self, name: object) -> bool:
        """Say whether there is one of a name."""
        return super().__contains__(name) or (name in self._strays and UNREAD)

    def __missing__(self, name: str) -> object:
        """Give one, which cannot be read."""
        if name in self._strays:
            return UNREAD
        raise KeyError(name)


def without(held: Any, path: PathParts) -> Any:
    """Give a value with `UNREAD` at a path within it; itself where the path leads nowhere.

    Parameters
    ----------
    held : Spec, mapping, tuple or anything else
        As it was read.
    path : tuple of str and int
        As the file has it: where one value stands for several, all of them are meant.
    """
    if not path or held is UNREAD:
        is_one = isinstance(held, tuple) and len(cast("tuple[object, ...]", held)) == 1
        return (UNREAD,) if is_one else UNREAD
    first, rest = path[0], path[1:]
    if isinstance(held, tuple):
        items = cast("tuple[object, ...]", held)
        at, below = ({first}, rest) if isinstance(first, int) else (set(range(len(items))), path)
        left = tuple(without(item, below) if i in at else item for i, item in enumerate(items))
        is_of_tables = any(isinstance(item, Spec) for item in items)
        return UNREAD if is_of_tables and any(item is UNREAD for item in left) else left
    if isinstance(held, Mapping):
        named = cast("Mapping[object, object]", held)
        return {**named, first: without(named[first], rest)} if first in [*named] else named
    if not isinstance(held, Spec):
        return UNREAD
    fields = {key_of(name, field): name for name, field in type(held).model_fields.items()}
    name = fields.get(str(first), type(held).others)
    if name is None:
        return held
    changed = held.model_copy()
    vars(changed)[name] = without(vars(held)[name], rest if str(first) in fields else path)
    return changed


def _chosen(union: Bare, data: object) -> object | None:
    """Find the alternative that a table is meant to be: by its tag, or as the only one that is a table."""
    if isinstance(data, Mapping) and union.tag is not None:
        label = cast("Mapping[str, object]", data).get(union.tag)
        found = alternative_of(union, str(label))
        return None if found is object else found
    if not isinstance(data, Mapping):
        return None
    tables = [one for one in union.alternatives if table_of(bare(one).annotation) or bare(one).alternatives]
    return tables[0] if len(tables) == 1 else None
