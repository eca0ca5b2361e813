"""RPR group: a slider in a guide that rocks or turns about a pivot."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.crank import Crank, crank
from cranktrain.linkage.point import Ends, fixed
from cranktrain.linkage.slide import AHEAD
from cranktrain.linkage.vectors import between, cross, dot, moving_between, rotated
from cranktrain.motion import Array, Coefficient, Handed, Link


class Swivel(NamedTuple):
    """Offset of the guide's line from the pivot [m], and side.

    The offset counts to the left of the guide's direction (turned 90° from x toward y). side is `AHEAD` (+1) where the
    slider lies ahead of the pivot along the guide, −1 where it lies behind.
    """

    offset: Array
    side: Array


class SwivelMotion(NamedTuple):
    """Slider: its position along the guide from the foot of the pivot [m]; guide: the link, from the pivot along it."""

    slider: Coefficient
    guide: Link


def swivel(ends: Ends, geometry: Swivel) -> SwivelMotion:
    """Guide that follows a slider on a moving pin, and its derivatives by the crank angle.

    Parameters
    ----------
    ends : Ends, coefficients of shape (..., n)
    geometry : Swivel, fields broadcastable to (..., 1)

    Returns
    -------
    SwivelMotion, shape (..., n)
        NaN where the pin is nearer to the pivot than the guide's line. The angle is a principal value in (−π, π].

    Notes
    -----
    d from pivot to pin, D = |d|: ρ = σ√((D − e)(D + e)), d = ρ(cos θ, sin θ) + e(−sin θ, cos θ). With d's turn
    ψ′ = d × d′/D² and stretch ε = d·d′/D², ψ″ = d × d″/D² − 2εψ′, ε′ = d·d″/D² + ψ′² − ε², and c = e/ρ:
    θ′ = ψ′ + εc, θ″ = ψ″ + ε′c − ε²c(1 + c²), ρ′ = εD²/ρ, ρ″ = (ε′ + ε²(1 − c²))D²/ρ. Exact; docs/theory/groups-2,
    eqs. (7.1) to (7.4).

    Examples
    --------
    A Whitworth drive, pivot below a longer crank: the guide turns R/(R + g) as fast while the pin is above.

    >>> from cranktrain.linkage import AHEAD, Crank, crank, fixed
    >>> pin = crank(np.pi / 2, Crank(0.3))
    >>> round(float(swivel(Ends(pin, fixed(0.0, -0.1)), Swivel(0.0, AHEAD)).guide.angle.first), 12)
    0.75
    """
    d, d1, d2 = moving_between(ends.pivot, ends.driver)
    square = dot(d, d)
    distance = np.sqrt(square)
    reach = geometry.side * np.sqrt((distance - geometry.offset) * (distance + geometry.offset))
    along = rotated(d, reach, -geometry.offset)
    cos = along.x / square
    sin = along.y / square
    turn = cross(d, d1) / square
    stretch = dot(d, d1) / square
    turn_rate = cross(d, d2) / square - 2.0 * stretch * turn
    stretch_rate = dot(d, d2) / square + (turn * turn - stretch * stretch)
    cot = geometry.offset / reach
    cot_square = cot * cot
    stretch_square = stretch * stretch
    lever = square / reach
    slider = Coefficient(reach, stretch * lever, (stretch_rate + stretch_square * (1.0 - cot_square)) * lever)
    angle = Coefficient(
        np.arctan2(sin, cos),
        turn + stretch * cot,
        turn_rate + (stretch_rate - stretch_square * (1.0 + cot_square)) * cot,
    )
    return SwivelMotion(slider, Link(ends.pivot, angle, cos, sin))


def swivel_gap(ends: Ends, geometry: Swivel) -> Array:
    """By how much the pin is farther from the pivot than the guide's line; negative where it cannot close. [m]"""
    d = between(ends.pivot, ends.driver)
    return np.sqrt(dot(d, d)) - np.abs(geometry.offset)


class CrankAndPivot(NamedTuple):
    """A crank and the fixed pivot of the guide that it drives.

    Crank radius, ground (shaft centre to pivot, along x), offset of the guide's line from the pivot, to its left [m];
    way: +1 where the pivot lies outside the crank circle, −1 inside.
    """

    crank_radius: Array
    ground_length: Array
    offset: Handed
    way: Array


def crank_swivel_gap(angle: Array, geometry: CrankAndPivot) -> Array:
    """By how much the crank pin is farther from the pivot than the guide's line; negative where not. [m]

    Negative also where the pivot has come to the other side of the crank circle: on the way there it was on it.
    """
    pin = crank(angle, Crank(geometry.crank_radius))
    pivot = fixed(geometry.ground_length, 0.0 * geometry.ground_length)
    nearest = geometry.ground_length - geometry.crank_radius
    crossed = np.abs(nearest) - geometry.way * nearest
    return swivel_gap(Ends(pin, pivot), Swivel(geometry.offset, AHEAD)) - crossed
