"""What rod and crank pin do to each other: in the crank's directions, with rotating mass and without; in the rod's."""

from typing import NamedTuple

from cranktrain.linkage.forces import Drive, Wrench
from cranktrain.motion import Array, Link


class PinLoad(NamedTuple):
    """Force of the rod on the crank pin: toward the shaft, and in the sense of rotation. [N]"""

    radial: Array
    tangential: Array


class RodBearingLoad(NamedTuple):
    """Force of the crank pin on the rod: along it toward its other pin, and across, 90° ahead of that. [N]"""

    along: Array
    across: Array


def rod_bearing_load(crank_pin: Wrench, rod: Link) -> RodBearingLoad:
    """Load of the rod's bearing: the joint's reaction, the crank's on the rod; docs/theory/crankshaft, eq. (24.45)."""
    return RodBearingLoad(crank_pin.x * rod.cos + crank_pin.y * rod.sin, crank_pin.y * rod.cos - crank_pin.x * rod.sin)


def pin_load(crank_pin: Wrench, crank: Link) -> PinLoad:
    """Load of the crank pin from the joint's reaction, the crank's on the rod; docs/theory/forces, eq. (13.35)."""
    return PinLoad(
        crank_pin.x * crank.cos + crank_pin.y * crank.sin,
        crank_pin.x * crank.sin - crank_pin.y * crank.cos,
    )


def with_rotating_mass(load: PinLoad, mass: Array, crank_radius: Array, drive: Drive) -> PinLoad:
    """Load of the crank pin with the rod's rotating mass, which `piston_forces` leave out.

    Parameters
    ----------
    load : PinLoad, shape (..., n)
        K and T of a piston, its reciprocating mass taken with the rod's share.
    mass : Array, broadcastable to (..., 1)
        The rod's rotating share, `weighed_ends(...).first`. [kg]
    crank_radius : Array, broadcastable to (..., 1). [m]
    drive : Drive

    Returns
    -------
    PinLoad, shape (..., n)
        K − m_R Rω², T − m_R Rε. docs/theory/forces, eq. (13.36).
    """
    radius = mass * crank_radius
    return PinLoad(load.radial - radius * (drive.speed * drive.speed), load.tangential - radius * drive.acceleration)
