"""Balance shafts, solved for: they turn n times as fast as the crank, one with it and one against it."""

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.harmonics import ComplexArray
from cranktrain.numerics.plane_vectors import PlaneVectors
from cranktrain.numerics.ties import first_smallest
from cranktrain.questions.balance.counterweights import two_plane_vectors
from cranktrain.questions.balance.rotating_weights import RotatingWeights
from cranktrain.questions.balance.unit_shaking import Shaking


def lanchester_shafts(force: PlaneVectors, order: int, position: Array, places: ComplexArray) -> RotatingWeights:
    """Two shafts that cancel the force of one order.

    Parameters
    ----------
    force : PlaneVectors, shape (..., n)
        For each (rad/s)². [kg·m]
    order : int
        Which order; the shafts turn at plus and minus so many times the crank's speed.
    position : Array, shape (...)
        z of their weights; the force's own plane, or a couple is left. [m]
    places : complex, broadcastable to (..., 2)
        Where they lie, x + iy, first the one that turns with the crank. [m]

    Returns
    -------
    RotatingWeights, shape (..., 2)
        First the one that turns with the crank. A moment of 0 is a shaft that is not needed.

    Notes
    -----
    docs/theory/balance, eq. (16.12).
    """
    forward, backward = vectors_of(force, order)
    vectors = -np.stack([forward, backward], axis=-1)
    z = np.broadcast_to(np.asarray(position)[..., np.newaxis], vectors.shape)
    return _shafts(vectors, order, z, np.array([1.0, -1.0]), places)


def two_plane_shafts(
    before: Shaking, order: int, planes: Array, places: ComplexArray, mid_plane: Array | float = 0.0
) -> RotatingWeights:
    """Two shafts with weights in two planes that cancel force and couple of one order.

    Parameters
    ----------
    before : Shaking, shapes (..., n)
        About the mid-plane, for each (rad/s)². `couple_of(before)` has the shafts cancel the couple alone.
    order : int
        Which order.
    planes : Array, shape (..., 2)
        z of both planes. [m]
    places : complex, broadcastable to (..., 2)
        Where they lie, x + iy, first the one that turns with the crank. [m]
    mid_plane : Array, shape (...)
        z̄. [m]

    Returns
    -------
    RotatingWeights, shape (..., 4)
        Forward shaft in plane 1, in plane 2, backward shaft in plane 1, in plane 2.

    Notes
    -----
    docs/theory/balance, eqs. (16.11) and (16.12).
    """
    arm = planes - np.asarray(mid_plane)[..., np.newaxis]
    pairs = [
        two_plane_vectors(force, couple, arm)
        for force, couple in zip(vectors_of(before.force, order), vectors_of(before.couple, order), strict=True)
    ]
    vectors = np.concatenate(pairs, axis=-1)
    z = np.broadcast_to(np.concatenate([planes, planes], axis=-1), vectors.shape)
    return _shafts(vectors, order, z, np.array([1.0, 1.0, -1.0, -1.0]), np.repeat(places, 2, axis=-1))


def couple_of(before: Shaking) -> Shaking:
    """The couple alone, without its force."""
    order, forward, backward = before.force
    return Shaking(PlaneVectors(order, np.zeros_like(forward), np.zeros_like(backward)), before.couple)


def vectors_of(vectors: PlaneVectors, order: int) -> tuple[ComplexArray, ComplexArray]:
    """Forward and backward vector of one order, of shape (...)."""
    at = first_smallest(np.abs(vectors.order - order))
    return vectors.forward[..., at], vectors.backward[..., at]


def _shafts(force: ComplexArray, order: int, position: Array, sense: Array, place: ComplexArray) -> RotatingWeights:
    """Weights with these forces for each (rad/s)² of the crank, on shafts that turn `order` times as fast."""
    ratio, where = np.broadcast_to(sense * order, force.shape), np.broadcast_to(place, force.shape)
    return RotatingWeights(ratio, np.abs(force) / order**2, np.angle(force), position, where)
