"""Harmonics of the central slider-crank, exact: of the piston's acceleration and of the torque of its inertia."""

import numpy as np

from cranktrain.motion import Array

MOST_RATIO = 0.9999
"""λ up to which the harmonics are given: nearer to 1 ever more of them matter, and at 1 the series has no sum."""
_NEGLIGIBLE = 40.0
"""A harmonic smaller than e⁻⁴⁰ of the first is not felt."""


def acceleration_harmonics(rod_ratio: Array, highest: int) -> Array:
    """Harmonics A_k of the piston's acceleration, x″ = R Σ A_k cos kφ, for a central slider-crank.

    Parameters
    ----------
    rod_ratio : Array, shape (...)
        λ = R/L, 0 ≤ λ ≤ 0.9999. [1]
    highest : int
        Highest order wanted.

    Returns
    -------
    Array, shape (..., highest + 1)
        A_k by order k = 0, 1, 2, …: A_0 = 0, A_1 = 1, further odd ones 0. Exact to rounding. NaN for another λ.

    Notes
    -----
    A_2n = (8n²/λ) C(½, n) (λ/2)²ⁿ ₂F₁(n − ½, n + ½; 2n + 1; λ²), found by the recurrence of the root's Fourier
    coefficients, which is run downward because only so does it keep its digits. docs/theory/harmonics-and-orders,
    eqs. (15.2) to (15.5).

    Examples
    --------
    >>> float(acceleration_harmonics(0.25, 4)[4])
    -0.004098111172...
    """
    even = _even_harmonics(np.asarray(rod_ratio, dtype=float), highest // 2)
    harmonics = np.zeros((*even.shape[:-1], highest + 1))
    harmonics[..., 2::2] = even[..., : highest // 2]
    harmonics[..., 1:2] = 1.0
    harmonics[np.isnan(even[..., 0])] = np.nan
    return harmonics


def torque_harmonics(rod_ratio: Array, highest: int) -> Array:
    """Harmonics D_k of the torque of the piston's inertia, −m x′x″ ω² = m R² ω² Σ D_k sin kφ.

    Parameters
    ----------
    rod_ratio : Array, shape (...)
        λ = R/L, 0 ≤ λ ≤ 0.9999. [1]
    highest : int
        Highest order wanted.

    Returns
    -------
    Array, shape (..., highest + 1)
        D_k by order k = 0, 1, 2, …, D_0 = 0; positive in the sense of rotation. NaN for another λ.

    Notes
    -----
    With V_k = A_k/k: D_k = (k/2) [Σᵢ Vᵢ Vᵢ₊ₖ − ½ Σ_{i+j=k} Vᵢ Vⱼ]. docs/theory/harmonics-and-orders, eq. (15.7).

    Examples
    --------
    >>> float(torque_harmonics(0.25, 3)[3])
    -0.192055573419...
    """
    return both_harmonics(rod_ratio, highest)[1]


def both_harmonics(rod_ratio: Array, highest: int) -> tuple[Array, Array]:
    """`acceleration_harmonics`, and `torque_harmonics`, which are made of them."""
    ratio = np.asarray(rod_ratio, dtype=float)
    n_all = 2 * max(_n_terms(ratio), highest)
    acceleration = acceleration_harmonics(ratio, n_all)
    velocity = acceleration[..., 1:] / np.arange(1, n_all + 1)
    # Both sums over i, from 1 on: V beyond the last, and before the first, is nothing.
    order, index = np.arange(highest + 1)[:, np.newaxis], np.arange(n_all)
    padded = np.concatenate([np.zeros((*ratio.shape, n_all)), velocity, np.zeros((*ratio.shape, highest))], axis=-1)
    others = padded[..., n_all + index + order] - padded[..., n_all + order - 2 - index] / 2
    torque = order[:, 0] / 2 * np.sum(velocity[..., np.newaxis, :] * others, axis=-1)
    return acceleration[..., : highest + 1], torque


def _even_harmonics(ratio: Array, n_wanted: int) -> Array:
    """A₂, A₄, … of each λ, at least as many as matter and as are wanted."""
    known = np.where((ratio >= 0) & (ratio <= MOST_RATIO), ratio, np.nan)
    n_terms = _n_terms(ratio) + n_wanted
    half_square = known**2 / 2
    middle = 1 - half_square
    quotient = np.zeros_like(known)
    quotients = np.empty((*known.shape, n_terms))
    every = np.arange(n_terms + 1.0).reshape(-1, *np.ones(known.ndim, dtype=int))
    lower, own, higher = -(every - 1.5) * half_square, 2 * middle * every, (every + 1.5) * half_square
    for n in range(n_terms, 1, -1):
        quotient = lower[n] / (own[n] + higher[n] * quotient)
        quotients[..., n - 1] = quotient
    # c₁/(λ c₀), which is finite at λ = 0 too.
    quotients[..., 0] = known / 2 / (2 * middle + 2.5 * half_square * quotient)
    root = np.cumprod(quotients, axis=-1)
    mean = 1 / (1 + known * np.sum(root, axis=-1))
    return 4 * np.arange(1, n_terms + 1) ** 2 * root * mean[..., np.newaxis]


def _n_terms(ratio: Array) -> int:
    """How many even harmonics matter for the largest λ: they fall as (1 − k′)/(1 + k′), k′ = √(1 − λ²)."""
    largest = float(np.max(np.where((ratio > 0) & (ratio <= MOST_RATIO), ratio, 0.01), initial=0.01))
    complement = np.sqrt((1 - largest) * (1 + largest))
    return int(np.ceil(-_NEGLIGIBLE / np.log((1 - complement) / (1 + complement)))) + 2
