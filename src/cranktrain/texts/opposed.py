"""Opposed pistons by the two-harmonic formulas (I.11) and (I.12) of [bolotin], and their volumetric dead centres.

Kinematic coefficients: velocity is `first` times ω, acceleration (at constant ω) `second` times ω². The exhaust crank
leads the scavenge crank by the lead Δ; all angles are the exhaust crank's, from its own inner dead centre. Equations
and errors: docs/theory/textbook-forms.
"""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array, Coefficient
from cranktrain.texts.steam_engine import two_harmonics


class OpposedMotion(NamedTuple):
    """Pistons' displacements from their own inner dead centres, outward, and both together. [m, m/rad, m/rad²]"""

    exhaust: Coefficient
    scavenge: Coefficient
    combined: Coefficient


class OpposedSize(NamedTuple):
    """Crank radius R [m] and ratio λ = R/L to the rod [1] of each piston; lead Δ of the exhaust crank [rad].

    λ is negative of a far piston, which side rods drive: at its inner dead centre its crank points away from the
    cylinder, and the formulas have the minus sign that (333), (336), (337) have from the crank-side dead centre.
    """

    exhaust_radius: Array
    exhaust_ratio: Array
    scavenge_radius: Array
    scavenge_ratio: Array
    lead: Array


class FirstOrderDeadCentres(NamedTuple):
    """Where the volume between two pistons is least (inner) and greatest (outer), as exhaust crank angles. [rad]"""

    inner: Array
    outer: Array


def opposed_pistons(angle: Array, size: OpposedSize) -> OpposedMotion:
    """Opposed pistons by (I.11), exhaust, and (I.12), scavenge.

    Parameters
    ----------
    angle : Array
        Angle α of the exhaust crank from its inner dead centre. [rad]
    size : OpposedSize, fields broadcastable with angle

    Returns
    -------
    OpposedMotion, of the broadcast shape
        The combined displacement is the volume, less its clearance, by the area of the bore.

    Notes
    -----
    S = R(1 + λ/4 − cos θ − (λ/4) cos 2θ), v/ω = R(sin θ + (λ/2) sin 2θ), j/ω² = R(cos θ + λ cos 2θ) with θ = α for
    the exhaust piston and θ = α − Δ for the scavenge piston. They are (333), (336), (337) of each.

    Examples
    --------
    Half the lead after the exhaust crank's inner dead centre both pistons are equally far out.

    >>> motion = opposed_pistons(0.1, OpposedSize(0.127, 0.25, 0.127, 0.25, 0.2))
    >>> bool(motion.exhaust.value == motion.scavenge.value), round(float(motion.combined.first), 12)
    (True, 0.0)
    """
    exhaust = two_harmonics(angle, size.exhaust_radius, size.exhaust_ratio)
    scavenge = two_harmonics(angle - size.lead, size.scavenge_radius, size.scavenge_ratio)
    combined = Coefficient(*(one + other for one, other in zip(exhaust, scavenge, strict=True)))
    return OpposedMotion(exhaust, scavenge, combined)


def volumetric_dead_centres(lead: Array) -> FirstOrderDeadCentres:
    """Volumetric dead centres as the source has them: half the lead after the exhaust crank's own.

    Parameters
    ----------
    lead : Array
        Δ [rad]

    Returns
    -------
    FirstOrderDeadCentres
        Δ/2 and π + Δ/2; exact only where both cranks and both rods are equal.
    """
    return FirstOrderDeadCentres(lead / 2, np.pi + lead / 2)


def volumetric_dead_centres_to_first_order(size: OpposedSize) -> FirstOrderDeadCentres:
    """Volumetric dead centres of unequal cranks or rods, to first order in the lead.

    Parameters
    ----------
    size : OpposedSize

    Returns
    -------
    FirstOrderDeadCentres, of the broadcast shape

    Notes
    -----
    (Δ/2)(1 + (w_s − w_e)/(w_s + w_e)), w = R(1 + λ) inside and R(1 − λ) outside, where π is added: each piston leaves
    its dead centre as wθ²/2. Derived here; the source has Δ/2 for all. Of a far piston λ is negative.

    Examples
    --------
    >>> found = volumetric_dead_centres_to_first_order(OpposedSize(0.127, 0.22, 0.127, 0.26, np.radians(12.0)))
    >>> [round(float(np.degrees(angle)), 4) for angle in found]
    [6.0968, 185.8421]
    """
    inner, outer = (
        (size.exhaust_radius * (1 + sign * size.exhaust_ratio), size.scavenge_radius * (1 + sign * size.scavenge_ratio))
        for sign in (1, -1)
    )
    return FirstOrderDeadCentres(
        size.lead * inner[1] / (inner[0] + inner[1]), np.pi + size.lead * outer[1] / (outer[0] + outer[1])
    )


def combined_stroke(crank_radius: Array, lead: Array) -> Array:
    """Combined stroke 4R cos(Δ/2) of opposed pistons with equal cranks and rods, exact and by (I.11), (I.12) alike.

    Parameters
    ----------
    crank_radius : Array
        R of both. [m]
    lead : Array, broadcastable with crank_radius
        Δ [rad]

    Returns
    -------
    Array, of the broadcast shape. [m]
        Published displacements are mostly nominal, of 4R.
    """
    return 4 * crank_radius * np.cos(lead / 2)
