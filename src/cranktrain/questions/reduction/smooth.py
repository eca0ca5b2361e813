"""Smooth periodic coefficients of a turn as polynomials on equal pieces, as close as their kernels are."""

from collections.abc import Callable

import numpy as np
from numpy.polynomial import chebyshev

from cranktrain.motion import Array
from cranktrain.transient.reduced import DEGREE, TURN

_FEWEST, _MOST = 32, 1024
_CLOSE = 1e-13
"""Of a coefficient's peak: what a polynomial may miss between its nodes."""
_FALL = 8
"""Of what a polynomial misses, at least, where halving its pieces is worth while."""
NODES = np.cos(np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1))
"""Places −1…1 within a piece at which a curve is asked for its polynomial."""
LOOKS = np.array([-0.93, -0.41, 0.07, 0.68, 0.97])
"""Others, at which that polynomial is held against the curve."""
POWERS_AT_LOOKS = np.vander(LOOKS, DEGREE + 1, increasing=True).T


_DEGREES = np.arange(DEGREE + 1)
_TO_SERIES = np.cos(np.outer(_DEGREES, np.arccos(NODES))) * np.where(_DEGREES > 0, 2.0, 1.0)[:, np.newaxis] / NODES.size
"""From values at the nodes to Chebyshev's series."""
_TO_POWERS = np.array([np.pad(chebyshev.cheb2poly(row), (0, DEGREE - i)) for i, row in enumerate(np.eye(DEGREE + 1))])
"""From the series to powers of −1…1. A second step: multiplied into the first, these whole numbers make a thousand
times its rounding, of which an inertia's slope gives work in every turn, and a soft motor a slip."""


def smooth_pieces(coefficients: Callable[[Array], Array]) -> Array:
    """Polynomials of all coefficients, on as many pieces as it takes.

    Parameters
    ----------
    coefficients : callable
        From angles of a turn, shape (n,), to values, shape (design, coefficient, n), with the period 2π.

    Returns
    -------
    Array, shape (design, piece, coefficient, `DEGREE` + 1)
        Of powers of −1…1 within a piece, the constant first.

    Notes
    -----
    docs/theory/reduced-machine, eq. (31.3). Chebyshev's nodes; pieces are halved until the polynomials meet the kernel
    between the nodes to 1e-13 of the peak, or halving brings no more.
    """
    n_pieces, before = _FEWEST, np.inf
    pieces = _on(coefficients, n_pieces)
    while True:
        miss = _miss(coefficients, pieces)
        # What no longer falls is rounding, or a kink that the kernel has.
        if n_pieces >= _MOST or np.all((miss <= _CLOSE) | (miss > before / _FALL)):
            return pieces
        n_pieces, before = 2 * n_pieces, miss
        pieces = _on(coefficients, n_pieces)


def powers_from(values: Array) -> Array:
    """Polynomials of powers of −1…1, shape (..., `DEGREE` + 1), by values at `NODES`, of that shape."""
    # From one of its own values on, as a constant is to have no slope, not even by rounding.
    base = values[..., :1]
    found = (values - base) @ _TO_SERIES.T @ _TO_POWERS
    found[..., :1] += base
    return found


def _angles(n_pieces: int, places: Array) -> Array:
    """Angles at places −1…1 of every piece, shape (piece · place,). [rad]"""
    width = TURN / n_pieces
    return np.ravel((np.arange(n_pieces) + 0.5)[:, np.newaxis] * width + 0.5 * width * places)


def _on(coefficients: Callable[[Array], Array], n_pieces: int) -> Array:
    """Polynomials on so many pieces."""
    values = coefficients(_angles(n_pieces, NODES))
    return np.moveaxis(powers_from(values.reshape(*values.shape[:2], n_pieces, DEGREE + 1)), 1, 2)


def _miss(coefficients: Callable[[Array], Array], pieces: Array) -> Array:
    """Largest difference between the nodes, in parts of each coefficient's peak, shape (design, coefficient)."""
    exact = coefficients(_angles(pieces.shape[1], LOOKS))
    found = np.moveaxis(pieces @ POWERS_AT_LOOKS, 1, 2).reshape(exact.shape)
    peak = np.max(np.abs(exact), axis=-1)
    return np.max(np.abs(found - exact), axis=-1) / np.where(peak > 0, peak, 1.0)
