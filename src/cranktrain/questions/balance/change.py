"""Before and after: what counterweights and balance shafts take away, and what is left, of which order."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.plane_vectors import PlaneVectors, added, hodograph
from cranktrain.questions.balance.rotating_weights import RotatingWeights, weight_vectors
from cranktrain.questions.balance.unit_shaking import Shaking, shaking

FORCE = "force"
COUPLE = "couple"
_GONE = 1e-9
"""What is left below this share of what the parts could do has gone: rounding."""


class BalanceChange(NamedTuple):
    """Largest force and couple of each order, before and after; arrays of shape (..., n), for each (rad/s)²."""

    order: Array
    force_before: Array
    force_after: Array
    couple_before: Array
    couple_after: Array


class Remainder(NamedTuple):
    """One order of force or couple that is left, and how large it was and is, for each (rad/s)²."""

    what: str
    order: float
    before: float
    after: float


class Gross(NamedTuple):
    """What all parts would do if they added up in every order: force and couple for each (rad/s)², shape (...)."""

    force: Array
    couple: Array


def gross_shaking(vectors: PlaneVectors, position: Array, mid_plane: Array | float = 0.0) -> Gross:
    """Sum the parts' largest forces and their moments without regard to direction: the scale of what balance is.

    Parameters
    ----------
    vectors : PlaneVectors, shape (..., plane, n)
    position : Array, shape (..., plane)
        z along the shaft. [m]
    mid_plane : Array, shape (...)
        z̄. [m]

    Returns
    -------
    Gross, shape (...)
    """
    length = np.sum(hodograph(vectors).major, axis=-1)
    arm = np.abs(position - np.asarray(mid_plane)[..., np.newaxis])
    return Gross(np.sum(length, axis=-1), np.sum(arm * length, axis=-1))


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


def balance_change(before: Shaking, after: Shaking) -> BalanceChange:
    """Largest force and couple of each order, before and after."""
    return BalanceChange(
        before.force.order,
        hodograph(before.force).major,
        hodograph(after.force).major,
        hodograph(before.couple).major,
        hodograph(after.couple).major,
    )


def remainders(change: BalanceChange, gross: Gross) -> tuple[Remainder, ...]:
    """What is left of one machine, forces first, the largest in front: the data of a sentence.

    Parameters
    ----------
    change : BalanceChange, shape (n,)
    gross : Gross
        Of the same machine: what is less than rounding of it is nothing.

    Returns
    -------
    tuple of Remainder
        Empty where the machine is balanced in every order that was looked at.
    """
    lines: list[Remainder] = []
    for what, before, after, scale in (
        (FORCE, change.force_before, change.force_after, gross.force),
        (COUPLE, change.couple_before, change.couple_after, gross.couple),
    ):
        found = [
            Remainder(what, float(order), float(was), float(left))
            for order, was, left in zip(change.order, before, after, strict=True)
            if left > _GONE * float(scale)
        ]
        lines += sorted(found, key=lambda one: -one.after)
    return tuple(lines)
