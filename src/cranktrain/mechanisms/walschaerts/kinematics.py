"""Kinematics of Walschaerts' gear: a chain of main crank and crosshead, return crank, link and combination lever."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage import AHEAD, LinkPoint, Pin
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    Coordinates,
    CrankSize,
    GuideLegSize,
    GuideLegStep,
    MountStep,
    PinStep,
    PointStep,
    RodLegSize,
    RodLegStep,
    SlideSize,
    SlideStep,
    StartSize,
    Structure,
    TriadSize,
    TriadStep,
)
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank
from cranktrain.motion import Array, Handed, single

STRUCTURE = Structure(
    ("main", "return"),
    ("trunnion",),
    (
        SlideStep("main.pin", "main_rod", "crosshead", "O"),
        MountStep("crosshead", "drop_pin"),
        PinStep("return.pin", "trunnion", "eccentric_rod", "link", "foot"),
        PointStep("link", "die"),
        TriadStep(
            "combination_lever",
            (
                RodLegStep("die", "radius_rod", "radius_pin"),
                RodLegStep("drop_pin", "union_link", "union_pin"),
                GuideLegStep("valve", "O"),
            ),
        ),
    ),
    "valve",
)
"""The link about its trunnion is a rocker; the combination lever hangs on radius rod, union link and valve."""


class Walschaerts(NamedTuple):
    """Walschaerts' gear in one notch.

    master: the main crank, rod and crosshead; bank_angle: of the valve's line ahead of the cylinder's axis [rad];
    eccentricity: of the return crank's pin from the shaft; ahead: how far that stands ahead of the main crank [rad];
    rod_length: of the eccentric rod; trunnion: of the link; foot, foot_setback: joint of the eccentric rod on the link,
    from the trunnion along it and toward the shaft; die: of the block in this notch from the trunnion, toward the foot,
    which the slot's arc of radius `radius_rod_length` takes; lever_length: of the combination lever, from the radius
    rod's pin to the union link's; valve_pin: on it, from the radius rod's toward that one; union_link_length; drop:
    union link's pin on the crosshead, from its pin in the cylinder's axes; offset: of the valve's line toward +y [m];
    side: +1 where the foot lies toward +y of the trunnion, −1 toward −y; start: pose of the lever where the crank lies
    along x.
    """

    master: SliderCrank
    bank_angle: Handed
    eccentricity: Array
    ahead: Handed
    rod_length: Array
    trunnion: Coordinates
    foot: Array
    foot_setback: Array
    die: Array
    radius_rod_length: Array
    lever_length: Array
    valve_pin: Array
    union_link_length: Array
    drop: Coordinates
    offset: Handed
    side: Handed
    start: StartSize


def walschaerts_size(geometry: Walschaerts) -> ChainSize:
    """Give the gear's numbers as those of its chain, in the axes of the valve's line.

    Parameters
    ----------
    geometry : Walschaerts

    Returns
    -------
    ChainSize
        The crank angle counts from the *cylinder's* axis.

    Notes
    -----
    Exact, for a block that keeps its place in the link; docs/theory/walschaerts, eqs. (22.1) to (22.5).
    """
    cylinder = -geometry.bank_angle
    master, drop = geometry.master, geometry.drop
    none = 0.0 * geometry.die
    radius = geometry.radius_rod_length
    # From the trunnion to the foot the shaft lies to the left where the foot lies toward +y.
    foot_angle = np.arctan2(geometry.side * geometry.foot_setback, geometry.foot)
    sagitta = geometry.die * geometry.die / (radius + np.sqrt((radius - geometry.die) * (radius + geometry.die)))
    die_angle = np.arctan2(-geometry.side * sagitta, geometry.die)
    legs = (
        RodLegSize(LinkPoint(none, none), radius),
        RodLegSize(LinkPoint(geometry.lever_length, none), geometry.union_link_length),
        GuideLegSize(
            LinkPoint(np.abs(geometry.valve_pin), np.arctan2(none, geometry.valve_pin)), none, geometry.offset
        ),
    )
    return ChainSize(
        (
            CrankSize(master.crank_radius, cylinder),
            CrankSize(geometry.eccentricity, geometry.ahead + cylinder),
        ),
        (geometry.trunnion,),
        (
            SlideSize(master.rod_length, AHEAD, cylinder, master.offset),
            LinkPoint(np.hypot(drop.x, drop.y), cylinder + np.arctan2(drop.y, drop.x)),
            Pin(geometry.rod_length, np.hypot(geometry.foot, geometry.foot_setback), geometry.side),
            LinkPoint(np.hypot(geometry.die, sagitta), die_angle - foot_angle),
            TriadSize(legs, geometry.start),
        ),
    )


def upright(geometry: Walschaerts) -> Array:
    """Where about the combination lever's three joints lie, shape (3, 2): across the valve's line. [m]"""
    x = geometry.trunnion.x + geometry.radius_rod_length
    down = np.copysign(single(1.0), geometry.drop.y - geometry.offset)
    pin = geometry.offset - down * geometry.valve_pin
    return np.array([[x, pin], [x, pin + down * geometry.lever_length], [x, geometry.offset]])
