"""Force or couple on the frame from all mechanisms and balance weights, as curves and by order, and in words."""

from collections.abc import Callable, Sequence
from dataclasses import field
from typing import NamedTuple, TypeVar

import numpy as np

from cranktrain.language import Listed, Words, _
from cranktrain.layout.crank_angle import HIGHEST_ORDER, CrankAngle, order_labels, orders, within
from cranktrain.layout.frames import Frames
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN, ComplexArray
from cranktrain.numerics.plane_vectors import (
    PlaneVectors,
    added,
    curve_vectors,
    hodograph,
    integrated,
    machine_axes,
    vector_curve,
)
from cranktrain.numerics.ties import falling
from cranktrain.questions.balance.frame_forces import FrameForces, RunningFrame
from cranktrain.questions.balance.rotating_weights import RotatingWeights, weight_orders, weight_vectors
from cranktrain.questions.balance.unit_shaking import gross
from cranktrain.record import record
from cranktrain.saying.checks import StageResult
from cranktrain.saying.wording import Names

_GONE = 1e-9
"""What is less than this share of what all parts could do together is none in words."""
_ROUNDING = 1e-12
"""What is less than this share of it is 0."""
BALANCE = ("without", "with")
"""What the dimension `balance` has: the machine without balance weights and, where there are any, with them."""
_ONE_WAY = 1e-9
"""Directions so near to −90° are +90°, and angles so near to a period are its start. [rad]"""
_NAMED = 3
"""How many orders a sentence names."""


@record
class Shaken(StageResult):
    """Force [N] or couple [N·m] on the frame, first without balance weights, then, where there are any, with them.

    gross, shape (design,), is what all parts would do if they added up.
    """

    gross: Array = field(kw_only=True)

    def said(self, largest: Array, names: Names, design: int, unit: str) -> list[Words]:
        """Say its orders, without balance weights and, where there are any, with them."""
        return [orders_in_words(names["order"], one, float(self.gross[design]), unit) for one in largest[design]]

    def left(self, largest: Array, design: int) -> list[list[tuple[int, float]] | None]:
        """Places and sizes of the largest orders, without and with balance weights; None where nothing is known."""
        return [
            [(i, float(one[i])) for i in _largest_first(one, float(self.gross[design]))[:_NAMED]]
            if np.all(np.isfinite(one))
            else None
            for one in largest[design]
        ]


ShakenLike = TypeVar("ShakenLike", bound=Shaken)


class Balanced(NamedTuple):
    """Balance weights, and the arm of each: 1 for the force, z − z̄ for the couple, shape (design, weight)."""

    weights: RotatingWeights
    arm: Array


class _Sums(NamedTuple):
    """Sums of all parts, without and with balance weights: over the cycle's grid, and by order; [N or N·m]."""

    curves: ComplexArray
    vectors: PlaneVectors


def shaken(
    made: Callable[..., ShakenLike],
    frame: FrameForces,
    running: RunningFrame | None,
    frames: Frames,
    crank_angle: CrankAngle,
    speed: Speed,
    *,
    arm: Array,
    balanced: Balanced | None,
) -> ShakenLike:
    """Sum what all mechanisms and the balance weights do to the frame, in force or couple.

    Parameters
    ----------
    made : callable
        The result's class: of curves along the machine's X and Y, shape (design, balance, crank_angle), and by the
        cycle's orders, shape (design, balance, order), of the parts that turn with the crank and against it, of the
        largest and the smallest, of its direction from Y in the normal sense, and of the crank angle there [rad].
    frame : FrameForces
    running : RunningFrame or None
        Where the speed varies over the cycle.
    frames : Frames
    crank_angle : CrankAngle
    speed : Speed
    arm : Array, shape (design, mechanism)
        1 for the force, z − z̄ for the couple. [1 or m]
    balanced : Balanced or None

    Returns
    -------
    What `made` gives.

    Notes
    -----
    docs/theory/balance, eqs. (16.5) and (16.7).
    """
    if running is None:
        sums = _at_constant_speed(frame, crank_angle, speed, arm, balanced)
    else:
        sums = _over_cycle(running, crank_angle, arm, balanced)
    curve = machine_axes(sums.curves, clockwise=frames.clockwise)
    vectors = sums.vectors
    ellipse = hodograph(vectors)
    scale = speed.mean[:, 0, 0] ** 2 * _gross(frame, arm, balanced)
    least = np.maximum(_GONE * scale[:, np.newaxis, np.newaxis], _GONE * ellipse.major)
    # A circle has no long axis, and what has gone no direction.
    has_axis = ellipse.major - ellipse.minor > least
    # Directions along one line are one: from −90°, which itself counts as +90°.
    along = np.pi / 2 - within(np.pi / 2 - frames.running * ellipse.direction, np.pi, _ONE_WAY)
    rounding = _ROUNDING * scale[:, np.newaxis, np.newaxis]
    phase = _phase(vectors, frames.running * along) - crank_angle.zero

    def clear(values: Array) -> Array:
        return np.where(np.abs(values) <= rounding, 0.0, values)

    return made(
        clear(curve.real),
        clear(curve.imag),
        clear(np.abs(vectors.forward)),
        clear(np.abs(vectors.backward)),
        clear(ellipse.major),
        clear(ellipse.minor),
        np.where(has_axis, along, np.nan),
        np.where(has_axis, within(phase, TURN / vectors.order, _ONE_WAY), np.nan),
        gross=scale,
        labels={"balance": BALANCE[: sums.curves.shape[1]], **order_labels(crank_angle.cycle)},
    )


