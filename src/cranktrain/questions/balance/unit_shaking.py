"""Shaking forces and couples of any layout, by order, for each (rad/s)² of the crank."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.gathering import gathered
from cranktrain.numerics.harmonics import Harmonics, from_vectors, phasor
from cranktrain.numerics.plane_vectors import PlaneVectors
from cranktrain.questions.torque.rod_harmonics import acceleration_harmonics, torque_harmonics


class Cylinders(NamedTuple):
    """Central slider-cranks on one shaft, each with its own dimensions; arrays of shape (..., cylinder).

    Attributes
    ----------
    throw_angle : Array
        θ, the direction of the cylinder's throw at φ = 0, from x in the sense of rotation. Where φ counts from throw 1
        parallel to the first bank's axis, θ_i − θ_1 + γ_1 of a machine file. [rad]
    axis_angle : Array
        γ, the cylinder's axis, from x in the sense of rotation: its crank angle is φ + θ − γ. [rad]
    reciprocating_mass : Array
        Piston set and the rod's share. [kg]
    crank_radius : Array
        [m]
    rod_ratio : Array
        λ = R/L. [1]
    """

    throw_angle: Array
    axis_angle: Array
    reciprocating_mass: Array
    crank_radius: Array
    rod_ratio: Array


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


def reciprocating_vectors(cylinders: Cylinders, highest: int) -> PlaneVectors:
    """Inertia force of each cylinder's reciprocating mass on the frame, by order, exact.

    Parameters
    ----------
    cylinders : Cylinders, shape (..., cylinder)
    highest : int
        Highest order wanted.

    Returns
    -------
    PlaneVectors, shape (..., cylinder, highest + 1)
        For each (rad/s)². [kg·m]

    Notes
    -----
    f_n = ½ m R A_n e^{i[nθ − (n−1)γ]}, b_n = ½ m R A_n e^{−i[nθ − (n+1)γ]}. docs/theory/balance, eq. (16.2).
    """
    order = np.arange(highest + 1.0)
    harmonics = acceleration_harmonics(cylinders.rod_ratio, highest)
    half = 0.5 * (cylinders.reciprocating_mass * cylinders.crank_radius)[..., np.newaxis] * harmonics
    throw, axis = cylinders.throw_angle[..., np.newaxis], cylinders.axis_angle[..., np.newaxis]
    local = phasor(order * (throw - axis))
    along = phasor(axis)
    return PlaneVectors(order, half * along * local, half * along / local)


def throw_vectors(vectors: PlaneVectors, throw: NDArray[np.intp], n_throws: int) -> PlaneVectors:
    """Force of each throw, from those of the cylinders that work on it.

    Parameters
    ----------
    vectors : PlaneVectors, shape (..., cylinder, n)
    throw : integer array, shape (cylinder,)
        Index of each cylinder's throw.
    n_throws : int

    Returns
    -------
    PlaneVectors, shape (..., throw, n)
    """
    forward, backward = (gathered(part, throw, n_throws) for part in (vectors.forward, vectors.backward))
    return PlaneVectors(vectors.order, forward, backward)


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


def inertia_roll(cylinders: Cylinders, highest: int) -> Harmonics:
    """Roll moment of the reciprocating masses on the frame about the crankshaft, by order, for each (rad/s)².

    Parameters
    ----------
    cylinders : Cylinders, shape (..., cylinder)
    highest : int
        Highest order wanted.

    Returns
    -------
    Harmonics, shape (..., highest + 1)
        Positive in the sense of rotation: minus the torque of the same masses on the shaft. [kg·m²]

    Notes
    -----
    Masses at the pins (a rod replaced by two masses; a real rod adds its own). The gas rolls the frame as well, by
    minus its torque. docs/theory/balance, eq. (16.6).
    """
    order = np.arange(highest + 1.0)
    scale = (cylinders.reciprocating_mass * cylinders.crank_radius**2)[..., np.newaxis]
    local = (cylinders.throw_angle - cylinders.axis_angle)[..., np.newaxis]
    amplitude = scale * torque_harmonics(cylinders.rod_ratio, highest) * phasor(order * local)
    return from_vectors(order, 1j * np.sum(amplitude, axis=-2))
