"""Matrices of two rows, for the two directions across a shaft, and band systems of them.

All is elementwise in designs and angles. Matrices have the shape (..., 2, 2, angle), vectors (..., 2, angle);
either may have a single angle.
"""

from collections.abc import Mapping, Sequence

import numpy as np

from cranktrain.motion import Array


def applied(matrix: Array, vector: Array) -> Array:
    """Matrix times vector."""
    return matrix[..., :, 0, :] * vector[..., 0:1, :] + matrix[..., :, 1, :] * vector[..., 1:2, :]


def product(one: Array, other: Array) -> Array:
    """Matrix times matrix."""
    return one[..., :, 0:1, :] * other[..., 0:1, :, :] + one[..., :, 1:2, :] * other[..., 1:2, :, :]


def transposed(matrix: Array) -> Array:
    """Rows as columns."""
    return np.swapaxes(matrix, -3, -2)


def inverse(matrix: Array) -> Array:
    """Inverse of a matrix that has one; else not finite."""
    determinant = matrix[..., 0, 0, :] * matrix[..., 1, 1, :] - matrix[..., 0, 1, :] * matrix[..., 1, 0, :]
    adjugate = np.empty_like(matrix)
    adjugate[..., 0, 0, :], adjugate[..., 1, 1, :] = matrix[..., 1, 1, :], matrix[..., 0, 0, :]
    adjugate[..., 0, 1, :], adjugate[..., 1, 0, :] = -matrix[..., 0, 1, :], -matrix[..., 1, 0, :]
    return adjugate / determinant[..., np.newaxis, np.newaxis, :]


def turned_by(vector: Array, angle: Array) -> Array:
    """Vectors, shape (design, ..., 2, angle), in axes that are turned by an angle, shape (design, angle)."""
    between = (slice(None), *(np.newaxis,) * (vector.ndim - 3))
    cos, sin = np.cos(angle)[between], np.sin(angle)[between]
    one, other = vector[..., 0, :], vector[..., 1, :]
    return np.stack([cos * one + sin * other, cos * other - sin * one], axis=-2)


def band_solution(matrices: Mapping[tuple[int, int], Array], right: Sequence[Array]) -> list[Array]:
    """Solve a symmetric positive definite system of blocks by elimination, which needs no exchange of rows.

    Parameters
    ----------
    matrices : mapping of (row, column) to Array, shape (design, 2, 2, angle or 1)
        Blocks on and above the diagonal; those that are not there are 0.
    right : sequence of Array, shape (design, 2, angle)

    Returns
    -------
    list of Array, shape (design, 2, angle)
    """
    rest, values = dict(matrices), list(right)
    inverses: list[Array] = []
    for pivot in range(len(values)):
        inverses.append(inverse(rest[pivot, pivot]))
        below = [row for row in range(pivot + 1, len(values)) if (pivot, row) in rest]
        for row in below:
            factor = product(transposed(rest[pivot, row]), inverses[pivot])
            values[row] = values[row] - applied(factor, values[pivot])
            for column in below:
                if column >= row:
                    change = product(factor, rest[pivot, column])
                    rest[row, column] = rest[row, column] - change if (row, column) in rest else -change
    for pivot in reversed(range(len(values))):
        for column in range(pivot + 1, len(values)):
            if (pivot, column) in rest:
                values[pivot] = values[pivot] - applied(rest[pivot, column], values[column])
        values[pivot] = applied(inverses[pivot], values[pivot])
    return values
