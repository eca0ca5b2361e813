"""Where numbers that are varied stand in a machine's tables: found by designs that differ in one of them."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from cranktrain.columns import items_of, numbers_of
from cranktrain.errors import InputError
from cranktrain.machine import Machine
from cranktrain.paths import PathParts
from cranktrain.quantities import Given, Quantity
from cranktrain.record import record
from cranktrain.spec import Spec
from cranktrain.study.sweep.numbers import ReadValues, given_as, quantity_at
from cranktrain.study.sweep.varied import Varied

_TRIED = 6
"""Values of which some are to give tables that are right each by itself."""
_ENOUGH = 3
"""Designs by which it is found where numbers stand."""


@record
class NumberPlace:
    """Where the values of a path stand.

    Attributes
    ----------
    varied : Varied
    where : tuple of paths
        Of the quantities that have them: of a star one for each of its mechanisms.
    quantity : Quantity
        As which they are read.
    """

    varied: Varied
    where: tuple[PathParts, ...]
    quantity: Quantity

    @property
    def read(self) -> ReadValues:
        """All values, read."""
        return self.varied.read_as(self.quantity)


def designs_tried(start: Machine, varied: Varied, used: NDArray[np.intp]) -> list[tuple[object, Machine]]:
    """Give some values of a path, with designs in which these alone differ from one, and whose tables are right.

    Parameters
    ----------
    start : Machine
        With some value at the path.
    varied : Varied
    used : array of int
        Which of its values there are.
    """
    found: list[tuple[object, Machine]] = []
    for index in used[np.linspace(0, used.size - 1, min(_TRIED, used.size)).astype(np.intp)].tolist():
        value = varied.values[index]
        try:
            found.append((value, start.with_({varied.path: value})))
        except InputError:
            continue
        if len(found) == _ENOUGH:
            break
    return found


def are_numbers(start: Machine, tried: Sequence[tuple[object, Machine]]) -> bool:
    """Whether designs differ in quantities alone."""
    words = words_of(start)
    return all(words_of(design) == words for _value, design in tried)


def place_of(start: Machine, varied: Varied, tried: Sequence[tuple[object, Machine]]) -> NumberPlace | None:
    """Find where values stand, by designs that differ in them and in quantities alone.

    Returns
    -------
    NumberPlace or None
        None where it is not to be told for sure.
    """
    before = dict(numbers_of(start))
    numbers = [(value, dict(numbers_of(design))) for value, design in tried]
    where = tuple(at for at, given in before.items() if any(own[at] != given for _value, own in numbers))
    quantities = {quantity_at(start, at) for at in where}
    quantity = quantities.pop() if len(quantities) == 1 else None
    if quantity is None or any(own[at] != given_as(quantity, value) for value, own in numbers for at in where):
        return None
    return NumberPlace(varied, where, quantity)


def words_of(spec: Spec) -> tuple[object, ...]:
    """Give all of a table that is no quantity, with where it stands: tables in which it is alike differ in numbers."""
    return tuple(_words_of(spec, ()))


def _words_of(value: object, where: PathParts) -> Iterator[tuple[PathParts, object]]:
    if isinstance(value, Given):
        yield where, Given
        return
    items = tuple(items_of(value))
    if isinstance(value, Spec):
        yield where, (type(value), frozenset(value.model_fields_set))
    elif not items:
        yield where, dict if isinstance(value, Mapping) else value
    for key, item in items:
        yield from _words_of(item, (*where, key))
