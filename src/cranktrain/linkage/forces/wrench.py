"""Wrenches: a force and a moment, what acts on a link or passes through a joint."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import ZERO, Array, Link, Point


class Wrench(NamedTuple):
    """Force [N], and moment about a point [N·m]: on a link about its first pin, in a joint about the joint's point."""

    x: Array
    y: Array
    moment: Array


NOTHING = Wrench(ZERO, ZERO, ZERO)


def added(one: Wrench, other: Wrench) -> Wrench:
    """Give both together; they must be about the same point and in the same axes."""
    return Wrench(one.x + other.x, one.y + other.y, one.moment + other.moment)


def opposite(wrench: Wrench) -> Wrench:
    """Give what the other body of a joint gets."""
    return Wrench(-wrench.x, -wrench.y, -wrench.moment)


def handed_back(link: Link, place: Point, reaction: Wrench) -> Wrench:
    """Give what a link gets from what hangs on it.

    Parameters
    ----------
    link : Link, coefficients of shape (..., n)
        Carries the joint.
    place : Point
        The joint. [m]
    reaction : Wrench, shape (..., n)
        Of the link on what hangs there.

    Returns
    -------
    Wrench, shape (..., n)
        On the link, about its first pin: the opposite of the reaction. docs/theory/forces, eq. (13.3).
    """
    arm_x = place.x.value - link.origin.x.value
    arm_y = place.y.value - link.origin.y.value
    return Wrench(-reaction.x, -reaction.y, -(reaction.moment + (arm_x * reaction.y - arm_y * reaction.x)))


def turned_wrench(wrench: Wrench, angle: Array) -> Wrench:
    """Give the same wrench in axes turned by `angle` in the sense of rotation; as `turned` does with points."""
    cos = np.cos(angle)
    sin = np.sin(angle)
    return Wrench(cos * wrench.x + sin * wrench.y, cos * wrench.y - sin * wrench.x, wrench.moment)


def work(link: Link, wrench: Wrench) -> Array:
    """Work of what acts on a link, about its first pin, by the crank angle: its torque on the crank. [N·m]

    F·o′ + Mθ′; docs/theory/forces, eq. (13.6).
    """
    return (wrench.x * link.origin.x.first + wrench.y * link.origin.y.first) + wrench.moment * link.angle.first
