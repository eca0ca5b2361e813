"""Phase-vector stars: how the cylinders' torques of one order add up, by their firing angles."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.harmonics import ComplexArray, Harmonics, from_vectors, phasor

_ALIGNED = 1e-9
"""Vectors whose sum falls short of their lengths' by less, in parts of it, all point one way."""
_ROUNDING = 1e-12
"""A sum of less is none, in parts of what all vectors would be in one direction."""


class PhaseStars(NamedTuple):
    """Stars of phase vectors.

    Attributes
    ----------
    order : Array, shape (n,)
    vectors : complex, shape (..., n, cylinder)
        w_i e^{−ikφ_i}: where a cylinder's harmonic of that order stands.
    total : complex, shape (..., n)
        Sum of each star; 0 where it is rounding.
    is_major : bool, shape (..., n)
        All its vectors point one way, so that the harmonics of all cylinders add up. With weights of both signs the
        directions count with them.
    """

    order: Array
    vectors: ComplexArray
    total: ComplexArray
    is_major: NDArray[np.bool_]

    @property
    def length(self) -> Array:
        """Length of each star's sum."""
        return np.abs(self.total)


def phase_stars(order: Array, firing_angle: Array, weight: Array | None = None) -> PhaseStars:
    """Stars of phase vectors for given orders.

    Parameters
    ----------
    order : Array, shape (n,)
        Orders: ½, 1, 1½, … for a cycle of two turns.
    firing_angle : Array, shape (..., cylinder)
        φ_i. [rad]
    weight : Array, shape (..., cylinder), optional
        Each cylinder's weight, as its amplitude in a mode of the shaft (`linear_mode`); 1 unless given.

    Returns
    -------
    PhaseStars

    Notes
    -----
    docs/theory/harmonics-and-orders, eq. (15.14).

    Examples
    --------
    >>> four = np.radians([0.0, 540.0, 180.0, 360.0])
    >>> phase_stars(np.array([0.5, 1.0, 2.0]), four).length
    array([0., 0., 4.])
    """
    weights = np.ones_like(firing_angle) if weight is None else np.asarray(weight, dtype=float)
    vectors = weights[..., np.newaxis, :] * phasor(-order[:, np.newaxis] * firing_angle[..., np.newaxis, :])
    most = np.sum(np.abs(weights), axis=-1)[..., np.newaxis]
    summed = np.sum(vectors, axis=-1)
    total = np.where(np.abs(summed) <= _ROUNDING * most, 0.0, summed)
    return PhaseStars(order, vectors, total, np.abs(total) >= (1 - _ALIGNED) * most)


def linear_mode(position: Array) -> Array:
    """Weights of a mode that falls in a straight line along the shaft, from +1 at the first to −1 at the last position.

    Parameters
    ----------
    position : Array, shape (..., cylinder)
        Along the shaft. [m]

    Returns
    -------
    Array, shape (..., cylinder)
        A first guess at a shaft's twisting; a single position gives 1.
    """
    first, last = np.min(position, axis=-1, keepdims=True), np.max(position, axis=-1, keepdims=True)
    length = np.where(last > first, last - first, 1.0)
    return 1 - 2 * (position - first) / length


def even_firing_sum(order: Array, n_cylinders: int, interval: float) -> Array:
    """Length of the star of cylinders that fire at equal intervals, in closed form.

    Parameters
    ----------
    order : Array, shape (n,)
    n_cylinders : int
    interval : float
        Between one firing and the next. [rad]

    Returns
    -------
    Array, shape (n,)
        |sin(zkΔ/2)/sin(kΔ/2)|, z where kΔ is a whole number of turns. Over a full cycle it is z at the major orders and
        0 at all others; firings over a part of the cycle (one bank) leave others too.

    Notes
    -----
    docs/theory/harmonics-and-orders, eq. (15.15).

    Examples
    --------
    >>> even_firing_sum(np.array([1.0, 1.5, 3.0]), 6, 2 * np.pi / 3).round(12)
    array([0., 0., 6.])
    """
    half = order * interval / 2
    whole = np.abs(half / np.pi - np.rint(half / np.pi)) < _ALIGNED
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(whole, float(n_cylinders), np.abs(np.sin(n_cylinders * half) / np.sin(half)))


def shaft_harmonics(cylinder: Harmonics, firing_angle: Array) -> Harmonics:
    """Harmonics of the whole shaft's torque from one cylinder's, all cylinders being alike.

    Parameters
    ----------
    cylinder : Harmonics, shape (..., n)
        By the angle since the cylinder's own firing.
    firing_angle : Array, shape (..., cylinder)
        φ_i. [rad]

    Returns
    -------
    Harmonics, shape (..., n)
    """
    return from_vectors(cylinder.order, cylinder.vectors * phase_stars(cylinder.order, firing_angle).total)
