"""Kinematic coefficients: a moving thing's position and its first two derivatives by the crank angle.

A mechanism with one degree of freedom moves by geometry alone; speed enters last:
velocity q′ω, acceleration q″ω² + q′ε.
"""

from collections.abc import Callable
from typing import Annotated, NamedTuple, TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]

Handed: TypeAlias = Annotated[Array, "handed"]
"""Geometry that counts toward +y or in the sense of rotation: seen with y reversed, the same metal has its negative."""


class Coefficient(NamedTuple):
    """A coordinate and its derivatives by the crank angle: [unit, unit/rad, unit/rad²]."""

    value: Array
    first: Array
    second: Array


class Point(NamedTuple):
    """A moving point in the mechanism's axes. [m]"""

    x: Coefficient
    y: Coefficient


class Link(NamedTuple):
    """A moving rigid link: its first pin, its direction from that pin to its second, and the direction's cosines."""

    origin: Point
    angle: Coefficient
    cos: Array
    sin: Array


def single(value: float) -> Array:
    """Take one number where arrays are asked for: kernels broadcast both alike."""
    return cast(Array, value)


def plain(value: Array | float) -> float:
    """Take a number of NumPy's as one of Python's, as `float` does; one that a sweep follows through rules stays so."""
    item: Callable[[], float] | None = getattr(value, "item", None)
    return float(value) if item is None else item()


def chosen(condition: NDArray[np.bool_], one: Array | float, other: Array | float) -> Array:
    """Take `one` where the condition holds and `other` elsewhere, of any shapes that broadcast.

    Kernels choose with this alone: compiled, a choice between numbers is a number, where `np.where` makes an array.
    """
    return np.where(condition, one, other)


ZERO, ONE = single(0.0), single(1.0)
"""For what is the same at every angle: an array would be computed with in vain."""
