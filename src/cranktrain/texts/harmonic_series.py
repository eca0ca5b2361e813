"""The texts' power series in λ for the harmonics of a central slider-crank, beside the exact ones."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.torque.rod_harmonics import acceleration_harmonics, torque_harmonics

HIGHEST_ACCELERATION = 8
HIGHEST_TORQUE = 6

_ACCELERATION: Mapping[int, Mapping[int, float]] = {
    1: {0: 1.0},
    2: {1: 1.0, 3: 1 / 4, 5: 15 / 128, 7: 35 / 512},
    4: {3: -1 / 4, 5: -3 / 16, 7: -35 / 256},
    6: {5: 9 / 128, 7: 45 / 512},
    8: {7: -5 / 256},
}
"""Coefficients of A_k by order and power of λ."""
_TORQUE: Mapping[int, Mapping[int, float]] = {
    1: {1: 1 / 4, 3: 1 / 16, 5: 15 / 512},
    2: {0: -1 / 2, 4: -1 / 32, 6: -1 / 32},
    3: {1: -3 / 4, 3: -9 / 32, 5: -81 / 512},
    4: {2: -1 / 4, 4: -1 / 8, 6: -1 / 16},
    5: {3: 5 / 32, 5: 75 / 512},
    6: {4: 3 / 32, 6: 3 / 32},
}
"""Coefficients of D_k by order and power of λ."""
_TWO_ACCELERATION: Mapping[int, Mapping[int, float]] = {1: {0: 1.0}, 2: {1: 1.0}}
"""Two harmonics of the acceleration, cos φ + λ cos 2φ."""
_TWO_TORQUE: Mapping[int, Mapping[int, float]] = {1: {1: 1 / 4}, 2: {0: -1 / 2}, 3: {1: -3 / 4}, 4: {2: -1 / 4}}
"""Torque of that acceleration at its own velocity, sin φ + ½λ sin 2φ."""


class HarmonicsByMethod(NamedTuple):
    """Harmonics by order: exact, by the texts' form, and the form's error; arrays of shape (..., highest + 1)."""

    exact: Array
    textbook: Array
    error: Array


def acceleration_series(rod_ratio: Array) -> HarmonicsByMethod:
    """Series of the texts for A_k up to order 8, to λ⁷, and what they leave.

    Parameters
    ----------
    rod_ratio : Array, shape (...)
        λ = R/L. [1]

    Returns
    -------
    HarmonicsByMethod, shape (..., 9)

    Notes
    -----
    docs/theory/harmonics-and-orders, eq. (15.6). A text that stops at the second order keeps A_2 = λ alone.

    Examples
    --------
    >>> float(acceleration_series(0.25).error[2]) < 0
    True
    """
    return _compared(acceleration_harmonics(rod_ratio, HIGHEST_ACCELERATION), rod_ratio, _ACCELERATION)


def torque_series(rod_ratio: Array) -> HarmonicsByMethod:
    """Series of the texts for D_k up to order 6, to λ⁶, and what they leave.

    Parameters
    ----------
    rod_ratio : Array, shape (...)
        λ = R/L. [1]

    Returns
    -------
    HarmonicsByMethod, shape (..., 7)

    Notes
    -----
    docs/theory/harmonics-and-orders, eq. (15.8).
    """
    return _compared(torque_harmonics(rod_ratio, HIGHEST_TORQUE), rod_ratio, _TORQUE)


def two_harmonics(rod_ratio: Array) -> HarmonicsByMethod:
    """Two harmonics of the texts, A_1 = 1 and A_2 = λ, and what they leave of orders up to 8; shape (..., 9)."""
    return _compared(acceleration_harmonics(rod_ratio, HIGHEST_ACCELERATION), rod_ratio, _TWO_ACCELERATION)


def two_harmonic_torque(rod_ratio: Array) -> HarmonicsByMethod:
    """Torque of the texts' two harmonics, and what it leaves of orders up to 6; shape (..., 7).

    The first terms of eq. (15.8), docs/theory/harmonics-and-orders.

    Examples
    --------
    >>> two_harmonic_torque(0.25).textbook[:5].tolist()
    [0.0, 0.0625, -0.5, -0.1875, -0.015625]
    """
    return _compared(torque_harmonics(rod_ratio, HIGHEST_TORQUE), rod_ratio, _TWO_TORQUE)


def _compared(exact: Array, rod_ratio: Array, series: Mapping[int, Mapping[int, float]]) -> HarmonicsByMethod:
    """Sum the series and subtract the exact harmonics."""
    ratio = np.asarray(rod_ratio, dtype=float)
    textbook = np.zeros_like(exact)
    for order, terms in series.items():
        textbook[..., order] = sum(coefficient * ratio**power for power, coefficient in terms.items())
    return HarmonicsByMethod(exact, textbook, textbook - exact)
