"""Class III group: a floating link with three points, each on a leg: a rod, or a block on a line that is carried."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.point import LinkPoint
from cranktrain.motion import Array, Coefficient, Link, Point, single

ROD = single(0.0)
"""Kind of a leg that keeps a point of the link at a distance from the leg's end."""

GUIDE = single(1.0)
"""Kind of a leg that keeps a point of the link on a line through the leg's end."""

_MOST_OPENING = 1e-14  # of the size of link, legs and frame: ten times what rounding leaves


class Leg(NamedTuple):
    """A point of the floating link, from the link's origin and axis, and the leg that it is on.

    kind is `ROD` or `GUIDE`. length is the rod's [m]; of a guide it is the line's shift from the leg's end, to the left
    of its direction (turned 90° from x toward y) [m].
    """

    point: LinkPoint
    length: Array
    kind: Array


class Triad(NamedTuple):
    """The three legs."""

    first: Leg
    second: Leg
    third: Leg


class TriadEnds(NamedTuple):
    """The legs' outer ends. A guide lies along its link; of a rod's end only the link's first pin counts."""

    first: Link
    second: Link
    third: Link


class Pose(NamedTuple):
    """Where the floating link is: its origin [m] and the angle of its axis from x [rad]."""

    x: Array
    y: Array
    angle: Array


class TriadDriver(NamedTuple):
    """The legs' ends, and a pose near the one to be found, which chooses the assembly mode."""

    ends: TriadEnds
    start: Pose


class TriadMotion(NamedTuple):
    """Floating link, and how firmly the legs hold it.

    transmission is the determinant of the legs' unit normals and their arms about the link's origin [m]. It is zero
    where the link is loose: the three legs' normals meet in one point or are parallel.
    """

    link: Link
    transmission: Array


class _Hold(NamedTuple):
    """A leg with what does not depend on the pose: its end, its point in the link's axes, its equation's constants."""

    x: Array
    y: Array
    arm_x: Array
    arm_y: Array
    rod: Array
    normal_x: Array
    normal_y: Array
    share: Array
    level: Array


class _Row(NamedTuple):
    """A leg's equation at a pose: gradient by x, y, angle; how far it is from holding; arm and leg as vectors."""

    x: Array
    y: Array
    turn: Array
    misfit: Array
    arm_x: Array
    arm_y: Array
    leg_x: Array
    leg_y: Array


class _Inverse(NamedTuple):
    """Determinant of three rows and its cofactors: the coefficients of each row's right side in x, y and angle."""

    determinant: Array
    x: tuple[Array, Array, Array]
    y: tuple[Array, Array, Array]
    turn: tuple[Array, Array, Array]


def _hold(end: Link, leg: Leg) -> _Hold:
    """Take a leg's equation together: k v·w = level, v = w, k = ½ for a rod, v = n, k = 1 for a guide."""
    rod = 1.0 - leg.kind
    return _Hold(
        end.origin.x.value,
        end.origin.y.value,
        leg.point.radius * np.cos(leg.point.angle),
        leg.point.radius * np.sin(leg.point.angle),
        rod,
        -leg.kind * end.sin,
        leg.kind * end.cos,
        0.5 * (1.0 + leg.kind),
        rod * (0.5 * leg.length * leg.length) + leg.kind * leg.length,
    )


def _row(hold: _Hold, x: Array, y: Array, cos: Array, sin: Array) -> _Row:
    """Linearise a leg's equation at a pose."""
    arm_x = hold.arm_x * cos - hold.arm_y * sin
    arm_y = hold.arm_x * sin + hold.arm_y * cos
    leg_x = (x - hold.x) + arm_x
    leg_y = (y - hold.y) + arm_y
    row_x = hold.rod * leg_x + hold.normal_x
    row_y = hold.rod * leg_y + hold.normal_y
    misfit = hold.share * (row_x * leg_x + row_y * leg_y) - hold.level
    return _Row(row_x, row_y, row_y * arm_x - row_x * arm_y, misfit, arm_x, arm_y, leg_x, leg_y)


def _inverse(a: _Row, b: _Row, c: _Row) -> _Inverse:
    """Cofactors of three rows."""
    x = (b.y * c.turn - b.turn * c.y, c.y * a.turn - c.turn * a.y, a.y * b.turn - a.turn * b.y)
    y = (b.turn * c.x - b.x * c.turn, c.turn * a.x - c.x * a.turn, a.turn * b.x - a.x * b.turn)
    turn = (b.x * c.y - b.y * c.x, c.x * a.y - c.y * a.x, a.x * b.y - a.y * b.x)
    return _Inverse(a.turn * turn[0] + b.turn * turn[1] + c.turn * turn[2], x, y, turn)


def _combined(cofactors: tuple[Array, Array, Array], a: Array, b: Array, c: Array) -> Array:
    return cofactors[0] * a + cofactors[1] * b + cofactors[2] * c


def _closer(first: _Hold, second: _Hold, third: _Hold, pose: Pose) -> Pose:
    """One step of Newton's."""
    cos = np.cos(pose.angle)
    sin = np.sin(pose.angle)
    a = _row(first, pose.x, pose.y, cos, sin)
    b = _row(second, pose.x, pose.y, cos, sin)
    c = _row(third, pose.x, pose.y, cos, sin)
    inverse = _inverse(a, b, c)
    return Pose(
        pose.x - _combined(inverse.x, a.misfit, b.misfit, c.misfit) / inverse.determinant,
        pose.y - _combined(inverse.y, a.misfit, b.misfit, c.misfit) / inverse.determinant,
        pose.angle - _combined(inverse.turn, a.misfit, b.misfit, c.misfit) / inverse.determinant,
    )


