"""Curves over a cycle that are smooth between known ends, as polynomials on pieces as narrow as they have to be."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics import in_slots
from cranktrain.numerics.products import product
from cranktrain.questions.reduction.smooth import LOOKS, NODES, POWERS_AT_LOOKS, powers_from

_WIDEST = 2 * np.pi / 32
_NARROW, _NARROWEST = 1e-3, 1e-5
"""Narrow pieces are halved while that brings anything, and the narrowest no more: what a polynomial misses there is
rounding, or a kink or a jump that nothing told of. [rad]"""
_FALL = 1.5
"""Of what a polynomial misses, at least, where halving brings something."""
_ONE_END = 1e-9
"""Ends that are closer are one. [rad]"""
_CLOSE = 1e-12
"""Of the curve's peak: what a polynomial may miss between its nodes."""


class _Pieces(NamedTuple):
    """Pieces of curves, each array of shape (piece,).

    Attributes
    ----------
    design : array of int
        Whose it is.
    start, width : Array
        [rad]
    missed : Array
        What the polynomial missed of which it is a half; infinite of a whole.
    """

    design: NDArray[np.intp]
    start: Array
    width: Array
    missed: Array

    def of(self, which: NDArray[np.bool_]) -> "_Pieces":
        """Some of them."""
        return _Pieces(self.design[which], self.start[which], self.width[which], self.missed[which])

    def halves(self) -> "_Pieces":
        """Both halves of each."""
        start, width = np.repeat(self.start, 2), np.repeat(0.5 * self.width, 2)
        start[1::2] += width[1::2]
        return _Pieces(np.repeat(self.design, 2), start, width, np.repeat(self.missed, 2))


def curve_pieces(curve: Callable[[Array], Array], ends: Array, cycle: float) -> list[Array]:
    """Polynomials along a curve of each design.

    Parameters
    ----------
    curve : callable
        From angles of each design, shape (design, 1, n), to values, shape (design, n), with the cycle as their period.
    ends : Array, shape (design, end)
        Where the curve may have kinks or jumps; NaN for none. [rad]
    cycle : float
        [rad]

    Returns
    -------
    list of Array, shape (piece, `CURVE_WIDTH`)
        Of each design, in the order of their angles: where a piece begins, how wide it is [rad], and its polynomial in
        powers of −1…1 within it, the constant first.

    Notes
    -----
    docs/theory/reduced-machine, eq. (31.15). Chebyshev's nodes; pieces are halved until the polynomials meet the curve
    between the nodes to 1e-12 of its peak.
    """
    n_designs = len(ends)
    pieces, done, peak = _between(ends, cycle), list[tuple[_Pieces, Array]](), np.zeros(n_designs)
    while pieces.design.size:
        values = _values(curve, pieces, np.concatenate([NODES, LOOKS]), n_designs)
        at_nodes, looked = values[:, : NODES.size], values[:, NODES.size :]
        np.maximum.at(peak, pieces.design, np.max(np.abs(values), axis=-1))
        powers = powers_from(at_nodes)
        missed = np.max(np.abs(product(powers, POWERS_AT_LOOKS) - looked), axis=-1)
        in_vain = (pieces.width <= _NARROW) & (missed > pieces.missed / _FALL)
        stays = (missed <= _CLOSE * peak[pieces.design]) | in_vain | (pieces.width <= _NARROWEST)
        done.append((pieces.of(stays), powers[stays]))
        pieces = pieces._replace(missed=missed).of(~stays).halves()
    whole = _together([own for own, _powers in done])
    rows = np.column_stack([whole.start, whole.width, np.concatenate([powers for _own, powers in done])])
    order = np.lexsort((whole.start, whole.design))
    return np.split(rows[order], np.searchsorted(whole.design[order], np.arange(1, n_designs)))


def _between(ends: Array, cycle: float) -> _Pieces:
    """Pieces between the ends, none wider than a thirty-second of a turn."""
    even = np.linspace(0.0, cycle, round(cycle / _WIDEST) + 1)
    found = list[_Pieces]()
    for design, own in enumerate(ends):
        places = np.unique(np.concatenate([even, np.mod(own[np.isfinite(own)], cycle)]))
        places = places[np.append(True, np.diff(places) > _ONE_END)]
        places[-1] = cycle
        found.append(
            _Pieces(np.full(places.size - 1, design), places[:-1], np.diff(places), np.full(places.size - 1, np.inf))
        )
    return _Pieces(*(np.concatenate(parts) for parts in zip(*found, strict=True)))


def _together(each: Sequence[_Pieces]) -> _Pieces:
    """Pieces one after another."""
    design, start, width, missed = zip(*each, strict=True)
    return _Pieces(np.concatenate(design), np.concatenate(start), np.concatenate(width), np.concatenate(missed))


def _values(curve: Callable[[Array], Array], pieces: _Pieces, places: Array, n_designs: int) -> Array:
    """A curve at places −1…1 of each piece, shape (piece, place)."""
    angle = pieces.start[:, np.newaxis] + pieces.width[:, np.newaxis] * (0.5 + 0.5 * places)
    laid, slot = in_slots(pieces.design, angle, n_designs)
    found = curve(laid.reshape(n_designs, 1, -1)).reshape(laid.shape)
    return found[pieces.design, slot]
