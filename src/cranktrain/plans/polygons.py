"""Polygons of velocities and accelerations as data: points in drawing millimetres, vectors with exact values.

One drawing millimetre is μ_v m/s or μ_a m/s². All axes are the machine's: X right, Y up.
"""

from collections.abc import Mapping, Sequence

import numpy as np

from cranktrain.analysis import SpeedWanted, speed_over_cycle
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.linkage.forces import Drive
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.plans.lettering import lettered
from cranktrain.plans.positions import ROOM, closed_angles, fitting
from cranktrain.plans.together import placed_together, places_called, together_name
from cranktrain.plans.turning import turning
from cranktrain.plans.vectors import POLE, PolygonVector, Quantity, plan_vectors
from cranktrain.record import record
from cranktrain.saying.scales import scale_for


@record
class Polygon:
    """A polygon of velocities or accelerations at one crank angle.

    Attributes
    ----------
    mechanism : str
    quantity : "velocity" or "acceleration"
    angle : float
        Crank angle as the machine shows it. [deg]
    scale : float
        μ: what one drawing millimetre is; round in the unit in which it is shown. [unit]
    unit : str
        m/s or m/s^2 at the machine's speed; m/rad or m/rad^2 where it has none.
    points : mapping of name to (X, Y)
        From the pole `p`. [drawing mm]
    vectors : tuple of PolygonVector
    """

    mechanism: str
    quantity: Quantity
    angle: float
    scale: float
    unit: str
    points: Mapping[str, tuple[float, float]]
    vectors: tuple[PolygonVector, ...]

    def length(self, vector: PolygonVector) -> float:
        """Give a vector's length on paper. [drawing mm]"""
        return vector.size / self.scale


def velocity_polygons(
    machine: Machine,
    angles: int | Sequence[float],
    *,
    mechanism: str | None = None,
    room: tuple[float, float] = ROOM,
    is_lettered: bool = False,
    speed: SpeedWanted = "constant",
) -> tuple[Polygon, ...]:
    """Polygons of velocities, one for each crank angle, all to one scale.

    Parameters
    ----------
    machine : Machine
        Its speed makes m/s of them; without one they are m/rad, for 1 rad/s.
    angles : int or sequence of float
        How many, evenly over a turn from the shown angle 0, or which. [deg]
    mechanism : str, optional
        Its name, such as `1R`; unless given, the first slave of throw 1, or the first mechanism. Of a cylinder with
        opposed pistons, by its name or unnamed, both.
    room : (width, height)
        For which the scale factor must suffice, polygon by polygon. [mm]
    is_lettered : bool
        Call pins with long names by letters.
    speed : SpeedWanted
        As `cranktrain.run` takes it.

    Returns
    -------
    tuple of Polygon
        From the pole `p`: `a` of the crank pin A, `b`, `c`, `d` of the other pins; `a'` of the point of a slotted link
        under A. A fixed pin lies on the pole.
    """
    return _polygons(machine, "velocity", angles, mechanism, room, speed, is_lettered=is_lettered)


def acceleration_polygons(
    machine: Machine,
    angles: int | Sequence[float],
    *,
    mechanism: str | None = None,
    room: tuple[float, float] = ROOM,
    is_lettered: bool = False,
    speed: SpeedWanted = "constant",
) -> tuple[Polygon, ...]:
    """Polygons of accelerations, one for each crank angle, all to one scale.

    Parameters
    ----------
    machine, angles, mechanism, room, is_lettered, speed
        As `velocity_polygons` takes them.

    Returns
    -------
    tuple of Polygon
        Beside the points that the velocities have, `n_BA` ends the normal part of B's acceleration about A, `k_AA'`
        Coriolis' part of A's in a slot.
    """
    return _polygons(machine, "acceleration", angles, mechanism, room, speed, is_lettered=is_lettered)


def _polygons(
    machine: Machine,
    quantity: Quantity,
    angles: int | Sequence[float],
    mechanism: str | None,
    room: tuple[float, float],
    speed: SpeedWanted,
    *,
    is_lettered: bool,
) -> tuple[Polygon, ...]:
    """Polygons of either kind."""
    places = places_called(machine, mechanism)
    shown = closed_angles(machine, places, angles)
    angle = np.deg2rad(shown) + machine.zero
    drawing = placed_together(machine, places, angle)
    if is_lettered:
        drawing = lettered(drawing)
    curve = speed_over_cycle(machine, speed)
    drives = [Drive(*pair) for pair in zip(*turning(machine, curve, angle), strict=True)]
    with np.errstate(all="ignore"):
        found = [plan_vectors(drawing, at, drive, quantity) for at, drive in enumerate(drives)]
    _refuse_boundless(together_name(places), shown, found)
    described = [_points(vectors) for vectors in found]
    time = "rad" if machine.main_shaft.speed is None and curve is None else "s"
    unit = f"m/{time}" if quantity == "velocity" else f"m/{time}^2"
    outlines = [np.stack(list(points.values()), axis=1) for points in described]
    scale = fitting(outlines, room, one=scale_for(unit, 0.0).one)
    return tuple(
        Polygon(
            mechanism=together_name(places),
            quantity=quantity,
            angle=float(angle),
            scale=scale,
            unit=unit,
            points={name: (float(point[0] / scale), float(point[1] / scale)) for name, point in points.items()},
            vectors=vectors,
        )
        for angle, points, vectors in zip(shown, described, found, strict=True)
    )


def _refuse_boundless(name: str, shown: Array, found: Sequence[tuple[PolygonVector, ...]]) -> None:
    """Refuse positions that the links reach only at rest, where velocities have no bound."""
    bounded = np.array([np.all(np.isfinite([vector.value for vector in vectors])) for vectors in found])
    if not np.all(bounded):
        there = ", ".join(f"φ = {angle:g}°" for angle in shown[~bounded])
        allowed = _("there the links of {name} only just close, and velocities have no bound", name=name)
        raise InputError([Problem("", there, allowed)])


def _points(vectors: Sequence[PolygonVector]) -> dict[str, Array]:
    """Go from the pole along the vectors; a point that several reach lies where the first ends."""
    points = {POLE: np.zeros(2)}
    for vector in vectors:
        if vector.end not in points:
            points[vector.end] = points[vector.start] + np.asarray(vector.value)
    return points
