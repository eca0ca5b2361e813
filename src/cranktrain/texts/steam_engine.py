"""Piston of a steam engine by [steam-engine]: the exact root, the formulas (333)–(337), and Brix's construction.

Kinematic coefficients: velocity is `first` times ω, acceleration (at constant ω) `second` times ω².
Equations, errors and ranges: docs/theory/textbook-forms.
"""

import numpy as np

from cranktrain.motion import Array, Coefficient


def infinite_rod(angle: Array, crank_radius: Array) -> Coefficient:
    """Piston on an infinitely long rod, eq. (334): the crank pin projected onto the line of stroke.

    Parameters
    ----------
    angle : Array
        Crank angle φ from the head-side dead centre. [rad]
    crank_radius : Array, broadcastable with angle
        R [m]

    Returns
    -------
    Coefficient, of the broadcast shape
        Displacement from the head-side dead centre toward the shaft. [m, m/rad, m/rad²]

    Notes
    -----
    S = R(1 − cos φ), written R·2 sin²(φ/2), which keeps its digits near the dead centre.
    """
    return Coefficient(
        2 * crank_radius * np.sin(angle / 2) ** 2,
        crank_radius * np.sin(angle),
        crank_radius * np.cos(angle),
    )


def exact_root(angle: Array, crank_radius: Array, ratio: Array) -> Coefficient:
    """Piston as the source has it by fig. 146, before it takes the root to first order: exact for a central mechanism.

    Parameters
    ----------
    angle : Array
        Crank angle φ from the head-side dead centre. [rad]
    crank_radius : Array, broadcastable with angle
        R [m]
    ratio : Array, broadcastable with angle
        λ = R/L, less than 1. [1]

    Returns
    -------
    Coefficient, of the broadcast shape
        Displacement from the head-side dead centre toward the shaft. [m, m/rad, m/rad²]

    Notes
    -----
    S = R(1 − cos φ) + L(1 − √(1 − λ² sin² φ)) = A_M D + DC. The second part is written Rλ sin² φ/(1 + √), which keeps
    its digits however long the rod is. docs/theory/textbook-forms, eq. (6.1).

    Examples
    --------
    >>> round(float(exact_root(np.pi / 2, 0.1, 0.25).value), 6)
    0.112702
    """
    sine, cosine = np.sin(angle), np.cos(angle)
    root = np.sqrt((1 - ratio * sine) * (1 + ratio * sine))
    harmonic = infinite_rod(angle, crank_radius)
    return Coefficient(
        harmonic.value + crank_radius * ratio * sine**2 / (1 + root),
        harmonic.first + crank_radius * ratio * sine * cosine / root,
        harmonic.second + crank_radius * ratio * (np.cos(2 * angle) + ratio**2 * sine**4) / root**3,
    )


def two_harmonics(angle: Array, crank_radius: Array, ratio: Array) -> Coefficient:
    """Piston by the two-harmonic formulas (333), (336), (337), counted from the head-side dead centre.

    Parameters
    ----------
    angle : Array
        Crank angle φ from the head-side dead centre. [rad]
    crank_radius : Array, broadcastable with angle
        R [m]
    ratio : Array, broadcastable with angle
        λ = R/L, crank radius to rod length. [1]

    Returns
    -------
    Coefficient, of the broadcast shape
        Displacement from the head-side dead centre toward the shaft. [m, m/rad, m/rad²]

    Notes
    -----
    S = R(1 − cos φ + (λ/2) sin² φ), c/ω = R(sin φ + (λ/2) sin 2φ), j/ω² = R(cos φ + λ cos 2φ).

    Examples
    --------
    >>> motion = two_harmonics(np.pi / 2, 0.1, 0.25)
    >>> [round(float(number), 6) for number in motion]
    [0.1125, 0.1, -0.025]
    """
    harmonic = infinite_rod(angle, crank_radius)
    return Coefficient(
        harmonic.value + crank_radius * ratio / 2 * np.sin(angle) ** 2,
        harmonic.first + crank_radius * ratio / 2 * np.sin(2 * angle),
        harmonic.second + crank_radius * ratio * np.cos(2 * angle),
    )


def two_harmonics_from_crank_side(angle: Array, crank_radius: Array, ratio: Array) -> Coefficient:
    """Piston by (333), (336), (337) with the minus sign, counted from the crank-side dead centre.

    Parameters
    ----------
    angle : Array
        Crank angle φ from the crank-side dead centre. [rad]
    crank_radius : Array, broadcastable with angle
        R [m]
    ratio : Array, broadcastable with angle
        λ = R/L, crank radius to rod length. [1]

    Returns
    -------
    Coefficient, of the broadcast shape
        Displacement from the crank-side dead centre away from the shaft. [m, m/rad, m/rad²]
    """
    return two_harmonics(angle, crank_radius, -ratio)


def largest_difference(crank_radius: Array, ratio: Array) -> Array:
    """Largest difference Z = λR/2 = R²/(2L) of (333) and (334), eq. (335): at φ = 90° and 270°.

    Parameters
    ----------
    crank_radius : Array
        R [m]
    ratio : Array, broadcastable with crank_radius
        λ = R/L [1]

    Returns
    -------
    Array, of the broadcast shape
        Z [m]; also the distance of Brix's pole from the shaft centre.
    """
    return ratio * crank_radius / 2


def exact_largest_difference(crank_radius: Array, ratio: Array) -> Array:
    """Largest difference of the exact displacement and (334), L − √(L² − R²), at φ = 90° and 270°; parameters as above.

    Examples
    --------
    >>> round(float(exact_largest_difference(0.3, 0.25)), 6), round(float(largest_difference(0.3, 0.25)), 6)
    (0.038105, 0.0375)
    """
    return crank_radius * ratio / (1 + np.sqrt((1 - ratio) * (1 + ratio)))


def brix(angle: Array, crank_radius: Array, ratio: Array) -> Coefficient:
    """Piston by Brix's construction, from the crank angle to the displacement.

    A ray at φ from the pole P, which lies Z from the shaft centre O away from the cylinder, meets the crank circle;
    that point, projected onto the line of stroke, is the piston.

    Parameters
    ----------
    angle : Array
        Crank angle φ from the head-side dead centre. [rad]
    crank_radius : Array, broadcastable with angle
        R [m]
    ratio : Array, broadcastable with angle
        λ = R/L [1]; the construction needs λ < 2, a pole within the crank circle.

    Returns
    -------
    Coefficient, of the broadcast shape
        Displacement from the head-side dead centre toward the shaft. [m, m/rad, m/rad²]
        The derivatives are those of the construction; the source takes velocities from (336).

    Notes
    -----
    φ_O = φ + asin((λ/2) sin φ), S = R(1 − cos φ_O).  [brix-1893], fig. 147 of [steam-engine].
    """
    sine = ratio / 2 * np.sin(angle)
    cosine = np.sqrt((1 - sine) * (1 + sine))
    excess_first = ratio / 2 * np.cos(angle) / cosine
    excess_second = (excess_first**2 - 1) * sine / cosine
    about_centre = infinite_rod(angle + np.arcsin(sine), crank_radius)
    centre_first = 1 + excess_first
    return Coefficient(
        about_centre.value,
        about_centre.first * centre_first,
        about_centre.second * centre_first**2 + about_centre.first * excess_second,
    )
