"""Dead centres of an articulated rod and their slopes by its dimensions, in closed form.

docs/theory/synthesis, eqs. (8.30) and (8.31).
"""

from typing import Literal, NamedTuple

import numpy as np

from cranktrain.mechanisms.articulated_rod import ArticulatedRod, articulated_rod
from cranktrain.motion import Array

Free = Literal["knuckle_radius", "articulation_angle", "rod_length"]
"""What a solution may choose: r, ζ, l."""

NEWTON_STEPS = 12
HALF_THE_DIGITS = 1e-9
"""A Newton step this small, in radians or in parts of the quantity, leaves nothing but rounding for the next."""
_REST = 1e-9
"""Largest |s′| of a converged dead centre, in parts of the crank radius."""


class SlaveDeadCentres(NamedTuple):
    """Crank angles of a slave's dead centres from the master's axis [rad], and its distances from the shaft [m].

    NaN where the search from γ and γ + π does not settle on a highest and a lowest point.
    """

    top_angle: Array
    bottom_angle: Array
    top: Array
    bottom: Array


def slave_dead_centres(rod: ArticulatedRod) -> SlaveDeadCentres:
    """Dead centres of slaves, by Newton's method on s′ from γ and γ + π.

    Parameters
    ----------
    rod : ArticulatedRod, fields of any broadcastable shape

    Returns
    -------
    SlaveDeadCentres, of the broadcast shape
    """
    top_angle, top = _dead_centre(rod, rod.bank_angle, -1.0)
    bottom_angle, bottom = _dead_centre(rod, rod.bank_angle + np.pi, 1.0)
    return SlaveDeadCentres(top_angle, bottom_angle, top, bottom)


def _dead_centre(rod: ArticulatedRod, start: Array, bend: float) -> tuple[Array, Array]:
    """Angle and distance of the dead centre near an angle; `bend` is the sign that s″ must have there."""
    with np.errstate(all="ignore"):
        angle = start
        for _step in range(NEWTON_STEPS):
            slider = articulated_rod(angle, rod).slider
            step = slider.first / slider.second
            angle = angle - step
            if not np.any(np.abs(step) > HALF_THE_DIGITS):
                break
        slider = articulated_rod(angle, rod).slider
        settled = (np.abs(slider.first) <= _REST * rod.master.crank_radius) & (bend * slider.second > 0)
        near = np.abs(angle - start) < np.pi / 2
        return np.where(settled & near, angle, np.nan), np.where(settled & near, slider.value, np.nan)


def distance_slope(angle: Array, rod: ArticulatedRod, by: Free) -> Array:
    """Derivative of a slave's distance from the shaft by one of its dimensions, at a fixed crank angle.

    Parameters
    ----------
    angle : Array
        At a dead centre it is the derivative of H or h as well, since s′ = 0 there. [rad]
    rod : ArticulatedRod
    by : "knuckle_radius", "articulation_angle" or "rod_length"

    Returns
    -------
    Array, of the broadcast shape
        [1], for the angle [m/rad].

    Notes
    -----
    docs/theory/synthesis, eq. (8.31).
    """
    motion = articulated_rod(angle, rod)
    slope = motion.rod.sin / motion.rod.cos
    if by == "rod_length":
        return 1 / motion.rod.cos
    direction = rod.articulation_angle - rod.bank_angle + motion.master_rod.angle.value
    if by == "knuckle_radius":
        return np.cos(direction) + slope * np.sin(direction)
    return rod.knuckle_radius * (slope * np.cos(direction) - np.sin(direction))


def unshifted_angle(rod: ArticulatedRod, dead_centre: Literal["top", "bottom"]) -> Array:
    """Articulation angle that leaves a dead centre unshifted, docs/theory/articulated-rod, eqs. (4.8), (4.9). [rad]"""
    sine = rod.master.crank_radius * np.sin(rod.bank_angle)
    if dead_centre == "top":
        return rod.bank_angle + np.arcsin((sine - rod.master.offset) / rod.master.rod_length)
    return rod.bank_angle - np.arcsin((sine + rod.master.offset) / rod.master.rod_length)


def stroke_product(rod: ArticulatedRod) -> Array:
    """What a stroke nearly fixes: r(1 + r/l) sin(ζ − γ). [m]"""
    return (
        rod.knuckle_radius * (1 + rod.knuckle_radius / rod.rod_length) * np.sin(rod.articulation_angle - rod.bank_angle)
    )
