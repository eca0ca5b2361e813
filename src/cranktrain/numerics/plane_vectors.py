"""Vectors in the plane across the shaft, by order: one that turns with the crank, one against it."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN, ComplexArray, phasor
from cranktrain.numerics.products import product


class PlaneVectors(NamedTuple):
    """A periodic vector F_x + iF_y = Σ (forward e^{inφ} + backward e^{−inφ}).

    Attributes
    ----------
    order : Array, shape (n,)
        Turns of the vectors to one of the crank.
    forward, backward : complex, shape (..., n)
        In the vector's unit; real part along x, imaginary along y. Order 0 is all forward.
    """

    order: Array
    forward: ComplexArray
    backward: ComplexArray


class Hodograph(NamedTuple):
    """Ellipse that the tip of one order's vector runs along, n times a turn of the crank.

    Attributes
    ----------
    major, minor : Array
        Semi-axes, in the vector's unit: the largest and the smallest length that the vector has.
    direction : Array
        Of the major axis, from x toward y, within half a turn. [rad]
    sense : Array
        1 where the tip runs in the sense of rotation, −1 against it, 0 along a line.
    """

    major: Array
    minor: Array
    direction: Array
    sense: Array


def curve_vectors(x: Array, y: Array, highest: int, cycle: float = TURN) -> PlaneVectors:
    """Orders of any periodic vector, from its components on a grid.

    Parameters
    ----------
    x, y : Array, shape (..., n)
        Components, in equal steps over a cycle, endpoint excluded.
    highest : int
        Highest order wanted.
    cycle : float
        2π or 4π: then the orders are 0, ½, 1, …. [rad]

    Returns
    -------
    PlaneVectors, shape (..., highest · cycle/2π + 1)
        Exact for curves without orders above n/2 periods a cycle.

    Notes
    -----
    docs/theory/balance, eq. (16.4).
    """
    n_points = x.shape[-1]
    n_orders = round(highest * cycle / TURN) + 1
    parts = np.fft.fft(x + 1j * y, axis=-1) / n_points
    place = np.arange(n_orders)
    forward, backward = parts[..., place], parts[..., -place]
    backward[..., 0] = 0.0
    # Seen at its peaks alone, the highest order is not known to turn either way: half of it each.
    once = place == n_points / 2
    share = np.where(once, 0.5, 1.0)
    return PlaneVectors(place.astype(float) * (TURN / cycle), share * forward, share * backward)


def vector_curve(of: PlaneVectors, angle: Array) -> ComplexArray:
    """Sum the orders at crank angles [rad], the same for all (k,) or each its own (..., k); gives (..., k)."""
    turning = phasor(np.asarray(angle)[..., np.newaxis] * of.order)
    if turning.ndim == 2:
        return product(of.forward, turning.T) + product(of.backward, np.conj(turning).T)
    parts = of.forward[..., np.newaxis, :] * turning + of.backward[..., np.newaxis, :] * np.conj(turning)
    return np.sum(parts, axis=-1)


def integrated(of: PlaneVectors) -> PlaneVectors:
    """Integral of the vectors by the crank angle, about its mean; orders above 0.

    Of what turning weights do for each (rad/s)² it is what they do for each rad/s²: both come of their momentum.
    """
    return PlaneVectors(of.order, of.forward / (1j * of.order), of.backward * 1j / of.order)


def delayed_vectors(of: PlaneVectors, angle: Array) -> PlaneVectors:
    """The same vectors, later by a crank angle [rad] of shape (...)."""
    turn = phasor(-np.asarray(angle)[..., np.newaxis] * of.order)
    return PlaneVectors(of.order, of.forward * turn, of.backward / turn)


def machine_axes(vector: ComplexArray, *, clockwise: bool) -> ComplexArray:
    """Components X + iY in the machine's axes, X right and Y up as seen from the free end, of vectors x + iy.

    Parameters
    ----------
    vector : complex
        x is the axis of bank angle 0, which is Y; y is turned from it in the sense of rotation.
    clockwise : bool
        The sense of rotation, so seen.

    Returns
    -------
    complex
        X + iY. It mirrors a clockwise machine, so it is for values at crank angles, not for the vectors of orders.

    Notes
    -----
    docs/theory/balance, eq. (16.14).
    """
    return 1j * (np.conj(vector) if clockwise else vector)


def running_axes(vector: ComplexArray, *, clockwise: bool) -> ComplexArray:
    """Vectors x + iy of components X + iY in the machine's axes: `machine_axes` backward."""
    return 1j * np.conj(vector) if clockwise else -1j * vector


def reversed_vectors(of: PlaneVectors) -> PlaneVectors:
    """The same vectors in axes with y turned round, as a shaft that runs the other way sees them."""
    return PlaneVectors(of.order, np.conj(of.backward), np.conj(of.forward))


def added(*parts: PlaneVectors) -> PlaneVectors:
    """Sum of vectors with the same orders."""
    forward = sum((part.forward for part in parts[1:]), parts[0].forward)
    backward = sum((part.backward for part in parts[1:]), parts[0].backward)
    return PlaneVectors(parts[0].order, forward, backward)


def hodograph(of: PlaneVectors) -> Hodograph:
    """Ellipse of each order.

    Parameters
    ----------
    of : PlaneVectors, shape (..., n)

    Returns
    -------
    Hodograph, shape (..., n)

    Notes
    -----
    Semi-axes |f| + |b| and ||f| − |b||, the major one along (arg f + arg b)/2. docs/theory/balance, eq. (16.3).

    Examples
    --------
    >>> one = hodograph(PlaneVectors(np.array([1.0]), np.array([0.5 + 0j]), np.array([0.5 + 0j])))
    >>> one.major, one.minor
    (array([1.]), array([0.]))
    """
    forward, backward = np.abs(of.forward), np.abs(of.backward)
    direction = np.angle(of.forward * np.where(backward > 0, of.backward, 1.0)) / 2
    return Hodograph(forward + backward, np.abs(forward - backward), direction, np.sign(forward - backward))
