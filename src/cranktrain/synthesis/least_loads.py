"""The least largest, or the least mean size of plane vectors that unknowns change linearly: one minimum, and proved."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.synthesis.centres import Barred, BarrierValue, centres, outside
from cranktrain.synthesis.plane_loads import Rest, Vectors, sizes, within

ALIKE = 1e-6
"""Of the least: what is above it by no more than this part is as good, and of that what else matters decides."""
_LEFT, _LEFT_OF_REST = 1e-9, 1e-8
"""How far the last centre may be from the minimum, in parts of the largest vector, and of what else matters."""


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
    Least t with |q_k| ≤ t: convex, with cones of second order. docs/theory/synthesis, eqs. (8.33) to (8.37).

    Examples
    --------
    >>> from cranktrain.synthesis.plane_loads import mean_square
    >>> vectors = Vectors(np.array([[3.0, 1.0], [1.0, 0.0]]), np.array([[[-4.0], [0.0]], [[-4.0], [0.0]]]))
    >>> found = least_largest(vectors, mean_square(vectors, np.ones(2)), turns=False)
    >>> round(float(found.unknown[0]), 4), round(found.value, 4)
    (0.5625, 1.25)
    """
    scale, scaled, unknown = _scaled(vectors, turns=turns)
    start = np.append(unknown, 1.0 + np.max(sizes(scaled.at(unknown))))
    parameter, bound = 2.0 * (len(scaled.base) + start.size), 0.0
    for centre in centres(_under_the_largest(scaled, turns=turns), start, parameter, _LEFT):
        unknown, most = centre.place[:-1], centre.place[-1]
        vector = scaled.at(unknown)
        dual = vector / (most**2 - np.sum(vector**2, axis=1))[:, np.newaxis]
        bound = max(bound, scaled.bound(dual / (np.sum(sizes(dual)) or 1.0), turns=turns))
    cap = (1 + ALIKE) * float(np.max(sizes(scaled.at(unknown)))) + _LEFT
    for centre in centres(_under_a_cap(scaled, rest, cap, turns=turns), unknown, parameter, _LEFT_OF_REST):
        unknown = centre.place
    return Least(unknown, scale * float(np.max(sizes(scaled.at(unknown)))), scale * bound)


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
    >>> from cranktrain.synthesis.plane_loads import mean_square
    >>> vectors = Vectors(np.array([[3.0, 0.0], [1.0, 0.0]]), np.array([[[-4.0], [0.0]], [[-4.0], [0.0]]]))
    >>> share = np.array([0.75, 0.25])
    >>> found = least_mean(vectors, share, mean_square(vectors, share), turns=False)
    >>> round(float(found.unknown[0]), 4), round(found.value, 4)
    (0.75, 0.5)
    """
    counts = weight > 0
    scale, scaled, unknown = _scaled(Vectors(vectors.base[counts], vectors.change[counts]), turns=turns)
    share, bound = weight[counts], 0.0
    parameter = 2.0 * (len(scaled.base) + unknown.size)
    for centre in centres(_over_the_mean(scaled, share, rest, turns=turns), unknown, parameter, _LEFT):
        unknown = centre.place
        vector = scaled.at(unknown)
        _root, most = _over(sizes(vector), centre.sharpness * share)
        bound = max(bound, scaled.bound((share / most)[:, np.newaxis] * vector, turns=turns))
    return Least(unknown, scale * float(np.sum(share * sizes(scaled.at(unknown)))), scale * bound)


def _scaled(vectors: Vectors, *, turns: bool) -> tuple[float, Vectors, Array]:
    """The largest vector, the vectors in parts of it, and unknowns in the middle of their room."""
    scale = vectors.scale
    middle: Array = np.zeros(vectors.change.shape[-1]) + (0.0 if turns else 0.5)
    return scale, Vectors(vectors.base / scale, vectors.change / scale), middle


def _under_the_largest(vectors: Vectors, *, turns: bool) -> Barred:
    """Of unknowns and t: t, where it is above all sizes."""

    def measured(place: Array, sharpness: float) -> BarrierValue:
        unknown, most = place[:-1], place[-1]
        room, vector = within(unknown, turns=turns), vectors.at(unknown)
        above = most**2 - np.sum(vector**2, axis=1)
        if most <= 0 or np.any(above <= 0):
            return outside(place.size)
        slope = np.append(vectors.along(2 / above, vector) + room.slope, sharpness - np.sum(2 * most / above))
        curvature = np.empty((place.size, place.size))
        curvature[:-1, :-1] = vectors.across(vector, 2 / above, 4 / above**2) + room.curvature
        curvature[-1, -1] = np.sum(4 * most**2 / above**2 - 2 / above)
        curvature[:-1, -1] = curvature[-1, :-1] = vectors.along(-4 * most / above**2, vector)
        return BarrierValue(float(sharpness * most - np.sum(np.log(above))) + room.value, slope, curvature)

    return measured


def _under_a_cap(vectors: Vectors, rest: Rest, cap: float, *, turns: bool) -> Barred:
    """Of unknowns: what else matters, where a cap is above all sizes."""

    def measured(place: Array, sharpness: float) -> BarrierValue:
        vector, own = vectors.at(place), rest.with_room(place, sharpness, turns=turns)
        below = cap**2 - np.sum(vector**2, axis=1)
        if np.any(below <= 0):
            return outside(place.size)
        return BarrierValue(
            own.value - float(np.sum(np.log(below))),
            own.slope + vectors.along(2 / below, vector),
            own.curvature + vectors.across(vector, 2 / below, 4 / below**2),
        )

    return measured


def _over_the_mean(vectors: Vectors, share: Array, rest: Rest, *, turns: bool) -> Barred:
    """Of unknowns: the mean of the least t_k above each size, and a little of what else matters."""

    def measured(place: Array, sharpness: float) -> BarrierValue:
        own = rest.with_room(place, ALIKE * sharpness, turns=turns)
        vector, sharp = vectors.at(place), sharpness * share
        root, most = _over(sizes(vector), sharp)
        return BarrierValue(
            own.value + float(np.sum(sharp * most - np.log(2 * most / sharp))),
            own.slope + vectors.along(sharp / most, vector),
            own.curvature + vectors.across(vector, sharp / most, -(sharp**2) / (root * most**2)),
        )

    return measured


def _over(size: Array, sharp: Array) -> tuple[Array, Array]:
    """√(1 + (τ w s)²) of sizes s, and the t at their centre."""
    root = np.hypot(1.0, sharp * size)
    return root, (1 + root) / sharp
