"""Lengths of slider-cranks within permissible pressure angles, exact with an offset; docs/theory/synthesis."""

from collections.abc import Callable
from math import asin, sqrt
from typing import NamedTuple

import numpy as np

from cranktrain.numerics import bracketed_roots


class Lengths(NamedTuple):
    """Crank radius, rod, and offset toward +y, of a slider-crank. [m]"""

    crank_radius: float
    rod_length: float
    offset: float


class Limits(NamedTuple):
    """Sines of the permissible pressure angles on the slow and on the quick stroke."""

    slow: float
    quick: float


def stroke_of(lengths: Lengths) -> float:
    """Stroke of a slider-crank, S = 4LR/(s_T + s_B). [m]"""
    radius, rod, offset = lengths
    top, bottom = sqrt((rod + radius) ** 2 - offset**2), sqrt((rod - radius) ** 2 - offset**2)
    return 4 * rod * radius / (top + bottom)


def excess_angle_of(lengths: Lengths) -> float:
    """Angle ϑ by which the crank travels more than half a turn on the slow stroke, eq. (2.8). [rad]"""
    radius, rod, offset = lengths[0], lengths[1], abs(lengths[2])
    return asin(offset / (rod - radius)) - asin(offset / (rod + radius))


def pressure_angles_of(lengths: Lengths) -> tuple[float, float]:
    """Largest pressure angle on the slow and on the quick stroke, dead centres included. [rad]

    Parameters
    ----------
    lengths : Lengths
        With R + |e| ≤ L.

    Returns
    -------
    tuple of float
        asin max((R − |e|)/L, |e|/(L − R)) and asin((R + |e|)/L); docs/theory/synthesis, eq. (8.3).
    """
    radius, rod, offset = lengths[0], lengths[1], abs(lengths[2])
    slow = max((radius - offset) / rod, offset / (rod - radius) if offset else 0.0)
    return asin(slow), asin(min((radius + offset) / rod, 1.0))


def crank_radius_for(stroke: float, rod_length: float, offset: float) -> float:
    """Crank radius that makes a stroke with a rod and an offset, docs/theory/slider-crank, eq. (2.9). [m]"""
    return stroke / 2 * sqrt(1 - 4 * offset**2 / (4 * rod_length**2 - stroke**2)) if offset else stroke / 2


def least_rod(stroke: float, offset: float) -> float:
    """Rod with which the crank can just no longer turn, (|e| + √(e² + S²))/2. [m]"""
    return (abs(offset) + sqrt(offset**2 + stroke**2)) / 2


def shortest_rod(stroke: float, offset: float, limits: Limits) -> Lengths:
    """Shortest rod that keeps the limits with an offset that is given.

    Parameters
    ----------
    stroke, offset : float
        [m]
    limits : Limits

    Returns
    -------
    Lengths

    Notes
    -----
    Both pressure angles fall as the rod grows, so the shortest rod is one root; docs/theory/synthesis, eq. (8.4).
    """
    if offset == 0.0:
        radius = stroke / 2
        return Lengths(radius, radius / min(limits), 0.0)
    size = abs(offset)

    def excess(rod: float) -> float:
        radius = crank_radius_for(stroke, rod, size)
        slow = max((radius - size) / rod, size / (rod - radius))
        return max(slow - limits.slow, (radius + size) / rod - limits.quick)

    low, high = least_rod(stroke, size), stroke / 2 + (stroke / 2 + size) / min(limits)
    rod = _root(excess, low, high)
    return Lengths(crank_radius_for(stroke, rod, size), rod, offset)


def shortest_rod_and_offset(stroke: float, limits: Limits) -> Lengths:
    """Shortest rod of all, with the offset (positive) that allows it, in closed form.

    Parameters
    ----------
    stroke : float
        [m]
    limits : Limits
        Of which the slow stroke's must be the smaller.

    Returns
    -------
    Lengths

    Notes
    -----
    docs/theory/synthesis, eqs. (8.5) and (8.6).
    """
    slow, quick = limits
    if quick >= slow * (3 - slow) / (1 + slow):
        ratio, offset = 2 * slow / (1 + slow), slow * (1 - slow) / (1 + slow)
    else:
        ratio, offset = (quick + slow) / 2, (quick - slow) / 2
    rod = stroke / stroke_of(Lengths(ratio, 1.0, offset))
    return Lengths(ratio * rod, rod, offset * rod)


def best_offset(stroke: float, rod_length: float) -> Lengths:
    """Offset (positive) that makes the slow stroke's pressure angle least, for a rod that is given.

    Parameters
    ----------
    stroke, rod_length : float
        S < 2L [m]

    Returns
    -------
    Lengths

    Notes
    -----
    The middle of the stroke and its lower dead centre are then equally bad, e = R(L − R)/(2L − R);
    docs/theory/synthesis, eq. (8.7).
    """

    def with_radius(radius: float) -> Lengths:
        return Lengths(radius, rod_length, radius * (rod_length - radius) / (2 * rod_length - radius))

    return with_radius(_root(lambda radius: stroke_of(with_radius(radius)) - stroke, 0.0, stroke / 2))


def largest_offset(stroke: float, rod_length: float, quick: float) -> Lengths:
    """Offset (positive) at which the quick stroke's pressure angle is at its limit, for a rod that is given.

    Parameters
    ----------
    stroke, rod_length : float
        [m]
    quick : float
        Sine of the limit, at least S/2L.

    Returns
    -------
    Lengths
    """

    def excess(offset: float) -> float:
        return crank_radius_for(stroke, rod_length, offset) + offset - quick * rod_length

    offset = _root(excess, 0.0, rod_length - stroke**2 / (4 * rod_length))
    return Lengths(crank_radius_for(stroke, rod_length, offset), rod_length, offset)


def _root(curve: Callable[[float], float], low: float, high: float) -> float:
    """Root of a curve of one number, to rounding."""
    one = np.vectorize(curve, otypes=[float])
    return float(bracketed_roots(one, np.array([low]), np.array([high]))[0])
