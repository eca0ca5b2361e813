"""Arrays in nested NamedTuples, as kernels take geometry and give motions: listed, or each changed, by its name too."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, TypeVar, cast

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.gathering import in_even_steps

Nested = TypeVar("Nested", bound=tuple[object, ...])


def mapped(change: Callable[[str, Array], Array], parts: Nested, above: str = "") -> Nested:
    """Change every array of nested tuples.

    Parameters
    ----------
    change : callable (name, array) → array
        The name is dotted, as in `master.rod_length`; of a plain tuple, the place: `legs.0.length`.
    parts : NamedTuple or tuple
        Of arrays, numbers, or further tuples.
    above : str
        What names begin with.

    Returns
    -------
    NamedTuple or tuple
        Of the same types.

    Examples
    --------
    >>> mapped(lambda name, value: -value if name == "1.0" else value, (1.0, (2.0, 3.0)))
    (1.0, (-2.0, 3.0))
    """
    names = cast("tuple[str, ...]", getattr(parts, "_fields", ())) or map(str, range(len(parts)))
    make = cast("Callable[[Iterable[object]], Nested]", getattr(parts, "_make", tuple))
    return make(
        mapped(change, cast("tuple[object, ...]", part), f"{above}{name}.")
        if isinstance(part, tuple)
        else change(f"{above}{name}", cast(Array, part))
        for name, part in zip(names, parts, strict=True)
    )


def each_changed(change: Callable[[Array], Array], parts: Nested) -> Nested:
    """Change every array of nested tuples, whatever its name: as `mapped`, in less time.

    Examples
    --------
    >>> each_changed(lambda value: -value, (1.0, (2.0, 3.0)))
    (-1.0, (-2.0, -3.0))
    """
    make = cast("Callable[[Iterable[object]], Nested]", getattr(parts, "_make", tuple))
    each = cast("tuple[Any, ...]", parts)
    return make(
        [
            each_changed(change, cast("tuple[object, ...]", part)) if isinstance(part, tuple) else change(part)
            for part in each
        ]
    )


def leaves(parts: tuple[object, ...]) -> list[Array]:
    """List all arrays of nested tuples, in order."""
    found: list[Array] = []
    for part in cast("tuple[Any, ...]", parts):
        if isinstance(part, tuple):
            found += leaves(cast("tuple[object, ...]", part))
        else:
            found.append(part)
    return found


def side_by_side(found: Sequence[tuple[NDArray[np.intp], Nested]], shape: tuple[int, ...]) -> Nested:
    """Join nested tuples of arrays, each at its places along the axis after the design's, to arrays of that shape."""
    columns = np.empty((len(leaves(found[0][1])), *shape))
    for places, parts in found:
        put(columns, places, leaves(parts))
    return filled(found[0][1], iter(columns))


def put(of_all: Iterable[Array], place: NDArray[np.intp], values: Iterable[Array]) -> None:
    """Put curves of some, each of shape (design, one, ...), at their places in those of all, which are changed."""
    there = in_even_steps(place.tolist())
    for whole, part in zip(of_all, values, strict=True):
        whole[:, there] = part


def filled(parts: Nested, arrays: Iterator[Array]) -> Nested:
    """Put other arrays into nested tuples, in order."""
    return each_changed(lambda _value: next(arrays), parts)
