"""Counterweights on the crank, solved for: all that rotates, a share of what reciprocates, the least largest force.

First *what* turns with the crank and is to be taken away (`share_of`, `middle_of`), of the force or, alike, of the
couple; then *where* the weights stand: opposite, on each throw (`on_crank`), or in `two_plane_counterweights`.
"""

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.enclosing import smallest_circle
from cranktrain.numerics.harmonics import ComplexArray, phasor
from cranktrain.numerics.plane_vectors import PlaneVectors, vector_curve
from cranktrain.questions.balance.rotating_weights import RotatingWeights, on_crank


def share_of(rotating: ComplexArray, swinging: ComplexArray, share: Array | float) -> ComplexArray:
    """All that rotates and a share of what reciprocates, as a vector that turns with the crank.

    Parameters
    ----------
    rotating : complex, shape (...)
        Mass times radius of what rotates, toward where it stands at φ = 0; or its first moment along the shaft. [kg·m]
    swinging : complex, shape (...)
        What turns with the crank in the first order of the reciprocating masses' force for each (rad/s)²; or of its
        couple. [kg·m]
    share : Array, shape (...)
        κ of the reciprocating masses: ½ is all that turns with the crank. [1]

    Returns
    -------
    complex, shape (...)

    Notes
    -----
    r + 2κ f_1: central slider-cranks of one throw have f_1 = ½ Σm R e^{iθ} whatever their axes. docs/theory/balance,
    eq. (16.9).
    """
    return rotating + 2 * np.asarray(share) * swinging


def middle_of(force: PlaneVectors) -> ComplexArray:
    """What turns with the crank so that, without it, the largest force of all orders together is the least.

    Parameters
    ----------
    force : PlaneVectors, shape (..., n)
        All that shakes, whole orders: of a throw or of the engine, or its couple, for each (rad/s)². [kg·m]

    Returns
    -------
    complex, shape (...)
        Toward where it stands at φ = 0. [kg·m]

    Notes
    -----
    Seen from the crank, a counterweight moves the whole hodograph by its vector: the best one brings the centre of the
    smallest circle round it to the shaft. docs/theory/balance, eq. (16.10).
    """
    shape = force.forward.shape[:-1]
    centre = np.empty(shape, dtype=np.complex128)
    for place in np.ndindex(shape):
        one = PlaneVectors(force.order, force.forward[place], force.backward[place])

        def seen_from_crank(angle: Array, one: PlaneVectors = one) -> ComplexArray:
            return vector_curve(one, angle) * phasor(-angle)

        centre[place] = smallest_circle(seen_from_crank).centre
    return centre


def two_plane_counterweights(
    force: ComplexArray, couple: ComplexArray, planes: Array, mid_plane: Array | float = 0.0
) -> RotatingWeights:
    """Counterweights in two planes of the crankshaft.

    Parameters
    ----------
    force, couple : complex, shape (...)
        What they take away of the shaft, the couple about the mid-plane. [kg·m, kg·m²]
    planes : Array, shape (..., 2)
        z of both planes. [m]
    mid_plane : Array, shape (...)
        z̄. [m]

    Returns
    -------
    RotatingWeights, shape (..., 2)

    Notes
    -----
    docs/theory/balance, eq. (16.11).
    """
    arm = planes - np.asarray(mid_plane)[..., np.newaxis]
    return on_crank(two_plane_vectors(force, couple, arm), planes)


def two_plane_vectors(force: ComplexArray, couple: ComplexArray, planes: Array) -> ComplexArray:
    """Vectors in two planes that cancel a force and a couple.

    Parameters
    ----------
    force, couple : complex, shape (...)
        What is to be cancelled.
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
