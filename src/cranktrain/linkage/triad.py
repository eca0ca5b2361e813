"""Class III group: a floating link with three points, each on a leg: a rod, or a block on a line that is carried."""

from typing import Generic, NamedTuple, TypeAlias, TypeVar

import numpy as np

from cranktrain.linkage.point import LinkPoint
from cranktrain.linkage.vectors import Vector, Wrench, at_arm, cross, crossed, direction, dot, rotated
from cranktrain.motion import Array, Coefficient, Link, Point, single

_Each = TypeVar("_Each")

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


class OfLegs(NamedTuple, Generic[_Each]):
    """What each of the three legs has, or is."""

    first: _Each
    second: _Each
    third: _Each


Triad: TypeAlias = OfLegs[Leg]
"""The three legs."""

TriadEnds: TypeAlias = OfLegs[Link]
"""The legs' outer ends. A guide lies along its link; of a rod's end only the link's first pin counts."""


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

    end: Vector
    arm: Vector
    rod: Array
    normal: Vector
    share: Array
    level: Array


class _Row(NamedTuple):
    """A leg's equation at a pose: gradient by x, y, angle; how far it is from holding; arm and leg as vectors.

    The gradient is the wrench on the link of a unit force of the leg.
    """

    unit: Wrench
    misfit: Array
    arm: Vector
    leg: Vector


class _Inverse(NamedTuple):
    """Determinant of three rows and its cofactors: the coefficients of each row's right side in x, y and angle."""

    determinant: Array
    a: Wrench
    b: Wrench
    c: Wrench


def _hold(end: Link, leg: Leg) -> _Hold:
    """Take a leg's equation together: k v·w = level, v = w, k = ½ for a rod, v = n, k = 1 for a guide."""
    rod = 1.0 - leg.kind
    return _Hold(
        Vector(end.origin.x.value, end.origin.y.value),
        Vector(leg.point.radius * np.cos(leg.point.angle), leg.point.radius * np.sin(leg.point.angle)),
        rod,
        Vector(-leg.kind * end.sin, leg.kind * end.cos),
        0.5 * (1.0 + leg.kind),
        rod * (0.5 * leg.length * leg.length) + leg.kind * leg.length,
    )


def _row(hold: _Hold, pose: Pose, cos: Array, sin: Array) -> _Row:
    """Linearise a leg's equation at a pose, whose angle has this cosine and sine."""
    arm = rotated(hold.arm, cos, sin)
    leg = Vector((pose.x - hold.end.x) + arm.x, (pose.y - hold.end.y) + arm.y)
    normal = Vector(hold.rod * leg.x + hold.normal.x, hold.rod * leg.y + hold.normal.y)
    return _Row(at_arm(arm, normal), hold.share * dot(normal, leg) - hold.level, arm, leg)


def _inverse(a: _Row, b: _Row, c: _Row) -> _Inverse:
    """Cofactors of three rows."""
    bc = crossed(b.unit, c.unit)
    ca = crossed(c.unit, a.unit)
    ab = crossed(a.unit, b.unit)
    return _Inverse(a.unit.moment * bc.moment + b.unit.moment * ca.moment + c.unit.moment * ab.moment, bc, ca, ab)


def _solution(inverse: _Inverse, a: Array, b: Array, c: Array) -> Pose:
    """What three rows with these right sides ask of x, y and angle, times the determinant."""
    return Pose(
        inverse.a.x * a + inverse.b.x * b + inverse.c.x * c,
        inverse.a.y * a + inverse.b.y * b + inverse.c.y * c,
        inverse.a.moment * a + inverse.b.moment * b + inverse.c.moment * c,
    )


def _closer(first: _Hold, second: _Hold, third: _Hold, pose: Pose) -> Pose:
    """One step of Newton's."""
    cos = np.cos(pose.angle)
    sin = np.sin(pose.angle)
    a = _row(first, pose, cos, sin)
    b = _row(second, pose, cos, sin)
    c = _row(third, pose, cos, sin)
    inverse = _inverse(a, b, c)
    step = _solution(inverse, a.misfit, b.misfit, c.misfit)
    return Pose(
        pose.x - step.x / inverse.determinant,
        pose.y - step.y / inverse.determinant,
        pose.angle - step.angle / inverse.determinant,
    )


def _velocity_of_end(end: Link, leg: Leg, row: _Row) -> Array:
    """What a leg's equation asks of the link's first derivatives: v·a′, and β′u·w for a guide that turns."""
    along = dot(direction(end), row.leg)
    return row.unit.x * end.origin.x.first + row.unit.y * end.origin.y.first + leg.kind * (end.angle.first * along)


def _acceleration_of_end(end: Link, leg: Leg, row: _Row, first: Pose) -> Array:
    """What a leg's equation asks of the second derivatives, the first being known."""
    turn = first.angle
    leg1 = Vector((first.x - end.origin.x.first) - turn * row.arm.y, (first.y - end.origin.y.first) + turn * row.arm.x)
    u = direction(end)
    swing = 2.0 * dot(u, leg1) + end.angle.first * cross(u, row.leg)
    carried = end.angle.first * swing + end.angle.second * dot(u, row.leg)
    return (
        row.unit.x * end.origin.x.second
        + row.unit.y * end.origin.y.second
        + turn * turn * dot(row.unit, row.arm)
        + (leg.kind * carried - (1.0 - leg.kind) * dot(leg1, leg1))
    )


def _opening_square(row: _Row) -> Array:
    return row.misfit * row.misfit / dot(row.unit, row.unit)


def _size_square(hold: _Hold, row: _Row) -> Array:
    """Square of the lengths whose rounding shows in a leg's opening."""
    return (dot(row.arm, row.arm) + dot(row.leg, row.leg)) + dot(hold.end, hold.end)


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
    a = _row(first, pose, cos, sin)
    b = _row(second, pose, cos, sin)
    c = _row(third, pose, cos, sin)
    opening_square = _opening_square(a) + _opening_square(b) + _opening_square(c)
    size_square = _size_square(first, a) + _size_square(second, b) + _size_square(third, c)
    # Newton's steps always give numbers: those that do not close the legs become NaN.
    closed = 0.0 * np.sqrt(_MOST_OPENING * _MOST_OPENING * size_square - opening_square)
    inverse = _inverse(a, b, c)
    determinant = inverse.determinant + closed
    a1 = _velocity_of_end(ends.first, geometry.first, a) / determinant
    b1 = _velocity_of_end(ends.second, geometry.second, b) / determinant
    c1 = _velocity_of_end(ends.third, geometry.third, c) / determinant
    velocity = _solution(inverse, a1, b1, c1)
    a2 = _acceleration_of_end(ends.first, geometry.first, a, velocity) / determinant
    b2 = _acceleration_of_end(ends.second, geometry.second, b, velocity) / determinant
    c2 = _acceleration_of_end(ends.third, geometry.third, c, velocity) / determinant
    acceleration = _solution(inverse, a2, b2, c2)
    origin = Point(
        Coefficient(pose.x + closed, velocity.x, acceleration.x),
        Coefficient(pose.y + closed, velocity.y, acceleration.y),
    )
    angle = Coefficient(np.arctan2(sin, cos) + closed, velocity.angle, acceleration.angle)
    norms = np.sqrt(dot(a.unit, a.unit)) * np.sqrt(dot(b.unit, b.unit)) * np.sqrt(dot(c.unit, c.unit))
    return TriadMotion(Link(origin, angle, cos + closed, sin + closed), determinant / norms)
