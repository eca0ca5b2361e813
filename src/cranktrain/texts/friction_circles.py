"""Pin friction of a crank-rocker by friction circles: forces of massless links that rub in their four pins."""

from typing import NamedTuple

import numpy as np

from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker, crank_rocker
from cranktrain.motion import Array

_STANDS = 1e-12
"""Turning of a pin for a radian of the crank that is but rounding."""


class FrictionRadii(NamedTuple):
    """Radii of the friction circles: of shaft O, crank pin B, rocker's pin A, rocker's pivot O₁. [m]"""

    shaft: Array
    crank_pin: Array
    rocker_pin: Array
    pivot: Array


class RubbingLinks(NamedTuple):
    """What rubbing links pass on: force in the rod, torque on the crank, NaN where the links are locked. [N, N·m]"""

    rod_force: Array
    torque: Array


def friction_radius(coefficient: Array, pin_radius: Array) -> Array:
    """Radius of the friction circle of a pin, r sin(atan f). [m]

    Examples
    --------
    >>> round(float(friction_radius(np.array(0.75), np.array(10.0))), 12)
    6.0
    """
    return pin_radius * coefficient / np.sqrt(1 + coefficient**2)


def rubbing_links(angle: Array, geometry: CrankRocker, load: Array, radii: FrictionRadii) -> RubbingLinks:
    """Force in the rod and torque on the crank of a crank-rocker whose pins rub, turning forward.

    Parameters
    ----------
    angle : Array, shape (..., n)
        Crank angle from the line of the fixed pivots. [rad]
    geometry : CrankRocker
    load : Array, broadcastable
        Torque on the rocker's shaft against its growing angle: of a weight or a spring as it stands, of dry friction
        times the sign of the rocker's speed. A couple, which presses on no pin: a force across the rocker at A, of the
        same torque, would press on the pivot, too. [N·m]
    radii : FrictionRadii

    Returns
    -------
    RubbingLinks, shape (..., n)
        NaN where no force in the rod can hold the load. A pin that stops turning has no sense of friction; 0 there.

    Notes
    -----
    The rod's force, tension or thrust, touches both its pins' circles: it is turned by asin κ̂ from the rod's line.
    docs/theory/crank-rocker-drive, eqs. (27.11) and (27.12). Massless links; with mass the reactions of joints count.
    """
    motion = crank_rocker(angle, geometry)
    beta, alpha1 = motion.rod.angle, motion.rocker.angle
    at_a, at_b, at_pivot = _sense(beta.first - alpha1.first), _sense(beta.first - 1.0), _sense(alpha1.first)
    turned = (radii.rocker_pin * at_a + radii.crank_pin * at_b) / geometry.rod_length
    straight = np.sqrt(1 - turned**2)
    to_rocker, to_crank = beta.value - alpha1.value, beta.value - angle

    def arm(along: Array, direction: Array, length: Array) -> Array:
        return length * (along * np.sin(direction) - turned * np.cos(direction))

    def force(along: Array) -> Array:
        arms = arm(along, to_rocker, geometry.rocker_length) + radii.rocker_pin * at_a - radii.pivot * at_pivot
        with np.errstate(divide="ignore", invalid="ignore"):
            return load / arms

    one, other = force(straight), force(-straight)
    along = np.where(one > 0, straight, np.where(other > 0, -straight, np.nan))
    found = np.where(one > 0, one, other)
    torque = found * (arm(along, to_crank, geometry.crank_radius) - radii.crank_pin * at_b + radii.shaft)
    return RubbingLinks(found + 0.0 * along, torque)


def _sense(turning: Array) -> Array:
    """Sense in which a pin turns; 0 where it stands."""
    return np.where(np.abs(turning) > _STANDS, np.sign(turning), 0.0)
