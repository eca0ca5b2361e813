"""Tables of several designs as one: the first design's, in which every number is a column of those of all."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, cast

import numpy as np
from pydantic import BaseModel

from cranktrain.motion import Array
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


def n_rows(spec: Spec) -> int:
    """How many designs stand together in a table; 1 where no number is a column."""
    return next((column.size for column in _columns(spec)), 1)


def row_of(spec: SpecType, design: int) -> SpecType:
    """Give the table of one design of those that stand together in one."""
    return cast("SpecType", _row_of(spec, design))


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


def _row_of(value: Any, design: int) -> Any:
    if isinstance(value, Given):
        return value if value.column is None else replace(value, si=float(value.column[design]), column=None)
    if isinstance(value, Spec):
        return _copied(value, lambda name: _row_of(getattr(value, name), design))
    if isinstance(value, Mapping):
        return {name: _row_of(item, design) for name, item in cast("Mapping[str, Any]", value).items()}
    if isinstance(value, tuple):
        return tuple(_row_of(item, design) for item in cast("tuple[Any, ...]", value))
    return value


def _copied(spec: Spec, field: Callable[[str], object]) -> Spec:
    """Copy a spec with other fields, unchecked: each design was."""
    fields = {name: field(name) for name in type(spec).model_fields}
    return cast("Spec", BaseModel.model_copy(spec, update=fields))
