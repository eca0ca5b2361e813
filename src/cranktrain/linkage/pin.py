"""RRR group: a rod and a rocker jointed to one another, each with its other end on a moving or fixed point."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.point import Ends, fixed
from cranktrain.linkage.vectors import Vector, between, cross, dot, moving_between, rotated
from cranktrain.motion import Array, Coefficient, Handed, Link, Point


class CrankAndGround(NamedTuple):
    """A crank's pin [m, m/rad, m/rad²], and how far along x from the shaft's centre a pivot stands still. [m]"""

    pin: Point
    ground_length: Array


class CentreLine(NamedTuple):
    """The line d from the rod's end to the rocker's, and how it moves, with e = d/D².

    vector d [m], its square D² [m²], inverse e [1/m]; turn ψ′ = e × d′, stretch ε = e·d′, and of the second derivative
    across = e × d″, bend = e·d″ + ψ′².
    """

    vector: Vector
    square: Array
    inverse: Vector
    turn: Array
    stretch: Array
    across: Array
    bend: Array


class Pin(NamedTuple):
    """Lengths of rod and rocker [m]; side +1: joint left of the line from the rod's end to the rocker's, −1: right.

    Left is the side to which that line points when turned 90° from x toward y.
    """

    rod_length: Array
    rocker_length: Array
    side: Handed


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
    d from the rod's end to the rocker's, D = |d|, e = d/D²; rod q, rocker t = q − d; q × t = σH with
    H = ½√(((l + r)² − D²)(D² − (l − r)²)), d·q = ½((l + r)(l − r) + D²), d·t = d·q − D², q = (d·q)e + σH e⊥.
    With d's turn ψ′ = e × d′ and stretch ε = e·d′, the links swing against d by a = ε d·t/σH and b = ε d·q/σH:
    θ_l′ = ψ′ + a, θ_r′ = ψ′ + b; and θ_l″ = c + s d·t, θ_r″ = c + s d·q with c = e × d″ − ε(θ_l′ + θ_r′) and
    s = (e·d″ + ψ′² − ab)/σH. Exact; docs/theory/groups. The differences in H keep their digits where the links are
    nearly in line; turn and stretch apart keep those of θ″ where the whole turns nearly as one body (a drag link).
    """
    q, t, rod, rocker = _vectors_and_angles(line_between(ends), geometry)
    v, a = _swept(q, rod)
    x = ends.driver.x
    y = ends.driver.y
    return PinMotion(
        Point(
            Coefficient(x.value + q.x, x.first + v.x, x.second + a.x),
            Coefficient(y.value + q.y, y.first + v.y, y.second + a.y),
        ),
        Link(ends.driver, rod, q.x / geometry.rod_length, q.y / geometry.rod_length),
        Link(ends.pivot, rocker, t.x / geometry.rocker_length, t.y / geometry.rocker_length),
    )


def pin_from_crank(driver: CrankAndGround, geometry: Pin) -> PinMotion:
    """Joint of a rod on a crank's pin and a rocker on a pivot that stands still; the same as `pin`, in fewer steps.

    Parameters
    ----------
    driver : CrankAndGround, coefficients of shape (..., n), length broadcastable to (..., 1)
    geometry : Pin, fields broadcastable to (..., 1)

    Returns
    -------
    PinMotion, shape (..., n)
        NaN where the links cannot meet. Angles are principal values in (−π, π].

    Notes
    -----
    The joint is the far end of a rocker t about a pivot on x: b = (g, 0) + t, b′ = θ_r′t⊥, b″ = θ_r″t⊥ − θ_r′²t.
    """
    crank_pin = driver.pin
    q, t, rod, rocker = _vectors_and_angles(line_from_crank(driver), geometry)
    pivot = fixed(driver.ground_length, 0.0 * driver.ground_length)
    v, a = _swept(t, rocker)
    return PinMotion(
        Point(Coefficient(crank_pin.x.value + q.x, v.x, a.x), Coefficient(t.y, v.y, a.y)),
        Link(crank_pin, rod, q.x / geometry.rod_length, q.y / geometry.rod_length),
        Link(pivot, rocker, t.x / geometry.rocker_length, t.y / geometry.rocker_length),
    )


