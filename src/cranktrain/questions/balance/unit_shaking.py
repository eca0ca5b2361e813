"""Shaking forces and couples of any layout, by order, for each (rad/s)² of the crank."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.plane_vectors import PlaneVectors, added, hodograph
from cranktrain.questions.balance.rotating_weights import RotatingWeights, weight_vectors


class Shaking(NamedTuple):
    """What a layout does to its frame, by order.

    Attributes
    ----------
    force : PlaneVectors, shape (..., n)
        For each (rad/s)²: [kg·m].
    couple : PlaneVectors, shape (..., n)
        First moment Σ (z − z̄) F, with the force's axes, for each (rad/s)²: [kg·m²]. Where the force vanishes it does
        not depend on z̄. No cross product: a couple along x acts in the plane of x and the shaft.
    """

    force: PlaneVectors
    couple: PlaneVectors


def shaking(vectors: PlaneVectors, position: Array, mid_plane: Array | float = 0.0) -> Shaking:
    """Sum the forces of several planes along the shaft, and their first moments about the mid-plane.

    Parameters
    ----------
    vectors : PlaneVectors, shape (..., plane, n)
        Force of each cylinder, throw or weight, whatever its mechanism, in common axes.
    position : Array, shape (..., plane)
        z along the shaft. [m]
    mid_plane : Array, shape (...)
        z̄, the plane about which couples are taken. [m]

    Returns
    -------
    Shaking

    Notes
    -----
    docs/theory/balance, eq. (16.5).
    """
    arm = (position - np.asarray(mid_plane)[..., np.newaxis])[..., np.newaxis]
    order, forward, backward = vectors
    return Shaking(
        PlaneVectors(order, np.sum(forward, axis=-2), np.sum(backward, axis=-2)),
        PlaneVectors(order, np.sum(arm * forward, axis=-2), np.sum(arm * backward, axis=-2)),
    )


def with_weights(before: Shaking, weights: RotatingWeights, mid_plane: Array | float = 0.0) -> Shaking:
    """Shaking with rotating weights added.

    Parameters
    ----------
    before : Shaking, shapes (..., n)
        About the mid-plane, for each (rad/s)².
    weights : RotatingWeights, shape (..., weight)
    mid_plane : Array, shape (...)
        z̄. [m]

    Returns
    -------
    Shaking
    """
    order = before.force.order
    more = shaking(weight_vectors(weights, order), weights.position, mid_plane)
    return Shaking(added(before.force, more.force), added(before.couple, more.couple))


def gross(vectors: PlaneVectors, arm: Array) -> Array:
    """What all parts would do if they added up in every order: the scale of what balance is.

    Parameters
    ----------
    vectors : PlaneVectors, shape (..., part, n)
    arm : Array, shape (..., part)
        1 for the force, z − z̄ for the couple.

    Returns
    -------
    Array, shape (...)
        For each (rad/s)².
    """
    return np.sum(np.abs(arm) * np.sum(hodograph(vectors).major, axis=-1), axis=-1)
