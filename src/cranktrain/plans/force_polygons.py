"""Polygons of forces as data: corners in drawing millimetres, forces with exact values, group by group.

One drawing millimetre is μ_F newtons. All axes are the machine's: X right, Y up.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cranktrain.analysis import SpeedWanted
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.plans.acting import made_ready, member_of
from cranktrain.plans.assur_groups import group_forces
from cranktrain.plans.force_sides import GroupForces, PolygonForce, Span
from cranktrain.plans.positions import ROOM, closed_angles, fitting
from cranktrain.plans.together import numbered_pin, places_called, together_name
from cranktrain.record import record
from cranktrain.saying.scales import scale_for


@record
class ForcePolygon(GroupForces):
    """Forces on an Assur group, or on the crank, drawn to scale.

    Attributes
    ----------
    mechanism : str
    angle : float
        Crank angle as the machine shows it. [deg]
    scale : float
        μ_F: what one drawing millimetre is. [N]
    corners : Array, shape (2, n + 1)
        Where each force starts, and where the last one ends. [drawing mm]
    """

    mechanism: str
    angle: float
    scale: float
    corners: Array

    def length(self, force: PolygonForce) -> float:
        """Give a force's length on paper. [drawing mm]"""
        return force.size / self.scale

    def parts(self, span: Span) -> tuple[PolygonForce, ...]:
        """Give the sides that are the parts of a whole reaction."""
        return tuple(self.forces[(span.start + i) % len(self.forces)] for i in range(2))

    @property
    def gap(self) -> float:
        """By how much the polygon does not close, in parts of its largest force."""
        values = [force.value for force in self.forces]
        return float(np.hypot(*np.sum(values, axis=0))) / max(force.size for force in self.forces)


def force_polygons(
    machine: Machine,
    angles: int | Sequence[float],
    *,
    mechanism: str | None = None,
    room: tuple[float, float] = ROOM,
    speed: SpeedWanted = "constant",
) -> tuple[ForcePolygon, ...]:
    """Polygons of forces of a mechanism's groups and crank, for each crank angle, all to one scale.

    Parameters
    ----------
    machine : Machine
        With masses or gas, and a speed.
    angles : int or sequence of float
        How many, evenly over a turn from the shown angle 0, or which. [deg]
    mechanism : str, optional
        Its name, such as `1R`; unless given, the first slave of throw 1, or the first mechanism. Of a cylinder with
        opposed pistons, by its name or unnamed, both: the second one's links have the next numbers.
    room : (width, height)
        For which the scale factor must suffice, polygon by polygon. [mm]
    speed : SpeedWanted
        As `cranktrain.run` takes it.

    Returns
    -------
    tuple of ForcePolygon
        For the first angle, then for the next: groups in the order in which they are solved, the last one first, so
        that each hands its load to those that carry it; of a slave its master's after its own; then the crank.

    Raises
    ------
    InputError
        If nothing acts on the links.

    Notes
    -----
    Reactions are the exact ones of the joints; inertia is found apart from them, so that a polygon which did not close
    would be wrong. docs/theory/forces.
    """
    places = places_called(machine, mechanism)
    shown = closed_angles(machine, places, angles)
    loaded = made_ready(machine, speed)
    found: list[tuple[str, float, GroupForces]] = []
    for angle in shown.tolist():
        after = 1
        for i, place in enumerate(places):
            one = member_of(machine, loaded, place, np.deg2rad([angle]) + machine.zero)
            groups = [_numbered(group, i) for group in group_forces(one, after) if group.forces]
            after = max((number for group in groups for number in group.numbers), default=after)
            found += [(place.name, angle, group) for group in groups]
    if not found:
        allowed = _("no force acts on the links of {name} there", name=together_name(places))
        raise InputError([Problem("", ", ".join(f"φ = {angle:g}°" for angle in shown), allowed)])
    scale = fitting([_corners(group.forces) for _name, _angle, group in found], room, one=scale_for("N", 0.0).one)
    return tuple(
        ForcePolygon(**vars(group), mechanism=name, angle=angle, scale=scale, corners=_corners(group.forces) / scale)
        for name, angle, group in found
    )


def _numbered(group: GroupForces, i: int) -> GroupForces:
    """Call pins of one of several mechanisms as they are drawn together."""
    forces = (force._replace(about=numbered_pin(force.about, i)) if force.about else force for force in group.forces)
    return replace(group, forces=tuple(forces))


def rescaled(polygon: ForcePolygon, scale: float) -> ForcePolygon:
    """Give the same polygon to another scale. [N for 1 mm]"""
    return replace(polygon, scale=scale, corners=polygon.corners * (polygon.scale / scale))


def _corners(forces: Sequence[PolygonForce]) -> Array:
    """Corners of a polygon of forces, shape (2, n + 1). [N]"""
    return np.cumsum([(0.0, 0.0), *(force.value for force in forces)], axis=0).T
