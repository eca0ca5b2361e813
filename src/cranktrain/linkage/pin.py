"""RRR group: a rod and a rocker jointed to one another, each with its other end on a moving or fixed point."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array, Coefficient, Link, Point


class Ends(NamedTuple):
    """The outer pins of the group: the rod's and the rocker's. [m, m/rad, m/rad²]"""

    rod: Point
    rocker: Point


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
        NaN where the links cannot meet. Angles are principal values in (−π, π].

    Notes
    -----
    d from the rod's end to the rocker's, D = |d|; rod q, rocker t = q − d; q × t = d × q = d × t = σH with
    H = ½√((l + r + D)(l + r − D)(D + l − r)(D − l + r)), d·q = ½(D² + (l + r)(l − r)), d·t = d·q − D².
    With d's turn ψ′ = d × d′/D² and stretch ε = d·d′/D², whose derivatives are ψ″ = d × d″/D² − 2εψ′ and
    ε′ = d·d″/D² + ψ′² − ε², and the cotangents c_l = d·q/σH, c_r = d·t/σH of the angles from d to rod and rocker,
    θ_l′ = ψ′ + εc_r, θ_r′ = ψ′ + εc_l, θ_l″ = ψ″ + ε′c_r − ε²c_l(1 + c_r²), θ_r″ = ψ″ + ε′c_l − ε²c_r(1 + c_l²).
    Exact; docs/theory/groups. Heron's product keeps its digits where the links are nearly in line; turn and stretch
    apart keep those of θ″ where the whole turns nearly as one body (a drag link).
    """
    dx = ends.rocker.x.value - ends.rod.x.value
    dy = ends.rocker.y.value - ends.rod.y.value
    dx1 = ends.rocker.x.first - ends.rod.x.first
    dy1 = ends.rocker.y.first - ends.rod.y.first
    dx2 = ends.rocker.x.second - ends.rod.x.second
    dy2 = ends.rocker.y.second - ends.rod.y.second
    total = geometry.rod_length + geometry.rocker_length
    difference = geometry.rod_length - geometry.rocker_length
    square = dx * dx + dy * dy
    distance = np.sqrt(square)
    cross = (0.5 * geometry.side) * np.sqrt(
        ((total + distance) * (total - distance)) * ((distance + difference) * (distance - difference))
    )
    ahead = 0.5 * (square + total * difference)
    behind = 0.5 * (total * difference - square)
    qx = (ahead * dx - cross * dy) / square
    qy = (ahead * dy + cross * dx) / square
    tx = (behind * dx - cross * dy) / square
    ty = (behind * dy + cross * dx) / square
    turn = (dx * dy1 - dy * dx1) / square
    stretch = (dx * dx1 + dy * dy1) / square
    turn_rate = (dx * dy2 - dy * dx2) / square - 2.0 * stretch * turn
    stretch_rate = (dx * dx2 + dy * dy2) / square + (turn * turn - stretch * stretch)
    rod_cot = ahead / cross
    rocker_cot = behind / cross
    rod_turn = turn + stretch * rocker_cot
    rocker_turn = turn + stretch * rod_cot
    stretch_square = stretch * stretch
    rod_rate = turn_rate + (stretch_rate * rocker_cot - stretch_square * rod_cot * (1.0 + rocker_cot * rocker_cot))
    rocker_rate = turn_rate + (stretch_rate * rod_cot - stretch_square * rocker_cot * (1.0 + rod_cot * rod_cot))
    rod_square = rod_turn * rod_turn
    joint = Point(
        Coefficient(
            ends.rod.x.value + qx,
            ends.rod.x.first - qy * rod_turn,
            ends.rod.x.second - (qy * rod_rate + qx * rod_square),
        ),
        Coefficient(
            ends.rod.y.value + qy,
            ends.rod.y.first + qx * rod_turn,
            ends.rod.y.second + (qx * rod_rate - qy * rod_square),
        ),
    )
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
    return PinMotion(joint, rod, rocker)


def pin_gap(ends: Ends, geometry: Pin) -> Array:
    """By how much the triangle of rod, rocker and the line between their ends can close; negative where not. [m]"""
    dx = ends.rocker.x.value - ends.rod.x.value
    dy = ends.rocker.y.value - ends.rod.y.value
    distance = np.sqrt(dx * dx + dy * dy)
    return np.minimum(
        geometry.rod_length + geometry.rocker_length - distance,
        distance - np.abs(geometry.rod_length - geometry.rocker_length),
    )
