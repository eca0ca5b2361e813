"""A triad whose legs do not reach: the pose in which they are least apart, and how much one of them lacks."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.triad import Leg, Pose, Triad, TriadEnds
from cranktrain.linkage.vectors import Vector, Wrench, cross, crossed, dot, rotated
from cranktrain.motion import Array, Link

_STEPS = 40
_FIRST_DAMPING = 1e-3
_LEAST_DAMPING, _MOST_DAMPING = 1e-16, 1e6
_SETTLED, _FLAT = 1e-13, 1e-7  # of the link's size; where a step makes the sum less, and where it does not


class NearestPose(NamedTuple):
    """Pose in which the squares of the legs' openings are least, and what one leg lacks there. [m]"""

    pose: Pose
    opening: Array


class _Openings(NamedTuple):
    """Of each leg along the first axis: opening [m]; its gradient by x, y and angle; its second derivatives."""

    opening: Array
    gradient: Array
    second: Array


def nearest_pose(ends: TriadEnds, geometry: Triad, start: Pose) -> NearestPose:
    """Find where a triad's legs are least apart; where they close, a pose in which they do.

    Parameters
    ----------
    ends : TriadEnds, coefficients of shape (..., n)
    geometry : Triad, fields broadcastable to (..., 1)
    start : Pose, broadcastable to (..., n)

    Returns
    -------
    NearestPose, shape (..., n)
        opening is the least by which one leg would have to be longer or shorter for all three to close, as far as this
        is proportional; NaN where the ends are.

    Notes
    -----
    Newton's method on ½Σf², damped until each step makes it less; docs/theory/groups-2, eqs. (7.24) and (7.25).
    """
    size = np.maximum.reduce([leg.point.radius for leg in geometry])
    size = np.where(size > 0, size, 1.0)
    numbers = (*start, size, *(end.origin.x.value for end in ends), *(leg.length for leg in geometry))
    shape = np.broadcast_shapes(*map(np.shape, numbers))
    pose = np.stack([np.broadcast_to(part, shape) for part in start])
    here = _openings(ends, geometry, pose)
    square: Array = np.sum(here.opening**2, axis=0)
    damping = _FIRST_DAMPING + 0.0 * square
    for _ in range(_STEPS):
        step = _step(here, damping, size)
        there = _openings(ends, geometry, pose - step)
        square_there: Array = np.sum(there.opening**2, axis=0)
        is_less = square_there < square
        pose = np.where(is_less, pose - step, pose)
        here = _Openings(*(np.where(is_less, *parts) for parts in zip(there, here, strict=True)))
        square = np.where(is_less, square_there, square)
        damping = np.clip(np.where(is_less, 0.1 * damping, 10.0 * damping), _LEAST_DAMPING, _MOST_DAMPING)
        moved = np.abs(step[0]) + np.abs(step[1]) + size * np.abs(step[2])
        # About a least sum that is not 0, so small a step is lost in its rounding.
        if not np.any(moved > np.where(is_less, _SETTLED, _FLAT) * size):
            break
    largest = np.max(np.abs(here.opening), axis=0)
    return NearestPose(Pose(*pose), np.where(largest > 0, square / np.where(largest > 0, largest, 1.0), largest))


def _openings(ends: TriadEnds, geometry: Triad, pose: Array) -> _Openings:
    """Openings of the three legs at a pose, (3, ...), in metres, with first and second derivatives."""
    legs = (_opening(end, leg, pose) for end, leg in zip(ends, geometry, strict=True))
    return _Openings(*(np.array(parts) for parts in zip(*legs, strict=True)))


def _opening(end: Link, leg: Leg, pose: Array) -> tuple[Array, list[Array], list[list[Array]]]:
    own = Vector(leg.point.radius * np.cos(leg.point.angle), leg.point.radius * np.sin(leg.point.angle))
    arm = rotated(own, np.cos(pose[2]), np.sin(pose[2]))
    w = Vector(pose[0] + arm.x - end.origin.x.value, pose[1] + arm.y - end.origin.y.value)
    bend = (1.0 - leg.kind) / np.hypot(w.x, w.y)
    unit = Vector(bend * w.x - leg.kind * end.sin, bend * w.y + leg.kind * end.cos)
    turn = cross(arm, unit)
    xy = -bend * unit.x * unit.y
    x_turn, y_turn = -bend * (arm.y + unit.x * turn), bend * (arm.x - unit.y * turn)
    second = [
        [bend * (1.0 - unit.x * unit.x), xy, x_turn],
        [xy, bend * (1.0 - unit.y * unit.y), y_turn],
        [x_turn, y_turn, bend * (dot(arm, arm) - turn * turn) - dot(unit, arm)],
    ]
    return dot(unit, w) - leg.length, [unit.x, unit.y, turn], second


def _step(legs: _Openings, damping: Array, size: Array) -> Array:
    """Newton's step toward the least sum of squares, damped."""
    opening, gradient, second = legs
    slope = np.sum(gradient * opening[:, np.newaxis], axis=0)
    curvature = np.sum(
        gradient[:, :, np.newaxis] * gradient[:, np.newaxis] + opening[:, np.newaxis, np.newaxis] * second, axis=0
    )
    curvature[range(3), range(3)] += np.stack([damping, damping, damping * size * size])
    x, y, turn = (Wrench(*row) for row in curvature)
    cofactors = np.array([crossed(y, turn), crossed(turn, x), crossed(x, y)])
    return np.sum(cofactors * slope, axis=1) / np.sum(curvature[0] * cofactors[0], axis=0)
