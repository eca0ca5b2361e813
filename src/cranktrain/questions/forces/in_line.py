"""Forces where links lie in line and come through: the limits from beside, or beyond all bounds."""

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.mechanisms.dynamics import Forces
from cranktrain.motion import Array
from cranktrain.numerics.nested import filled, leaves
from cranktrain.numerics.series import around_zero
from cranktrain.numerics.subintervals import interpolation, leggauss
from cranktrain.numerics.ties import first_smallest_along

_NEAR = 1e-3
"""Nearer than so to a change point forces have lost digits that they have from here on. [rad]"""
_AT = 1e-9
"""Nearer than so is at it. [rad]"""
_WIDTH = 0.05
"""Of the panel beside a change point from which the limit is taken [rad], at so many of Gauss's points."""
_N_POINTS = 8
_LEFT = 1e-7
"""Of the forces about: what is more is no rounding of a moment that is left where no force of links in line has one."""


class _Beside(NamedTuple):
    """Angles that lie near change points, shape (design, mechanism, column): how far off, of whom, their panels."""

    column: NDArray[np.intp]
    off: Array
    is_near: NDArray[np.bool_]
    nodes: Array


def change_points(mechanisms: Mechanisms) -> Array:
    """Where links lie in line and come through, φ of shape (design, mechanism, k), NaN for none."""
    own = [
        (batch.index, batch.kind.change_points.angle(batch.members.geometry) - batch.members.phase)
        for batch in mechanisms.batches
        if batch.kind.change_points is not None
    ]
    found = np.full((*mechanisms.nominal_top.shape[:2], max(angle.shape[-1] for _index, angle in own)), np.nan)
    for index, angle in own:
        found[:, index, : angle.shape[-1]] = angle
    return found


def by_limits(
    mechanisms: Mechanisms,
    angle: Array,
    solved: Sequence[Forces],
    solve: Callable[[Array], Sequence[Forces]],
) -> Sequence[Forces]:
    """Put limits in place of forces at change points and just beside.

    Parameters
    ----------
    mechanisms : Mechanisms
    angle : Array, shape (n,), (design, 1, n) or (design, mechanism, n)
        φ. [rad]
    solved : sequence of Forces
        There, of each kind's mechanisms.
    solve : callable
        Gives them at other φ, of shape (design, mechanism, m).

    Returns
    -------
    sequence of Forces
        NaN at a change point where a moment is left that no force of links in line can hold.

    Notes
    -----
    The limit is that of a polynomial through points of the panel beside; docs/theory/forces, eq. (13.59).
    """
    beside = _beside(change_points(mechanisms), angle)
    if beside is None:
        return solved
    aside = solve(beside.nodes.reshape(*beside.off.shape[:2], -1))
    return [
        one if batch.kind.change_points is None else filled(one, _with_limits(one, other, beside, batch.index))
        for batch, one, other in zip(mechanisms.batches, solved, aside, strict=True)
    ]


def _beside(points: Array, angle: Array) -> _Beside | None:
    """Find the angles that lie near change points; None where none does."""
    every = np.broadcast_to(angle, (*points.shape[:2], angle.shape[-1]))[..., np.newaxis]
    apart = around_zero(every - points[:, :, np.newaxis])
    nearest = first_smallest_along(np.where(np.isnan(apart), np.inf, np.abs(apart)))
    off = np.take_along_axis(apart, nearest[..., np.newaxis], axis=-1)[..., 0]
    is_near = np.abs(off) <= _NEAR
    column = np.flatnonzero(np.any(is_near, axis=(0, 1)))
    if column.size == 0:
        return None
    is_near = is_near[..., column]
    off = np.where(is_near, off[..., column], 0.0)
    panel = np.where(off < 0, -_WIDTH, _WIDTH)[..., np.newaxis] * (0.5 + 0.5 * leggauss(_N_POINTS)[0])
    return _Beside(column, off, is_near, every[..., column, :] - off[..., np.newaxis] + panel)


def _with_limits(one: Forces, other: Forces, beside: _Beside, index: NDArray[np.intp]) -> Iterator[Array]:
    """All arrays of the forces of one kind, with limits in the columns beside change points."""
    off, is_near = beside.off[:, index], beside.is_near[:, index]
    weights = interpolation(2.0 * np.abs(off) / _WIDTH - 1.0, _N_POINTS)
    way = 0.5 * _WIDTH * (1.0 + leggauss(_N_POINTS)[0])
    at_end = interpolation(np.array(-1.0), _N_POINTS) * way
    shape = one.driving_torque.shape
    panels = [np.broadcast_to(part, (*shape[:2], beside.nodes[0, 0].size)) for part in leaves(other)]
    panels = [part.reshape(*shape[:2], -1, _N_POINTS) for part in panels]
    # Torques on the crank have limits: what a rod in line cannot hold has no power there.
    joints = len(leaves(one.joints))
    scale = np.max([np.max(np.abs(part), axis=-1) for part in panels[:joints]], axis=0)
    for place, (part, panel) in enumerate(zip(leaves(one), panels, strict=True)):
        values = np.array(np.broadcast_to(part, shape))
        limit = np.sum(weights * panel, axis=-1)
        if place < joints:
            left = np.sum(at_end * panel, axis=-1)
            beyond = np.where(np.abs(off) <= _AT, np.nan, values[..., beside.column])
            limit = np.where(np.abs(left) > _LEFT * _WIDTH * scale, beyond, limit)
        values[..., beside.column] = np.where(is_near, limit, values[..., beside.column])
        yield values
