"""A triad whose legs do not reach: the pose in which they are least apart, and how much one of them lacks."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.linkage.triad import Leg, Pose, Triad, TriadEnds
from cranktrain.motion import Array, Link

_STEPS = 40
_FIRST_DAMPING = 1e-3
_LEAST_DAMPING, _MOST_DAMPING = 1e-16, 1e6
_SETTLED = 1e-13  # of the link's size


class NearestPose(NamedTuple):
    """Pose in which the squares of the legs' openings are least, and what one leg lacks there. [m]"""

    pose: Pose
    opening: Array


class _Row(NamedTuple):
    """One leg's opening [m]; its gradient by x, y and angle; its second derivatives."""

    opening: Array
    x: Array
    y: Array
    turn: Array
    xx: Array
    xy: Array
    yy: Array
    x_turn: Array
    y_turn: Array
    turn_turn: Array


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
    pose = Pose(*(np.broadcast_to(part, shape) for part in start))
    rows = _rows(ends, geometry, pose)
    square = _square(rows)
    damping = _FIRST_DAMPING + 0.0 * square
    for _ in range(_STEPS):
        step = _step(rows, damping, size)
        tried = Pose(*(part - change for part, change in zip(pose, step, strict=True)))
        there = _rows(ends, geometry, tried)
        square_there = _square(there)
        is_less = square_there < square
        pose = Pose(*(np.where(is_less, new, old) for new, old in zip(tried, pose, strict=True)))
        rows = [_chosen(is_less, *pair) for pair in zip(there, rows, strict=True)]
        square = np.where(is_less, square_there, square)
        damping = np.clip(np.where(is_less, 0.1 * damping, 10.0 * damping), _LEAST_DAMPING, _MOST_DAMPING)
        moved = np.abs(step.x) + np.abs(step.y) + size * np.abs(step.angle)
        if not np.any(moved > _SETTLED * size):
            break
    largest = np.maximum.reduce([np.abs(row.opening) for row in rows])
    return NearestPose(pose, np.where(largest > 0, square / np.where(largest > 0, largest, 1.0), largest))


def _chosen(condition: NDArray[np.bool_], one: _Row, other: _Row) -> _Row:
    return _Row(*(np.where(condition, *parts) for parts in zip(one, other, strict=True)))


def _square(rows: list[_Row]) -> Array:
    a, b, c = (row.opening for row in rows)
    return a * a + b * b + c * c


def _rows(ends: TriadEnds, geometry: Triad, pose: Pose) -> list[_Row]:
    """Openings of the three legs at a pose, in metres, with first and second derivatives."""
    cos, sin = np.cos(pose.angle), np.sin(pose.angle)
    return [_row(end, leg, pose, cos, sin) for end, leg in zip(ends, geometry, strict=True)]


def _row(end: Link, leg: Leg, pose: Pose, cos: Array, sin: Array) -> _Row:
    own_x, own_y = leg.point.radius * np.cos(leg.point.angle), leg.point.radius * np.sin(leg.point.angle)
    arm_x, arm_y = own_x * cos - own_y * sin, own_x * sin + own_y * cos
    leg_x, leg_y = pose.x + arm_x - end.origin.x.value, pose.y + arm_y - end.origin.y.value
    length = np.hypot(leg_x, leg_y)
    rod = 1.0 - leg.kind
    bend = rod / length
    x, y = bend * leg_x - leg.kind * end.sin, bend * leg_y + leg.kind * end.cos
    turn = y * arm_x - x * arm_y
    return _Row(
        x * leg_x + y * leg_y - leg.length,
        x,
        y,
        turn,
        bend * (1.0 - x * x),
        -bend * x * y,
        bend * (1.0 - y * y),
        -bend * (arm_y + x * turn),
        bend * (arm_x - y * turn),
        bend * (arm_x * arm_x + arm_y * arm_y - turn * turn) - (x * arm_x + y * arm_y),
    )


def _step(rows: list[_Row], damping: Array, size: Array) -> Pose:
    """Newton's step toward the least sum of squares, damped."""

    def total(one: str, other: str, both: str) -> Array:
        return sum(
            (getattr(row, one) * getattr(row, other) + row.opening * getattr(row, both) for row in rows), 0.0 * damping
        )

    xx, yy = total("x", "x", "xx") + damping, total("y", "y", "yy") + damping
    tt = total("turn", "turn", "turn_turn") + damping * size * size
    xy, xt, yt = total("x", "y", "xy"), total("x", "turn", "x_turn"), total("y", "turn", "y_turn")
    x, y, t = (sum((getattr(row, name) * row.opening for row in rows), 0.0 * damping) for name in ("x", "y", "turn"))
    first, second, third = yy * tt - yt * yt, xt * yt - xy * tt, xy * yt - yy * xt
    determinant = xx * first + xy * second + xt * third
    return Pose(
        (first * x + second * y + third * t) / determinant,
        (second * x + (xx * tt - xt * xt) * y + (xy * xt - xx * yt) * t) / determinant,
        (third * x + (xy * xt - xx * yt) * y + (xx * yy - xy * xy) * t) / determinant,
    )
