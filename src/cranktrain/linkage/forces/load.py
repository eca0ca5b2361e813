"""Loads on links: along what they go, and for each unit of their size what they do to the link."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.vectors import Vector, Wrench, at_arm, dot, rotated, swept
from cranktrain.motion import ONE, ZERO, Array, Link, chosen


class LoadWay(NamedTuple):
    """What a load goes along.

    Attributes
    ----------
    unit : Wrench
        Of a load of 1 N or 1 N·m on the link, about its first pin.
    place : Array
        How far it is along: its point [m], or its link [rad].
    rate : Array
        Derivative of that by the crank angle.
    """

    unit: Wrench
    place: Array
    rate: Array


def turning(link: Link) -> LoadWay:
    """Way of a torque on a link: in the sense of rotation."""
    return LoadWay(Wrench(ZERO, ZERO, ONE), link.angle.value, link.angle.first)


def pushing(link: Link, arm: Vector, direction: Array) -> LoadWay:
    """Way of a force at a point of a link, in a direction that does not change.

    Parameters
    ----------
    link : Link, shape (..., n)
    arm : Vector, broadcastable to (..., 1)
        Of the point from the link's first pin, along and across it. [m]
    direction : Array, broadcastable
        Of the force from x, in the mechanism's axes. [rad]

    Returns
    -------
    LoadWay, shape (..., n)
    """
    own = rotated(arm, link.cos, link.sin)
    unit = Vector(np.cos(direction) + 0.0 * own.x, np.sin(direction) + 0.0 * own.x)
    return _at(link, own, unit)


def along_link(link: Link) -> LoadWay:
    """Way of a force on a slider: at its pin, along its guide."""
    still = 0.0 * link.origin.x.value
    return _at(link, Vector(still, still), Vector(link.cos + still, link.sin + still))


def across_link(link: Link, radius: Array) -> LoadWay:
    """Way of a force across a link that turns, at an arm about its first pin: to its left. [m]"""
    own = rotated(Vector(radius, ZERO), link.cos, link.sin)
    found = _at(link, own, Vector(-link.sin, link.cos))
    return LoadWay(found.unit, radius * link.angle.value, found.rate)


def off_arc(link: Link, radius: Array, direction: Array) -> LoadWay:
    """Way of a rope off an arc about a link's first pin: a direction that does not change, at an arm that does not.

    direction from x, in the mechanism's axes [rad]; radius is less than 0 where it turns the link backward [m].
    """
    still = 0.0 * link.angle.first
    unit = Wrench(np.cos(direction) + still, np.sin(direction) + still, radius + still)
    rate = radius * link.angle.first + link.origin.x.first * unit.x + link.origin.y.first * unit.y
    place = radius * link.angle.value + link.origin.x.value * unit.x + link.origin.y.value * unit.y
    return LoadWay(unit, place, rate)


def with_motion(link: Link, arm: Vector) -> LoadWay:
    """Way of a force that goes wherever its point goes; where that stands it has none, and no place. [m]"""
    own = rotated(arm, link.cos, link.sin)
    velocity, _ = swept(link.origin, own, link.angle)
    rate = np.hypot(velocity.x, velocity.y)
    moves = chosen(rate > 0.0, rate, 1.0)
    return LoadWay(at_arm(own, Vector(velocity.x / moves, velocity.y / moves)), 0.0 * rate, rate)


def _at(link: Link, arm: Vector, unit: Vector) -> LoadWay:
    """Way of a force at an arm in the mechanism's axes, along a unit vector."""
    velocity, _ = swept(link.origin, arm, link.angle)
    point = Vector(link.origin.x.value + arm.x, link.origin.y.value + arm.y)
    return LoadWay(at_arm(arm, unit), dot(point, unit), dot(velocity, unit))
