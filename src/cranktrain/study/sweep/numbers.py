"""Values of one place of the file as numbers in SI: each read once, as a new machine reads it."""

from collections.abc import Sequence
from typing import NamedTuple, get_origin

import numpy as np
from numpy.typing import NDArray

from cranktrain.declared_types import bare, inner_of, quantity_of
from cranktrain.errors import InputError
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.paths import PathParts, item_at
from cranktrain.quantities import Given, Quantity
from cranktrain.spec import Spec
from cranktrain.study.sweep.typed import quantity_typed


class ReadValues(NamedTuple):
    """Values of one place of the file.

    Attributes
    ----------
    si : Array, shape (value,)
        NaN of those that cannot be read.
    is_right : array of bool, shape (value,)
        Whether they can, and lie within the limits of their field.
    """

    si: Array
    is_right: NDArray[np.bool_]


def unit_written(value: object) -> str | None:
    """Give the unit of what may be read as a quantity, right or wrong; None of a word, a list or a table."""
    if isinstance(value, str):
        number = quantity_typed(value)
        return None if number is None else number.unit
    return "" if isinstance(value, int | float) and not isinstance(value, bool) else None


def given_as(quantity: Quantity, value: object) -> Given | None:
    """Read a value; None where it is refused."""
    try:
        return quantity.given(value)
    except InputError:
        return None


def read_values(quantity: Quantity, values: Sequence[object]) -> ReadValues:
    """Read values as a field does.

    Parameters
    ----------
    quantity : Quantity
        What the field declares.
    values : sequence of object
        Texts and numbers.

    Returns
    -------
    ReadValues
    """
    if all(type(value) is float for value in values):
        return _read_plain(quantity, np.array(values, dtype=float))
    si = np.full(len(values), np.nan)
    for place, value in enumerate(values):
        given = given_as(quantity, value)
        si[place] = np.nan if given is None else given.si
    return ReadValues(si, ~np.isnan(si))


def _read_plain(quantity: Quantity, values: Array) -> ReadValues:
    """Read numbers without a unit: where none is needed they are their own values, once read."""
    if quantity.dimension.needs_unit:
        return ReadValues(np.full(values.size, np.nan), np.zeros(values.size, dtype=bool))
    is_right = quantity.allows(values)
    # −0.0 is read as 0.0.
    return ReadValues(np.where(is_right, values + 0.0, np.nan), is_right)


def quantity_at(machine: Machine, where: PathParts) -> Quantity | None:
    """As what a number of the tables is read; None where that is not to be told."""
    above = max(n for n in range(len(where)) if isinstance(item_at(machine, where[:n]), Spec))
    table, (name, *items) = item_at(machine, where[:above]), where[above:]
    assert isinstance(table, Spec)
    assert isinstance(name, str)
    field = type(table).model_fields[name]
    declared = bare(field.annotation, tuple(field.metadata))
    for item in items:
        kind = tuple if isinstance(item, int) else dict
        fitting = [one for one in (declared.alternatives or (declared.annotation,)) if _holds(one, kind)]
        if len(fitting) != 1:
            return None
        declared = bare(inner_of(bare(fitting[0]).annotation, item))
    found = quantity_of(declared.annotation) or next((one for one in declared.marks if isinstance(one, Quantity)), None)
    return None if found is None else found.of_field(name)


def _holds(annotation: object, kind: type) -> bool:
    """Whether a declared type is a list, or a table by names."""
    origin = get_origin(bare(annotation).annotation)
    return origin is tuple if kind is tuple else origin not in (tuple, None)


def bits(numbers: Array) -> NDArray[np.int64]:
    """Numbers by their bits: what is equal in them is the same number, to the last one."""
    return np.asarray(numbers, dtype=np.float64).view(np.int64)
