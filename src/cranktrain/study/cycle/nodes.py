"""Chebyshev's points on panels, ends among them: weights, and what makes integrals and series of values there."""

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.products import product

SIZES = (8, 12, 18, 26)
"""Points of a panel, by how wide it is; even, as their series are found by values on both sides of its middle."""
SHARES = (0.05, 0.2, 0.5, np.inf)
"""Up to which part of the widest that shows a curve."""

_AT_ONCE = 4
"""Numbers that a processor adds and multiplies at once."""


class PanelNodes(NamedTuple):
    """Points x in [−1, 1] for each of some sizes; beyond a size's own rows and columns all is 0.

    Attributes
    ----------
    size : array of int, shape (size,)
    share : Array, shape (size,)
        Up to which part of the widest panel each is enough.
    place, weight : Array, shape (size, point)
        x, rising, and weights of the integral over [−1, 1].
    integral : Array, shape (size, point, point)
        From values to their integrals from −1 to each point.
    even, odd : Array, shape (size, point, order)
        From sums and differences of values at −x and x, from the ends inward, to the coefficients of Chebyshev's
        polynomials T₀, T₂, … and T₁, T₃, …, so many as a processor finds at once.
    last : Array, shape (size, 2, point)
        From values to the coefficients of the last two polynomials.
    """

    size: NDArray[np.intp]
    share: Array
    place: Array
    weight: Array
    integral: Array
    even: Array
    odd: Array
    last: Array


@cache
def nodes() -> PanelNodes:
    """Tables of all sizes.

    Examples
    --------
    The integral of cos over a panel of 2 rad by 12 points:

    >>> one = nodes()
    >>> values = np.cos(one.place[1, :12])
    >>> round(float(np.sum(one.weight[1, :12] * values)), 9) == round(2 * float(np.sin(1.0)), 9)
    True
    """
    n_sizes, most = len(SIZES), max(SIZES)
    place, weight = np.zeros((2, n_sizes, most))
    integral = np.zeros((n_sizes, most, most))
    even, odd = np.zeros((2, n_sizes, most // 2, -(-most // (2 * _AT_ONCE)) * _AT_ONCE))
    last = np.zeros((n_sizes, 2, most))
    for row, size in enumerate(SIZES):
        angle = np.arange(size)[::-1] * (np.pi / (size - 1))
        x = np.cos(angle)
        x[size // 2 :] = -x[: (size + 1) // 2][::-1]  # alike on both sides, to the last bit
        to_series = np.asarray(np.linalg.inv(_values_of_orders(x, size - 1)), dtype=np.float64)
        # Integrals of T_k from −1 on, one degree higher.
        of_each: Array = np.asarray(np.polynomial.chebyshev.chebint(np.eye(size), lbnd=-1, axis=0), dtype=np.float64)
        to_integral = product(_values_of_orders(x, size), product(of_each, to_series))
        place[row, :size] = x
        weight[row, :size] = to_integral[-1]
        integral[row, :size, :size] = to_integral
        half = size // 2
        even[row, :half, :half] = to_series[::2, :half].T
        odd[row, :half, :half] = to_series[1::2, :half].T
        last[row, :, :size] = to_series[-2:]
    return PanelNodes(np.array(SIZES, dtype=np.intp), np.array(SHARES), place, weight, integral, even, odd, last)


def _values_of_orders(x: Array, degree: int) -> Array:
    """Chebyshev's polynomials up to a degree at some places, shape (place, degree + 1)."""
    return np.asarray(np.polynomial.chebyshev.chebvander(x, degree), dtype=np.float64)
