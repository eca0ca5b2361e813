"""Many polynomials at once."""

import numpy as np

from cranktrain.motion import Array, Coefficient


def polynomial(powers: Array, x: Array) -> Coefficient:
    """Value and first two derivatives of polynomials, by their coefficients in rising powers along the first axis.

    Examples
    --------
    1 + 2x + 3x² at 10:

    >>> [float(part) for part in polynomial(np.array([1.0, 2.0, 3.0]), np.array(10.0))]
    [321.0, 62.0, 6.0]
    """
    *others, value = powers
    first = half_second = np.zeros_like(value)
    for part in reversed(others):
        half_second = half_second * x + first
        first = first * x + value
        value = value * x + part
    return Coefficient(value, first, 2 * half_second)


def value_and_first(powers: Array, x: Array) -> tuple[Array, Array]:
    """Value and first derivative of `polynomial` alone.

    Examples
    --------
    >>> value_and_first(np.array([1.0, 2.0, 3.0]), np.array([10.0]))
    (array([321.]), array([62.]))
    """
    value, first = powers[-1], np.zeros_like(powers[-1])
    for part in powers[-2::-1]:
        first = first * x + value
        value = value * x + part
    return value, first


def polynomial_value(powers: Array, x: Array) -> Array:
    """Value of `polynomial` alone.

    Parameters
    ----------
    powers : Array, shape (power, ..., n)
    x : Array, shape (n,)

    Returns
    -------
    Array, shape (..., n)
    """
    value = powers[-1].copy()
    # In place, as with many most of the time would go into new memory.
    for part in powers[-2::-1]:
        value *= x
        value += part
    return value
