"""Integral of a vector's size: near where it is next to nothing its size turns sharply, which Gauss's points miss."""

from collections.abc import Sequence
from functools import cache

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.products import product
from cranktrain.numerics.subintervals import Subintervals, interpolation, leggauss, to_series

_SHOWN = 1e-8
"""Last orders of a size in a panel, in parts of its largest: the integral is then far nearer, if none is by chance."""
_MOST_HALVINGS = 40


def integral_of_size(of: Subintervals, parts: Sequence[Array]) -> Array:
    """Integrate the size of vectors over one period.

    Parameters
    ----------
    of : Subintervals
    parts : sequence of Array, shape (curve, point)
        Parts of each vector at the panels' points.

    Returns
    -------
    Array, shape (curve,)
        To rounding of what the panels know of the vectors; NaN for a vector that is NaN anywhere.

    Notes
    -----
    Between a panel's points a vector is their polynomial. Panels are halved where its size is none that they show, and
    where the vector may come next to nothing between points: of a sharp turn there last orders may be small by chance.

    Examples
    --------
    A vector that goes to and fro, and passes nothing by a hair:

    >>> from cranktrain.numerics.subintervals import subintervals
    >>> cut = subintervals(np.array([0.3]), 1.0, 2 * np.pi)
    >>> found = integral_of_size(cut, [np.cos(cut.angle)[np.newaxis], np.full((1, cut.angle.size), 1e-9)])
    >>> np.round(found, 9).tolist()
    [4.0]
    """
    vectors = np.stack(parts)
    n_curves = vectors.shape[1]
    largest = np.max(_size(vectors), axis=-1)
    total = np.zeros(n_curves)
    for n_nodes in np.unique(of.size).tolist():
        own = np.flatnonzero(of.size == n_nodes)
        curve: NDArray[np.intp] = np.repeat(np.arange(n_curves, dtype=np.intp), own.size)
        half: Array = np.tile(of.width[own] / 2, n_curves)
        vector = vectors[..., of.first[own, np.newaxis] + np.arange(n_nodes)].reshape(len(vectors), -1, n_nodes)
        weight, halves = leggauss(n_nodes)[1], _halves(n_nodes)
        for n_halvings in range(_MOST_HALVINGS + 1):
            size = _size(vector)
            last = np.max(np.abs(product(size, to_series(n_nodes)[-2:].T)), axis=-1)
            is_sharp = (last > _SHOWN * largest[curve]) | _may_vanish(vector, _SHOWN * largest[curve])
            is_sharp &= n_halvings < _MOST_HALVINGS
            total += np.bincount(curve, np.where(is_sharp, 0.0, half * product(size, weight)), n_curves)
            if not np.any(is_sharp):
                break
            curve, half = np.repeat(curve[is_sharp], 2), np.repeat(half[is_sharp] / 2, 2)
            vector = product(vector[:, is_sharp], halves).reshape(len(vectors), -1, n_nodes)
    return total


def _may_vanish(vector: Array, shown: Array) -> NDArray[np.bool_]:
    """Whether a vector changes by more than its size from a point of a panel, or an end, to the next: it may vanish.

    Shapes (part, panel, n) and (panel,); where the vector is less on both sides than is shown, that is no matter.
    """
    ends = product(vector, _at_ends(vector.shape[-1]))
    along = np.concatenate([ends[..., :1], vector, ends[..., 1:]], axis=-1)
    size, change = _size(along), _size(np.diff(along, axis=-1))
    before, after = size[:, :-1], size[:, 1:]
    is_near = (change > np.minimum(before, after)) & (np.maximum(before, after) > shown[:, np.newaxis])
    return np.any(is_near, axis=-1)


def _size(vectors: Array) -> Array:
    """Size of vectors by their parts, along the first axis."""
    return np.sqrt(np.sum(vectors * vectors, axis=0))


@cache
def _at_ends(n_nodes: int) -> Array:
    """From values at a panel's points to those at its ends, shape (n, 2)."""
    return interpolation(np.array([-1.0, 1.0]), n_nodes).T


@cache
def _halves(n_nodes: int) -> Array:
    """From values at a panel's points to those at the points of both of its halves, shape (n, 2n)."""
    node = leggauss(n_nodes)[0]
    return interpolation(np.concatenate([(node - 1) / 2, (node + 1) / 2]), n_nodes).T
