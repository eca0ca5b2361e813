"""Kinematics of the slider-crank: crank and RRP group."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage import AHEAD, Crank, Slide, crank, slide, slide_gap
from cranktrain.motion import Array, Coefficient, Handed, Link, Point
from cranktrain.numerics import Extreme


class SliderCrank(NamedTuple):
    """Crank radius, rod length, offset of the line of stroke toward +y. [m]"""

    crank_radius: Array
    rod_length: Array
    offset: Handed


class SliderCrankMotion(NamedTuple):
    """Crank pin, slider along x from the shaft centre [m], and the rod from crank pin to slider."""

    pin: Point
    slider: Coefficient
    rod: Link


def slider_crank(angle: Array, geometry: SliderCrank) -> SliderCrankMotion:
    """Slider-crank, central or offset, and its derivatives by the crank angle.

    Parameters
    ----------
    angle : Array, shape (..., n)
        Crank angle from x, the line of stroke's direction away from the shaft. [rad]
    geometry : SliderCrank, fields broadcastable to (..., 1)

    Returns
    -------
    SliderCrankMotion, shape (..., n)
        NaN where the rod cannot reach.

    Notes
    -----
    s = R cos φ + √(l² − (R sin φ − e)²). Exact; docs/theory/slider-crank.
    """
    pin = crank(angle, Crank(geometry.crank_radius))
    motion = slide(pin, Slide(geometry.rod_length, geometry.offset, AHEAD))
    return SliderCrankMotion(pin, motion.slider, motion.rod)


def slider_crank_gap(angle: Array, geometry: SliderCrank) -> Array:
    """By how much the rod is long enough at each angle; negative where the links cannot close. [m]"""
    pin = crank(angle, Crank(geometry.crank_radius))
    return slide_gap(pin, Slide(geometry.rod_length, geometry.offset, AHEAD))


def slider_crank_least_gap(geometry: SliderCrank) -> Extreme:
    """Least gap over a turn: where the crank pin is farthest from the line of stroke. docs/theory/closing-margin."""
    R, l, e = geometry  # noqa: N806 - the letters of the equation
    # 270° for e > 0; without an offset 90° and 270° are alike.
    return Extreme(np.pi - np.copysign(np.pi / 2, 0.0 - e), l - R - np.abs(e))
