"""A triad of a chain round the turn: where to start at any crank angle, and how much a leg lacks where it is open."""

from collections.abc import Callable, Hashable
from typing import Any, NamedTuple, cast

import numpy as np

from cranktrain.linkage import Pose, Triad, TriadDriver, TriadEnds, Walk, pose_at, triad, triad_walk
from cranktrain.linkage.nearest import nearest_pose
from cranktrain.mechanisms.chain.steps import StartSize
from cranktrain.motion import Array, Coefficient, single

EndsAt = Callable[[Array], TriadEnds]

_KEPT = 32
"""Walks that are remembered: root finding asks for the same mechanisms at other angles again and again."""


class Branch(NamedTuple):
    """A triad's link round the turn from φ = 0: forward and, where it cannot turn on for all machines, backward.

    start: pose at φ = 0; apart: how far off the link is after a turn on which it went over to another mode, else 0 [m].
    """

    start: Pose
    forward: Walk
    backward: Walk | None
    apart: Array


class Walks:
    """Walks by what they are walks of, the last few."""

    def __init__(self) -> None:
        self._known: dict[Hashable, Branch] = {}

    def branch(self, key: Hashable, ends: EndsAt, legs: Triad, start: StartSize) -> Branch:
        """Give the branch of a triad; `key` must tell it from all others."""
        if key not in self._known:
            while len(self._known) >= _KEPT:
                del self._known[next(iter(self._known))]
            self._known[key] = _branch(ends, legs, start)
        return self._known[key]


def _branch(ends: EndsAt, legs: Triad, start: StartSize) -> Branch:
    """Walk from the start: from the pose nearest to it, where lengths have been changed since it was found."""
    with np.errstate(all="ignore"):
        at_start = ends(np.zeros(1))
        pose = nearest_pose(at_start, legs, Pose(start.x, start.y, start.direction)).pose
        keeps_side = triad(TriadDriver(at_start, pose), legs).transmission * start.side > 0
        begun = Pose(*(np.where(keeps_side, part, np.nan) for part in pose))
        forward = triad_walk(ends, legs, begun)
        turns = ~np.isnan(forward.pose.value[0, ..., -1:])
        left = Pose(*(np.where(turns, np.nan, part) for part in begun))
        back = None if np.all(turns) else triad_walk(lambda angle: _reversed(ends(-angle)), legs, left)
        first, last = forward.pose.value[..., :1], forward.pose.value[..., -1:]
        apart = np.where(turns & ~forward.comes_back, np.hypot(*(last - first)[:2]), 0.0)
    return Branch(pose, forward, back, apart)


def start_at(branch: Branch, angle: Array) -> Pose:
    """Start for the kernel at any crank angle; NaN where the link cannot go from φ = 0, or does not come back."""
    lost = np.where(branch.apart > 0, np.nan, 0.0)
    pose = Pose(*(part + lost for part in pose_at(branch.forward, angle)))
    if branch.backward is None:
        return pose
    other = pose_at(branch.backward, -angle)
    return Pose(*(np.where(np.isnan(part), back, part) for part, back in zip(pose, other, strict=True)))


def lacking(branch: Branch, ends: TriadEnds, legs: Triad, is_open: Array) -> Array:
    """By how much one leg is too short or too long, where the link cannot be: from the nearest that it can. [m]"""
    starts = [branch.start, *(_last(walk, branch.start) for walk in (branch.forward, branch.backward) if walk)]
    chosen = np.nonzero(is_open)

    def there(value: Any) -> Any:
        if isinstance(value, tuple):
            return type(value)(*(there(part) for part in cast(tuple[Any, ...], value)))
        return np.broadcast_to(value, is_open.shape)[chosen]

    openings = [nearest_pose(there(ends), there(legs), there(pose)).opening for pose in starts]
    found = np.zeros(is_open.shape)
    found[chosen] = np.fmin.reduce(openings)
    return np.where(branch.apart > 0, branch.apart, found)


def _last(walk: Walk, start: Pose) -> Pose:
    """Where a walk ends; the start, where it has not begun."""
    n_nodes = np.sum(~np.isnan(walk.pose.value[0]), axis=-1, keepdims=True)
    place = np.maximum(n_nodes - 1, 0)[np.newaxis]
    last = np.take_along_axis(walk.pose.value, np.broadcast_to(place, (3, *place.shape[1:])), axis=-1)
    return Pose(*(np.where(n_nodes > 0, one, other) for one, other in zip(last, start, strict=True)))


def _reversed(ends: Any) -> Any:
    """Give ends as a crank that turns the other way drives them: first derivatives change sign."""
    if isinstance(ends, Coefficient):
        return ends._replace(first=-ends.first)
    if isinstance(ends, tuple):
        return type(ends)(*(_reversed(part) for part in cast(tuple[Any, ...], ends)))
    return ends


def side_of(ends: TriadEnds, legs: Triad, pose: Pose) -> Array:
    """Sign of the transmission in a pose; 1 where there is none."""
    with np.errstate(all="ignore"):
        sign = np.sign(triad(TriadDriver(ends, pose), legs).transmission)
    return np.where(np.abs(sign) > 0, sign, single(1.0))
