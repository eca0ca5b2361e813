"""Forces of a piston as engine dynamics takes them apart: the textbook's P, N, S, K (Z) and T, and S by reactions."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.forces import Drive, Gravity, Wrench
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, SliderCrankMotion
from cranktrain.motion import Array, Coefficient, Link
from cranktrain.questions.forces.rod_masses import TwoMasses


class PistonForces(NamedTuple):
    """Forces of a piston. [N]

    piston: P, along the cylinder toward the shaft; side: N, of the wall on the piston toward +y; rod: S, + in
    compression; radial: K or Z, at the crank pin toward the shaft; tangential: T, there, in the sense of rotation.
    """

    piston: Array
    side: Array
    rod: Array
    radial: Array
    tangential: Array


def inertia_force(slider: Coefficient, mass: Array, drive: Drive) -> Array:
    """Inertia of what goes with the piston, toward the shaft: P_j = −m_j x″ω² − m_j x′ε, x toward the shaft. [N]"""
    return mass * (slider.second * (drive.speed * drive.speed) + slider.first * drive.acceleration)


def two_harmonic_inertia_force(angle: Array, geometry: SliderCrank, mass: Array, drive: Drive) -> Array:
    """Inertia force of two harmonics of the motion. [N]

    −m_j R[ω²(cos φ + λ cos 2φ + (e/L) sin φ) + ε(sin φ + ½λ sin 2φ − (e/L) cos φ)]; docs/theory/forces, eq. (13.34).
    """
    ratio = geometry.crank_radius / geometry.rod_length
    aside = geometry.offset / geometry.rod_length
    cos = np.cos(angle)
    sin = np.sin(angle)
    # cos 2φ and ½ sin 2φ.
    second = cos + ratio * (cos * cos - sin * sin) + aside * sin
    first = sin + ratio * (sin * cos) - aside * cos
    pulled = second * (drive.speed * drive.speed) + first * drive.acceleration
    return -mass * geometry.crank_radius * pulled


def piston_forces(force: Array, motion: SliderCrankMotion, geometry: SliderCrank) -> PistonForces:
    """Force on a piston taken apart by a rod without mass.

    Parameters
    ----------
    force : Array, shape (..., n)
        P: gas less ambient pressure, loads, inertia and weight, toward the shaft. [N]
    motion : SliderCrankMotion, shape (..., n)
    geometry : SliderCrank, fields broadcastable to (..., 1)

    Returns
    -------
    PistonForces, shape (..., n)

    Notes
    -----
    N = P tan β, S = P/cos β, K = P cos(φ + β)/cos β, T = P sin(φ + β)/cos β; with an offset too. docs/theory/forces,
    eqs. (13.30) and (13.31).

    Examples
    --------
    >>> from cranktrain.mechanisms.slider_crank.kinematics import slider_crank
    >>> geometry = SliderCrank(0.05, 0.13, 0.0)
    >>> forces = piston_forces(1000.0, slider_crank(np.pi / 2, geometry), geometry)
    >>> round(float(forces.tangential), 9), round(float(forces.rod), 6)
    (1000.0, 1083.333333)
    """
    rod = motion.rod
    cos = motion.pin.x.value / geometry.crank_radius
    sin = motion.pin.y.value / geometry.crank_radius
    # The rod points at −β.
    tangent = -rod.sin / rod.cos
    return PistonForces(
        force + 0.0 * rod.cos,
        force * tangent,
        force / rod.cos,
        force * (cos - sin * tangent),
        force * (sin + cos * tangent),
    )


def piston_identities(
    forces: PistonForces, motion: SliderCrankMotion, geometry: SliderCrank
) -> tuple[Array, Array, Array]:
    """What must be zero of the forces of a piston: K² + T² − S² [N²]; TR − Px′ and TR − (Ns + Pe) [N·m].

    docs/theory/forces, eqs. (13.32) and (13.33).
    """
    torque = forces.tangential * geometry.crank_radius
    resolved = forces.radial * forces.radial + forces.tangential * forces.tangential
    return (
        resolved - forces.rod * forces.rod,
        torque + forces.piston * motion.slider.first,
        torque - (forces.side * motion.slider.value + forces.piston * geometry.offset),
    )


def rod_forces(
    rod: Link,
    slider: Coefficient,
    pins: tuple[Wrench, Wrench],
    masses: TwoMasses,
    drive: Drive,
    gravity: Gravity,
) -> tuple[Array, Array]:
    """Force along a rod by the reactions in both its pins.

    Parameters
    ----------
    rod : Link, coefficients of shape (..., n)
        From its first pin, at the crank or a knuckle, to the piston's.
    slider : Coefficient, shape (..., n)
        The piston pin along x. [m, m/rad, m/rad²]
    pins : (Wrench, Wrench), shape (..., n)
        At the first pin on the rod, at the second by the rod.
    masses : TwoMasses, broadcastable to (..., 1)
        The rod's shares at its pins, whose inertia and weight go with what is there, as in `piston_forces`. [kg]
    drive : Drive
    gravity : Gravity, in the mechanism's axes

    Returns
    -------
    at_piston, at_crank : Array, shape (..., n)
        + in compression. [N]
        Where nothing hangs on the rod, both are the same. docs/theory/forces, eq. (13.50).
    """
    first, second = pins
    square = drive.speed * drive.speed
    origin = rod.origin
    first_x = first.x - masses.first * (origin.x.second * square + origin.x.first * drive.acceleration - gravity.x)
    first_y = first.y - masses.first * (origin.y.second * square + origin.y.first * drive.acceleration - gravity.y)
    second_x = second.x + masses.second * (slider.second * square + slider.first * drive.acceleration - gravity.x)
    second_y = second.y - masses.second * gravity.y
    return second_x * rod.cos + second_y * rod.sin, first_x * rod.cos + first_y * rod.sin
