"""Mechanical advantage of a slider-crank and of a toggle near their dead centres, in closed form."""

from math import asin, cos, sin, sqrt, tan
from typing import Literal

from cranktrain.synthesis.slider_crank_lengths import Lengths

DeadCentre = Literal["top", "bottom"]
"""Farthest from the shaft, crank and rod stretched; or nearest, folded."""


def advantage(lengths: Lengths, angle: float) -> float:
    """Force on the slider for each newton of tangential force at the crank pin.

    Parameters
    ----------
    lengths : Lengths
    angle : float
        Crank angle from x. [rad]

    Returns
    -------
    float
        R/|s′| = cos β/|sin(φ + β)|, exact; docs/theory/synthesis, eq. (8.24).

    Examples
    --------
    >>> from math import pi
    >>> round(advantage(Lengths(0.1, 0.5, 0.0), pi / 2), 12)
    1.0
    """
    radius, rod, offset = lengths
    lean = asin((radius * sin(angle) - offset) / rod)
    return cos(lean) / abs(sin(angle + lean))


def advantage_near(lengths: Lengths, before: float, dead_centre: DeadCentre = "bottom") -> float:
    """Advantage at a small crank angle before or after a dead centre, to first order.

    Parameters
    ----------
    lengths : Lengths
    before : float
        Crank angle between it and the true dead centre. [rad]
    dead_centre : "top" or "bottom"

    Returns
    -------
    float
        cos β_D/((1 ± R/L) Δφ), + at the top; docs/theory/synthesis, eq. (8.25).
    """
    return lengths.crank_radius / (_bend(lengths, dead_centre) * before)


def advantage_at_travel(lengths: Lengths, travel: float, dead_centre: DeadCentre = "bottom") -> float:
    """Advantage where the slider is a small travel from its dead centre, to first order.

    Parameters
    ----------
    lengths : Lengths
    travel : float
        Between slider and dead centre. [m]
    dead_centre : "top" or "bottom"

    Returns
    -------
    float
        √(R cos β_D/(2(1 ± R/L) x)); docs/theory/synthesis, eq. (8.26).
    """
    return lengths.crank_radius / sqrt(2 * _bend(lengths, dead_centre) * travel)


def toggle_advantage(first: float, second: float) -> float:
    """Thrust of a toggle along its line for each newton across it at the knee.

    Parameters
    ----------
    first, second : float
        Angles of the two links from the line through their outer pins. [rad]

    Returns
    -------
    float
        1/(tan α₁ + tan α₂); of equal links 1/(2 tan α). docs/theory/synthesis, eq. (8.27).

    Examples
    --------
    >>> from math import radians
    >>> round(toggle_advantage(radians(5), radians(5)), 4)
    5.715
    """
    return 1 / (tan(first) + tan(second))


def _bend(lengths: Lengths, dead_centre: DeadCentre) -> float:
    """|s″| at a dead centre, R(1 ± R/L)/cos β_D. [m/rad²]"""
    radius, rod, offset = lengths
    reach = 1.0 if dead_centre == "top" else -1.0
    sine = offset / (rod + reach * radius)
    return radius * (1 + reach * radius / rod) / sqrt((1 - sine) * (1 + sine))
