"""Steps along which plane vectors turn one way, so that their directions at the ends tell all between."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.polynomials import polynomial, polynomial_value
from cranktrain.numerics.products import product
from cranktrain.numerics.roots import SlopedCurve, newton_roots, secant_share
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


class _Brackets(NamedTuple):
    """Ways on pieces between which a rate changes sign, in which sense, and where to begin, shape (k,)."""

    piece: NDArray[np.intp]
    low: Array
    high: Array
    sense: Array
    share: Array


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
    piece, way = _marks(powers, value, slope)
    owner, later = stretches(np.bincount(piece, minlength=n_pieces))
    steps = OneWaySteps(owner, np.full(owner.size, -1.0), np.ones(owner.size), value[0][:, owner], value[-1][:, owner])
    there = polynomial_value(powers[..., piece], way)
    steps.start[later], steps.at_start[:, later] = way, there
    steps.end[later - 1], steps.at_end[:, later - 1] = way, there
    return steps


def _marks(powers: Array, value: Array, slope: Array) -> tuple[NDArray[np.intp], Array]:
    """On which pieces and where vectors are least or turn back, in order, by values and slopes at the ways tried."""
    growing, turning, square = dot(value, slope), cross(value, slope), dot(value, value)
    still = _TURNING * (square[:-1] + square[1:])
    is_least = (growing[:-1] <= 0) & (growing[1:] >= 0) & (np.diff(growing, axis=0) > still)
    is_back = (turning[:-1] * turning[1:] <= 0) & (np.abs(np.diff(turning, axis=0)) > still)
    place, piece = np.nonzero(is_least)
    least = _roots(_growing, powers, _brackets(growing, place, piece))
    there = _turning(powers[..., piece])(least)[0]
    backs = [_brackets(turning, *np.nonzero(is_back)), *_hidden(turning, place, piece, least, there)]
    back = _Brackets(*(np.concatenate(parts) for parts in zip(*backs, strict=True)))
    pieces, ways = np.concatenate([piece, back.piece]), np.concatenate([least, _roots(_turning, powers, back)])
    order = np.lexsort((ways, pieces))
    return pieces[order], ways[order]


def _brackets(rate: Array, place: NDArray[np.intp], piece: NDArray[np.intp]) -> _Brackets:
    """Brackets from ways tried to the next."""
    before, after = rate[place, piece], rate[place + 1, piece]
    return _Brackets(piece, _TRIED[place], _TRIED[place + 1], np.sign(after - before), secant_share(before, after))


def _hidden(
    turning: Array, place: NDArray[np.intp], piece: NDArray[np.intp], least: Array, there: Array
) -> tuple[_Brackets, _Brackets]:
    """Brackets before and after where a vector is least, if it turns the other way there than at both ways tried.

    One that passes nothing by a hair swings round there and turns back before and after, nearer than a grid shows.
    """
    before, after = turning[place, piece], turning[place + 1, piece]
    is_hidden = (there * before < 0) & (there * after < 0)
    place, piece = place[is_hidden], piece[is_hidden]
    least, there, before, after = (part[is_hidden] for part in (least, there, before, after))
    # How fast it turns is nearly a parabola about the least.
    until, since = 1 - np.sqrt(secant_share(there, before)), np.sqrt(secant_share(there, after))
    return (
        _Brackets(piece, _TRIED[place], least, np.sign(there), until),
        _Brackets(piece, least, _TRIED[place + 1], -np.sign(there), since),
    )


def _roots(rate: Callable[[Array], SlopedCurve], powers: Array, brackets: _Brackets) -> Array:
    """Where a rate of the vectors changes sign."""
    return newton_roots(rate(powers[..., brackets.piece]), *brackets[1:])


def _growing(powers: Array) -> SlopedCurve:
    """How fast vectors grow, times their size."""

    def rate(way: Array) -> tuple[Array, Array]:
        value, first, second = polynomial(powers, way)
        return dot(value, first), dot(first, first) + dot(value, second)

    return rate


def _turning(powers: Array) -> SlopedCurve:
    """How fast vectors turn, times their square."""

    def rate(way: Array) -> tuple[Array, Array]:
        value, first, second = polynomial(powers, way)
        return cross(value, first), cross(value, second)

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
