"""The legs of a triad once its link has been found, and the ends that they are given."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.point import fixed
from cranktrain.linkage.vectors import cross, direction, dot, moving_between
from cranktrain.motion import Array, Coefficient, Link, Point


class OnLine(NamedTuple):
    """A moving line, given by the link that carries it, and a point on it or beside it at a constant distance."""

    line: Link
    point: Point


def fixed_guide(x: Array, y: Array, angle: Array) -> Link:
    """Line that stands still in the frame: through (x, y) [m], at an angle from x [rad]."""
    return Link(fixed(x, y), Coefficient(angle, 0.0 * angle, 0.0 * angle), np.cos(angle), np.sin(angle))


def rod_end(end: Point) -> Link:
    """Outer end of a rod, as a `Triad` takes it: a link of no particular direction from that point."""
    zero = 0.0 * end.x.value
    return Link(end, Coefficient(zero, zero, zero), zero + 1.0, zero)


def rod_between(start: Point, end: Point) -> Link:
    """Rod between two points whose distance does not change, and its derivatives by the crank angle.

    Parameters
    ----------
    start, end : Point, coefficients of shape (..., n)

    Returns
    -------
    Link, shape (..., n)
        From start to end. Its angle is a principal value in (−π, π].

    Notes
    -----
    d·d′ = 0: θ′ = d × d′/D², θ″ = d × d″/D². Exact; docs/theory/groups-2, eq. (7.16).
    """
    d, d1, d2 = moving_between(start, end)
    square = dot(d, d)
    length = np.sqrt(square)
    angle = Coefficient(np.arctan2(d.y, d.x), cross(d, d1) / square, cross(d, d2) / square)
    return Link(start, angle, d.x / length, d.y / length)


def block_along(on_line: OnLine) -> Coefficient:
    """Position of a block along the line that carries it, and its derivatives by the crank angle.

    Parameters
    ----------
    on_line : OnLine, coefficients of shape (..., n)

    Returns
    -------
    Coefficient, shape (..., n)
        From beside the line's first pin, along its direction. [m, m/rad, m/rad²]

    Notes
    -----
    t = u·w, h = n·w constant: t′ = u·w′ + β′h, t″ = u·w″ + β″h + β′²t. Exact; docs/theory/groups-2, eq. (7.17).
    """
    line, point = on_line
    u = direction(line)
    w, w1, w2 = moving_between(line.origin, point)
    along = dot(u, w)
    shift = cross(u, w)
    turn = line.angle.first
    return Coefficient(along, dot(u, w1) + turn * shift, dot(u, w2) + (line.angle.second * shift + turn * turn * along))
