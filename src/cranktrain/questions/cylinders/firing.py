"""Firing: when each cylinder fires, at what intervals, and whether its true dead centre is there."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import InputError, Problem
from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Pistons
from cranktrain.motion import Array
from cranktrain.numerics import around_zero
from cranktrain.numerics.designs import by_design
from cranktrain.questions.cylinders.travel import CylinderPistons, CylinderTravel
from cranktrain.questions.motion.dead_centres import ANGLE_ROUNDING
from cranktrain.record import record
from cranktrain.references import CONVENTIONS as _THEORY
from cranktrain.saying.catalogue import quantity

_CYLINDER = ("cylinder",)
_SAME = 1e-9
"""Firings closer than this are simultaneous. [rad]"""
_KEPT = 256
"""Orders of which it is kept how they fire."""


@record
class Cycle:
    """The working cycle that the machine declares: 2π or 4π. [rad]

    fires: whether its cylinders fire; a compressor's do not.
    """

    needs: ClassVar[str] = N_("[cylinder] cycle")

    length: float
    fires: bool = True


@record
class FiringOrder:
    """In which order cylinders fire.

    Attributes
    ----------
    order : array of int, shape (cylinder,)
        Indices of the cylinders as they come.
    numbers : tuple of str
        The maker's numbers of these, if any.
    angles : Array, shape (design, cylinder), or None
        φ at which each fires, in [0, cycle), where the file says it. [rad]
    """

    needs: ClassVar[str] = N_("[cylinder] firing_order or firing_angles")
    reads: ClassVar[tuple[str, ...]] = ("[shaft.main]",)

    order: NDArray[np.intp]
    numbers: tuple[str, ...] = ()
    angles: Array | None = None


def common_order(found: FiringOrder | None, n_designs: int) -> FiringOrder | None:
    """Give designs of one machine the order of the first, and each its angles.

    Raises
    ------
    InputError
        Where the angles of one design make another order than those of the first.
    """
    if found is None or found.angles is None:
        return found
    if np.any(np.argsort(found.angles, axis=-1, kind="stable") != found.order):
        raise InputError([Problem("cylinder.firing_angles", None, _("must make the same order in all designs"))])
    return replace(found, angles=by_design(list(found.angles.T), n_designs))


@record
class Firing:
    """When each cylinder fires, nominally (crank along it), and how long until the next one does."""

    firing_angle: Array = quantity(
        "φ_f",
        "deg",
        _CYLINDER,
        N_("Crank angle of nominal firing, the (exhaust) crank along the cylinder"),
        _THEORY,
        "definition",
        is_place=True,
    )
    firing_dead_centre: Array = quantity(
        "φ_fT",
        "deg",
        _CYLINDER,
        N_("Crank angle of the least volume at firing: the true dead centre"),
        _THEORY,
        "definition",
        is_place=True,
    )
    firing_interval: Array = quantity(
        "Δφ_f", "deg", _CYLINDER, N_("From this cylinder's firing to the next one in the order"), _THEORY, "definition"
    )
    order: tuple[int, ...] = ()
    numbers: tuple[str, ...] = ()
    n_choices: tuple[int, ...] = ()


def firing(
    order: FiringOrder,
    cycle: Cycle,
    cylinders: CylinderPistons,
    pistons: Pistons,
    crank_angle: CrankAngle,
    travel: CylinderTravel,
) -> Firing:
    """Firing angles as they are given, or in the turns that make the order true and the intervals most even."""
    top = pistons.nominal_top[:, cylinders.leading, 0]
    nominal = within_turn(top)
    shift = travel.inner - top
    each = [_of_tops(tops[order.order], cycle.length) for tops in nominal] if order.angles is None else []
    in_order = np.stack([own for own, _choices in each]) if order.angles is None else order.angles[:, order.order]
    angles, interval = np.empty_like(nominal), np.empty_like(nominal)
    angles[:, order.order] = in_order
    interval[:, order.order] = np.diff(in_order, append=in_order[:, :1] + cycle.length, axis=-1)
    return Firing(
        firing_angle=crank_angle.counted(angles[..., np.newaxis], cycle.length)[..., 0],
        firing_dead_centre=crank_angle.counted((angles + around_zero(shift))[..., np.newaxis], cycle.length)[..., 0],
        firing_interval=interval,
        order=tuple(order.order.tolist()),
        numbers=order.numbers,
        n_choices=tuple(choices for _own, choices in each) if each else (1,) * len(nominal),
    )


def _of_tops(tops: Array, cycle: float) -> tuple[Array, int]:
    """Firing angles for tops in the order of firing, NaN where there are none, and of how many choices of turns."""
    angles = firing_angles(tops, cycle)
    return np.full(tops.shape, np.nan) if angles is None else angles, firing_choices(tops, cycle)


def has_firing(cycle: Cycle | None) -> bool:
    """Say whether it is for this machine: where nothing fires there is no order to miss."""
    return cycle is None or cycle.fires


def within_turn(tops: Array, period: float = 2 * np.pi) -> Array:
    """Bring crank angles into [0, 2π), or another period; what rounding put just before its end stands at 0. [rad]"""
    turned = np.mod(tops, period)
    return np.where(turned > period - ANGLE_ROUNDING, 0.0, turned)


def firing_angles(tops: Array, cycle: float) -> Array | None:
    """Choose the turn in which each cylinder fires, so that the order is true and the intervals are most even.

    Parameters
    ----------
    tops : Array, shape (cylinder,)
        Crank angle in [0, 2π) at which each one's piston is nominally at its top, in firing order. [rad]
    cycle : float
        2π or 4π. [rad]

    Returns
    -------
    Array, shape (cylinder,), or None
        Angles that rise from the first one's, within one cycle; None where the crank pins stand so that no choice
        of turns gives this order. Cylinders fire at the same time only where more of
        their pistons are at their tops together than the cycle has turns.
    """
    angles = _angles(tuple(tops.tolist()), cycle)
    return None if angles is None else np.array(angles)


def firing_choices(tops: Array, cycle: float) -> int:
    """Count the choices of turns that give an order; parameters as of `firing_angles`."""
    return _choices(tuple(tops.tolist()), cycle)


# Designs, and a machine whose other numbers are changed, mostly have their tops at the same angles.


@lru_cache(maxsize=_KEPT)
def _angles(tops: tuple[float, ...], cycle: float) -> tuple[float, ...] | None:
    """What `firing_angles` gives."""
    apart = _chosen(tops, cycle, least=_SAME)
    if apart is not None:
        return apart
    at = np.array(tops)
    from_each_other = np.abs(np.mod(at - at[:, np.newaxis] + np.pi, 2 * np.pi) - np.pi)
    together = int(np.max(np.sum(from_each_other < _SAME, axis=1)))
    return _chosen(tops, cycle, least=-_SAME) if together > round(cycle / (2 * np.pi)) else None


@lru_cache(maxsize=_KEPT)
def _choices(tops: tuple[float, ...], cycle: float) -> int:
    """What `firing_choices` gives."""
    return _n_choices(tops, cycle, least=_SAME) or _n_choices(tops, cycle, least=-_SAME)


def _n_choices(tops: Sequence[float], cycle: float, least: float) -> int:
    """Count the choices by which the order rises."""
    # For each possible angle of the piston reached so far: by how many choices it is reached.
    ways: list[tuple[float, int]] = [(tops[0], 1)]
    for options in _options(tops, cycle):
        ways = [(angle, sum(n for before, n in ways if angle - before > least)) for angle in options]
    return sum(n for _angle, n in ways)


def _options(tops: Sequence[float], cycle: float) -> Iterator[list[float]]:
    """Give the angles at which each piston but the first can fire within a cycle from the first one's angle."""
    start, *others = tops
    for top in others:
        first = start + (top - start) % (2 * np.pi)
        first = start if first > start + 2 * np.pi - _SAME else first
        yield [first + 2 * np.pi * turn for turn in range(round(cycle / (2 * np.pi)))]


def _chosen(tops: Sequence[float], cycle: float, least: float) -> tuple[float, ...] | None:
    """Choose among the turns by the smallest sum of squared intervals; None where the order cannot rise."""
    start = tops[0]
    # For each possible angle of the piston reached so far: the sum of squares and the angles that led there.
    ways: list[tuple[float, list[float]]] = [(0.0, [start])]
    for options in _options(tops, cycle):
        ways = [
            min((cost + (angle - path[-1]) ** 2, [*path, angle]) for cost, path in reachable)
            for angle in options
            if (reachable := [way for way in ways if angle - way[1][-1] > least])
        ]
        if not ways:
            return None
    return tuple(min((cost + (start + cycle - path[-1]) ** 2, path) for cost, path in ways)[1])
