"""Plane vectors that unknowns change linearly, sums over them, and the room that the unknowns have."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.products import summed_products
from cranktrain.synthesis.centres import BarrierValue, outside

_SMALL = 1e-6
"""What an unknown counts of itself among what else matters."""


class Vectors(NamedTuple):
    """Plane vectors at some points, affine in unknowns: base + change · unknown.

    Attributes
    ----------
    base : Array, shape (point, 2)
    change : Array, shape (point, 2, unknown)
    """

    base: Array
    change: Array

    @property
    def scale(self) -> float:
        """Largest vector that there is without unknowns, or that one of them makes."""
        largest = np.max(sizes(self.base)), np.max(np.abs(self.change), initial=0.0)
        return float(max(largest)) or 1.0

    def at(self, unknown: Array) -> Array:
        """Give the vectors, shape (point, 2)."""
        return self.base + self.change @ unknown

    def along(self, weight: Array, vector: Array) -> Array:
        """Σ w Bᵀ q of weights and vectors at the points, shape (unknown,)."""
        return np.einsum("kiu,ki->u", self.change, weight[:, np.newaxis] * vector)

    def across(self, vector: Array, plain: Array, along: Array) -> Array:
        """Σ Bᵀ (p 1 + a q qᵀ) B, shape (unknown, unknown)."""
        flat = (np.sqrt(plain)[:, np.newaxis, np.newaxis] * self.change).reshape(-1, self.change.shape[-1])
        own = np.einsum("kiu,ki->ku", self.change, vector)
        return summed_products(flat, flat) + summed_products(along[:, np.newaxis] * own, own)

    def bound(self, dual: Array, *, turns: bool) -> float:
        """What a dual solution, shape (point, 2), says that the aim does not go below for unknowns in their room."""
        slope = np.einsum("kiu,ki->u", self.change, dual)
        least = -np.sum(np.hypot(*slope.reshape(2, -1))) if turns else np.sum(np.minimum(slope, 0.0))
        return float(np.sum(dual * self.base) + least)


class Rest(NamedTuple):
    """What else matters where several unknowns are as good: ½ uᵀ C u + sᵀ u, of unknowns u; C of shape (n, n)."""

    slope: Array
    curvature: Array

    def with_room(self, unknown: Array, sharpness: float, *, turns: bool) -> BarrierValue:
        """It, times a sharpness, with what keeps unknowns within their room."""
        room, slope = within(unknown, turns=turns), self.slope + self.curvature @ unknown
        return BarrierValue(
            room.value + 0.5 * sharpness * float(unknown @ (slope + self.slope)),
            room.slope + sharpness * slope,
            room.curvature + sharpness * self.curvature,
        )


def mean_square(vectors: Vectors, weight: Array) -> Rest:
    """What half the mean square of plane vectors is of the unknowns, in parts of the largest vector.

    Parameters
    ----------
    vectors : Vectors
    weight : Array, shape (point,)
        Of each vector's square in the mean.

    Returns
    -------
    Rest
        With a little of the unknowns themselves, for those that change no vector.
    """
    scaled = Vectors(vectors.base / vectors.scale, vectors.change / vectors.scale)
    curvature = scaled.across(scaled.base, weight, np.zeros(len(weight)))
    return Rest(scaled.along(weight, scaled.base), curvature + _SMALL * np.eye(len(curvature)))


def within(unknown: Array, *, turns: bool) -> BarrierValue:
    """What keeps unknowns within their room: from 0 to 1, or as components of plane vectors of length 1 at most."""
    n = unknown.size
    pairs = unknown.reshape(2 if turns else 1, -1)
    room = 1 - np.sum(pairs**2, axis=0) if turns else np.concatenate([pairs, 1 - pairs])
    if np.any(room <= 0):
        return outside(n)
    if turns:
        each = 4 * pairs[:, np.newaxis] * pairs / room**2 + 2 / room * np.eye(2)[..., np.newaxis]
        slope, curvature = np.ravel(2 * pairs / room), np.einsum("ijw,wv->iwjv", each, np.eye(n // 2)).reshape(n, n)
    else:
        slope, curvature = 1 / room[1] - 1 / room[0], np.diag(np.sum(1 / room**2, axis=0))
    return BarrierValue(-float(np.sum(np.log(room))), slope, curvature)


def sizes(vector: Array) -> Array:
    """Lengths of vectors, shape (point,)."""
    return np.hypot(vector[:, 0], vector[:, 1])
