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
