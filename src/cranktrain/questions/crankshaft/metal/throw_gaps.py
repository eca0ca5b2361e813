"""What lies between neighbouring throws, and the textbooks' rules for how much of a plain shaft twists as far."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array

_OF_RADIUS = 0.2
"""Ker Wilson's part of both diameters by which a web is shorter than the crank radius."""


class Gaps(NamedTuple):
    """From the middle of a throw's pin to that of the next: half a pin, a web, a journal, a web, half a pin.

    Attributes
    ----------
    journal : Array, shape (design, gap, 2)
        Diameter and bore. [m]
    journal_length : Array, shape (design, gap)
        Between the faces of the webs. [m]
    pin : Array, shape (design, gap, 2, 2)
        Diameter and bore of the pins on both sides. [m]
    pin_length, radius, web_width, web_thickness : Array, shape (design, gap, 2)
        Of both sides; of a pin its whole length, between the faces of its webs. [m]
    """

    journal: Array
    journal_length: Array
    pin: Array
    pin_length: Array
    radius: Array
    web_width: Array
    web_thickness: Array


class ThrowSizes(NamedTuple):
    """Sizes of a shaft of throws.

    Attributes
    ----------
    planes : Array, shape (design, throw, 2)
        z of the middles of both webs. [m]
    radius : Array, shape (design, throw)
        [m]
    journal : Array, shape (design, throw + 1, 2)
        Diameter and bore; NaN of one that there is not. [m]
    pin : Array, shape (design, throw, 2)
        Diameter and bore. [m]
    pin_length : Array, shape (design, throw)
        [m]
    web_width, web_thickness : Array, shape (design, throw, 2)
        Of its first and its last web. [m]
    """

    planes: Array
    radius: Array
    journal: Array
    pin: Array
    pin_length: Array
    web_width: Array
    web_thickness: Array


def gaps_of(sizes: ThrowSizes) -> Gaps:
    """What lies between the throws of a shaft."""
    faces = sizes.planes + np.array([-0.5, 0.5]) * sizes.web_thickness
    return Gaps(
        journal=sizes.journal[:, 1:-1],
        journal_length=faces[:, 1:, 0] - faces[:, :-1, 1],
        pin=_both_sides(sizes.pin),
        pin_length=_both_sides(sizes.pin_length),
        radius=_both_sides(sizes.radius),
        web_width=np.stack([sizes.web_width[:, :-1, 1], sizes.web_width[:, 1:, 0]], axis=2),
        web_thickness=np.stack([sizes.web_thickness[:, :-1, 1], sizes.web_thickness[:, 1:, 0]], axis=2),
    )


def _both_sides(values: Array) -> Array:
    """Values of the throws before and behind every gap."""
    return np.stack([values[:, :-1], values[:, 1:]], axis=2)


def carter(gaps: Gaps) -> Array:
    """A plain shaft that twists as far, by Carter: its length over its diameter's fourth power. [1/m³]

    Parameters
    ----------
    gaps : Gaps

    Returns
    -------
    Array, shape (design, gap)

    Notes
    -----
    (l_j + 0.8 h)/D_j⁴ + 0.75 l_p/D_p⁴ + 1.5 r/(h b³) for like throws, [carter-1928].
    docs/theory/torsion, eq. (23.18).

    Examples
    --------
    >>> like = like_throws(0.039, (0.05, 0.028), (0.048, 0.028), (0.076, 0.018))
    >>> (np.pi / 32 * 79.230769e9 / carter(like)).round(-3)
    array([[429000.]])
    """
    journal = gaps.journal_length + 0.4 * np.sum(gaps.web_thickness, axis=-1)
    pins = 0.375 * gaps.pin_length / _fourth(gaps.pin)
    webs = 0.75 * gaps.radius / _cubed(gaps)
    return journal / _fourth(gaps.journal) + np.sum(pins + webs, axis=-1)


def ker_wilson(gaps: Gaps) -> Array:
    """The same by Ker Wilson.

    Notes
    -----
    (l_j + 0.4 D_j)/D_j⁴ + (l_p + 0.4 D_p)/D_p⁴ + (r − 0.2 (D_j + D_p))/(h b³) for like throws, [ker-wilson].
    docs/theory/torsion, eq. (23.19).

    Examples
    --------
    >>> like = like_throws(0.039, (0.05, 0.028), (0.048, 0.028), (0.076, 0.018))
    >>> (np.pi / 32 * 79.230769e9 / ker_wilson(like)).round(-3)
    array([[409000.]])
    """
    journal = gaps.journal_length + 0.4 * gaps.journal[..., 0]
    pins = (0.5 * gaps.pin_length + 0.2 * gaps.pin[..., 0]) / _fourth(gaps.pin)
    webs = 0.5 * ker_wilson_web(gaps) / _cubed(gaps)
    return journal / _fourth(gaps.journal) + np.sum(pins + webs, axis=-1)


def ker_wilson_web(gaps: Gaps) -> Array:
    """What Ker Wilson leaves of the crank radius, shape (design, gap, 2): of sense where more than 0. [m]"""
    return gaps.radius - _OF_RADIUS * (gaps.journal[..., np.newaxis, 0] + gaps.pin[..., 0])


def zimanenko(gaps: Gaps) -> Array:
    """The same by Zimanenko.

    Notes
    -----
    (l_j + 0.6 h D_j/l_j)/D_j⁴ + (0.8 l_p + 0.2 b D_j/r)/D_p⁴ + r √(r/D_p)/(h b³) for like throws, [zimanenko].
    docs/theory/torsion, eq. (23.20).

    Examples
    --------
    >>> like = like_throws(0.039, (0.05, 0.028), (0.048, 0.028), (0.076, 0.018))
    >>> (np.pi / 32 * 79.230769e9 / zimanenko(like)).round(-3)
    array([[391000.]])
    """
    diameter = gaps.journal[..., 0]
    journal = gaps.journal_length + 0.3 * np.sum(gaps.web_thickness, axis=-1) * diameter / gaps.journal_length
    beside = 0.1 * gaps.web_width * diameter[..., np.newaxis] / gaps.radius
    pins = (0.4 * gaps.pin_length + beside) / _fourth(gaps.pin)
    webs = 0.5 * gaps.radius * np.sqrt(gaps.radius / gaps.pin[..., 0]) / _cubed(gaps)
    return journal / _fourth(gaps.journal) + np.sum(pins + webs, axis=-1)


def like_throws(
    radius: float, journal: tuple[float, float], pin: tuple[float, float], web: tuple[float, float]
) -> Gaps:
    """The gap between two like throws without bores. [m]

    Of journal and pin the diameter and the length, of a web the width and the thickness.
    """
    one, both = (1, 1), (1, 1, 2)

    def solid(diameter: float, shape: tuple[int, ...]) -> Array:
        return np.stack([np.full(shape, diameter), np.zeros(shape)], axis=-1)

    return Gaps(
        solid(journal[0], one),
        np.full(one, journal[1]),
        solid(pin[0], both),
        *(np.full(both, value) for value in (pin[1], radius, *web)),
    )


def _fourth(section: Array) -> Array:
    """D⁴ − δ⁴ of diameter and bore."""
    return section[..., 0] ** 4 - section[..., 1] ** 4


def _cubed(gaps: Gaps) -> Array:
    """Of webs h b³, h along the shaft."""
    return gaps.web_thickness * gaps.web_width**3
