"""Steps along which plane vectors turn one way, so that their directions at the ends tell all between."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.polynomials import polynomial, polynomial_value
from cranktrain.numerics.products import product
from cranktrain.numerics.roots import SlopedCurve, newton_roots
from cranktrain.numerics.short_pieces import N_POWERS, ShortPieces

_TURNING = 1e-9
"""Directions that turn by less along a piece do not turn. [rad]"""
_TRIED = np.linspace(-1.0, 1.0, 5)
"""Where on a piece it is looked at which way the direction turns."""
_ORDER = np.arange(N_POWERS)
_AT_TRIED = np.concatenate(
    [_TRIED[:, np.newaxis] ** _ORDER, _ORDER * _TRIED[:, np.newaxis] ** np.maximum(_ORDER - 1, 0)]
)
"""From powers to values there, and to slopes."""


class OneWaySteps(NamedTuple):
    """Steps along pieces, on each of which a vector turns one way and is nowhere less than at its ends.

    Attributes
    ----------
    piece : array of int, shape (step,)
        Rising.
    start, end : Array, shape (step,)
        Ways along the piece in [−1, 1].
    at_start, at_end : Array, shape (2, step)
        The vector there.
    """

    piece: NDArray[np.intp]
    start: Array
    end: Array
    at_start: Array
    at_end: Array


def one_way_steps(pieces: ShortPieces) -> OneWaySteps:
    """Cut pieces where vectors turn back, and where they are least.

    Parameters
    ----------
    pieces : ShortPieces, powers of shape (power, 2, piece)

    Returns
    -------
    OneWaySteps
    """
    powers, n_pieces = pieces.powers, pieces.half.size
    value, slope = product(_AT_TRIED, powers.reshape(N_POWERS, -1)).reshape(2, _TRIED.size, 2, n_pieces)
    rates, square = np.stack([cross(value, slope), dot(value, slope)]), dot(value, value)
    change, least = np.diff(rates, axis=1), _TURNING * (square[:-1] + square[1:])
    # A vector grows after it was least, but may turn back either way.
    is_change = np.stack([np.abs(change[0]) > least, change[1] > least])
    kind, place, piece = np.nonzero(is_change & (rates[:, :-1] * rates[:, 1:] <= 0.0))
    before, after = rates[kind, place, piece], rates[kind, place + 1, piece]
    way = newton_roots(_rate(powers[..., piece], kind == 0), _TRIED[place], _TRIED[place + 1], before, after)
    order = np.lexsort((way, piece))
    owner, later = stretches(np.bincount(piece, minlength=n_pieces))
    steps = OneWaySteps(owner, np.full(owner.size, -1.0), np.ones(owner.size), value[0][:, owner], value[-1][:, owner])
    there = polynomial_value(powers[..., piece[order]], way[order])
    steps.start[later], steps.at_start[:, later] = way[order], there
    steps.end[later - 1], steps.at_end[:, later - 1] = way[order], there
    return steps


def _rate(powers: Array, is_turning: NDArray[np.bool_]) -> SlopedCurve:
    """How fast some vectors turn, or else grow, up to a positive factor."""

    def rate(way: Array) -> tuple[Array, Array]:
        value, first, second = polynomial(powers, way)
        turning = cross(value, first), cross(value, second)
        growing = dot(value, first), dot(first, first) + dot(value, second)
        return np.where(is_turning, turning[0], growing[0]), np.where(is_turning, turning[1], growing[1])

    return rate


def stretches(n_cuts: NDArray[np.intp]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Stretches that each of some is cut into.

    Parameters
    ----------
    n_cuts : array of int, shape (n,)

    Returns
    -------
    owner : array of int, shape (stretch,)
        Which of them each is part of, rising.
    later : array of int, shape (cut,)
        Which of the stretches follow a cut; the ones before them end there.

    Examples
    --------
    >>> owner, later = stretches(np.array([0, 2, 0]))
    >>> owner.tolist(), later.tolist()
    ([0, 1, 1, 1, 2], [2, 3])
    """
    owner = np.repeat(np.arange(n_cuts.size, dtype=np.intp), n_cuts + 1)
    return owner, np.flatnonzero(owner[1:] == owner[:-1]) + 1


def cross(one: Array, other: Array) -> Array:
    """Cross product of vectors of shape (..., 2, k)."""
    return one[..., 0, :] * other[..., 1, :] - one[..., 1, :] * other[..., 0, :]


def dot(one: Array, other: Array) -> Array:
    """Dot product of vectors of shape (..., 2, k)."""
    return one[..., 0, :] * other[..., 0, :] + one[..., 1, :] * other[..., 1, :]
