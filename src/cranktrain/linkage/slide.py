"""RRP group: a rod and a slider on a fixed guide along x."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array, Coefficient, Link, Point, single

AHEAD = single(1.0)
"""Side of a slider that lies ahead (at larger x) of the rod's first pin; −1 where it lies behind."""


class Slide(NamedTuple):
    """Rod and guide: rod length [m], offset of the guide from the axis x [m], side (`AHEAD` or −1, behind)."""

    rod_length: Array
    offset: Array
    side: Array


class SlideMotion(NamedTuple):
    """Slider: position along x [m]; rod: the link from the driving pin to the slider's."""

    slider: Coefficient
    rod: Link


def slide(pin: Point, geometry: Slide) -> SlideMotion:
    """Slider on a guide along x, driven by a rod from `pin`, and its derivatives by the crank angle.

    Parameters
    ----------
    pin : Point, coefficients of shape (..., n)
        Driving pin. [m, m/rad, m/rad²]
    geometry : Slide, fields broadcastable to (..., 1)

    Returns
    -------
    SlideMotion, shape (..., n)
        NaN where the rod cannot reach the guide.

    Notes
    -----
    With u = y − e: W = σ √((l − u)(l + u)), s = x + W; the rod's angle has θ′ = −y′/W, θ″ = −(y″ + uθ′²)/W, and
    W′ = uθ′, W″ = y′θ′ + uθ″. Exact; docs/theory/groups. The root is taken of a product, because l² − u² would lose
    the digits of l − u where the rod hardly reaches. `rise` is −u, the rod's component along y.

    Examples
    --------
    >>> from cranktrain.linkage.crank import Crank, crank
    >>> round(float(slide(crank(0.0, Crank(0.04)), Slide(0.14, 0.0, AHEAD)).slider.value), 6)
    0.18
    """
    rise = geometry.offset - pin.y.value
    reach = geometry.side * np.sqrt((geometry.rod_length - rise) * (geometry.rod_length + rise))
    turn = -pin.y.first / reach
    turn_rate = (rise * turn * turn - pin.y.second) / reach
    slider = Coefficient(
        pin.x.value + reach,
        pin.x.first - rise * turn,
        pin.x.second + (pin.y.first * turn - rise * turn_rate),
    )
    rod = Link(
        pin,
        Coefficient(np.arctan2(rise, reach), turn, turn_rate),
        reach / geometry.rod_length,
        rise / geometry.rod_length,
    )
    return SlideMotion(slider, rod)


def slide_gap(pin: Point, geometry: Slide) -> Array:
    """By how much the rod is long enough to reach the guide; negative where it cannot. [m]"""
    return geometry.rod_length - np.abs(pin.y.value - geometry.offset)
