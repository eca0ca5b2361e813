"""Phase-vector stars: how the cylinders' torques of one order add up, by their firing angles."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.crank_angle import orders
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN, ComplexArray, Harmonics, from_vectors, phasor

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


def stars_of_cycle(firing_angle: Array, cycle: float, of_machine: float, weight: Array | None = None) -> PhaseStars:
    """Stars of all orders of a machine, whose cycle may be two of its cylinders.

    Parameters
    ----------
    firing_angle, weight
        As of `phase_stars`.
    cycle : float
        Of the cylinders. [rad]
    of_machine : float
        Cycle of the machine, one or two of these. [rad]

    Returns
    -------
    PhaseStars
        Without vectors between the cylinders' own orders, where their torque has none.
    """
    order = orders(of_machine)
    found = phase_stars(order, firing_angle, weight)
    is_own = np.mod(order * round(cycle / TURN), 1.0) == 0.0
    return found._replace(
        vectors=np.where(is_own[:, np.newaxis], found.vectors, 0.0),
        total=np.where(is_own, found.total, 0.0),
        is_major=found.is_major & is_own,
    )


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
