"""Kinematics of the eccentric: a slider-crank of small crank, set ahead of the main crank."""

from typing import NamedTuple

from cranktrain.mechanisms.slider_crank.kinematics import (
    SliderCrank,
    SliderCrankMotion,
    slider_crank,
    slider_crank_gap,
    slider_crank_least_gap,
)
from cranktrain.motion import Array, Handed
from cranktrain.numerics import Extreme


class Eccentric(NamedTuple):
    """As `SliderCrank`, its crank the eccentricity [m]; and how far ahead of the machine's crank that stands [rad]."""

    crank_radius: Array
    rod_length: Array
    offset: Handed
    ahead: Handed


def eccentric(angle: Array, geometry: Eccentric) -> SliderCrankMotion:
    """Valve driven by one eccentric, and its derivatives by the crank angle.

    Parameters
    ----------
    angle : Array, shape (..., n)
        Angle of the main crank from x, the valve's line away from the shaft. [rad]
    geometry : Eccentric, fields broadcastable to (..., 1)

    Returns
    -------
    SliderCrankMotion, shape (..., n)
        Of the eccentric's centre, the valve and the eccentric rod. NaN where the rod cannot reach.

    Notes
    -----
    The slider-crank at φ + ζ. Exact; docs/theory/eccentric, eq. (20.1).
    """
    return slider_crank(angle + geometry.ahead, SliderCrank(*geometry[:3]))


def eccentric_gap(angle: Array, geometry: Eccentric) -> Array:
    """By how much the rod is long enough at each angle; negative where the links cannot close. [m]"""
    return slider_crank_gap(angle + geometry.ahead, SliderCrank(*geometry[:3]))


def eccentric_least_gap(geometry: Eccentric) -> Extreme:
    """Least gap over a turn, as of the slider-crank."""
    angle, gap = slider_crank_least_gap(SliderCrank(*geometry[:3]))
    return Extreme(angle - geometry.ahead, gap)
