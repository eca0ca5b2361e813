"""Four-bars that swing as wanted: the one-parameter family, its crank-rockers, the best of them.

docs/theory/synthesis.
"""

from math import cos, pi, sin, sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.mechanisms.crank_rocker import CrankRocker
from cranktrain.mechanisms.crank_rocker.facts import grashof_class
from cranktrain.motion import ONE, Array, single
from cranktrain.numerics import bracketed_roots

_SAMPLES = 400
_SWING_ROUNDING = 1e-9
"""By how much the swing, from differences of arc cosines, may miss the wanted one. [rad]"""


class FourBarRequirements(NamedTuple):
    """Swing and excess angle ϑ [rad], rocker length [m]."""

    swing: float
    excess: float
    rocker_length: float


class Judged(NamedTuple):
    """What an analysis finds of four-bars: class (of `CLASSES`), one branch through both dead positions, and angles.

    transmission_angle: the smallest of μ and π − μ over the turn [rad].
    """

    grashof_class: Array
    is_one_branch: NDArray[np.bool_]
    transmission_angle: Array


def excess_angle(time_ratio: float) -> float:
    """Angle ϑ by which the crank travels more than half a turn on the slow swing, k = (π + ϑ)/(π − ϑ). [rad]"""
    return pi * (time_ratio - 1) / (time_ratio + 1)


def time_ratio_of(excess: float) -> float:
    """Time ratio k = (π + ϑ)/(π − ϑ) of a drive whose slow stroke takes π + ϑ of the turn."""
    return (pi + excess) / (pi - excess)


def largest_time_ratio(swing: float, side: int) -> float:
    """Time ratio that crank-rockers of a swing [rad] come near but do not reach; docs/theory/synthesis, eq. (8.14)."""
    return (3 * pi - side * swing) / (pi + side * swing)


def four_bar(requirement: FourBarRequirements, parameter: Array, side: int) -> CrankRocker:
    """Four-bar whose dead positions are as wanted, one for each value of the free parameter.

    Parameters
    ----------
    requirement : FourBarRequirements
        With ϑ > 0.
    parameter : Array
        ξ; between ϑ/2 and π/2 the rod is longer than the crank. [rad]
    side : int
        −1: the shaft lies on the pivot's side of the chord between the rocker's dead positions; +1: on the far side.

    Returns
    -------
    CrankRocker, of the parameter's shape

    Notes
    -----
    docs/theory/synthesis, eqs. (8.9) and (8.10).
    """
    swing, excess, rocker = requirement
    half_chord = rocker * sin(swing / 2)
    radius = half_chord * np.cos(parameter) / cos(excess / 2)
    rod = half_chord * np.sin(parameter) / sin(excess / 2)
    aside = side * (rod - radius) * (rod + radius) * sin(excess) / (2 * half_chord)
    along = rod * radius / half_chord
    ground = np.hypot(along, aside + rocker * cos(swing / 2))
    return CrankRocker(radius, rod, rocker + 0.0 * radius, ground, ONE)


def parameter_range(requirement: FourBarRequirements, side: int) -> tuple[float, float]:
    """Range of ξ whose four-bars are crank-rockers of one branch; empty where it ends below its start. [rad]

    Parameters
    ----------
    requirement : FourBarRequirements
    side : int

    Returns
    -------
    tuple of float
        docs/theory/synthesis, eq. (8.13).
    """
    return requirement.excess / 2, pi / 2 - abs(requirement.swing / 2 + side * requirement.excess / 2)


def judged(requirement: FourBarRequirements, bars: CrankRocker) -> Judged:
    """Analyse four-bars: class, branch of the dead positions, transmission angle.

    Parameters
    ----------
    requirement : FourBarRequirements
    bars : CrankRocker, of any shape

    Returns
    -------
    Judged, of the same shape
        Transmission angle NaN where the crank does not turn.

    Notes
    -----
    On one branch the swing between the dead positions is the difference of the rocker's angles there, on two their
    sum: docs/theory/crank-rocker, eq. (3.6), answers which.
    """
    radius, rod, rocker, ground, _side = bars
    with np.errstate(invalid="ignore"):
        at_dead = [
            np.arccos((ground**2 + rocker**2 - reach**2) / (2 * ground * rocker))
            for reach in (rod + radius, rod - radius)
        ]
        cosines = [(rod**2 + rocker**2 - (ground + sign * radius) ** 2) / (2 * rod * rocker) for sign in (-1.0, 1.0)]
        transmission = np.arccos(np.maximum(cosines[0], -cosines[1]))
    return Judged(
        grashof_class=grashof_class(bars),
        is_one_branch=np.abs(np.abs(at_dead[0] - at_dead[1]) - requirement.swing) < _SWING_ROUNDING,
        transmission_angle=transmission,
    )


def best_parameter(requirement: FourBarRequirements, side: int) -> float:
    """Parameter ξ with the largest smallest transmission angle on a side; NaN where no crank-rocker is there. [rad]

    Parameters
    ----------
    requirement : FourBarRequirements
        With ϑ > 0.
    side : int

    Returns
    -------
    float
        To rounding: a root of the transmission angle's derivative, docs/theory/synthesis, eq. (8.12).
    """
    start, end = parameter_range(requirement, side)
    if not start < end:
        return float("nan")
    samples = np.linspace(start, end, _SAMPLES + 1)
    inside = samples[1:-1]
    best = 1 + int(np.argmax(judged(requirement, four_bar(requirement, inside, side)).transmission_angle))
    return float(
        bracketed_roots(
            lambda xi: _slope(requirement, xi, side), samples[best - 1 : best], samples[best + 1 : best + 2]
        )[0]
    )


def _slope(requirement: FourBarRequirements, parameter: Array, side: int) -> Array:
    """Derivative by ξ of the cosine of the extreme transmission angle that decides on this side."""
    swing, excess, rocker = requirement
    radius, rod, _rocker, ground, _side = four_bar(requirement, parameter, side)
    half_chord = rocker * sin(swing / 2)
    radius_first = -half_chord * np.sin(parameter) / cos(excess / 2)
    rod_first = half_chord * np.cos(parameter) / sin(excess / 2)
    lean = side * rocker * cos(swing / 2) * sin(excess) / half_chord
    ground_first = ((1 + lean) * rod * rod_first + (1 - lean) * radius * radius_first) / ground
    reach, reach_first = ground + side * radius, ground_first + side * radius_first
    cosine = (rod**2 + rocker**2 - reach**2) / (2 * rod * rocker)
    return (rod * rod_first - reach * reach_first) / (rod * rocker) - cosine * rod_first / rod


def with_equal_swings(requirement: FourBarRequirements, rod: float) -> CrankRocker:
    """Four-bar of time ratio 1 with a given rod, docs/theory/synthesis, eq. (8.15)."""
    rocker = requirement.rocker_length
    radius = rocker * sin(requirement.swing / 2)
    ground = sqrt(rod**2 + (rocker * cos(requirement.swing / 2)) ** 2)
    return CrankRocker(single(radius), single(rod), single(rocker), single(ground), ONE)


def rod_with_equal_swings(requirement: FourBarRequirements, transmission_angle: float) -> float:
    """Rod with which a four-bar of time ratio 1 has just that smallest transmission angle, eq. (8.16)."""
    half = requirement.swing / 2
    ratio = cos(transmission_angle) / sin(half)
    return requirement.rocker_length * cos(half) / sqrt((ratio - 1) * (ratio + 1))
