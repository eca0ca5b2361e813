"""Geometry of mechanisms of one kind: put into one, mirrored, some of it taken, a length of it changed."""

from collections.abc import Sequence
from functools import reduce
from typing import TypeVar, cast

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.nested import filled, leaves, mapped

Geometry = TypeVar("Geometry", bound=tuple[object, ...])

_MIRRORED = frozenset(
    {
        *("offset", "shift", "y", "articulation_angle", "bank_angle", "slot_angle", "direction", "ahead", "side"),
        *("arm_direction", "angle", "across", "moment"),
    }
)
"""What changes sign when the mechanism's y is mirrored: what counts toward +y or in the sense of rotation."""


def mirrored(geometry: Geometry) -> Geometry:
    """Give geometry, bodies or loads seen with y reversed, as a machine that runs astern sees the same metal."""
    return mapped(lambda name, value: -value if name.rpartition(".")[2] in _MIRRORED else value, geometry)


def stacked(geometries: Sequence[Sequence[Geometry]]) -> Geometry:
    """Stack geometries [design][member] of floats into one of arrays, shape (design, member, 1)."""
    numbers = np.array([[leaves(member) for member in design] for design in geometries], dtype=float)
    return filled(geometries[0][0], iter(np.ascontiguousarray(np.moveaxis(numbers, -1, 0))[..., np.newaxis]))


def named_part(geometry: tuple[object, ...], name: str) -> Array:
    """Give one part of a nested geometry by its dotted name."""
    return cast(Array, reduce(_part, name.split("."), cast(object, geometry)))


def _part(geometry: object, name: str) -> object:
    """Give one part by its name, or of a plain tuple by its place."""
    return cast("tuple[object, ...]", geometry)[int(name)] if name.isdecimal() else getattr(geometry, name)


def rows(geometry: Geometry, index: NDArray[np.intp]) -> Geometry:
    """Take some of a geometry's mechanisms, counted through all its axes: arrays of shape (*index.shape, 1)."""
    return mapped(lambda _name, value: value.reshape(-1, 1)[index], geometry)
