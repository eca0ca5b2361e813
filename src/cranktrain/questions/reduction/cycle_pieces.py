"""Pieces of a cycle: Gauss's points on each, and the series of what is known there."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre

from cranktrain.motion import Array
from cranktrain.numerics.products import product

N_NODES = 12
_WIDEST = 2 * np.pi / 48
_ONE_END = 1e-9
"""Ends that are closer are one. [rad]"""
_BESIDE = 1e-14
"""In parts of a limit of ω²/2: how far within it a value is held."""

_GROWN = np.stack([np.asarray(legendre.legint(row, lbnd=-1), dtype=np.float64) for row in np.eye(N_NODES)], axis=1)
"""Series of the integrals of Legendre's polynomials from −1 on."""


def _rule() -> tuple[Array, Array, Array]:
    """Gauss's nodes in 0…1; integrals from 0 to each of them, and to 1, of what is known there; its Legendre series."""
    nodes = legendre.leggauss(N_NODES)[0]
    fitted = np.asarray(np.linalg.inv(legendre.legvander(nodes, N_NODES - 1)), dtype=np.float64)
    ends = np.append(nodes, 1.0)
    integrals = legendre.legvander(ends, N_NODES) @ _GROWN
    return (nodes + 1) / 2, integrals @ fitted / 2, fitted


NODES, INTEGRALS, _FITTED = _rule()


def to_integrals(places: Array) -> Array:
    """From what is known at the nodes of a piece to its integrals up to places in 0…1, in parts of its width."""
    powers = np.asarray(legendre.legvander(2 * places - 1, N_NODES), dtype=np.float64)
    return product(product(powers, _GROWN), _FITTED) / 2


def to_places(places: Array) -> Array:
    """From what is known at the nodes of a piece to its polynomial at places in 0…1."""
    return np.asarray(legendre.legvander(2 * places - 1, N_NODES - 1), dtype=np.float64) @ _FITTED


class CyclePieces(NamedTuple):
    """Pieces of a cycle between its corners; of designs with as many pieces every array begins with the design.

    Attributes
    ----------
    start, width : Array, shape (piece,)
        [rad]
    low, high : Array, shape (piece,)
        Between which ω²/2 stays: where a law jumps it is another one on each side. [rad²/s²]
    """

    start: Array
    width: Array
    low: Array
    high: Array

    @property
    def nodes(self) -> Array:
        """Angles at which the equation is met, shape (piece · node,). [rad]"""
        return self.at(NODES)

    def at(self, places: Array) -> Array:
        """Angles at places 0…1 of every piece, shape (place,) → (piece · place,). [rad]"""
        each = self.start[..., np.newaxis] + self.width[..., np.newaxis] * places
        return each.reshape(*self.start.shape[:-1], -1)

    def mean(self, values: Array) -> Array:
        """Mean over the angle of values at the nodes, shape (..., piece · node) → (...)."""
        return np.sum(self.of_each(values), axis=-1) / np.sum(self.width, axis=-1)

    def of_each(self, values: Array) -> Array:
        """Integral over each piece of values at the nodes, shape (..., piece · node) → (..., piece)."""
        return values.reshape(*values.shape[:-1], -1, N_NODES) @ INTEGRALS[-1] * self.width

    def within(self, half_square: Array) -> Array:
        """Values of ω²/2 at the nodes, shape (piece · node,), held on their piece's side of a jump."""
        low, high = self.low * (1 + _BESIDE), self.high * (1 - _BESIDE)
        return np.clip(half_square, np.repeat(low, N_NODES, axis=-1), np.repeat(high, N_NODES, axis=-1))

    def between(self, levels: Array, half_square: Array) -> "CyclePieces":
        """The same, each piece between those levels of ω²/2 at which the law jumps that its own value is between.

        Parameters
        ----------
        levels : Array, shape (n,)
        half_square : Array, shape (piece,)
            Of each piece.
        """
        bounds = np.concatenate([[-np.inf], np.sort(levels), [np.inf]])
        # no more than the last, as of a value that is not known where the shaft nearly stands
        place = np.minimum(np.searchsorted(bounds, half_square, side="right"), bounds.size - 1)
        return self._replace(low=bounds[place - 1], high=bounds[place])


def pieces_together(each: Sequence[CyclePieces]) -> CyclePieces:
    """Pieces of designs that have as many of them."""
    return CyclePieces(*(np.stack(parts) for parts in zip(*each, strict=True)))


def mesh_of(cycle: float, corners: Array) -> CyclePieces:
    """Pieces of a cycle, none wider than a forty-eighth of a turn, that end at all corners; NaN is none. [rad]"""
    own = np.mod(corners[np.isfinite(corners)], cycle)
    ends = np.unique(np.concatenate([np.linspace(0.0, cycle, round(cycle / _WIDEST) + 1), own]))
    ends = ends[np.append(True, np.diff(ends) > _ONE_END)]
    ends[-1] = cycle
    nowhere = np.full(len(ends) - 1, np.inf)
    return CyclePieces(ends[:-1], np.diff(ends), -nowhere, nowhere)
