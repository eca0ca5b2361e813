"""Points: on a link (knuckle pin, coupler point, centre of mass), fixed in the frame, or seen in turned axes."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.vectors import Vector, rotated, swept
from cranktrain.motion import Array, Coefficient, Handed, Link, Point


class LinkPoint(NamedTuple):
    """A point fixed on a link: radius from its first pin [m], angle from the link's direction [rad]."""

    radius: Array
    angle: Handed


class Ends(NamedTuple):
    """A group's outer pins: which drives its rod or slider, and pivot of its rocker or guide. [m, m/rad, m/rad²]"""

    driver: Point
    pivot: Point


def point(link: Link, geometry: LinkPoint) -> Point:
    """Point that a link carries with it, and its derivatives by the crank angle.

    Parameters
    ----------
    link : Link, coefficients of shape (..., n)
    geometry : LinkPoint, fields broadcastable to (..., 1)

    Returns
    -------
    Point, shape (..., n). [m, m/rad, m/rad²]

    Notes
    -----
    p = o + ρ, ρ = r(cos(θ + ζ), sin(θ + ζ)); p′ = o′ + θ′ρ⊥, p″ = o″ + θ″ρ⊥ − θ′²ρ. Exact; docs/theory/groups.
    """
    arm = arm_of(link, geometry)
    x = link.origin.x
    y = link.origin.y
    v, a = swept(link.origin, arm, link.angle)
    return Point(Coefficient(x.value + arm.x, v.x, a.x), Coefficient(y.value + arm.y, v.y, a.y))


def arm_of(link: Link, geometry: LinkPoint) -> Vector:
    """Arm of a point from its link's first pin. [m]"""
    toward = rotated(Vector(np.cos(geometry.angle), np.sin(geometry.angle)), link.cos, link.sin)
    return Vector(geometry.radius * toward.x, geometry.radius * toward.y)


def fixed(x: Array, y: Array) -> Point:
    """Point that stands still in the frame. [m]"""
    still_x = 0.0 * x
    still_y = 0.0 * y
    return Point(Coefficient(x, still_x, still_x), Coefficient(y, still_y, still_y))


def turned(moving: Point, angle: Array) -> Point:
    """Give the same point in axes turned by `angle` in the sense of rotation, as a guide elsewhere needs it.

    Parameters
    ----------
    moving : Point, coefficients of shape (..., n)
    angle : Array, broadcastable to (..., 1). [rad]

    Returns
    -------
    Point, shape (..., n). [m, m/rad, m/rad²]
    """
    cos = np.cos(angle)
    sin = np.sin(angle)
    x = moving.x
    y = moving.y
    return Point(
        Coefficient(cos * x.value + sin * y.value, cos * x.first + sin * y.first, cos * x.second + sin * y.second),
        Coefficient(cos * y.value - sin * x.value, cos * y.first - sin * x.first, cos * y.second - sin * x.second),
    )
