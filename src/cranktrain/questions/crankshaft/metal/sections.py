"""Stiffness of cross-sections: round ones with a bore, and rectangular webs."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array

RECTANGLE_IN_SHEAR = 5 / 6
"""Part of a rectangle's area that counts in shear, by the energy of a parabola."""

_ODD = np.arange(1, 16, 2)
"""Terms beyond are below the last digit: they fall as e^(−πk)."""


class Material(NamedTuple):
    """Young's modulus E and shear modulus G. [Pa]"""

    young: Array
    shear: Array


class Section(NamedTuple):
    """EI, GJ [N·m²]; κGA, EA [N]."""

    bending: Array
    torsion: Array
    shear: Array
    axial: Array


def round_section(diameter: Array, bore: Array, material: Material) -> Section:
    """A round section with a bore in its middle; the bore is 0 where there is none.

    Parameters
    ----------
    diameter, bore : Array
        [m]
    material : Material

    Returns
    -------
    Section

    Notes
    -----
    κ by [cowper-1966]. docs/theory/crankshaft, eqs. (24.21) and (24.22).

    Examples
    --------
    >>> section = round_section(np.array([0.05]), np.array([0.0]), Material(np.array([206e9]), np.array([79.23e9])))
    >>> round(float(section.bending[0]))
    63200
    """
    second_moment = np.pi / 64 * (diameter**4 - bore**4)
    area = np.pi / 4 * (diameter**2 - bore**2)
    return Section(
        material.young * second_moment,
        2 * material.shear * second_moment,
        round_in_shear(bore / diameter, material) * material.shear * area,
        material.young * area,
    )


def round_in_shear(bore: Array, material: Material) -> Array:
    """Cowper's κ of a round section whose bore is a part of its diameter; docs/theory/crankshaft, eq. (24.22)."""
    poisson = material.young / (2 * material.shear) - 1
    square = (1 + bore**2) ** 2
    return 6 * (1 + poisson) * square / ((7 + 6 * poisson) * square + (20 + 12 * poisson) * bore**2)


def rectangle_in_torsion(one: Array, other: Array) -> Array:
    """Saint-Venant's torsion constant of a rectangle of two sides. [m⁴]

    Notes
    -----
    docs/theory/crankshaft, eq. (24.23): the part of the series that does not fall exponentially is summed as ζ(5).

    Examples
    --------
    >>> round(float(rectangle_in_torsion(np.array(1.0), np.array(1.0))), 12)
    0.140577014955
    """
    long, short = np.maximum(one, other), np.minimum(one, other)
    ratio = short / long
    rest = 0.0
    for k in _ODD.tolist():
        fallen = np.exp(-np.pi * k / ratio)
        rest = rest + 2 * fallen / (1 + fallen) / k**5
    return long * short**3 * (1 / 3 - 64 / np.pi**5 * ratio * (_SUM_OF_FIFTHS - rest))


_SUM_OF_FIFTHS = 31 / 32 * 1.0369277551433699263
"""Σ 1/k⁵ over odd k: 31/32 ζ(5)."""


class WebSection(NamedTuple):
    """A web: EI in the plane of its line and the shaft's axis, and across it; GJ [N·m²]; κGA, EA [N]."""

    bending: Array
    bending_across: Array
    torsion: Array
    shear: Array
    axial: Array


def web_section(
    width: Array, thickness: Array, material: Material, *, in_shear: float = RECTANGLE_IN_SHEAR
) -> WebSection:
    """A rectangular web.

    Parameters
    ----------
    width, thickness : Array
        Across the web, and along the shaft. [m]
    material : Material
    in_shear : float
        Part of its area that counts in shear.

    Returns
    -------
    WebSection

    Notes
    -----
    docs/theory/crankshaft, eq. (24.24).
    """
    area = width * thickness
    return WebSection(
        material.young * width * thickness**3 / 12,
        material.young * thickness * width**3 / 12,
        material.shear * rectangle_in_torsion(width, thickness),
        in_shear * material.shear * area,
        material.young * area,
    )
