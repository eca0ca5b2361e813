"""A triad of a chain round the turn: where to start at any crank angle, and how much a leg lacks where it is open."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.linkage import Pose, Triad, TriadDriver, TriadEnds, Walk, pose_at, triad, triad_walk
from cranktrain.linkage.nearest import nearest_pose
from cranktrain.mechanisms.chain.steps import StartSize
from cranktrain.mechanisms.chain.triads import link_size
from cranktrain.motion import Array, single
from cranktrain.numerics.nested import Nested, each_changed, mapped

EndsAt = Callable[[Array], TriadEnds]

_ALIKE = 1e-6
"""Poses that differ by less, in parts of the link's size, are one. Of two modes only those of a loose link are near."""


class Branch(NamedTuple):
    """A triad's link round the turn from φ = 0: forward and, where it cannot turn on for all machines, backward.

    start: pose at φ = 0; apart: how far off the link is
    after a turn on which it went over to another mode, or from where it comes backward; else 0 [m].
    """

    start: Pose
    forward: Walk
    backward: Walk | None
    apart: Array


def branch_from(ends: EndsAt, legs: Triad, start: StartSize) -> Branch:
    """Walk from the start: from the pose nearest to it, where lengths have been changed since it was found."""
    with np.errstate(all="ignore"):
        at_start = ends(np.zeros(1))
        pose = nearest_pose(at_start, legs, Pose(start.x, start.y, start.direction)).pose
        keeps_side = triad(TriadDriver(at_start, pose), legs).transmission * kept_side(start, legs) > 0
        begun = Pose(*(np.where(keeps_side, part, np.nan) for part in pose))
        forward = triad_walk(ends, legs, begun)
        turns = ~np.isnan(forward.pose.value[0, ..., -1:])
        left = Pose(*(np.where(turns, np.nan, part) for part in begun))
        back = None if np.all(turns) else triad_walk(lambda angle: _reversed(ends(-angle)), legs, left)
        apart = _apart(forward, back)
        apart = np.where(apart > _ALIKE * link_size(legs), apart, 0.0)
    return Branch(pose, forward, back, apart)


def _apart(forward: Walk, back: Walk | None) -> Array:
    """How far apart the link is at one crank angle, reached forward and backward; 0 where only one way leads. [m]"""
    last, angle = _last(forward), np.take_along_axis(forward.angle, _end(forward), axis=-1)
    other = Pose(*forward.pose.value[..., :1])
    if back is not None:
        back_there = pose_at(back, -angle)
        other = Pose(*(np.where(angle < 2 * np.pi, one, two) for one, two in zip(back_there, other, strict=True)))
    return np.nan_to_num(np.hypot(last.x - other.x, last.y - other.y))


def start_at(branch: Branch, angle: Array) -> Pose:
    """Start for the kernel at any crank angle; NaN where the link cannot go from φ = 0, or does not come back."""
    lost = np.where(branch.apart > 0, np.nan, 0.0)
    pose = Pose(*(part + lost for part in pose_at(branch.forward, angle)))
    if branch.backward is None:
        return pose
    other = pose_at(branch.backward, -angle)
    return Pose(*map(_given, pose, other))


def lacking(branch: Branch, ends: TriadEnds, legs: Triad, is_open: Array) -> Array:
    """By how much one leg is too short or too long, where the link cannot be: from the ends of its branch. [m]"""
    chosen = np.nonzero(is_open)

    def there(parts: Nested) -> Nested:
        return each_changed(lambda value: np.broadcast_to(value, is_open.shape)[chosen], parts)

    lasts = [_last(walk) for walk in (branch.forward, branch.backward) if walk is not None]
    starts = [there(Pose(*map(_given, last, branch.start))) for last in lasts]
    # Of all starts at once: few angles are asked for at a time.
    openings = nearest_pose(there(ends), there(legs), Pose(*map(np.stack, zip(*starts, strict=True)))).opening
    found = np.zeros(is_open.shape)
    found[chosen] = np.fmin.reduce(openings, axis=0)
    return np.where(branch.apart > 0, branch.apart, found)


def _given(one: Array, other: Array) -> Array:
    return np.where(np.isnan(one), other, one)


def _last(walk: Walk) -> Pose:
    """Where a walk ends; NaN, where it has not begun."""
    return Pose(*np.take_along_axis(walk.pose.value, np.broadcast_to(_end(walk), (3, *_end(walk).shape)), axis=-1))


def _end(walk: Walk) -> NDArray[np.intp]:
    """Number of the last node that a walk has reached."""
    return np.maximum(np.sum(~np.isnan(walk.pose.value[0]), axis=-1, keepdims=True) - 1, 0)


def _reversed(ends: TriadEnds) -> TriadEnds:
    """Give ends as a crank that turns the other way drives them: first derivatives change sign."""
    return mapped(lambda name, value: -value if name.endswith(".first") else value, ends)


def kept_side(start: StartSize, legs: Triad) -> Array:
    """Sign of the transmission that is kept. Seen with y reversed, a guide's normal points to the other side."""
    return start.sign * start.side ** sum(leg.kind for leg in legs)


def sign_of(ends: TriadEnds, legs: Triad, pose: Pose) -> Array:
    """Sign of the transmission in a pose; 1 where there is none."""
    with np.errstate(all="ignore"):
        sign = np.sign(triad(TriadDriver(ends, pose), legs).transmission)
    return np.where(np.abs(sign) > 0, sign, single(1.0))
