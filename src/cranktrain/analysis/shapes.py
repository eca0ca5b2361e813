"""Arrays of results held against the dimensions that they declare, before anybody reads them by these."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache
from operator import attrgetter
from typing import Any, NamedTuple

import numpy as np

from cranktrain.saying.catalogue import Entry, entries


def refuse_misshapen(outcomes: Iterable[object], labels: Mapping[str, Sequence[str]], n_angles: int) -> None:
    """Refuse results whose arrays have other shapes than they declare.

    Parameters
    ----------
    outcomes : iterable of result objects
    labels : mapping of str to sequence of str
        Names along each dimension, the designs' too.
    n_angles : int
        Crank angles of the grid.

    Raises
    ------
    TypeError
        With the first such quantity: a stage is wrong, or what its result class says.
    """
    for outcome in outcomes:
        quantities, dimensions = _declared(type(outcome))
        if not quantities:
            continue
        lengths = {name: len(labels[name]) for name in dimensions if name in labels} | {"crank_angle": n_angles}
        for entry, read, axes in quantities:
            found = read(outcome)
            shape: tuple[int, ...] = getattr(found, "shape", None) or np.shape(found)
            if shape != tuple(map(lengths.get, axes)):
                raise TypeError(_contradiction(type(outcome), entry, shape, lengths))


class _Declared(NamedTuple):
    """Quantities of a class of results, each with what reads its array and with its axes; and all axes of these."""

    quantities: Sequence[tuple[Entry, Callable[[object], Any], tuple[str, ...]]]
    axes: frozenset[str]


@cache
def _declared(outcome: type) -> _Declared:
    """Say what a class of results declares."""
    each = [(entry, attrgetter(entry.path), ("design", *entry.dimensions)) for entry in entries(outcome)]
    return _Declared(each, frozenset(axis for _entry, _read, axes in each for axis in axes))


def _contradiction(outcome: type, entry: Entry, shape: tuple[int, ...], lengths: Mapping[str, int]) -> str:
    """Say of a quantity which shape its array has, and which it declares."""
    axes = ", ".join(f"{name} ({lengths.get(name, 'no labels')})" for name in ("design", *entry.dimensions))
    return (
        f"{outcome.__name__}.{entry.path}, the quantity {entry.name}, has the shape {shape}, but is declared along "
        f"{axes}. Its stage must give an axis for each of these, in this order, "
        "or the class and its labels name the axes that it gives."
    )
