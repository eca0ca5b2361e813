"""Kinematics of Stephenson's link motion: a chain of two eccentrics, their rods, the hung link and the valve."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage import AHEAD, LinkPoint
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    Coordinates,
    CrankSize,
    PointStep,
    RodLegSize,
    RodLegStep,
    SlideSize,
    SlideStep,
    StartSize,
    Structure,
    TrammelSize,
    TrammelStep,
    TriadSize,
    TriadStep,
)
from cranktrain.motion import Array, Handed, single

_LINK = TriadStep(
    "link",
    (
        RodLegStep("ahead.pin", "ahead_rod", "ahead_joint"),
        RodLegStep("back.pin", "back_rod", "back_joint"),
        RodLegStep("arm_end", "lifting_link", "saddle"),
    ),
)
_CRANKS, _FIXED = ("ahead", "back"), ("arm_end", "reverse_shaft")

CURVED = Structure(
    _CRANKS, _FIXED, (_LINK, PointStep("link", "centre"), SlideStep("centre", "slot", "valve", "O")), "valve"
)
"""The slot is an arc: a rod from its centre, which the link carries, to the valve's block."""

STRAIGHT = Structure(_CRANKS, _FIXED, (_LINK, TrammelStep("link", "valve", "O")), "valve")
"""The slot is straight, along the link."""


class Stephenson(NamedTuple):
    """Stephenson's link motion in one notch.

    eccentricity, rod_length: of both eccentrics and their rods; ahead: how far the eccentric for running ahead stands
    ahead of the crank, the other as far behind [rad]; pin_spacing: of the rods' joints on the link, pin_setback: of the
    line of these joints from the middle of the slot toward the shaft; slot_arc: the slot's radius, its centre toward
    the shaft; saddle_setback: of the joint of the lifting link, in the middle, toward the shaft; arm_length,
    arm_direction: of the arm on the reverse shaft, its direction in this notch from x [rad]; offset: of the valve's
    line toward +y [m]; side: +1 where the ahead rod's joint lies toward −y, −1 toward +y; start: pose of the
    link where the crank lies along x.
    """

    eccentricity: Array
    ahead: Handed
    rod_length: Array
    pin_spacing: Array
    pin_setback: Array
    slot_arc: Array
    saddle_setback: Array
    lifting_link_length: Array
    reverse_shaft: Coordinates
    arm_length: Array
    arm_direction: Handed
    offset: Handed
    side: Handed
    start: StartSize


def stephenson_size(structure: Structure, geometry: Stephenson) -> ChainSize:
    """Give the gear's numbers as those of its chain, the link's axis from the back joint to the ahead joint.

    Parameters
    ----------
    structure : Structure
        `CURVED` or `STRAIGHT`.
    geometry : Stephenson

    Returns
    -------
    ChainSize
        The crank angle counts from x, the valve's line away from the shaft.

    Notes
    -----
    Exact, the link's rise and fall on its lifting link included; docs/theory/stephenson, eqs. (21.1) to (21.3).
    """
    shaft = geometry.reverse_shaft
    half = 0.5 * geometry.pin_spacing
    none = 0.0 * half
    # Seen along the link, the shaft lies to the right where the ahead joint lies toward −y.
    toward_shaft = -geometry.side
    legs = (
        RodLegSize(_joint(half, toward_shaft * geometry.pin_setback), geometry.rod_length),
        RodLegSize(_joint(-half, toward_shaft * geometry.pin_setback), geometry.rod_length),
        RodLegSize(_joint(none, toward_shaft * geometry.saddle_setback), geometry.lifting_link_length),
    )
    along = single(0.0)
    if structure == STRAIGHT:
        rest = (TrammelSize(none, along, geometry.offset, -geometry.side),)
    else:
        centre = LinkPoint(geometry.slot_arc, toward_shaft * (0.5 * np.pi))
        rest = (centre, SlideSize(geometry.slot_arc, AHEAD, along, geometry.offset))
    return ChainSize(
        (CrankSize(geometry.eccentricity, geometry.ahead), CrankSize(geometry.eccentricity, -geometry.ahead)),
        (
            Coordinates(
                shaft.x + geometry.arm_length * np.cos(geometry.arm_direction),
                shaft.y + geometry.arm_length * np.sin(geometry.arm_direction),
            ),
            shaft,
        ),
        (TriadSize(legs, geometry.start), *rest),
    )


def _joint(along: Array, across: Array) -> LinkPoint:
    return LinkPoint(np.hypot(along, across), np.arctan2(across, along))
