"""Tables of several designs as one: the first design's, in which every number is a column of those of all."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, cast

import numpy as np
from pydantic import BaseModel

from cranktrain.grouping import grouped
from cranktrain.motion import Array
from cranktrain.paths import PathParts
from cranktrain.quantities import Given
from cranktrain.spec import Spec, SpecType


def in_columns(specs: Sequence[SpecType]) -> SpecType:
    """Put tables that differ in numbers alone together.

    Parameters
    ----------
    specs : sequence of Spec
        The same table in each design.

    Returns
    -------
    Spec
        The first one, whose quantities have the values of all as their `column`.

    Examples
    --------
    >>> from cranktrain.layout.bodies import BodySpec
    >>> light, heavy = BodySpec(mass="2 kg"), BodySpec(mass="3 kg")
    >>> in_columns([light, heavy]).mass.array
    array([2., 3.])
    """
    return cast("SpecType", _in_columns(specs))


def _in_columns(values: Sequence[Any]) -> Any:
    first = values[0]
    if isinstance(first, Given):
        return replace(first, column=np.array([one.si for one in values]))
    if isinstance(first, Spec):
        return _copied(first, lambda name: _in_columns([getattr(one, name) for one in values]))
    if isinstance(first, Mapping):
        named = cast("Mapping[str, Any]", first)
        return {name: _in_columns([one[name] for one in values]) for name in named}
    if isinstance(first, tuple):
        return tuple(_in_columns(items) for items in zip(*values, strict=True))
    return first


def numbers_of(spec: Spec) -> Iterator[tuple[PathParts, Given]]:
    """Give the quantities of a table and where they stand in it: by fields, names and places in lists."""
    return _numbers_of(spec, ())


def _numbers_of(value: object, where: PathParts) -> Iterator[tuple[PathParts, Given]]:
    if isinstance(value, Given):
        yield where, value
        return
    for key, item in items_of(value):
        yield from _numbers_of(item, (*where, key))


def items_of(value: object) -> Iterable[tuple[str | int, object]]:
    """Give what stands in a table by its fields, in tables by name by these, in a list by its places; else nothing."""
    if isinstance(value, Spec):
        return ((name, getattr(value, name)) for name in type(value).model_fields)
    if isinstance(value, Mapping):
        return cast("Mapping[str, object]", value).items()
    return enumerate(cast("tuple[object, ...]", value)) if isinstance(value, tuple) else ()


def with_numbers(spec: SpecType, numbers: Mapping[PathParts, Given]) -> SpecType:
    """Give a table like this one with other quantities, unchecked.

    Parameters
    ----------
    spec : Spec
    numbers : mapping
        By where they stand, as `numbers_of` says it.

    Returns
    -------
    Spec
        What none of them is in, is shared with `spec`.

    Examples
    --------
    >>> from cranktrain.layout.bodies import BodySpec
    >>> light = BodySpec(mass="2 kg")
    >>> with_numbers(light, {("mass",): Given(3.0, "3 kg")}).mass.si
    3.0
    """
    return cast("SpecType", _with_numbers(spec, numbers))


def _with_numbers(value: Any, numbers: Mapping[PathParts, Given]) -> Any:
    if () in numbers:
        return numbers[()]
    within = grouped((where[0], (where[1:], given)) for where, given in numbers.items())
    items = {key: _with_numbers(item, dict(within[key])) for key, item in items_of(value) if key in within}
    if isinstance(value, Spec):
        return BaseModel.model_copy(value, update=cast("dict[str, Any]", items))
    if isinstance(value, Mapping):
        return {**cast("Mapping[str, Any]", value), **items}
    return tuple(items.get(place, item) for place, item in items_of(value))


def as_columns(spec: SpecType, columns: Mapping[PathParts, Array], n_designs: int) -> SpecType:
    """Put designs together of which one table and the numbers that differ are known.

    Parameters
    ----------
    spec : Spec
        The table in the first of them.
    columns : mapping of Array, shape (design,)
        Numbers in SI, by where they stand, as `numbers_of` says it.
    n_designs : int

    Returns
    -------
    Spec
        As `in_columns` gives of the table in each design.

    Examples
    --------
    >>> from cranktrain.layout.bodies import BodySpec
    >>> both = as_columns(BodySpec(mass="2 kg"), {("mass",): np.array([2.0, 3.0])}, 2)
    >>> both.mass.array
    array([2., 3.])
    """
    found = {
        where: replace(given, column=columns[where] if where in columns else np.full(n_designs, given.si))
        for where, given in numbers_of(spec)
    }
    return with_numbers(spec, found)


def n_rows(spec: Spec) -> int:
    """How many designs stand together in a table; 1 where no number is a column."""
    return next((column.size for column in _columns(spec)), 1)


def row_of(spec: SpecType, design: int) -> SpecType:
    """Give the table of one design of those that stand together in one."""
    return cast("SpecType", _changed(spec, lambda one: _number_of(one, design)))


def some_rows(spec: SpecType, rows: slice) -> SpecType:
    """Give some of the designs that stand together in a table, together."""
    return cast("SpecType", _changed(spec, lambda one: _some_of(one, rows)))


def _some_of(given: Given, rows: slice) -> Given:
    if given.column is None:
        return given
    column = given.column[rows]
    return replace(given, si=float(column[0]), column=column)


def _columns(value: object) -> Iterator[Array]:
    if isinstance(value, Given):
        yield from () if value.column is None else (value.column,)
    elif isinstance(value, Spec):
        for name in type(value).model_fields:
            yield from _columns(getattr(value, name))
    elif isinstance(value, Mapping | tuple):
        items = cast("Mapping[str, object] | tuple[object, ...]", value)
        for item in items.values() if isinstance(items, Mapping) else items:
            yield from _columns(item)


def _number_of(given: Given, design: int) -> Given:
    return given if given.column is None else replace(given, si=float(given.column[design]), column=None)


def _changed(value: Any, change: Callable[[Given], Given]) -> Any:
    """Copy a table with every quantity changed."""
    if isinstance(value, Given):
        return change(value)
    if isinstance(value, Spec):
        return _copied(value, lambda name: _changed(getattr(value, name), change))
    if isinstance(value, Mapping):
        return {name: _changed(item, change) for name, item in cast("Mapping[str, Any]", value).items()}
    if isinstance(value, tuple):
        return tuple(_changed(item, change) for item in cast("tuple[Any, ...]", value))
    return value


def _copied(spec: Spec, field: Callable[[str], object]) -> Spec:
    """Copy a spec with other fields, unchecked: each design was."""
    fields = {name: field(name) for name in type(spec).model_fields}
    return cast("Spec", BaseModel.model_copy(spec, update=fields))