def _velocity_of_end(end: Link, leg: Leg, row: _Row) -> Array:
    """What a leg's equation asks of the link's first derivatives: v·a′, and β′u·w for a guide that turns."""
    along = end.cos * row.leg_x + end.sin * row.leg_y
    return row.x * end.origin.x.first + row.y * end.origin.y.first + leg.kind * (end.angle.first * along)


def _acceleration_of_end(end: Link, leg: Leg, row: _Row, x1: Array, y1: Array, turn: Array) -> Array:
    """What a leg's equation asks of the second derivatives, the first being known."""
    leg_x1 = (x1 - end.origin.x.first) - turn * row.arm_y
    leg_y1 = (y1 - end.origin.y.first) + turn * row.arm_x
    along = end.cos * row.leg_x + end.sin * row.leg_y
    across = end.cos * row.leg_y - end.sin * row.leg_x
    along1 = end.cos * leg_x1 + end.sin * leg_y1
    carried = end.angle.first * (2.0 * along1 + end.angle.first * across) + end.angle.second * along
    return (
        row.x * end.origin.x.second
        + row.y * end.origin.y.second
        + turn * turn * (row.x * row.arm_x + row.y * row.arm_y)
        + (leg.kind * carried - (1.0 - leg.kind) * (leg_x1 * leg_x1 + leg_y1 * leg_y1))
    )


def _norm(row: _Row) -> Array:
    return np.sqrt(row.x * row.x + row.y * row.y)


def _opening_square(row: _Row) -> Array:
    return row.misfit * row.misfit / (row.x * row.x + row.y * row.y)


def _size_square(hold: _Hold, row: _Row) -> Array:
    """Square of the lengths whose rounding shows in a leg's opening."""
    arm = row.arm_x * row.arm_x + row.arm_y * row.arm_y
    leg = row.leg_x * row.leg_x + row.leg_y * row.leg_y
    return (arm + leg) + (hold.x * hold.x + hold.y * hold.y)


def triad(driver: TriadDriver, geometry: Triad) -> TriadMotion:
    """Floating link on three legs whose ends move as given, and its derivatives by the crank angle.

    Parameters
    ----------
    driver : TriadDriver, coefficients and start of shape (..., n)
        A start within a twentieth of the link's size is near enough, unless the link is nearly loose: `triad_walk`
        gives one for every crank angle, `triad_modes` all the modes at one.
    geometry : Triad, fields broadcastable to (..., 1)

    Returns
    -------
    TriadMotion, shape (..., n)
        NaN where six steps of Newton's from the start do not close the legs. The angle is a principal value in (−π, π].

    Notes
    -----
    With w from a leg's end to its point, ρ from the link's origin to that point, u along a guide and n to its left:
    a rod holds ½(w·w − l²) = 0, a guide n·w − h = 0. With v = w or n, rows (v_x, v_y, v·ρ⊥) take (x′, y′, θ′) to v·a′
    (+ β′u·w), and (x″, y″, θ″) to v·a″ + θ′²v·ρ − w′·w′, or + β″u·w + 2β′u·w′ + β′²n·w. The derivatives are exact at
    the pose, which holds to rounding; docs/theory/groups-2, eqs. (7.10) to (7.15).
    """
    ends = driver.ends
    first = _hold(ends.first, geometry.first)
    second = _hold(ends.second, geometry.second)
    third = _hold(ends.third, geometry.third)
    pose = _closer(first, second, third, driver.start)
    for _ in range(5):
        pose = _closer(first, second, third, pose)
    cos = np.cos(pose.angle)
    sin = np.sin(pose.angle)
    a = _row(first, pose.x, pose.y, cos, sin)
    b = _row(second, pose.x, pose.y, cos, sin)
    c = _row(third, pose.x, pose.y, cos, sin)
    opening_square = _opening_square(a) + _opening_square(b) + _opening_square(c)
    size_square = _size_square(first, a) + _size_square(second, b) + _size_square(third, c)
    # Newton's steps always give numbers: those that do not close the legs become NaN.
    closed = 0.0 * np.sqrt(_MOST_OPENING * _MOST_OPENING * size_square - opening_square)
    inverse = _inverse(a, b, c)
    determinant = inverse.determinant + closed
    a1 = _velocity_of_end(ends.first, geometry.first, a) / determinant
    b1 = _velocity_of_end(ends.second, geometry.second, b) / determinant
    c1 = _velocity_of_end(ends.third, geometry.third, c) / determinant
    x1 = _combined(inverse.x, a1, b1, c1)
    y1 = _combined(inverse.y, a1, b1, c1)
    turn = _combined(inverse.turn, a1, b1, c1)
    a2 = _acceleration_of_end(ends.first, geometry.first, a, x1, y1, turn) / determinant
    b2 = _acceleration_of_end(ends.second, geometry.second, b, x1, y1, turn) / determinant
    c2 = _acceleration_of_end(ends.third, geometry.third, c, x1, y1, turn) / determinant
    origin = Point(
        Coefficient(pose.x + closed, x1, _combined(inverse.x, a2, b2, c2)),
        Coefficient(pose.y + closed, y1, _combined(inverse.y, a2, b2, c2)),
    )
    angle = Coefficient(np.arctan2(sin, cos) + closed, turn, _combined(inverse.turn, a2, b2, c2))
    return TriadMotion(Link(origin, angle, cos + closed, sin + closed), determinant / (_norm(a) * _norm(b) * _norm(c)))
