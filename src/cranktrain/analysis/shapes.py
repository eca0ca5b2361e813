"""Arrays of results held against the dimensions that they declare, before anybody reads them by these."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache
from operator import attrgetter
from typing import Any, TypeAlias

import numpy as np

from cranktrain.grouping import grouped
from cranktrain.saying.catalogue import Entry, entries

_ANGLES = "crank_angle"


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
        for axes, quantities in _declared(type(outcome)):
            lengths = [n_angles if axis == _ANGLES else len(labels[axis]) if axis in labels else None for axis in axes]
            expected = tuple(lengths)
            for entry, read in quantities:
                found = read(outcome)
                shape: tuple[int, ...] = getattr(found, "shape", None) or np.shape(found)
                if shape != expected:
                    raise TypeError(_contradiction(type(outcome), entry, shape, dict(zip(axes, lengths, strict=True))))


_Along: TypeAlias = tuple[tuple[str, ...], Sequence[tuple[Entry, Callable[[object], Any]]]]
"""Axes, and the quantities along them, each with what reads its array."""


@cache
def _declared(outcome: type) -> Sequence[_Along]:
    """Say what a class of results declares."""
    readers = ((entry.dimensions, (entry, attrgetter(entry.path))) for entry in entries(outcome))
    return [(("design", *dimensions), quantities) for dimensions, quantities in grouped(readers).items()]


def _contradiction(outcome: type, entry: Entry, shape: tuple[int, ...], lengths: Mapping[str, int | None]) -> str:
    """Say of a quantity which shape its array has, and which it declares."""
    axes = ", ".join(f"{name} ({'no labels' if length is None else length})" for name, length in lengths.items())
    return (
        f"{outcome.__name__}.{entry.path}, the quantity {entry.name}, has the shape {shape}, but is declared along "
        f"{axes}. Its stage must give an axis for each of these, in this order, "
        "or the class and its labels name the axes that it gives."
    )
