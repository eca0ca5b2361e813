"""Numbers of several designs as arrays: put together with the design first, and those of some designs taken.

A number that the file has in columns is one, or an array of shape (design,). Here it becomes one of an array whose
first axis is the design, of however many there are; what stands behind this knows no other shape.
"""

from collections.abc import Callable, Sequence
from typing import Any, TypeVar, cast, overload

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.nested import Nested, each_changed, filled, leaves

Numbers = TypeVar("Numbers", bound=tuple[object, ...])

_SINGLE = frozenset({float, np.float64})
"""Types of what is one number, whatever design it is of."""


@overload
def by_design(numbers: Sequence[Array | float], n_designs: int) -> Array: ...
@overload
def by_design(numbers: Sequence[Nested], n_designs: int) -> Nested: ...
def by_design(numbers: Sequence[Any], n_designs: int) -> Any:
    """Put numbers of members together.

    Parameters
    ----------
    numbers : sequence
        Of each member one number, or an array of shape (design,); or nested tuples of such.
    n_designs : int

    Returns
    -------
    Array, shape (design, member); or nested tuples of arrays of shape (design, member, 1), as kernels take them
        What is no number, as a card, in an array of objects.

    Examples
    --------
    >>> by_design([1.0, np.array([2.0, 3.0])], 2)
    array([[1., 2.],
           [1., 3.]])
    """
    if numbers and isinstance(numbers[0], tuple):
        members = cast("Sequence[tuple[object, ...]]", numbers)
        # Members that are alike are often one object.
        different = {id(member): member for member in members}
        listed = {key: leaves(member) for key, member in different.items()}
        rows = [listed[id(member)] for member in members]
        if all({*map(type, own)} <= _SINGLE for own in listed.values()):
            table = np.empty((len(rows[0]), n_designs, len(rows), 1))
            table[..., 0] = np.array(rows).T[:, np.newaxis]
            return filled(members[0], iter(table))
        columns = zip(*rows, strict=True)
        return filled(members[0], (_columns(column, n_designs)[..., np.newaxis] for column in columns))
    return _columns(numbers, n_designs)


def _columns(numbers: Sequence[Any], n_designs: int) -> Any:
    """Put single numbers, or arrays of shape (design,), side by side."""
    if {*map(type, numbers)} <= _SINGLE:
        found = np.empty((n_designs, len(numbers)))
        found[:] = numbers
        return found
    is_number = all(np.asarray(number).dtype.kind in "biuf" for number in numbers)
    found = np.empty((n_designs, len(numbers)), dtype=np.float64 if is_number else np.object_)
    for member, number in enumerate(numbers):
        found[:, member] = number
    return found


def of_designs(parts: Nested, designs: NDArray[np.intp]) -> Nested:
    """Take arrays of some designs, which is their first axis; whole numbers and truths are of all.

    Examples
    --------
    >>> of_designs((np.array([[1.0], [2.0], [3.0]]), np.array([4, 5])), np.array([0, 2]))
    (array([[1.],
           [3.]]), array([4, 5]))
    """

    def taken(value: Array) -> Array:
        return value[designs] if isinstance(cast(object, value), np.ndarray) and value.dtype.kind == "f" else value

    return each_changed(taken, parts)


def over_designs(find: Callable[[Numbers], Nested], numbers: Numbers) -> Nested:
    """Find numbers of each design by itself, where what finds them takes one design.

    Parameters
    ----------
    find : callable (numbers) → NamedTuple of numbers
    numbers : NamedTuple of numbers or arrays of shape (design,)

    Returns
    -------
    NamedTuple of numbers, or of arrays of shape (design,) where any was one
    """
    shape = np.broadcast_shapes(*(np.shape(leaf) for leaf in leaves(numbers)))
    if not shape:
        return find(numbers)
    columns = [np.broadcast_to(leaf, shape) for leaf in leaves(numbers)]
    each = [find(filled(numbers, iter(own))) for own in zip(*columns, strict=True)]
    return filled(each[0], iter(np.array([leaves(one) for one in each], dtype=float).T))