def _phase(vectors: PlaneVectors, direction: Array) -> Array:
    """φ at which each order is largest in its direction, from the running axes, and not against it. [rad]

    docs/theory/balance, eq. (16.18).
    """
    lead = np.angle(vectors.backward * np.conj(vectors.forward)) / 2
    is_against = np.cos(np.angle(vectors.forward) + lead - direction) < 0
    return (lead + np.pi * is_against) / vectors.order


def _gross(frame: FrameForces, arm: Array, balanced: Balanced | None) -> Array:
    """What all parts would do if they added up, for each (rad/s)², shape (design,)."""
    size = gross(frame.vectors, arm)
    if balanced is not None:
        size = size + gross(weight_vectors(balanced.weights, frame.vectors.order), balanced.arm)
    return size


def _at_constant_speed(
    frame: FrameForces, crank_angle: CrankAngle, speed: Speed, arm: Array, balanced: Balanced | None
) -> _Sums:
    """Sums of what the parts do over a turn, for each (rad/s)², times the square of the speed."""
    turns = round(crank_angle.cycle / (2 * np.pi))
    weigh = arm[..., np.newaxis]
    curves: list[ComplexArray] = [np.tile(np.sum(weigh * frame.force[..., :: frame.step], axis=1), turns)]
    by_order = [_summed(frame.vectors, weigh)]
    if balanced is not None:
        own = weight_vectors(balanced.weights, frame.vectors.order)
        more = _summed(own, balanced.arm[..., np.newaxis])
        curves.append(curves[0] + vector_curve(_of_weights(balanced), crank_angle.angle[:, 0]))
        by_order.append(added(by_order[0], more))
    square = speed.value[:, 0] ** 2
    lots = [PlaneVectors(one.order, square * one.forward, square * one.backward) for one in by_order]
    whole: ComplexArray = speed.value**2 * np.stack(curves, axis=1)
    return _Sums(whole, _in_cycle(lots, turns))


def _over_cycle(running: RunningFrame, crank_angle: CrankAngle, arm: Array, balanced: Balanced | None) -> _Sums:
    """Sums over the cycle, and their orders, of which a speed that varies makes half ones as well."""
    curves: list[ComplexArray] = [np.sum(arm[..., np.newaxis] * running.force, axis=1)]
    if balanced is not None:
        of = _of_weights(balanced)
        turning = vector_curve(of, running.angle) * running.drive.speed**2
        curves.append(curves[0] + turning + vector_curve(integrated(of), running.angle) * running.drive.acceleration)
    whole: ComplexArray = np.stack(curves, axis=1)
    order, forward, backward = curve_vectors(whole.real, whole.imag, HIGHEST_ORDER, crank_angle.cycle)
    return _Sums(whole[..., :: running.step], PlaneVectors(order[1:], forward[..., 1:], backward[..., 1:]))


def _of_weights(balanced: Balanced) -> PlaneVectors:
    """What all weights do together, at their own orders, for each (rad/s)²."""
    own = weight_vectors(balanced.weights, weight_orders(balanced.weights))
    return _summed(own, balanced.arm[..., np.newaxis])


def _in_cycle(lots: Sequence[PlaneVectors], turns: int) -> PlaneVectors:
    """Vectors by the orders of a cycle, shape (design, lot, order): what turns with the crank has no half orders."""
    whole = np.stack([one[1:] for one in lots], axis=2)[..., 1:]
    every = np.zeros((*whole.shape[:-1], HIGHEST_ORDER * turns), dtype=np.complex128)
    every[..., turns - 1 :: turns] = whole
    return PlaneVectors(orders(turns * 2 * np.pi), every[0], every[1])


def _summed(vectors: PlaneVectors, arm: Array) -> PlaneVectors:
    """Sum with arms, shape (design, part, order) → (design, order)."""
    return PlaneVectors(vectors.order, *(np.sum(arm * part, axis=1) for part in vectors[1:]))


def _largest_first(largest: Array, gross: float) -> list[int]:
    """Places of orders that there are, the largest first; what is nothing beside `gross` is none."""
    return [i for i in falling(largest) if largest[i] > _GONE * gross]


def _size(value: float, unit: str) -> str:
    """Write a force or couple with four figures."""
    return f"{value / 1e3:.4g} k{unit}" if value >= 1e4 else f"{value:.4g} {unit}"


def orders_in_words(names: Sequence[str], largest: Array, gross: float, unit: str) -> Words:
    """Say which orders there are and how large, the largest first: `order 2, 123 N`; or that there is none.

    Parameters
    ----------
    names : sequence of str
        Of the orders.
    largest : Array, shape (order,)
        Of one design, in SI.
    gross : float
        What is nothing beside this is none.
    unit : str
        N or N*m.
    """
    if not np.all(np.isfinite(largest)):
        return _("not known, as the links do not close all round")
    left = _largest_first(largest, gross)
    if not left:
        return _("none")
    said = [_("order {order}, {size}", order=names[i], size=_size(float(largest[i]), unit)) for i in left[:_NAMED]]
    return Listed([*said, _("and less of others")] if len(left) > _NAMED else said, "; ")
