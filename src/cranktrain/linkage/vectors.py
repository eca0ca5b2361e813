"""Vectors in the plane, and wrenches, as kernels compute with them."""

from typing import NamedTuple, TypeAlias

from cranktrain.motion import Array, Coefficient, Link, Point


class Vector(NamedTuple):
    """A vector in the mechanism's axes."""

    x: Array
    y: Array


class Wrench(NamedTuple):
    """Force [N], and moment about a point [N·m]: on a link about its first pin, in a joint about the joint's point."""

    x: Array
    y: Array
    moment: Array


InPlane: TypeAlias = Vector | Wrench
"""What has components along x and y: of a wrench, those of its force."""


class MovingVector(NamedTuple):
    """A vector and its first two derivatives by the crank angle."""

    value: Vector
    first: Vector
    second: Vector


def dot(one: InPlane, other: InPlane) -> Array:
    """Scalar product of two vectors."""
    return one.x * other.x + one.y * other.y


def cross(one: InPlane, other: InPlane) -> Array:
    """Component across the plane of the vector product: a moment, of an arm and a force."""
    return one.x * other.y - one.y * other.x


def at_arm(arm: Vector, force: Vector) -> Wrench:
    """Wrench of a force at an arm, about where the arm begins."""
    return Wrench(force.x, force.y, cross(arm, force))


def crossed(one: Wrench, other: Wrench) -> Wrench:
    """Vector product of two wrenches, taken as vectors of three numbers: perpendicular to both."""
    return Wrench(
        one.y * other.moment - one.moment * other.y,
        one.moment * other.x - one.x * other.moment,
        one.x * other.y - one.y * other.x,
    )


def rotated(vector: InPlane, cos: Array, sin: Array) -> Vector:
    """Vector turned by an angle with these cosine and sine; from a link's own axes into the mechanism's."""
    return Vector(vector.x * cos - vector.y * sin, vector.x * sin + vector.y * cos)


def direction(link: Link) -> Vector:
    """Unit vector from a link's first pin toward its second."""
    return Vector(link.cos, link.sin)


def between(start: Point, end: Point) -> Vector:
    """Vector from one point to another. [m]"""
    return Vector(end.x.value - start.x.value, end.y.value - start.y.value)


def moving_between(start: Point, end: Point) -> MovingVector:
    """Vector from one point to another, and its derivatives by the crank angle. [m, m/rad, m/rad²]"""
    return MovingVector(
        between(start, end),
        Vector(end.x.first - start.x.first, end.y.first - start.y.first),
        Vector(end.x.second - start.x.second, end.y.second - start.y.second),
    )


def swept(origin: Point, arm: Vector, angle: Coefficient) -> tuple[Vector, Vector]:
    """First and second derivatives by the crank angle of a point at an arm that turns about a moving point.

    Notes
    -----
    p′ = o′ + θ′ρ⊥, p″ = o″ + θ″ρ⊥ − θ′²ρ. Exact; docs/theory/groups.
    """
    turn = angle.first
    rate = angle.second
    square = turn * turn
    x = origin.x
    y = origin.y
    return (
        Vector(x.first - arm.y * turn, y.first + arm.x * turn),
        Vector(x.second - (arm.y * rate + arm.x * square), y.second + (arm.x * rate - arm.y * square)),
    )
