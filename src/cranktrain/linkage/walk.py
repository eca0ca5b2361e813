"""Walking a triad's link round the turn: starts for its kernel at every crank angle, all on one branch."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.linkage.triad import Pose, Triad, TriadDriver, TriadEnds, TriadMotion, triad
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics.harmonics import TURN

_FIRST_STEP = TURN / 48
_LARGEST_STEP = TURN / 12
_SMALLEST_STEP = TURN / 2**16
_MOST_MISSED = 1e-3  # of the link's size, by the prediction of a step


class Walk(NamedTuple):
    """A link's branch over one turn of the crank, as nodes to start from between.

    angle: crank angles of the nodes from the first to one turn later, shape (..., m) [rad]. pose: x, y [m] and angle
    (without jumps) [rad] of the link along the first axis, shape (3, ..., m); NaN from where the crank cannot turn on.
    Where the link is not after the turn as it was before, it has gone over to another mode on the way, without ever
    being loose, and needs more than one turn to come back.
    """

    angle: Array
    pose: Coefficient


def triad_walk(ends: Callable[[Array], TriadEnds], geometry: Triad, start: Pose) -> Walk:
    """Follow a triad's link over one turn of the crank.

    Parameters
    ----------
    ends : function
        Gives the legs' ends at crank angles of shape (..., 1), which differ from machine to machine.
    geometry : Triad, fields broadcastable to (..., 1)
    start : Pose, fields broadcastable to (..., 1)
        Near the pose at φ = 0, as `triad_modes` gives it: the assembly mode. [m, rad]

    Returns
    -------
    Walk
        For `pose_at`. Each machine takes its own steps.

    Notes
    -----
    A step is predicted by value and two derivatives and corrected by the kernel. It is taken where the prediction has
    missed by no more than 0.1 % of the link's size and the transmission keeps its sign; else it is made smaller. Where
    a step of 0.0055° is too large the crank cannot turn on. docs/theory/groups-2, eq. (7.18).
    """
    with np.errstate(all="ignore"):
        found = triad(TriadDriver(ends(np.zeros(1)), start), geometry)
        side, pose = found.transmission, _pose(found)
        scale = _scale(geometry, side)
        at, step = np.zeros(side.shape), np.full(side.shape, _FIRST_STEP)
        nodes = [(at, pose)]
        while np.any(at < TURN):
            after = np.minimum(at + step, TURN)
            expected = pose[0] + (after - at) * (pose[1] + 0.5 * (after - at) * pose[2])
            found = triad(TriadDriver(ends(after), Pose(*expected)), geometry)
            reached = _pose(found)
            reached[0, 2] -= TURN * np.round((reached[0, 2] - expected[2]) / TURN)  # counted on from the last angle
            missed = np.max(np.abs(reached[0] - expected) / scale, axis=0) / _MOST_MISSED
            missed = np.where(found.transmission * side > 0, missed, np.inf)
            is_taken = missed <= 1
            is_stuck = ~is_taken & (step <= _SMALLEST_STEP)
            pose = np.where(is_taken, reached, np.where(is_stuck, np.nan, pose))
            at = np.where(is_taken, after, np.where(is_stuck, TURN, at))
            step = np.minimum(step * np.clip(0.9 / np.cbrt(missed), 0.1, 2.0), _LARGEST_STEP)
            nodes.append((at, pose))
    return Walk(
        np.concatenate([at for at, _ in nodes], axis=-1),
        Coefficient(*np.concatenate([pose for _, pose in nodes], axis=-1)),
    )


def pose_at(walk: Walk, angle: Array) -> Pose:
    """Start for the kernel at any crank angle, by the nodes on either side and their derivatives.

    Parameters
    ----------
    walk : Walk
    angle : Array, shape (..., n)
        Crank angle; of other turns too, which are all alike where the link comes back. [rad]

    Returns
    -------
    Pose, shape (..., n)
        Within some 1e-7 of the link's size; the kernel makes it exact.

    Notes
    -----
    The polynomial of fifth degree with value and two derivatives of both nodes; docs/theory/groups-2, eq. (7.19).
    """
    angle = np.mod(angle, TURN)
    walk = _lifted(walk, np.ndim(angle))
    last = walk.angle.shape[-1] - 2
    before = np.minimum(sum(walk.angle[..., i : i + 1] <= angle for i in range(1, last + 2)), last)
    near = np.take_along_axis(walk.angle, before, axis=-1)
    step = np.take_along_axis(walk.angle, before + 1, axis=-1) - near
    here, there = (_at_node(walk, node, step) for node in (before, before + 1))
    share = np.where(step > 0, (angle - near) / np.where(step > 0, step, 1.0), 0.0)
    value = there[0] - (here[0] + here[1] + 0.5 * here[2])
    first = there[1] - (here[1] + here[2])
    second = there[2] - here[2]
    cubic = 10.0 * value - 4.0 * first + 0.5 * second
    quartic = -15.0 * value + 7.0 * first - second
    quintic = 6.0 * value - 3.0 * first + 0.5 * second
    rest = cubic + share * (quartic + share * quintic)
    return Pose(*(here[0] + share * (here[1] + share * (0.5 * here[2] + share * rest))))


def _lifted(walk: Walk, n_axes: int) -> Walk:
    """The same walk with leading axes of one, where angles have more than it has."""
    more = (1,) * max(n_axes - walk.angle.ndim, 0)
    pose = Coefficient(*(part.reshape(len(part), *more, *part.shape[1:]) for part in walk.pose))
    return Walk(walk.angle.reshape(*more, *walk.angle.shape), pose)


def _at_node(walk: Walk, node: NDArray[np.intp], step: Array) -> tuple[Array, Array, Array]:
    """Value and derivatives by the share of the step, (3, ..., n) each."""
    value, first, second = (np.take_along_axis(order, node[np.newaxis], axis=-1) for order in walk.pose)
    return value, first * step, second * step * step


def _pose(motion: TriadMotion) -> Array:
    """Value, first and second derivative of x, y and angle of the link, (3, 3, ..., 1)."""
    return np.stack([motion.link.origin.x, motion.link.origin.y, motion.link.angle], axis=1)


def _scale(geometry: Triad, side: Array) -> Array:
    """What x, y and angle count by: the link's largest radius, the same, one radian; (3, ..., 1)."""
    radius = np.broadcast_to(np.maximum.reduce([leg.point.radius for leg in geometry]), side.shape)
    return np.stack([radius, radius, np.ones_like(radius)])
