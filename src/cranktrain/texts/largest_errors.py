"""Largest errors of one form of a motion over a turn, and those of the steam engine's forms by λ alone."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from cranktrain.mechanisms.slider_crank import SliderCrank, slider_crank
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import Extreme, extremes, largest
from cranktrain.texts.steam_engine import brix, infinite_rod, two_harmonics

Motion = Callable[[Array], Coefficient]
"""Displacement with its derivatives by the crank angle, from angles of shape (..., n)."""


class LargestErrors(NamedTuple):
    """Displacement's in parts of the stroke, velocity's and acceleration's of the exact peaks; numbers. [1, rad]"""

    displacement: Extreme
    velocity: Extreme
    acceleration: Extreme


def largest_errors(form: Motion, exact: Motion) -> LargestErrors:
    """Largest errors of a form.

    Parameters
    ----------
    form, exact : callable
        Both counted from the same place; of one mechanism.

    Returns
    -------
    LargestErrors

    Examples
    --------
    (333) at λ = 0.25 is off by 0.1 % of the stroke.

    >>> found = errors_by_ratio("two_harmonics", 0.25)
    >>> round(float(found.displacement.value), 5)
    0.00101
    """
    found: list[Extreme] = []
    for order in range(3):
        low, high = extremes(lambda angle, order=order: exact(angle)[order])
        size = high.value - low.value if order == 0 else np.maximum(high.value, -low.value)
        worst = largest(lambda angle, order=order: np.abs(form(angle)[order] - exact(angle)[order]))
        found.append(Extreme(worst.angle[..., 0], (worst.value / size)[..., 0]))
    return LargestErrors(*found)


def errors_by_ratio(method: str, ratio: float) -> LargestErrors:
    """Largest errors of a steam engine's form for a central mechanism, with λ = R/L.

    Parameters
    ----------
    method : str
        `infinite_rod`, `two_harmonics` or `brix`.
    ratio : float
        λ, less than 1.

    Returns
    -------
    LargestErrors
    """
    one = np.array(1.0)
    forms: dict[str, Motion] = {
        "infinite_rod": lambda angle: infinite_rod(angle, one),
        "two_harmonics": lambda angle: two_harmonics(angle, one, np.array(ratio)),
        "brix": lambda angle: brix(angle, one, np.array(ratio)),
    }
    return largest_errors(forms[method], from_top(SliderCrank(one, one / ratio, np.array(0.0))))


def from_top(geometry: SliderCrank) -> Motion:
    """Exact motion of a piston from its top toward the shaft, by the angle from where its crank points along x.

    The displacement keeps its digits however long the rod is: (6.1) of docs/theory/textbook-forms, with an offset e.
    """
    radius, rod, offset = geometry
    top = np.sqrt((rod + radius) ** 2 - offset**2)

    def motion(angle: Array) -> Coefficient:
        slider = slider_crank(angle, geometry).slider
        behind = _reach(angle, geometry)
        height = radius * np.sin(angle)
        lost = 2 * radius * offset**2 / (rod + radius + top) + height * (height - 2 * offset)
        value = 2 * radius * np.sin(angle / 2) ** 2 + lost / (top - radius + behind)
        return Coefficient(value, -slider.first, -slider.second)

    return motion


def from_bottom(geometry: SliderCrank) -> Motion:
    """Exact motion of a piston from its bottom away from the shaft, by the angle from half a turn after that."""
    radius, rod, offset = geometry
    bottom = np.sqrt((rod - radius) ** 2 - offset**2)

    def motion(angle: Array) -> Coefficient:
        turned = angle + np.pi
        slider = slider_crank(turned, geometry).slider
        height = radius * np.sin(angle)
        gained = 2 * radius * offset**2 / (rod - radius + bottom) - height * (height + 2 * offset)
        value = 2 * radius * np.sin(angle / 2) ** 2 + gained / (bottom + radius + _reach(turned, geometry))
        return Coefficient(value, slider.first, slider.second)

    return motion


def _reach(angle: Array, geometry: SliderCrank) -> Array:
    """How far along x the piston's pin is from the crank pin. [m]"""
    height = geometry.crank_radius * np.sin(angle) - geometry.offset
    return np.sqrt((geometry.rod_length - height) * (geometry.rod_length + height))
