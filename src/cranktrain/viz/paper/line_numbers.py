"""Where lines of equal value have their numbers: clear of other lines, of other numbers, of what is hatched."""

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array

_APART = 4.0
"""Between two points of a line at which its number may stand. [pixel]"""
_BESIDE, _STRAIGHT = 4, 0.97
"""So many points on either side a number takes; how long they are in a straight line where it hides no corner."""
_FAR = 40.0
"""From which distance on nothing crowds. [pixel]"""


def number_places(lines: Sequence[Sequence[Array]], hatched: Array, corners: Array, half_size: Array) -> list[Array]:
    """Give a place for the number of each line that has room for one.

    Parameters
    ----------
    lines : sequence of sequence of Array, shape (point, 2)
        The pieces of each line. [pixel]
    hatched : Array, shape (cell, 2, 2)
        Lower and upper corners of cells that no number may stand on. [pixel]
    corners : Array, shape (2, 2)
        Of the map. [pixel]
    half_size : Array, shape (2,)
        Half the width and half the height of a number. [pixel]

    Returns
    -------
    list of Array, shape (2,)
        Of one that has no room none. [pixel]
    """
    dense = [_dense(pieces) for pieces in lines]
    found: list[Array] = []
    width, height = half_size
    for own, points in enumerate(dense):
        others = np.concatenate([np.empty((0, 2)), *(each for place, each in enumerate(dense) if place != own)])
        clear = np.minimum.reduce(
            [
                _distance(points, others) - height,
                _outside(points, hatched) - width,
                np.min(np.minimum(points - corners[0], corners[1] - points), axis=1) - width,
                _distance(points, np.reshape(found, (-1, 2))) - 2 * width,
                np.full(len(points), _FAR),
            ]
        )
        clear[_is_bent(points)] -= _FAR
        if len(points) and np.max(clear) > 0:
            best = np.flatnonzero(clear >= np.max(clear) - 1e-9)
            found.append(points[best[len(best) // 2]])
    return found


def _dense(pieces: Iterable[Array]) -> Array:
    """Points along the pieces of a line, evenly."""
    along = [np.empty((0, 2))]
    for piece in pieces:
        lengths = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(piece, axis=0).T))])
        whole = float(lengths[-1])
        at = np.linspace(0.0, whole, max(int(whole / _APART), 2))
        along.append(np.column_stack([np.interp(at, lengths, piece[:, axis]) for axis in (0, 1)]))
    return np.concatenate(along)


def _is_bent(points: Array) -> NDArray[np.bool_]:
    """Where a number would hide a corner of its line."""
    bent = np.zeros(len(points), dtype=bool)
    if len(points) > 2 * _BESIDE:
        chord = np.hypot(*(points[2 * _BESIDE :] - points[: -2 * _BESIDE]).T)
        bent[_BESIDE:-_BESIDE] = chord < _STRAIGHT * 2 * _BESIDE * _APART
    return bent


def _distance(points: Array, others: Array) -> Array:
    """How far the nearest of others is."""
    if not len(others):
        return np.full(len(points), np.inf)
    return np.array([np.min(np.hypot(*(others - point).T)) for point in points])


def _outside(points: Array, cells: Array) -> Array:
    """How far the nearest cell is; 0 within one."""
    if not len(cells):
        return np.full(len(points), np.inf)
    beyond = [np.maximum(np.maximum(cells[:, 0] - point, point - cells[:, 1]), 0.0) for point in points]
    return np.array([np.min(np.hypot(*one.T)) for one in beyond])
