"""Products of matrices on the thread that calls.

BLAS shares a large product out among threads, which then spin for a while beside whatever comes next. Those of a run
are too small to gain by it, and some are large enough for it: they are done a block at a time, each for one thread.
"""

from collections.abc import Iterator
from math import isqrt
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array

Number = TypeVar("Number", np.float64, np.complex128)

_MOST = 2**17
"""Multiplications in a block: OpenBLAS shares out twice as many, or more of them as versions go."""
_MOST_OF_VECTOR = 2**13
"""The same where a block is one row or one column: of these it shares out 9216."""
_FEW, _MOST_FEW = 16, 4
"""Columns that BLAS does not part, on any processor, and how many times as many stand in a block at most."""


def product(rows: NDArray[Number], matrix: NDArray[Number]) -> NDArray[Number]:
    """Product of rows and a matrix, as `@` has it.

    Parameters
    ----------
    rows : Array, shape (..., m, k) or (k,)
    matrix : Array, shape (..., k, n) or (k,)

    Returns
    -------
    Array, shape (..., m, n)
        Without the axis that one of them has not.

    Examples
    --------
    >>> product(np.ones((3, 2)), np.array([[1.0, 2.0], [3.0, 4.0]]))[0]
    array([4., 6.])
    """
    if matrix.ndim == 1:
        return product(rows, matrix[:, np.newaxis])[..., 0]
    if rows.ndim == 1:
        return product(rows[np.newaxis], matrix)[..., 0, :]
    n_rows, (n_terms, n_columns) = rows.shape[-2], matrix.shape[-2:]
    stack = np.broadcast_shapes(rows.shape[:-2], matrix.shape[:-2])
    found = np.empty((*stack, n_rows, n_columns), dtype=rows.dtype)
    # One row of a block, or one column, may be left over: neither may be too much by itself.
    longest = max(1, _MOST_OF_VECTOR // n_terms)
    wide = min(n_columns, longest, isqrt(_MOST // n_terms))
    tall = min(longest, _MOST // (n_terms * wide))
    for row in _blocks(n_rows, tall):
        for column in _blocks(n_columns, wide):
            np.matmul(rows[..., row, :], matrix[..., column], out=found[..., row, column])
    return found


def product_by_columns(matrix: Array, columns: Array) -> Array:
    """Product of a matrix and columns, each to the last bit the same whatever stands beside it.

    BLAS does what is left over behind the last whole few columns on another way, with other rounding: these are filled
    up to whole blocks.

    Parameters
    ----------
    matrix : Array, shape (..., m, k)
    columns : Array, shape (..., k, n)

    Returns
    -------
    Array, shape (..., m, n)
    """
    n_rows, n_terms, n_columns = (*matrix.shape[-2:], columns.shape[-1])
    wide = _FEW * max(1, min(_MOST_FEW, _MOST // (_FEW * n_terms * n_rows)))
    n_blocks = -(-n_columns // wide)
    filled = np.zeros((*columns.shape[:-1], n_blocks * wide))
    filled[..., :n_columns] = columns
    blocks = np.swapaxes(filled.reshape(*columns.shape[:-1], n_blocks, wide), -3, -2)
    tall = max(1, _MOST // (n_terms * wide))
    rows = [np.matmul(matrix[..., np.newaxis, row, :], blocks) for row in _blocks(n_rows, tall)]
    found = np.swapaxes(np.concatenate(rows, axis=-2), -3, -2)
    return found.reshape(*found.shape[:-2], n_blocks * wide)[..., :n_columns]


def summed_products(left: Array, right: Array) -> Array:
    """Sum over all rows of the products of each left one's members with each right one's, leftᵀ right.

    Parameters
    ----------
    left : Array, shape (k, m)
    right : Array, shape (k, n)

    Returns
    -------
    Array, shape (m, n)
    """
    found = np.zeros((left.shape[1], right.shape[1]))
    tall = max(1, _MOST_OF_VECTOR // max(left.shape[1], right.shape[1]))
    for row in _blocks(len(left), tall):
        found += product(left[row].T, right[row])
    return found


def _blocks(whole: int, part: int) -> Iterator[slice]:
    """Blocks that together are the whole."""
    return (slice(first, first + part) for first in range(0, whole, part))
