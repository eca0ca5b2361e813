"""Parts of a wanted motion that are polynomials, cut where these turn round; and a spline from rest to rest."""

import itertools

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import NDArray

from cranktrain.layout.wish.laws import LAWS, NEAREST, polynomial_law
from cranktrain.layout.wish.wanted import Piece, WantedMotion, from_pieces
from cranktrain.motion import Array
from cranktrain.numerics.spline import tridiagonal

_NOTHING = 1e-9
"""Of the whole way: what a polynomial goes back between two roots that are one, in the next to last figure."""
_ROUNDING = 1e-12
"""Of the largest coefficient: what powers leave of one another."""
_LEFT_4 = np.array([1.0, -4.0, 6.0, -4.0, 1.0, 0.0])
_LEFT_5 = np.array([1.0, -5.0, 10.0, -10.0, 5.0, -1.0])
"""(1 − s)⁴ and (1 − s)⁵ by powers of s."""


def polynomial_pieces(start: float, span: float, begin: float, series: Array, number: int) -> tuple[Piece, ...]:
    """Cut a polynomial at its turning points.

    Parameters
    ----------
    start, span : float
        [s]
    begin : float
        Where it begins. [m or rad]
    series : Array, shape (power,)
        How far it is from there, by powers of the share of its time; the first is 0. [m or rad]
    number : int
        Which one of the file's it is.

    Returns
    -------
    tuple of Piece
        One, unless it turns round. docs/theory/servo, eq. (29.12).
    """
    way = Polynomial(series)
    turns = _turning_places(way)
    found: list[Piece] = []
    for low, high in itertools.pairwise([0.0, *turns, 1.0]):
        forth = _about(series, low, high - low, turns=low in turns)
        back = -_about(series, high, low - high, turns=high in turns)
        rise = float(np.sum(forth))
        law = None if rise == 0 else polynomial_law(forth / rise)._replace(end=back / rise)
        at = begin + float(way(low))
        found.append(Piece(start + low * span, (high - low) * span, at, rise, law, number))
    return tuple(found)


def _turning_places(way: Polynomial) -> list[float]:
    """Shares of the time within at which a polynomial goes on the other way; it may stand there longer."""
    roots: NDArray[np.complex128] = np.asarray(way.deriv().roots(), dtype=np.complex128)
    inner = sorted(float(root.real) for root in roots.tolist() if root.imag == 0 and 0 < root.real < 1)
    edges = [0.0, *inner, 1.0]
    rises = np.diff(way(np.array(edges)))
    least = _NOTHING * float(np.sum(np.abs(rises)))
    found: list[float] = []
    before = 0.0
    for edge, rise in zip(edges[:-1], rises.tolist(), strict=True):
        if abs(rise) > least:
            if rise * before < 0:
                found.append(edge)
            before = rise
    return found


def _about(series: Array, at: float, width: float, *, turns: bool) -> Array:
    """Series of what is gone from a place on, by shares of a width; its slope there is none where it turns round."""
    own = Polynomial(series)(Polynomial([at, width])).coef
    found = np.zeros(series.size)
    found[1 : own.size] = own[1:]
    if turns:
        found[1] = 0.0
    return np.where(np.abs(found) < _ROUNDING * np.max(np.abs(series)), 0.0, found)


def through_rests(times: Array, positions: Array, period: float, rests: NDArray[np.bool_]) -> WantedMotion:
    """Lay a smooth curve through positions that stands still for some of the time.

    Parameters
    ----------
    times, positions : Array, shape (n,)
        Rising within one period. [s; m or rad]
    period : float
        [s]
    rests : array of bool, shape (n,)
        Whether it stands from each time to the next; the last one until the first one comes again. One at least.

    Returns
    -------
    WantedMotion
        It leaves each rest and comes to it like t⁴; acceleration is continuous. docs/theory/servo, eq. (29.11).
    """
    spans, rises = np.diff(times, append=times[0] + period), np.diff(positions, append=positions[0])
    n = len(times)
    before: list[tuple[Piece, ...]] = [() for _each in range(n)]
    for first in np.flatnonzero(rests).tolist():
        before[first] = (Piece(_since(times, first), float(spans[first]), float(positions[first]), 0.0, None, first),)
        count = next(k for k in range(n) if rests[(first + 1 + k) % n])
        run = (first + 1 + np.arange(count)) % n
        for place, series in zip(run.tolist(), _run_series(spans[run], rises[run]), strict=True):
            at = _since(times, place)
            before[place] = polynomial_pieces(at, float(spans[place]), float(positions[place]), series, place)
    made = from_pieces(tuple(itertools.chain.from_iterable(before)))
    return made._replace(period=period, zero=float(times[0]))


def _since(times: Array, place: int) -> float:
    """Time of a point from the first one. [s]"""
    return float(times[place] - times[0])


def _run_series(spans: Array, rises: Array) -> list[Array]:
    """Ways of the spans from one rest to the next, each by powers of the share of its time. [m or rad]"""
    n = len(spans)
    if n < 2:
        return [float(rise) * LAWS[NEAREST].start for rise in rises]
    is_end = np.zeros(n, dtype=bool)
    is_end[[0, -1]] = True
    bends = np.where(is_end, 4.0, 2.0) / spans
    pulls = np.where(is_end, 10.0, 3.0) * rises / spans**2
    right = (pulls[:-1] + pulls[1:])[:, np.newaxis]
    inner = np.ravel(tridiagonal(1 / spans[1:-1], bends[:-1] + bends[1:], right))
    slopes = np.concatenate([[0.0], inner, [0.0]])
    starts, ends = slopes[:-1] * spans, slopes[1:] * spans
    leaving = [np.array([0, 0, 0, 0, 5 * rises[0] - ends[0], ends[0] - 4 * rises[0]])]
    inside = [
        np.array([0, start, 3 * rise - 2 * start - end, start + end - 2 * rise])
        for start, end, rise in zip(starts[1:-1], ends[1:-1], rises[1:-1], strict=True)
    ]
    fourth, fifth = 5 * rises[-1] - starts[-1], starts[-1] - 4 * rises[-1]
    coming = -fourth * _LEFT_4 - fifth * _LEFT_5
    coming[0] = 0.0
    return [*leaving, *inside, coming]
