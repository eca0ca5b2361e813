"""Polygons of forces as data: corners in drawing millimetres, forces with exact values, link by link.

One drawing millimetre is μ_F newtons. All axes are the machine's: X right, Y up.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from cranktrain.analysis import SpeedWanted
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.study.acting import ActedLink, Cause, acted_links, made_ready
from cranktrain.study.placement import place_called
from cranktrain.study.plans import ROOM, closed_angles, fitting

_NOTHING = 1e-9
"""A force less than this part of the mechanism's largest is none."""


class PolygonForce(NamedTuple):
    """A side of a polygon of forces: symbol, cause, joint of a reaction, exact X and Y. [N]"""

    symbol: str
    cause: Cause
    joint: str
    value: tuple[float, float]

    @property
    def size(self) -> float:
        """Size of the force. [N]"""
        return float(np.hypot(*self.value))


@dataclass(frozen=True)
class ForcePolygon:
    """All forces on one link at one crank angle, head to tail.

    Attributes
    ----------
    mechanism, link : str
    number : int
        Of the link: 1 is the frame, 2 the crank; `F_34` is the force of link 3 on link 4.
    angle : float
        Crank angle as the machine shows it. [deg]
    scale : float
        μ_F: what one drawing millimetre is. [N]
    forces : tuple of PolygonForce
        Load, weight, inertia, then reactions.
    corners : Array, shape (2, n + 1)
        Where each force starts, and where the last one ends. [drawing mm]
    """

    mechanism: str
    link: str
    number: int
    angle: float
    scale: float
    forces: tuple[PolygonForce, ...]
    corners: Array

    def length(self, force: PolygonForce) -> float:
        """Give a force's length on paper. [drawing mm]"""
        return force.size / self.scale

    @property
    def gap(self) -> float:
        """By how much the polygon does not close, in parts of its largest force."""
        return float(np.hypot(*np.sum([force.value for force in self.forces], axis=0))) / max(
            force.size for force in self.forces
        )


def force_polygons(
    machine: Machine,
    angles: int | Sequence[float],
    *,
    mechanism: str | None = None,
    room: tuple[float, float] = ROOM,
    speed: SpeedWanted = "constant",
) -> tuple[ForcePolygon, ...]:
    """Polygons of forces of every link that has any, for each crank angle, all to one scale.

    Parameters
    ----------
    machine : Machine
        With masses or gas, and a speed.
    angles : int or sequence of float
        How many, evenly over a turn from the shown angle 0, or which. [deg]
    mechanism : str, optional
        Its name, such as `1R`; unless given, the first slave of throw 1, or the first mechanism.
    room : (width, height)
        For which the scale factor must suffice, polygon by polygon. [mm]
    speed : SpeedWanted
        As `cranktrain.run` takes it.

    Returns
    -------
    tuple of ForcePolygon
        Link by link for the first angle, then for the next.

    Raises
    ------
    InputError
        If nothing acts on the links.

    Notes
    -----
    Reactions are the exact ones of the joints; inertia is found apart from them, so that a polygon which did not close
    would be wrong. docs/theory/forces.
    """
    place = place_called(machine, mechanism)
    shown = closed_angles(machine, place, angles)
    links = acted_links(machine, made_ready(machine, speed), place, np.deg2rad(shown) + machine.zero)
    least = _NOTHING * max(float(np.max(np.hypot(*force.value))) for link in links for force in link.forces)
    if not np.isfinite(least) or least == 0.0:
        allowed = _("no force acts on the links of {name} there").format(name=place.name)
        raise InputError([Problem("", ", ".join(f"φ = {angle:g}°" for angle in shown), allowed)])
    sides = [(i, link, _sides(link, i, least)) for i in range(len(shown)) for link in links]
    outlines = [_corners(forces) for _i, _link, forces in sides if forces]
    scale = fitting(outlines, room)
    return tuple(
        ForcePolygon(place.name, link.name, link.number, float(shown[i]), scale, forces, _corners(forces) / scale)
        for i, link, forces in sides
        if forces
    )


def rescaled(polygon: ForcePolygon, scale: float) -> ForcePolygon:
    """Give the same polygon to another scale. [N for 1 mm]"""
    return replace(polygon, scale=scale, corners=polygon.corners * (polygon.scale / scale))


def _sides(link: ActedLink, i: int, least: float) -> tuple[PolygonForce, ...]:
    """Forces on a link at one of the angles, without those that are none."""
    found = (
        PolygonForce(force.symbol, force.cause, force.joint, (float(force.value[0, i]), float(force.value[1, i])))
        for force in link.forces
    )
    return tuple(force for force in found if force.size > least)


def _corners(forces: Sequence[PolygonForce]) -> Array:
    """Corners of a polygon of forces, shape (2, n + 1). [N]"""
    return np.cumsum([(0.0, 0.0), *(force.value for force in forces)], axis=0).T
