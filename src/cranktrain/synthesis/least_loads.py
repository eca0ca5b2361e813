"""The least largest, or the least mean size of plane vectors that unknowns change linearly: one minimum, and proved."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.synthesis.centres import Measured, centres, outside

ALIKE = 1e-6
"""Of the least: what is above it by no more than this part is as good, and of that what else matters decides."""
_LEFT, _LEFT_OF_REST = 1e-9, 1e-8
"""How far the last centre may be from the minimum, in parts of the largest vector, and of what else matters."""
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

    def at(self, unknown: Array) -> Array:
        """Give the vectors, shape (point, 2)."""
        return self.base + self.change @ unknown


class Rest(NamedTuple):
    """What else matters where several unknowns are as good: ½ uᵀ C u + sᵀ u, of unknowns u; C of shape (n, n)."""

    slope: Array
    curvature: Array

    def with_barrier(self, barrier: Measured, unknown: Array, sharpness: float) -> Measured:
        """Add it, times a sharpness, to what keeps unknowns within their room."""
        slope = self.slope + self.curvature @ unknown
        return Measured(
            barrier.value + 0.5 * sharpness * float(unknown @ (slope + self.slope)),
            barrier.slope + sharpness * slope,
            barrier.curvature + sharpness * self.curvature,
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
    scale = _scale(vectors)
    change, base = vectors.change / scale, vectors.base / scale
    curvature = _across(Vectors(base, change), base, weight, np.zeros(len(base)))
    return Rest(np.einsum("kiu,ki->u", change, weight[:, np.newaxis] * base), curvature + _SMALL * np.eye(len(curvature)))


class Least(NamedTuple):
    """A minimum.

    Attributes
    ----------
    unknown : Array, shape (unknown,)
        Where it is; of all that are as good but for `ALIKE`, those for which the rest is least.
    value : float
        How much.
    bound : float
        What no unknowns in their room can go below, by a dual solution.
    """

    unknown: Array
    value: float
    bound: float


def least_largest(vectors: Vectors, rest: Rest, *, turns: bool) -> Least:
    """Unknowns for which the largest of some plane vectors is the smallest.

    Parameters
    ----------
    vectors : Vectors
    rest : Rest
    turns : bool
        Whether unknowns are components of plane vectors of length 1 at most, all first ones before all second ones;
        else each is from 0 to 1.

    Returns
    -------
    Least

    Notes
    -----
    Least t with |q_k| ≤ t: convex, with cones of second order. docs/theory/synthesis, eqs. (8.33) to (8.36).

    Examples
    --------
    >>> vectors = Vectors(np.array([[3.0, 1.0], [1.0, 0.0]]), np.array([[[-4.0], [0.0]], [[-4.0], [0.0]]]))
    >>> found = least_largest(vectors, mean_square(vectors, np.ones(2)), turns=False)
    >>> round(float(found.unknown[0]), 4), round(found.value, 4)
    (0.5625, 1.25)
    """
    scale = _scale(vectors)
    scaled = Vectors(vectors.base / scale, vectors.change / scale)
    start = np.append(_middle(vectors, turns=turns), 0.0)
    start[-1] = 1.0 + np.max(_sizes(scaled.at(start[:-1])))

    def measured(place: Array, sharpness: float) -> Measured:
        own, most = _within(place[:-1], turns=turns), place[-1]
        vector = scaled.at(place[:-1])
        room = most**2 - np.sum(vector**2, axis=1)
        if most <= 0 or np.any(room <= 0):
            return outside(place.size)
        slope = np.append(_along(scaled, 2 / room, vector) + own.slope, sharpness - np.sum(2 * most / room))
        curvature = np.empty((place.size, place.size))
        curvature[:-1, :-1] = _across(scaled, vector, 2 / room, 4 / room**2) + own.curvature
        curvature[-1, -1] = np.sum(4 * most**2 / room**2 - 2 / room)
        curvature[:-1, -1] = curvature[-1, :-1] = _along(scaled, -4 * most / room**2, vector)
        return Measured(float(sharpness * most - np.sum(np.log(room))) + own.value, slope, curvature)

    def below(place: Array, sharpness: float) -> Measured:
        vector, own = scaled.at(place), rest.with_barrier(_within(place, turns=turns), place, sharpness)
        room = cap**2 - np.sum(vector**2, axis=1)
        if np.any(room <= 0):
            return outside(place.size)
        return Measured(
            own.value - float(np.sum(np.log(room))),
            own.slope + _along(scaled, 2 / room, vector),
            own.curvature + _across(scaled, vector, 2 / room, 4 / room**2),
        )

    parameter = 2.0 * (len(scaled.base) + start.size)
    unknown, bound = start[:-1], 0.0
    for centre in centres(measured, start, parameter, _LEFT):
        unknown, most = centre.place[:-1], centre.place[-1]
        vector = scaled.at(unknown)
        dual = vector / (most**2 - np.sum(vector**2, axis=1))[:, np.newaxis]
        bound = max(bound, _bound(scaled, dual / np.sum(_sizes(dual)), turns=turns))
    cap = (1 + ALIKE) * np.max(_sizes(scaled.at(unknown)))
    for centre in centres(below, unknown, parameter, _LEFT_OF_REST):
        unknown = centre.place
    return Least(unknown, scale * float(np.max(_sizes(scaled.at(unknown)))), scale * bound)


def least_mean(vectors: Vectors, weight: Array, rest: Rest, *, turns: bool) -> Least:
    """Unknowns for which the mean size of some plane vectors is the smallest.

    Parameters
    ----------
    vectors : Vectors
    weight : Array, shape (point,)
        Of each vector's size in the mean; of 0 it does not count.
    rest : Rest
    turns : bool
        As `least_largest` takes it.

    Returns
    -------
    Least

    Notes
    -----
    Least Σ w_k t_k with |q_k| ≤ t_k; each t_k follows from the unknowns. docs/theory/synthesis, eqs. (8.33) to (8.37).

    Examples
    --------
    >>> vectors = Vectors(np.array([[3.0, 0.0], [1.0, 0.0]]), np.array([[[-4.0], [0.0]], [[-4.0], [0.0]]]))
    >>> share = np.array([0.75, 0.25])
    >>> found = least_mean(vectors, share, mean_square(vectors, share), turns=False)
    >>> round(float(found.unknown[0]), 4), round(found.value, 4)
    (0.75, 0.5)
    """
    scale, counts = _scale(vectors), weight > 0
    scaled, share = Vectors(vectors.base[counts] / scale, vectors.change[counts] / scale), weight[counts]
    start = _middle(vectors, turns=turns)
    parameter = 2.0 * (len(scaled.base) + start.size)

    def measured(place: Array, sharpness: float) -> Measured:
        own = rest.with_barrier(_within(place, turns=turns), place, ALIKE * sharpness)
        vector, sharp = scaled.at(place), sharpness * share
        root, most = _over(_sizes(vector), sharp)
        return Measured(
            own.value + float(np.sum(sharp * most - np.log(2 * most / sharp))),
            own.slope + _along(scaled, sharp / most, vector),
            own.curvature + _across(scaled, vector, sharp / most, -(sharp**2) / (root * most**2)),
        )

    unknown, bound = start, 0.0
    for centre in centres(measured, start, parameter, _LEFT):
        unknown = centre.place
        vector = scaled.at(unknown)
        _root, most = _over(_sizes(vector), centre.sharpness * share)
        bound = max(bound, _bound(scaled, (share / most)[:, np.newaxis] * vector, turns=turns))
    return Least(unknown, scale * float(np.sum(share * _sizes(scaled.at(unknown)))), scale * bound)


def _within(unknown: Array, *, turns: bool) -> Measured:
    """What keeps unknowns within their room."""
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
    return Measured(-float(np.sum(np.log(room))), slope, curvature)


def _middle(vectors: Vectors, *, turns: bool) -> Array:
    """Unknowns in the middle of their room."""
    return np.full(vectors.change.shape[-1], 0.0 if turns else 0.5)


def _scale(vectors: Vectors) -> float:
    """Largest vector that there is without unknowns, or that one of them makes."""
    largest = np.max(_sizes(vectors.base)), np.max(np.abs(vectors.change), initial=0.0)
    return float(max(largest)) or 1.0


def _sizes(vector: Array) -> Array:
    """Lengths of vectors, shape (point,)."""
    return np.hypot(vector[:, 0], vector[:, 1])


def _over(size: Array, sharp: Array) -> tuple[Array, Array]:
    """√(1 + (τ w s)²) of sizes s, and the t at their centre."""
    root = np.hypot(1.0, sharp * size)
    return root, (1 + root) / sharp


def _along(vectors: Vectors, weight: Array, vector: Array) -> Array:
    """Σ w Bᵀ q, shape (unknown,)."""
    return np.einsum("kiu,ki->u", vectors.change, weight[:, np.newaxis] * vector)


def _across(vectors: Vectors, vector: Array, plain: Array, along: Array) -> Array:
    """Σ Bᵀ (p 1 + a q qᵀ) B, shape (unknown, unknown)."""
    change = vectors.change
    flat = (np.sqrt(plain)[:, np.newaxis, np.newaxis] * change).reshape(-1, change.shape[-1])
    own = np.einsum("kiu,ki->ku", change, vector)
    return flat.T @ flat + (along[:, np.newaxis] * own).T @ own


def _bound(vectors: Vectors, dual: Array, *, turns: bool) -> float:
    """What a dual solution says that no unknowns in their room go below."""
    slope = np.einsum("kiu,ki->u", vectors.change, dual)
    least = -np.sum(np.hypot(*slope.reshape(2, -1))) if turns else np.sum(np.minimum(slope, 0.0))
    return float(np.sum(dual * vectors.base) + least)