def line_between(ends: Ends) -> CentreLine:
    """Line from the rod's end to the rocker's, both of which may move."""
    d, d1, d2 = moving_between(ends.driver, ends.pivot)
    square = dot(d, d)
    e = Vector(d.x / square, d.y / square)
    turn = cross(e, d1)
    # ψ′² to e·d″ first: where the whole turns as one body they cancel without rounding.
    return CentreLine(d, square, e, turn, dot(e, d1), cross(e, d2), dot(e, d2) + turn * turn)


def line_from_crank(driver: CrankAndGround) -> CentreLine:
    """Line from a crank's pin to a pivot that stands still on the axis x through the shaft's centre.

    A crank's derivatives are its own coordinates, a′ = a⊥, a″ = −a, and a + d = (g, 0): so ε = e × d″ = −g e_y, and
    e·d″ + ψ′² = −ψ′(1 − ψ′) = −ψ′ g e_x, without the differences that lose digits where the ground is short.
    """
    crank_pin = driver.pin
    d = Vector(driver.ground_length - crank_pin.x.value, crank_pin.y.second)
    square = dot(d, d)
    e = Vector(d.x / square, d.y / square)
    turn = e.x * crank_pin.x.second + e.y * d.y
    minus_ground = -driver.ground_length
    stretch = minus_ground * e.y
    return CentreLine(d, square, e, turn, stretch, stretch, (minus_ground * e.x) * turn)


def _vectors_and_angles(line: CentreLine, geometry: Pin) -> tuple[Vector, Vector, Coefficient, Coefficient]:
    """Rod and rocker as vectors to the joint, and their angles.

    On its own so that its intermediate arrays are freed before the results are made, and with the angles at once: a
    compiled loop then has less to keep across the calls of arctan2.
    """
    d, square, e, turn, stretch, across, bend = line
    total = geometry.rod_length + geometry.rocker_length
    difference = geometry.rod_length - geometry.rocker_length
    area = (0.5 * geometry.side) * np.sqrt((total * total - square) * (square - difference * difference))
    ahead = 0.5 * total * difference + 0.5 * square
    behind = ahead - square
    q = rotated(e, ahead, area)
    t = Vector(q.x - d.x, q.y - d.y)
    per_area = 1.0 / area
    opening = stretch * per_area
    rod_swing = opening * behind
    rocker_swing = opening * ahead
    rod_turn = turn + rod_swing
    rocker_turn = turn + rocker_swing
    common = across - stretch * (rod_turn + rocker_turn)
    spread = (bend - rod_swing * rocker_swing) * per_area
    rod = Coefficient(np.arctan2(q.y, q.x), rod_turn, common + spread * behind)
    return q, t, rod, Coefficient(np.arctan2(t.y, t.x), rocker_turn, common + spread * ahead)


def _swept(arm: Vector, angle: Coefficient) -> tuple[Vector, Vector]:
    """Derivatives of an arm that turns, θ′ρ⊥ and θ″ρ⊥ − θ′²ρ."""
    turn = angle.first
    v = Vector(-arm.y * turn, arm.x * turn)
    return v, Vector(-(arm.y * angle.second + v.y * turn), arm.x * angle.second + v.x * turn)


def pin_gap(ends: Ends, geometry: Pin) -> Array:
    """By how much the triangle of rod, rocker and the line between their ends can close; negative where not. [m]"""
    d = between(ends.driver, ends.pivot)
    distance = np.sqrt(dot(d, d))
    return np.minimum(
        geometry.rod_length + geometry.rocker_length - distance,
        distance - np.abs(geometry.rod_length - geometry.rocker_length),
    )
