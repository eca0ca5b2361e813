"""RRR group: a rod and a rocker jointed to one another, each with its other end on a moving or fixed point."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.point import fixed
from cranktrain.motion import Array, Coefficient, Link, Point


class Ends(NamedTuple):
    """The outer pins of the group: the rod's and the rocker's. [m, m/rad, m/rad²]"""

    rod: Point
    rocker: Point


class CrankAndGround(NamedTuple):
    """A crank's pin [m, m/rad, m/rad²], and how far along x from the shaft's centre a pivot stands still. [m]"""

    pin: Point
    ground_length: Array


class Line(NamedTuple):
    """The line d from the rod's end to the rocker's, and how it moves, with e = d/D².

    x, y [m] and square D² [m²] of it; inverse_x, inverse_y: e [1/m]; turn ψ′ = e × d′, stretch ε = e·d′, and of the
    second derivative across = e × d″, bend = e·d″ + ψ′².
    """

    x: Array
    y: Array
    square: Array
    inverse_x: Array
    inverse_y: Array
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
    d from the rod's end to the rocker's, D = |d|, e = d/D²; rod q, rocker t = q − d; q × t = σH with
    H = ½√(((l + r)² − D²)(D² − (l − r)²)), d·q = ½((l + r)(l − r) + D²), d·t = d·q − D², q = (d·q)e + σH e⊥.
    With d's turn ψ′ = e × d′ and stretch ε = e·d′, the links swing against d by a = ε d·t/σH and b = ε d·q/σH:
    θ_l′ = ψ′ + a, θ_r′ = ψ′ + b; and θ_l″ = c + s d·t, θ_r″ = c + s d·q with c = e × d″ − ε(θ_l′ + θ_r′) and
    s = (e·d″ + ψ′² − ab)/σH. Exact; docs/theory/groups. The differences in H keep their digits where the links are
    nearly in line; turn and stretch apart keep those of θ″ where the whole turns nearly as one body (a drag link).
    """
    qx, qy, tx, ty, rod_turn, rocker_turn, rod_rate, rocker_rate = _vectors_and_turns(line_between(ends), geometry)
    rod = Coefficient(np.arctan2(qy, qx), rod_turn, rod_rate)
    rocker = Coefficient(np.arctan2(ty, tx), rocker_turn, rocker_rate)
    sweep_x = qy * rod_turn
    sweep_y = qx * rod_turn
    x = ends.rod.x
    y = ends.rod.y
    joint = Point(
        Coefficient(x.value + qx, x.first - sweep_x, x.second - (qy * rod_rate + sweep_y * rod_turn)),
        Coefficient(y.value + qy, y.first + sweep_y, y.second + (qx * rod_rate - sweep_x * rod_turn)),
    )
    return PinMotion(
        joint,
        Link(ends.rod, rod, qx / geometry.rod_length, qy / geometry.rod_length),
        Link(ends.rocker, rocker, tx / geometry.rocker_length, ty / geometry.rocker_length),
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
    qx, qy, tx, ty, rod_turn, rocker_turn, rod_rate, rocker_rate = _vectors_and_turns(line_from_crank(driver), geometry)
    pivot = fixed(driver.ground_length, 0.0 * driver.ground_length)
    # The angles first: a compiled loop then has less to keep across the calls of arctan2.
    rod = Coefficient(np.arctan2(qy, qx), rod_turn, rod_rate)
    rocker = Coefficient(np.arctan2(ty, tx), rocker_turn, rocker_rate)
    minus_ty = -ty
    x1 = minus_ty * rocker_turn
    y1 = tx * rocker_turn
    joint = Point(
        Coefficient(crank_pin.x.value + qx, x1, minus_ty * rocker_rate - y1 * rocker_turn),
        Coefficient(ty, y1, tx * rocker_rate + x1 * rocker_turn),
    )
    return PinMotion(
        joint,
        Link(crank_pin, rod, qx / geometry.rod_length, qy / geometry.rod_length),
        Link(pivot, rocker, tx / geometry.rocker_length, ty / geometry.rocker_length),
    )


def line_between(ends: Ends) -> Line:
    """Line from the rod's end to the rocker's, both of which may move."""
    dx = ends.rocker.x.value - ends.rod.x.value
    dy = ends.rocker.y.value - ends.rod.y.value
    dx1 = ends.rocker.x.first - ends.rod.x.first
    dy1 = ends.rocker.y.first - ends.rod.y.first
    dx2 = ends.rocker.x.second - ends.rod.x.second
    dy2 = ends.rocker.y.second - ends.rod.y.second
    square = dx * dx + dy * dy
    ex = dx / square
    ey = dy / square
    turn = ex * dy1 - ey * dx1
    # ψ′² to e·d″ first: where the whole turns as one body they cancel without rounding.
    bend = (ex * dx2 + ey * dy2) + turn * turn
    return Line(dx, dy, square, ex, ey, turn, ex * dx1 + ey * dy1, ex * dy2 - ey * dx2, bend)


def line_from_crank(driver: CrankAndGround) -> Line:
    """Line from a crank's pin to a pivot that stands still on the axis x through the shaft's centre.

    A crank's derivatives are its own coordinates, a′ = a⊥, a″ = −a, and a + d = (g, 0): so ε = e × d″ = −g e_y, and
    e·d″ + ψ′² = −ψ′(1 − ψ′) = −ψ′ g e_x, without the differences that lose digits where the ground is short.
    """
    crank_pin = driver.pin
    dx = driver.ground_length - crank_pin.x.value
    dy = crank_pin.y.second
    square = dx * dx + dy * dy
    ex = dx / square
    ey = dy / square
    turn = ex * crank_pin.x.second + ey * dy
    minus_ground = -driver.ground_length
    stretch = minus_ground * ey
    return Line(dx, dy, square, ex, ey, turn, stretch, stretch, (minus_ground * ex) * turn)


def _vectors_and_turns(line: Line, geometry: Pin) -> tuple[Array, Array, Array, Array, Array, Array, Array, Array]:
    """Rod and rocker as vectors to the joint; first, then second derivatives of their angles.

    On its own so that its intermediate arrays are freed before the results are made.
    """
    dx, dy, square, ex, ey, turn, stretch, across, bend = line
    total = geometry.rod_length + geometry.rocker_length
    difference = geometry.rod_length - geometry.rocker_length
    cross = (0.5 * geometry.side) * np.sqrt((total * total - square) * (square - difference * difference))
    ahead = 0.5 * total * difference + 0.5 * square
    behind = ahead - square
    qx = ahead * ex - cross * ey
    qy = ahead * ey + cross * ex
    per_cross = 1.0 / cross
    opening = stretch * per_cross
    rod_swing = opening * behind
    rocker_swing = opening * ahead
    rod_turn = turn + rod_swing
    rocker_turn = turn + rocker_swing
    common = across - stretch * (rod_turn + rocker_turn)
    spread = (bend - rod_swing * rocker_swing) * per_cross
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
