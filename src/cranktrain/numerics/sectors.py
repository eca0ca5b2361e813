"""How much of a plane vector points where: its size, integrated while its direction is within each sector.

Between breaks the vector is smooth; on short pieces of every panel it is a polynomial of few powers, and where that
crosses an edge of a sector is found on it, so that nothing depends on a grid.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.one_way_steps import OneWaySteps, cross, dot, one_way_steps, stretches
from cranktrain.numerics.polynomials import polynomial_value
from cranktrain.numerics.roots import newton_roots, secant_share
from cranktrain.numerics.short_pieces import ShortPieces, short_pieces
from cranktrain.numerics.subintervals import Subintervals, leggauss

_ON_EDGE = 1e-12
"""A vector whose part across an edge is smaller, in parts of its largest, points along that edge; a smaller vector has
no direction."""
_ASIDE = 1e-3
"""How far into a step the direction is looked at where the vector is nothing, in parts of the step."""
_AT_ONCE = 20000
"""Points of curves at once: many more of them take longer one by one, as their pieces fit no cache."""
_FEW = 4
"""Gauss's points from mark to mark, for the size, which is no polynomial."""


class Sectors(NamedTuple):
    """Integral of a vector's size by its direction, shape (..., n): in [φ's unit · the vector's].

    Attributes
    ----------
    within : Array
        While it points between edge k and edge k + 1; edge k is at 2πk/n from the first axis toward the second.
    along : Array
        While it points along edge k, as a vector that does not turn may.
    """

    within: Array
    along: Array


def size_by_sector(of: Subintervals, x: Array, y: Array, n_sectors: int) -> Sectors:
    """Integrate the size of vectors over one period, apart by where they point.

    Parameters
    ----------
    of : Subintervals
    x, y : Array, shape (curve, point)
        Parts of each vector at the panels' points.
    n_sectors : int

    Returns
    -------
    Sectors, shape (curve, n_sectors)
        NaN for a vector that is NaN anywhere.

    Notes
    -----
    To some 1e-8 of the whole.

    Examples
    --------
    A vector of size 1 that goes round once:

    >>> from cranktrain.numerics.subintervals import subintervals
    >>> cut = subintervals(np.array([0.3]), 1.0, 2 * np.pi)
    >>> found = size_by_sector(cut, np.cos(cut.angle)[np.newaxis], np.sin(cut.angle)[np.newaxis], 4)
    >>> np.round(found.within * 4 / (2 * np.pi), 9).tolist()
    [[1.0, 1.0, 1.0, 1.0]]
    """
    largest = np.sqrt(np.max(x * x + y * y, axis=-1))
    known = np.flatnonzero(np.isfinite(largest))
    found = np.full((len(x), 2 * n_sectors), np.nan)
    n_blocks = -(-known.size * of.angle.size // _AT_ONCE)
    for own in np.array_split(known, n_blocks) if known.size else ():
        pieces = short_pieces(of, (x[own], y[own]))
        place, value = _by_direction(pieces, one_way_steps(pieces), _ON_EDGE * largest[own], n_sectors)
        found[own] = np.bincount(place, value, own.size * 2 * n_sectors).reshape(own.size, -1)
    return Sectors(within=found[:, 1::2], along=found[:, 0::2])


def _by_direction(
    pieces: ShortPieces, steps: OneWaySteps, nothing: Array, n_sectors: int
) -> tuple[NDArray[np.intp], Array]:
    """Parts of the integral of the size, and where they belong: curve by curve, by code of the direction.

    A code is 2k along edge k, 2k + 1 between edge k and the next.
    """
    start = _codes(pieces, steps, nothing, n_sectors)
    end = _codes(pieces, _backward(steps), nothing, n_sectors)
    ahead = (end - start + n_sectors) % (2 * n_sectors) - n_sectors
    sense: NDArray[np.intp] = np.where(ahead < 0, -1, 1)
    # On a step that turns only sectors count: an edge is where the vector stays.
    first = np.where((ahead != 0) & (start % 2 == 0), start + sense, start)
    last = start + ahead - np.where((ahead != 0) & ((start + ahead) % 2 == 0), sense, 0)
    step, later = stretches(np.abs(last - first) // 2)
    piece, low, high, code = steps.piece[step], steps.start[step], steps.end[step], first[step]
    own = step[later]
    n_before = later - np.searchsorted(step, own)
    code[later] += 2 * n_before * sense[own]
    edge = (code[later] - sense[own]).astype(np.float64) * (np.pi / n_sectors)
    crossing = _crossing(pieces, steps, own, edge, sense[own].astype(np.float64))
    low[later], high[later - 1] = crossing, crossing
    value = pieces.half[piece] * _size_between(pieces.powers[..., piece], low, high)
    return pieces.curve[piece] * (2 * n_sectors) + code % (2 * n_sectors), value


def _backward(steps: OneWaySteps) -> OneWaySteps:
    """The same steps from their ends."""
    return OneWaySteps(steps.piece, steps.end, steps.start, steps.at_end, steps.at_start)


def _codes(pieces: ShortPieces, steps: OneWaySteps, nothing: Array, n_sectors: int) -> NDArray[np.intp]:
    """Codes of the directions in which steps start: where the vector is nothing there, of what is next to it."""
    x, y = steps.at_start
    size, least = np.sqrt(x * x + y * y), nothing[pieces.curve[steps.piece]]
    lost = np.flatnonzero(size <= least)
    if lost.size:
        aside = steps.start[lost] + _ASIDE * (steps.end - steps.start)[lost]
        x, y = steps.at_start.copy()
        x[lost], y[lost] = polynomial_value(pieces.powers[..., steps.piece[lost]], aside)
        size[lost] = np.sqrt(x[lost] ** 2 + y[lost] ** 2)
    part: Array = np.arctan2(y, x) * (n_sectors / (2 * np.pi))
    nearest: Array = np.rint(part)
    is_along = size * np.abs(part - nearest) * (2 * np.pi / n_sectors) <= least
    code: Array = np.where(is_along, 2 * nearest, 2 * np.floor(part) + 1)
    return code.astype(np.intp)


def _crossing(pieces: ShortPieces, steps: OneWaySteps, step: NDArray[np.intp], edge: Array, sense: Array) -> Array:
    """Where vectors cross edges in a sense, each on a step of its own."""
    along = np.stack([np.cos(edge), np.sin(edge)])
    powers, low, high = cross(along, pieces.powers[..., steps.piece[step]]), steps.start[step], steps.end[step]
    slopes = powers[1:] * np.arange(1.0, len(powers))[:, np.newaxis]
    share = secant_share(*(cross(along, at[:, step]) for at in (steps.at_start, steps.at_end)))
    return newton_roots(
        lambda way: (polynomial_value(powers, way), polynomial_value(slopes, way)), low, high, sense, share
    )


def _size_between(powers: Array, low: Array, high: Array) -> Array:
    """Integral of the size from one way to another near to it."""
    half, total = (high - low) / 2, np.zeros(low.shape)
    for node, weight in zip(*leggauss(_FEW), strict=True):
        vector = polynomial_value(powers, low + half * (1 + node))
        total += weight * np.sqrt(dot(vector, vector))
    return half * total
