"""RRR group: a rod and a rocker jointed to one another, each with its other end on a moving or fixed point."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array, Coefficient, Link, Point


class Ends(NamedTuple):
    """The outer pins of the group: the rod's and the rocker's. [m, m/rad, m/rad²]"""

    rod: Point
    rocker: Point


class Span(NamedTuple):
    """The outer pins, and the line from the rod's to the rocker's: their difference. [m, m/rad, m/rad²]"""

    ends: Ends
    line: Point


class Pin(NamedTuple):
    """Lengths of rod and rocker [m]; side +1: joint left of the line from the rod's end to the rocker's, −1: right.

    Left is the side to which that line points when turned 90° from x toward y.
    """

    rod_length: Array
    rocker_length: Array
    side: Array


class PinMotion(NamedTuple):
    """The common joint [m], the rod from its outer pin to the joint, and the rocker from its outer pin to the joint."""

    joint: Point
    rod: Link
    rocker: Link


def pin(ends: Ends, geometry: Pin) -> PinMotion:
    """Joint of a rod and a rocker whose outer pins move as given, and its derivatives by the crank angle.

    Parameters
    ----------
    ends : Ends, coefficients of shape (..., n)
    geometry : Pin, fields broadcastable to (..., 1)

    Returns
    -------
    PinMotion, shape (..., n)
        As `pin_across`, which it calls with the difference of the ends.
    """
    rod, rocker = ends
    line = Point(
        Coefficient(rocker.x.value - rod.x.value, rocker.x.first - rod.x.first, rocker.x.second - rod.x.second),
        Coefficient(rocker.y.value - rod.y.value, rocker.y.first - rod.y.first, rocker.y.second - rod.y.second),
    )
    return pin_across(Span(ends, line), geometry)


def pin_across(span: Span, geometry: Pin) -> PinMotion:
    """Joint of a rod and a rocker across a line whose motion is known already.

    Parameters
    ----------
    span : Span, coefficients of shape (..., n)
    geometry : Pin, fields broadcastable to (..., 1)

    Returns
    -------
    PinMotion, shape (..., n)
        NaN where the links cannot meet. Angles are principal values in (−π, π].

    Notes
    -----
    d from the rod's end to the rocker's, D = |d|, e = d/D²; rod q, rocker t = q − d; q × t = σH with
    H = ½√(((l + r)² − D²)(D² − (l − r)²)), d·q = ½((l + r)(l − r) + D²), d·t = d·q − D², q = (d·q)e + σH e⊥.
    With d's turn ψ′ = e × d′ and stretch ε = e·d′, the links swing against d by a = ε d·t/σH and b = ε d·q/σH:
    θ_l′ = ψ′ + a, θ_r′ = ψ′ + b; and θ_l″ = c + s d·t, θ_r″ = c + s d·q with c = e × d″ − ε(θ_l′ + θ_r′) and
    s = (e·d″ + ψ′² − ab)/σH. Exact; docs/theory/groups. The differences in H keep their digits where the links are
    nearly in line; turn and stretch apart keep those of θ″ where the whole turns nearly as one body (a drag link).
    """
    ends = span.ends
    qx, qy, tx, ty, rod_turn, rocker_turn, rod_rate, rocker_rate = _vectors_and_turns(span.line, geometry)
    rod = Link(
        ends.rod,
        Coefficient(np.arctan2(qy, qx), rod_turn, rod_rate),
        qx / geometry.rod_length,
        qy / geometry.rod_length,
    )
    rocker = Link(
        ends.rocker,
        Coefficient(np.arctan2(ty, tx), rocker_turn, rocker_rate),
        tx / geometry.rocker_length,
        ty / geometry.rocker_length,
    )
    sweep_x = qy * rod_turn
    sweep_y = qx * rod_turn
    x = ends.rod.x
    y = ends.rod.y
    joint = Point(
        Coefficient(x.value + qx, x.first - sweep_x, x.second - (qy * rod_rate + sweep_y * rod_turn)),
        Coefficient(y.value + qy, y.first + sweep_y, y.second + (qx * rod_rate - sweep_x * rod_turn)),
    )
    return PinMotion(joint, rod, rocker)


def _vectors_and_turns(line: Point, geometry: Pin) -> tuple[Array, Array, Array, Array, Array, Array, Array, Array]:
    """Rod and rocker as vectors to the joint; first, then second derivatives of their angles.

    On its own so that its intermediate arrays are freed before the results are made.
    """
    dx, dx1, dx2 = line.x
    dy, dy1, dy2 = line.y
    total = geometry.rod_length + geometry.rocker_length
    difference = geometry.rod_length - geometry.rocker_length
    square = dx * dx + dy * dy
    cross = (0.5 * geometry.side) * np.sqrt((total * total - square) * (square - difference * difference))
    ahead = 0.5 * total * difference + 0.5 * square
    behind = ahead - square
    ex = dx / square
    ey = dy / square
    qx = ahead * ex - cross * ey
    qy = ahead * ey + cross * ex
    turn = ex * dy1 - ey * dx1
    stretch = ex * dx1 + ey * dy1
    per_cross = 1.0 / cross
    opening = stretch * per_cross
    rod_swing = opening * behind
    rocker_swing = opening * ahead
    rod_turn = turn + rod_swing
    rocker_turn = turn + rocker_swing
    common = (ex * dy2 - ey * dx2) - stretch * (rod_turn + rocker_turn)
    # ψ′² first: where the whole turns as one body it cancels e·d″ without rounding.
    spread = ((ex * dx2 + ey * dy2 + turn * turn) - rod_swing * rocker_swing) * per_cross
    return qx, qy, qx - dx, qy - dy, rod_turn, rocker_turn, common + spread * behind, common + spread * ahead


def pin_gap(ends: Ends, geometry: Pin) -> Array:
    """By how much the triangle of rod, rocker and the line between their ends can close; negative where not. [m]"""
    dx = ends.rocker.x.value - ends.rod.x.value
    dy = ends.rocker.y.value - ends.rod.y.value
    distance = np.sqrt(dx * dx + dy * dy)
    return np.minimum(
        geometry.rod_length + geometry.rocker_length - distance,
        distance - np.abs(geometry.rod_length - geometry.rocker_length),
    )
