"""RRR group that passes change points: rod and rocker are as long as the lines that its ends are carried by."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.pin import Pin, PinMotion, line_between
from cranktrain.linkage.point import Ends
from cranktrain.linkage.vectors import Vector, between, cross, dot, moving_between, swept
from cranktrain.motion import Array, Coefficient, Link, Point, chosen

_ROUNDING = 64 * np.finfo(float).eps
"""Of the terms of a turn's rate; what is less is nothing."""


class Hinged(NamedTuple):
    """A group's outer pins, and the hinge of the two bodies that carry them. [m, m/rad, m/rad²]"""

    ends: Ends
    hinge: Point


def parallelogram(driver: Hinged, geometry: Pin) -> PinMotion:
    """Rod and rocker that stay parallel to what carries their ends, through change points by continuity.

    Parameters
    ----------
    driver : Hinged, coefficients of shape (..., n)
    geometry : Pin, fields broadcastable to (..., 1)
        The rod as long as the line from hinge to pivot, the rocker as that from hinge to driver. Its side says nothing.

    Returns
    -------
    PinMotion, shape (..., n)
        Angles are principal values in (−π, π].

    Notes
    -----
    θ_l is the direction of the line from hinge to pivot, θ_r of that from hinge to driver. Exact; docs/theory/groups,
    eq. (1.21).
    """
    ends, hinge = driver
    return _joined(ends, geometry, _direction(hinge, ends.pivot), _direction(hinge, ends.driver))


def crossed_parallelogram(driver: Hinged, geometry: Pin) -> PinMotion:
    """Rod and rocker of a parallelogram's lengths, crossed: mirrored about the line of the ends.

    Parameters and returns as of `parallelogram`; NaN where the ends meet. docs/theory/groups, eq. (1.22).
    """
    ends, hinge = driver
    line = _doubled(ends)
    rod = _mirrored(_direction(hinge, ends.pivot), line)
    return _joined(ends, geometry, rod, _mirrored(_direction(hinge, ends.driver), line))


def kite(driver: Hinged, geometry: Pin) -> PinMotion:
    """Rod and rocker whose joint is the hinge's mirror image, through change points by continuity.

    Parameters
    ----------
    driver : Hinged, coefficients of shape (..., n)
    geometry : Pin, fields broadcastable to (..., 1)
        The rod as long as the line from driver to hinge, the rocker as that from pivot to hinge. Its side says nothing.

    Returns
    -------
    PinMotion, shape (..., n)
        NaN where the ends meet. Angles are principal values in (−π, π].

    Notes
    -----
    Exact; docs/theory/groups, eq. (1.22).
    """
    ends, hinge = driver
    line = _doubled(ends)
    rod = _mirrored(_direction(ends.driver, hinge), line)
    return _joined(ends, geometry, rod, _mirrored(_direction(ends.pivot, hinge), line))


def out_of_line(driver: Hinged) -> Array:
    """Sine of the angle from the line hinge to pivot to the line hinge to driver: 0 at a change point. [1]"""
    to_driver, to_pivot = between(driver.hinge, driver.ends.driver), between(driver.hinge, driver.ends.pivot)
    return cross(to_pivot, to_driver) / np.sqrt(dot(to_pivot, to_pivot) * dot(to_driver, to_driver))


class _Direction(NamedTuple):
    """Where a line points: unit vector; first and second derivative of its angle by the crank angle."""

    unit: Vector
    turn: Array
    turn_rate: Array


def _direction(start: Point, end: Point) -> _Direction:
    """Of the line between two points of one body, which keeps its length."""
    d, d1, d2 = moving_between(start, end)
    square = dot(d, d)
    length = np.sqrt(square)
    rate = cross(d, d2) / square
    # A body that turns evenly is sped up by the rounding of its pins alone.
    is_clear = np.abs(rate) > _ROUNDING * np.sqrt(dot(d2, d2) / square)
    return _Direction(Vector(d.x / length, d.y / length), cross(d, d1) / square, chosen(is_clear, rate, 0.0))


def _doubled(ends: Ends) -> _Direction:
    """Twice the angle of the line of the ends, which changes its length."""
    d, _square, e, turn, stretch, across, _bend = line_between(ends)
    unit = Vector(d.x * e.x - d.y * e.y, 2.0 * d.x * e.y)
    return _Direction(unit, 2.0 * turn, 2.0 * (across - 2.0 * stretch * turn))


def _mirrored(own: _Direction, line: _Direction) -> _Direction:
    """Mirrored about a line, whose angle comes doubled: 2ψ − θ."""
    one, other = line.unit, own.unit
    unit = Vector(one.x * other.x + one.y * other.y, one.y * other.x - one.x * other.y)
    return _Direction(unit, line.turn - own.turn, line.turn_rate - own.turn_rate)


def _joined(ends: Ends, geometry: Pin, rod: _Direction, rocker: _Direction) -> PinMotion:
    """Rod and rocker from their outer pins, and the rod's far end as their joint."""
    on_driver, on_pivot = _link(ends.driver, rod), _link(ends.pivot, rocker)
    arm = Vector(geometry.rod_length * rod.unit.x, geometry.rod_length * rod.unit.y)
    v, a = swept(ends.driver, arm, on_driver.angle)
    x = ends.driver.x
    y = ends.driver.y
    joint = Point(Coefficient(x.value + arm.x, v.x, a.x), Coefficient(y.value + arm.y, v.y, a.y))
    return PinMotion(joint, on_driver, on_pivot)


def _link(origin: Point, own: _Direction) -> Link:
    angle = Coefficient(np.arctan2(own.unit.y, own.unit.x), own.turn, own.turn_rate)
    return Link(origin, angle, own.unit.x, own.unit.y)
