"""Who has the largest or the smallest of some values, by a rule where several are alike: the first of them.

Which of two values that should be equal is the larger one, rounding decides, and it does so otherwise on another
processor. So whatever becomes a name, a place or an angle is chosen here; a value itself is `np.max` or `np.min`.
"""

from collections.abc import Callable, Iterable
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from cranktrain.motion import Array

ALIKE = 1e-9
"""Values that differ by less, in parts of the largest size of them all, are one."""

One = TypeVar("One")


def first_largest(values: ArrayLike) -> int:
    """Place of the largest of some values, flattened; of alike ones the first.

    Parameters
    ----------
    values : array_like
        NaN is never chosen beside what is known.

    Returns
    -------
    int

    Examples
    --------
    >>> first_largest([1.0, 3.0 - 1e-12, np.nan, 3.0])
    1
    """
    return int(first_largest_along(np.ravel(np.asarray(values))))


def first_smallest(values: ArrayLike) -> int:
    """Place of the smallest of some values, flattened; of alike ones the first. As `first_largest`.

    Examples
    --------
    >>> first_smallest([3.0, 1e-12, 0.0])
    1
    """
    return first_largest(-np.asarray(values, dtype=np.float64))


def first_largest_along(values: ArrayLike) -> NDArray[np.intp]:
    """Places of the largest values along the last axis, shape (..., n) to (...); of alike ones the first.

    Examples
    --------
    >>> first_largest_along(np.array([[1.0, 2.0], [2.0, 2.0 + 1e-12]])).tolist()
    [1, 0]
    """
    known = np.asarray(values, dtype=np.float64)
    sizes = np.where(np.isfinite(known), np.abs(known), 0.0)
    most = np.fmax.reduce(known, axis=-1, keepdims=True, initial=-np.inf)
    found: NDArray[np.intp] = np.argmax(known >= most - ALIKE * sizes.max(axis=-1, keepdims=True), axis=-1)
    return found


def first_smallest_along(values: ArrayLike) -> NDArray[np.intp]:
    """Places of the smallest values along the last axis, shape (..., n) to (...); of alike ones the first.

    Examples
    --------
    >>> first_smallest_along(np.array([[1.0, 2.0], [2.0, 2.0 - 1e-12]])).tolist()
    [0, 0]
    """
    return first_largest_along(-np.asarray(values, dtype=np.float64))


def largest_of(things: Iterable[One], size: Callable[[One], float]) -> One:
    """Thing of the largest size, of alike ones the first; there is one.

    Examples
    --------
    >>> largest_of(["ab", "cd", "e"], len)
    'ab'
    """
    known = list(things)
    return known[first_largest([size(one) for one in known])]


def smallest_of(things: Iterable[One], size: Callable[[One], float]) -> One:
    """Thing of the smallest size, of alike ones the first; there is one.

    Examples
    --------
    >>> smallest_of(["ab", "c", "d"], len)
    'c'
    """
    return largest_of(things, lambda one: -size(one))


def falling(values: ArrayLike) -> list[int]:
    """Places of some values, flattened, by falling size; alike ones stay in their order, and NaN comes last.

    Examples
    --------
    >>> falling([1.0, 2.0, 2.0 + 1e-12, 3.0])
    [3, 1, 2, 0]
    """
    sizes = np.ravel(np.asarray(values, dtype=np.float64))
    alike = ALIKE * float(np.max(np.abs(sizes), where=np.isfinite(sizes), initial=0.0))
    groups: list[list[int]] = []
    for place in np.argsort(-sizes, kind="stable").tolist():
        if groups and sizes[place] >= sizes[groups[-1][0]] - alike:
            groups[-1].append(place)
        else:
            groups.append([place])
    return [place for group in groups for place in sorted(group)]


def largest_first(things: Iterable[One], size: Callable[[One], float]) -> list[One]:
    """Things by falling size; alike ones stay in their order.

    Examples
    --------
    >>> largest_first(["a", "bcd", "ef", "gh"], len)
    ['bcd', 'ef', 'gh', 'a']
    """
    known = list(things)
    return [known[place] for place in falling([size(one) for one in known])]


def without_residue(values: Array, scale: ArrayLike) -> Array:
    """Values of which those are 0 that are nothing but rounding beside what they are made of.

    Examples
    --------
    >>> without_residue(np.array([2.0, -1e-8]), 100.0).tolist()
    [2.0, 0.0]
    """
    return np.where(np.abs(values) > ALIKE * np.asarray(scale), values, np.where(np.isnan(values), values, 0.0))
