"""Wrenches: a force and a moment, what acts on a link or passes through a joint."""

import numpy as np

from cranktrain.linkage.vectors import Wrench, between, cross, rotated
from cranktrain.motion import ZERO, Array, Link, Point

NOTHING = Wrench(ZERO, ZERO, ZERO)


def added(one: Wrench, other: Wrench) -> Wrench:
    """Give both together; they must be about the same point and in the same axes."""
    return Wrench(one.x + other.x, one.y + other.y, one.moment + other.moment)


def plus(one: Wrench, times: Array, other: Wrench) -> Wrench:
    """Give a wrench and so many times another; they must be about the same point and in the same axes."""
    return Wrench(one.x + times * other.x, one.y + times * other.y, one.moment + times * other.moment)


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
    return Wrench(-reaction.x, -reaction.y, -(reaction.moment + cross(between(link.origin, place), reaction)))


def turned_wrench(wrench: Wrench, angle: Array) -> Wrench:
    """Give the same wrench in axes turned by `angle` in the sense of rotation; as `turned` does with points."""
    force = rotated(wrench, np.cos(angle), -np.sin(angle))
    return Wrench(force.x, force.y, wrench.moment)


def work(link: Link, wrench: Wrench) -> Array:
    """Work of what acts on a link, about its first pin, by the crank angle: its torque on the crank. [N·m]

    F·o′ + Mθ′; docs/theory/forces, eq. (13.6).
    """
    return (wrench.x * link.origin.x.first + wrench.y * link.origin.y.first) + wrench.moment * link.angle.first
