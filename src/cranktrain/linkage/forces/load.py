"""Loads on links: the wrench of a force at a point, against its motion or in a direction of its own."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.vectors import Vector, at_arm, direction, dot, rotated, swept
from cranktrain.linkage.vectors import Wrench as _Wrench
from cranktrain.motion import ZERO, Array, Link, chosen


class Way(NamedTuple):
    """What a load goes along: for each unit of its size a wrench on the link, and how fast it goes by the crank angle.

    unit: [1] of a force, or a moment alone; rate: of the force's point along it [m/rad], or of the link [1].
    """

    unit: _Wrench
    rate: Array


def turning(link: Link) -> Way:
    """Way of a torque on a link: in the sense of rotation."""
    return Way(_Wrench(ZERO, ZERO, ZERO + 1.0), link.angle.first)


def pushing(link: Link, place: Vector, angle: Array) -> Way:
    """Way of a force at a place of a link, in a fixed direction.

    Parameters
    ----------
    link : Link, shape (..., n)
    place : Vector, broadcastable to (..., 1)
        From the link's first pin, along and across it. [m]
    angle : Array, broadcastable
        Of the force from x, in the mechanism's axes. [rad]

    Returns
    -------
    Way, shape (..., n)
    """
    arm = rotated(place, link.cos, link.sin)
    unit = Vector(np.cos(angle) + 0.0 * arm.x, np.sin(angle) + 0.0 * arm.x)
    velocity, _ = swept(link.origin, arm, link.angle)
    return Way(at_arm(arm, unit), dot(velocity, unit))


def along_link(link: Link) -> Way:
    """Way of a force on a slider, along its guide."""
    unit = direction(link)
    still = 0.0 * link.origin.x.first
    rate = link.origin.x.first * unit.x + link.origin.y.first * unit.y
    return Way(_Wrench(unit.x + still, unit.y + still, still), rate)


def across_link(link: Link, radius: Array) -> Way:
    """Way of a force across a link, at an arm about its first pin: to its left."""
    place = Vector(radius, ZERO)
    arm = rotated(place, link.cos, link.sin)
    unit = Vector(-link.sin, link.cos)
    velocity, _ = swept(link.origin, arm, link.angle)
    return Way(at_arm(arm, unit), dot(velocity, unit))


def with_motion(link: Link, place: Vector) -> Way:
    """Way of a force that goes with its point, wherever that goes; where it stands there is none."""
    arm = rotated(place, link.cos, link.sin)
    velocity, _ = swept(link.origin, arm, link.angle)
    rate = np.hypot(velocity.x, velocity.y)
    moves = chosen(rate > 0.0, rate, 1.0)
    return Way(at_arm(arm, Vector(velocity.x / moves, velocity.y / moves)), rate)
