"""Weights that turn: throws and rod ends, counterweights on the crank, and balance shafts beside it."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.harmonics import ComplexArray, Harmonics, from_vectors, phasor
from cranktrain.numerics.plane_vectors import PlaneVectors

_SAME = 1e-9
"""Orders that differ by less are the same."""


class RotatingWeights(NamedTuple):
    """Unbalanced weights, each on a shaft that turns with the crank; arrays of shape (..., weight).

    Attributes
    ----------
    ratio : Array
        Turns of its shaft to one of the crank, negative against it; 1 on the crank itself. [1]
    moment : Array
        Mass times radius. [kg·m]
    angle : Array
        Where the weight stands at φ = 0, from x in the sense of rotation. [rad]
    position : Array
        z along the shaft. [m]
    place : complex
        Where its shaft lies, x + iy; 0 for the crankshaft. [m]
    """

    ratio: Array
    moment: Array
    angle: Array
    position: Array
    place: ComplexArray


def on_crank(vector: ComplexArray, position: Array) -> RotatingWeights:
    """Weights on the crankshaft from mass times radius as vectors at φ = 0 [kg·m], shape (..., weight)."""
    shape = np.broadcast_shapes(vector.shape, np.shape(position))
    moment, angle, z = (np.broadcast_to(part, shape) for part in (np.abs(vector), np.angle(vector), position))
    return RotatingWeights(np.ones(shape), moment, angle, z, np.zeros(shape, dtype=np.complex128))


def joined(*parts: RotatingWeights) -> RotatingWeights:
    """All weights of several lots, one after another."""
    return RotatingWeights(*(np.concatenate(fields, axis=-1) for fields in zip(*parts, strict=True)))


def weight_orders(weights: RotatingWeights) -> Array:
    """Orders at which weights show, shape (n,)."""
    return np.unique(np.abs(weights.ratio))


def weight_vectors(weights: RotatingWeights, order: Array) -> PlaneVectors:
    """Centrifugal force of each weight on the frame, by order, for each (rad/s)² of the crank.

    Parameters
    ----------
    weights : RotatingWeights, shape (..., weight)
    order : Array, shape (n,)
        Orders wanted; a weight shows at the one that its ratio is.

    Returns
    -------
    PlaneVectors, shape (..., weight, n)
        [kg·m]

    Notes
    -----
    u k² e^{i(kφ + ψ)}. docs/theory/balance, eq. (16.7).
    """
    force = (weights.moment * weights.ratio**2 * phasor(weights.angle))[..., np.newaxis]
    ratio = weights.ratio[..., np.newaxis]
    forward = np.where(np.abs(ratio - order) < _SAME, force, 0.0)
    backward = np.where((np.abs(ratio + order) < _SAME) & (order > 0), force, 0.0)
    return PlaneVectors(order, forward, backward)


def weight_roll(weights: RotatingWeights, order: Array) -> Harmonics:
    """Roll moment of all weights on the frame about the crankshaft, from where their shafts lie, for each (rad/s)².

    Parameters
    ----------
    weights : RotatingWeights, shape (..., weight)
    order : Array, shape (n,)

    Returns
    -------
    Harmonics, shape (..., n)
        Positive in the sense of rotation. [kg·m²]

    Notes
    -----
    x F_y − y F_x. docs/theory/balance, eq. (16.8).
    """
    forward, backward = weight_vectors(weights, order)[1:]
    place = np.conj(weights.place)[..., np.newaxis]
    # Im(place · F): a forward vector f gives −i·place·f as the amplitude of e^{inφ}, a backward one the conjugate.
    amplitude = -1j * place * forward + np.conj(-1j * place * backward)
    return from_vectors(order, np.sum(amplitude, axis=-2))
