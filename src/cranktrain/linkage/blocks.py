"""Long sweeps on NumPy: a kernel evaluated block by block, so that what it computes on the way stays in the cache."""

from collections.abc import Callable
from typing import TypeVar

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.nested import filled, leaves

Geometry = TypeVar("Geometry")
Motion = TypeVar("Motion", bound=tuple[object, ...])

BLOCK = 4096
"""Numbers of an array in one block; some eighty of these fit the cache of a processor core."""


def in_blocks(kernel: Callable[[Array, Geometry], Motion], angle: Array, geometry: Geometry) -> Motion:
    """Evaluate a mechanism's kernel over any number of angles, with the same numbers as in one call, in less time.

    Parameters
    ----------
    kernel : kernel (angle, geometry) → NamedTuple
    angle : Array, shape (..., n). [rad]
    geometry : NamedTuple, fields broadcastable to (..., 1)

    Returns
    -------
    NamedTuple, shape (..., n)
        As the kernel gives it.
    """
    n_angles = angle.shape[-1]
    first = kernel(angle[..., :BLOCK], geometry)
    if n_angles <= BLOCK:
        return first
    pieces = _arrays(first)
    # One array may stand in several places of a motion, as the crank pin does: it is filled once.
    whole = {id(piece): np.empty((*piece.shape[:-1], n_angles)) for piece in pieces}
    rows = [whole[id(piece)] for piece in pieces]
    distinct = list({id(piece): place for place, piece in enumerate(pieces)}.values())
    for start in range(0, n_angles, BLOCK):
        block = slice(start, start + BLOCK)
        motion = first if start == 0 else kernel(angle[..., block], geometry)
        values = _arrays(motion)
        for place in distinct:
            rows[place][..., block] = values[place]
    return filled(first, iter(rows))


def _arrays(motion: tuple[object, ...]) -> list[Array]:
    """List all arrays of a motion, in order."""
    return [np.atleast_1d(part) for part in leaves(motion)]
