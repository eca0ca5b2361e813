"""Kinematics of the oscillating cylinder: crank and RPR group, the piston rod being the crank's own rod."""

from typing import NamedTuple

from cranktrain.linkage import AHEAD, Crank, CrankAndPivot, Ends, Swivel, crank, fixed, swivel
from cranktrain.motion import Array, Coefficient, Link, Point


class OscillatingCylinderMotion(NamedTuple):
    """Crank pin; slider: the piston in its cylinder, along its axis [m]; cylinder: from the trunnion to the crank pin.

    The slider counts toward the head from where it is when the crank pin is at the ground's distance from the trunnion.
    """

    pin: Point
    slider: Coefficient
    cylinder: Link


def oscillating_cylinder(angle: Array, geometry: CrankAndPivot) -> OscillatingCylinderMotion:
    """Piston in a cylinder that rocks about a trunnion, its rod on the crank pin, and the derivatives.

    Parameters
    ----------
    angle : Array, shape (..., n)
        Crank angle from x, the direction from the shaft centre to the trunnion. [rad]
    geometry : CrankAndPivot, fields broadcastable to (..., 1)

    Returns
    -------
    OscillatingCylinderMotion, shape (..., n)
        NaN where the crank pin is nearer to the trunnion than the cylinder's axis.

    Notes
    -----
    s = g − ρ, ρ = √(D² − e²), D² = R² + g² − 2Rg cos φ; s as (g² − ρ²)/(g + ρ), which keeps its digits where the
    crank is short. Exact; docs/theory/oscillating-cylinder, eq. (10.1).
    """
    pin = crank(angle, Crank(geometry.crank_radius))
    pivot = fixed(geometry.ground_length, 0.0 * geometry.ground_length)
    motion = swivel(Ends(pin, pivot), Swivel(geometry.offset, AHEAD))
    out = motion.slider
    square = (2.0 * geometry.ground_length) * pin.x.value - (
        (geometry.crank_radius - geometry.offset) * (geometry.crank_radius + geometry.offset)
    )
    slider = Coefficient(square / (geometry.ground_length + out.value), -out.first, -out.second)
    return OscillatingCylinderMotion(pin, slider, motion.guide)
