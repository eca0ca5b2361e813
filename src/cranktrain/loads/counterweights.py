"""Counterweights on the crank, solved for: all that rotates, a share of what reciprocates, the least largest force."""

import numpy as np

from cranktrain.loads.enclosing import smallest_circle
from cranktrain.loads.harmonics import ComplexArray, phasor
from cranktrain.loads.vectors import PlaneVectors, vector_curve
from cranktrain.loads.weights import RotatingWeights, on_crank
from cranktrain.motion import Array


def share_counterweights(
    rotating: ComplexArray, reciprocating: PlaneVectors, share: Array | float, position: Array
) -> RotatingWeights:
    """Counterweights opposite each throw for all of its rotating mass and a share of its reciprocating mass.

    Parameters
    ----------
    rotating : complex, shape (..., throw)
        Mass times radius of what rotates on the throw, toward where it stands at φ = 0. [kg·m]
    reciprocating : PlaneVectors, shape (..., throw, n)
        Forces of the throw's reciprocating masses for each (rad/s)², with order 1. [kg·m]
    share : Array, shape (..., 1)
        κ of the reciprocating masses: ½ takes away all that turns with the crank. [1]
    position : Array, shape (..., throw)
        z of the throws. [m]

    Returns
    -------
    RotatingWeights, shape (..., throw)

    Notes
    -----
    −(rotating + 2κ f_1): a central slider-crank has f_1 = ½ m R e^{iθ} whatever its axis. docs/theory/balance,
    eq. (16.9).
    """
    return on_crank(-(rotating + 2 * np.asarray(share) * first_forward(reciprocating)), position)


def two_plane_vectors(force: ComplexArray, couple: ComplexArray, planes: Array) -> ComplexArray:
    """Vectors in two planes that cancel a force and a couple.

    Parameters
    ----------
    force, couple : complex, shape (...)
        What is to be cancelled. [N, N·m or for each (rad/s)²]
    planes : Array, shape (..., 2)
        z of both planes, from where the couple counts. [m]

    Returns
    -------
    complex, shape (..., 2)
        NaN where both planes are one.

    Notes
    -----
    docs/theory/balance, eq. (16.11).
    """
    first, second = planes[..., 0], planes[..., 1]
    apart = np.where(second == first, np.nan, second - first)
    with np.errstate(invalid="ignore"):
        return np.stack([-(second * force - couple) / apart, -(couple - first * force) / apart], axis=-1)


def two_plane_counterweights(
    force: PlaneVectors, couple: PlaneVectors, planes: Array, mid_plane: Array | float = 0.0
) -> RotatingWeights:
    """Counterweights in two planes of the crankshaft that take away force and couple that turn with it.

    Parameters
    ----------
    force, couple : PlaneVectors, shape (..., n)
        All of the shaft, rotating and reciprocating, about the mid-plane, for each (rad/s)². [kg·m, kg·m²]
    planes : Array, shape (..., 2)
        z of both planes. [m]
    mid_plane : Array, shape (...)
        z̄ about which the couple counts. [m]

    Returns
    -------
    RotatingWeights, shape (..., 2)
    """
    arm = planes - np.asarray(mid_plane)[..., np.newaxis]
    return on_crank(two_plane_vectors(first_forward(force), first_forward(couple), arm), planes)


def least_largest_vector(force: PlaneVectors) -> ComplexArray:
    """Vector of the counterweight that makes the largest force of all orders together as small as it can be.

    Parameters
    ----------
    force : PlaneVectors, shape (..., n)
        What shakes without it, whole orders: of a throw, of the engine, or its couple, for each (rad/s)². [kg·m]

    Returns
    -------
    complex, shape (...)
        Mass times radius toward where it stands at φ = 0; for a couple also times the distance of its planes. [kg·m]

    Notes
    -----
    Seen from the crank, a counterweight moves the whole hodograph by its vector: the best one brings the centre of the
    smallest circle round it to the shaft. docs/theory/balance, eq. (16.10).
    """
    shape = force.forward.shape[:-1]
    best = np.empty(shape, dtype=complex)
    for place in np.ndindex(shape):
        one = PlaneVectors(force.order, force.forward[place], force.backward[place])
        best[place] = -smallest_circle(lambda angle, one=one: vector_curve(one, angle) * phasor(-angle)).centre
    return best


def first_forward(vectors: PlaneVectors) -> ComplexArray:
    """What turns with the crank: the forward vector of order 1, of shape (...)."""
    return vectors.forward[..., np.argmin(np.abs(vectors.order - 1))]
