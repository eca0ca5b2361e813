"""Forces and rolls of any layout of central slider-cranks by order, in closed form: what balance is judged by."""

from typing import NamedTuple

import numpy as np

from cranktrain.numerics.harmonics import from_vectors, phasor
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
    reciprocating_mass, crank_radius, rod_ratio : Array
        Piston set and the rod's share [kg], R [m], λ = R/L.
    """

    throw_angle: np.ndarray
    axis_angle: np.ndarray
    reciprocating_mass: np.ndarray
    crank_radius: np.ndarray
    rod_ratio: np.ndarray


def reciprocating_vectors(cylinders, highest):
    """Inertia force of each reciprocating mass on the frame, for each (rad/s)²; docs/theory/balance, eq. (16.2)."""
    order = np.arange(highest + 1.0)
    harmonics = acceleration_harmonics(cylinders.rod_ratio, highest)
    half = 0.5 * (cylinders.reciprocating_mass * cylinders.crank_radius)[..., np.newaxis] * harmonics
    throw, axis = cylinders.throw_angle[..., np.newaxis], cylinders.axis_angle[..., np.newaxis]
    local = phasor(order * (throw - axis))
    along = phasor(axis)
    return PlaneVectors(order, half * along * local, half * along / local)


def inertia_roll(cylinders, highest):
    """Roll moment of the same masses on the frame, minus their torque on the shaft; docs/theory/balance, eq. (16.6)."""
    order = np.arange(highest + 1.0)
    scale = (cylinders.reciprocating_mass * cylinders.crank_radius**2)[..., np.newaxis]
    local = (cylinders.throw_angle - cylinders.axis_angle)[..., np.newaxis]
    amplitude = scale * torque_harmonics(cylinders.rod_ratio, highest) * phasor(order * local)
    return from_vectors(order, 1j * np.sum(amplitude, axis=-2))


def roll_free_place(shafts, roll, order, backward):
    """Where the forward one of Lanchester's shafts also takes a roll moment away; docs/theory/balance, eq. (16.13)."""
    with_crank, against = np.moveaxis(shafts.moment * shafts.ratio**2 * phasor(shafts.angle), -1, 0)
    at = np.argmin(np.abs(roll.order - order))
    turned = -(roll.sine[..., at] + 1j * roll.cosine[..., at]) + np.conj(np.conj(backward) * against)
    return np.conj(turned / with_crank)
