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
    d from the rod's end to the rocker's, D = |d|; rod q = (k d + σH d⊥)/D², rocker t = q − d, with
    k = (D² + (l − r)(l + r))/2 and H = ½√((l + r + D)(l + r − D)(D + l − r)(D − l + r)), q × t = σH.
    Differentiating d = q − t: θ_l′ = d′·t/σH, θ_r′ = d′·q/σH; with κ = d″ + θ_l′²q − θ_r′²t, θ_l″ = κ·t/σH,
    θ_r″ = κ·q/σH. Exact; docs/theory/groups. Heron's product keeps its digits where the links are nearly in line.
    """
    dx = ends.rocker.x.value - ends.rod.x.value
    dy = ends.rocker.y.value - ends.rod.y.value
    dx1 = ends.rocker.x.first - ends.rod.x.first
    dy1 = ends.rocker.y.first - ends.rod.y.first
    total = geometry.rod_length + geometry.rocker_length
    difference = geometry.rod_length - geometry.rocker_length
    square = dx * dx + dy * dy
    distance = np.sqrt(square)
    cross = (0.5 * geometry.side) * np.sqrt(
        ((total + distance) * (total - distance)) * ((distance + difference) * (distance - difference))
    )
    along = 0.5 + (0.5 * total * difference) / square
    across = cross / square
    qx = along * dx - across * dy
    qy = along * dy + across * dx
    tx = qx - dx
    ty = qy - dy
    rod_turn = (dx1 * tx + dy1 * ty) / cross
    rocker_turn = (dx1 * qx + dy1 * qy) / cross
    rod_square = rod_turn * rod_turn
    rocker_square = rocker_turn * rocker_turn
    kx = (ends.rocker.x.second - ends.rod.x.second) + (rod_square * qx - rocker_square * tx)
    ky = (ends.rocker.y.second - ends.rod.y.second) + (rod_square * qy - rocker_square * ty)
    rod_rate = (kx * tx + ky * ty) / cross
    rocker_rate = (kx * qx + ky * qy) / cross
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
