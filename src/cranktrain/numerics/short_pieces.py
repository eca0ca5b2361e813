"""Curves between breaks as polynomials of few powers, each on a short piece of one of Gauss's panels."""

from collections.abc import Sequence
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.products import product
from cranktrain.numerics.subintervals import Subintervals, interpolation

N_POWERS = 7
"""Of a piece: what the panel's polynomial has beyond them there is less than some 1e-10 of it."""


class ShortPieces(NamedTuple):
    """Curves on pieces of panels.

    Attributes
    ----------
    powers : Array, shape (power, ..., piece)
        Coefficients of the rising powers of the way in [−1, 1] along a piece.
    half : Array, shape (piece,)
        Half the width of each. [rad]
    curve : array of int, shape (piece,)
        Which curve it belongs to.
    """

    powers: Array
    half: Array
    curve: NDArray[np.intp]


def short_pieces(of: Subintervals, values: Sequence[Array]) -> ShortPieces:
    """Cut the polynomials through the points of panels into pieces that few powers describe.

    Parameters
    ----------
    of : Subintervals
    values : sequence of Array, shape (curve, point)
        Parts of vectors, or a curve alone.

    Returns
    -------
    ShortPieces, powers of shape (power, part, piece)

    Examples
    --------
    >>> from cranktrain.numerics.subintervals import subintervals
    >>> cut = subintervals(np.array([0.0]), 1.0, 2.0)
    >>> found = short_pieces(cut, [3.0 * cut.angle[np.newaxis]])
    >>> np.round(found.powers[:3, 0, 0], 9).tolist(), float(3 * found.half[0])
    ([0.5, 0.5, 0.0], 0.5)
    """
    n_curves = len(values[0])
    by_point = [np.ascontiguousarray(part.T) for part in values]
    powers: list[Array] = []
    halves: list[Array] = []
    for n_nodes in np.unique(of.size).tolist():
        chosen = np.flatnonzero(of.size == n_nodes)
        place = of.first[chosen] + np.arange(n_nodes, dtype=np.intp)[:, np.newaxis]
        matrix = _to_powers(n_nodes)
        found = [product(matrix, part[place].reshape(n_nodes, -1)).reshape(N_POWERS, -1) for part in by_point]
        powers.append(np.stack(found, axis=1))
        n_pieces = _n_pieces(n_nodes)
        halves.append(np.tile(of.width[chosen] / (2 * n_pieces), n_pieces))
    half = np.concatenate(halves)
    return ShortPieces(
        powers=np.concatenate(powers, axis=-1),
        half=np.repeat(half, n_curves),
        curve=np.tile(np.arange(n_curves, dtype=np.intp), half.size),
    )


def _n_pieces(n_nodes: int) -> int:
    """Into how many pieces a panel is cut, for few powers to be enough on each."""
    return max(1, n_nodes // 3 - 1)


@cache
def _to_powers(n_nodes: int) -> Array:
    """From values at a panel's points to the powers of its pieces, shape (power · piece, n)."""
    edges = np.linspace(-1.0, 1.0, _n_pieces(n_nodes) + 1)
    own = np.cos(np.pi * (np.arange(N_POWERS) + 0.5) / N_POWERS)
    ways = edges[:-1, np.newaxis] + (edges[1] - edges[0]) / 2 * (1 + own)
    from_own = np.linalg.inv(np.vander(own, increasing=True))
    shares = np.sum(from_own[:, np.newaxis, :, np.newaxis] * interpolation(ways, n_nodes), axis=2)
    return shares.reshape(-1, n_nodes)
