"""Geometry of mechanisms of one kind: mirrored, some of it taken, a length of it changed."""

from collections.abc import Callable, Iterable
from functools import cache, reduce
from typing import TypeVar, cast, get_type_hints

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array, Handed
from cranktrain.numerics.nested import mapped

Geometry = TypeVar("Geometry", bound=tuple[object, ...])


def mirrored(geometry: Geometry) -> Geometry:
    """Give geometry seen with y reversed, as a machine that runs astern sees the same metal: `Handed` parts negated."""
    handed = handed_fields(type(geometry))
    names = cast("tuple[str, ...]", getattr(geometry, "_fields", ())) or ("",) * len(geometry)
    make = cast("Callable[[Iterable[object]], Geometry]", getattr(geometry, "_make", tuple))
    return make(
        mirrored(cast("tuple[object, ...]", part))
        if isinstance(part, tuple)
        else -cast(Array, part)
        if name in handed
        else part
        for name, part in zip(names, geometry, strict=True)
    )


@cache
def handed_fields(kind: type[tuple[object, ...]]) -> frozenset[str]:
    """Names of the fields of a geometry that are `Handed`."""
    hints = get_type_hints(kind, include_extras=True)
    return frozenset(name for name, hint in hints.items() if hint == Handed)


def named_part(geometry: tuple[object, ...], name: str) -> Array:
    """Give one part of a nested geometry by its dotted name."""
    return cast(Array, reduce(_part, name.split("."), cast(object, geometry)))


def _part(geometry: object, name: str) -> object:
    """Give one part by its name, or of a plain tuple by its place."""
    return cast("tuple[object, ...]", geometry)[int(name)] if name.isdecimal() else getattr(geometry, name)


def rows(geometry: Geometry, index: NDArray[np.intp]) -> Geometry:
    """Take some of a geometry's mechanisms, counted through all its axes: arrays of shape (*index.shape, 1)."""
    return mapped(lambda _name, value: value.reshape(-1, 1)[index], geometry)
