"""Polygons of velocities and accelerations as data: points in drawing millimetres, vectors with exact values.

One drawing millimetre is μ_v m/s or μ_a m/s². All axes are the machine's: X right, Y up.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from cranktrain.machine import Machine
from cranktrain.motion import Array, Point
from cranktrain.study.placement import Joints, joints, place_called
from cranktrain.study.plans import ROOM, closed_angles, fitting

Part = Literal["absolute", "relative", "normal", "tangential"]
"""What a vector of a polygon is."""

POLE = "p"


class Vector(NamedTuple):
    """A vector of a polygon: symbol, part, from which point to which, exact X and Y in the polygon's unit."""

    symbol: str
    part: Part
    start: str
    end: str
    value: tuple[float, float]

    @property
    def size(self) -> float:
        """Length of the vector, in the polygon's unit."""
        return float(np.hypot(*self.value))


@dataclass(frozen=True)
class Polygon:
    """A polygon of velocities or accelerations at one crank angle.

    Attributes
    ----------
    mechanism : str
    quantity : "velocity" or "acceleration"
    angle : float
        Crank angle as the machine shows it. [deg]
    scale : float
        μ: what one drawing millimetre is. [unit]
    unit : str
        m/s or m/s^2 at the machine's speed; m/rad or m/rad^2 where it has none.
    points : mapping of name to (X, Y)
        From the pole `p`. [drawing mm]
    vectors : tuple of Vector
    """

    mechanism: str
    quantity: Literal["velocity", "acceleration"]
    angle: float
    scale: float
    unit: str
    points: Mapping[str, tuple[float, float]]
    vectors: tuple[Vector, ...]

    def length(self, vector: Vector) -> float:
        """Give a vector's length on paper. [drawing mm]"""
        return vector.size / self.scale


class _Pair(NamedTuple):
    """Two pins of one link, the first of which is known before the second, and whether it is fixed."""

    known: str
    pin: str
    is_fixed: bool


_Vectors = Callable[[Joints, Sequence[_Pair], float], Iterator[Vector]]


def velocity_polygons(
    machine: Machine,
    angles: int | Sequence[float],
    *,
    mechanism: str | None = None,
    room: tuple[float, float] = ROOM,
) -> tuple[Polygon, ...]:
    """Polygons of velocities, one for each crank angle, all to one scale.

    Parameters
    ----------
    machine : Machine
        Its speed, taken as constant, makes m/s of them; without one they are m/rad, for 1 rad/s.
    angles : int or sequence of float
        How many, evenly over a turn from the shown angle 0, or which. [deg]
    mechanism : str, optional
        Its name, such as `1R`; unless given, the first slave of throw 1, or the first mechanism.
    room : (width, height)
        For which the scale factor must suffice, polygon by polygon. [mm]

    Returns
    -------
    tuple of Polygon
        From the pole `p`: `a` of the crank pin A, `b`, `c`, `d` of the other pins; a fixed pin lies on the pole.
    """
    unit = "m/rad" if machine.main_shaft.speed is None else "m/s"
    return _polygons(machine, "velocity", unit, _velocities, angles, mechanism, room)


def acceleration_polygons(
    machine: Machine,
    angles: int | Sequence[float],
    *,
    mechanism: str | None = None,
    room: tuple[float, float] = ROOM,
) -> tuple[Polygon, ...]:
    """Polygons of accelerations, one for each crank angle, all to one scale.

    Parameters
    ----------
    machine, angles, mechanism, room
        As `velocity_polygons` takes them.

    Returns
    -------
    tuple of Polygon
        Beside the points that the velocities have, `n_BA` ends the normal part of B's acceleration about A.
    """
    unit = "m/rad^2" if machine.main_shaft.speed is None else "m/s^2"
    return _polygons(machine, "acceleration", unit, _accelerations, angles, mechanism, room)


def _polygons(
    machine: Machine,
    quantity: Literal["velocity", "acceleration"],
    unit: str,
    vectors_of: _Vectors,
    angles: int | Sequence[float],
    mechanism: str | None,
    room: tuple[float, float],
) -> tuple[Polygon, ...]:
    """Polygons of either kind."""
    place = place_called(machine, mechanism)
    shown = closed_angles(machine, place, angles)
    speed = machine.main_shaft.speed
    described: list[tuple[dict[str, Array], tuple[Vector, ...]]] = []
    for angle in shown:
        phi = np.array([np.deg2rad(angle) + machine.zero])
        drawing = place.kind.drawing(phi + place.phase, place.geometry)
        pairs = [
            _Pair(link.pins[0], pin, link.pins[0] in drawing.fixed) for link in drawing.links for pin in link.pins[1:]
        ]
        vectors = tuple(vectors_of(joints(machine, place, phi), pairs, 1.0 if speed is None else speed.si))
        described.append((_points(vectors), vectors))
    scale = fitting([np.stack(list(points.values()), axis=1) for points, _vectors in described], room)
    return tuple(
        Polygon(
            mechanism=place.name,
            quantity=quantity,
            angle=float(angle),
            scale=scale,
            unit=unit,
            points={name: (float(point[0] / scale), float(point[1] / scale)) for name, point in points.items()},
            vectors=vectors,
        )
        for angle, (points, vectors) in zip(shown, described, strict=True)
    )


def _points(vectors: Sequence[Vector]) -> dict[str, Array]:
    """Go from the pole along the vectors; a point that several reach lies where the first ends."""
    points = {POLE: np.zeros(2)}
    for vector in vectors:
        if vector.end not in points:
            points[vector.end] = points[vector.start] + np.asarray(vector.value)
    return points


def _velocities(moving: Joints, pairs: Sequence[_Pair], omega: float) -> Iterator[Vector]:
    """Velocity of every moving pin, and of every pin about another that moves."""
    seen: set[str] = set()
    for known, pin, is_fixed in pairs:
        end, value = pin.lower(), omega * _first(moving[pin])
        if pin not in seen:
            yield _vector(f"v_{pin}", "absolute", POLE, end, value)
            seen.add(pin)
        if not is_fixed:
            yield _vector(f"v_{pin}{known}", "relative", known.lower(), end, value - omega * _first(moving[known]))


def _accelerations(moving: Joints, pairs: Sequence[_Pair], omega: float) -> Iterator[Vector]:
    """Acceleration of every moving pin, and the normal and tangential part of it about the link's other pin.

    The crank turns evenly: it has no tangential part.
    """
    seen: set[str] = set()
    for known, pin, is_fixed in pairs:
        end, value = pin.lower(), omega**2 * _second(moving[pin])
        if pin not in seen:
            yield _vector(f"a_{pin}", "absolute", POLE, end, value)
            seen.add(pin)
        arm = _value(moving[pin]) - _value(moving[known])
        turning = _first(moving[pin]) - _first(moving[known])
        normal = -(omega**2) * np.dot(turning, turning) / np.dot(arm, arm) * arm
        whole = omega**2 * (_second(moving[pin]) - _second(moving[known]))
        if known == "O":
            continue
        start = POLE if is_fixed else known.lower()
        corner = f"n_{pin}{known}"
        yield _vector(f"a_{pin}{known}^n", "normal", start, corner, normal)
        yield _vector(f"a_{pin}{known}^t", "tangential", corner, end, whole - normal)
        if not is_fixed:
            yield _vector(f"a_{pin}{known}", "relative", start, end, whole)


def _vector(symbol: str, part: Part, start: str, end: str, value: Array) -> Vector:
    return Vector(symbol, part, start, end, (float(value[0]), float(value[1])))


def _value(moving: Point) -> Array:
    return np.array([moving.x.value[0], moving.y.value[0]])


def _first(moving: Point) -> Array:
    return np.array([moving.x.first[0], moving.y.first[0]])


def _second(moving: Point) -> Array:
    return np.array([moving.x.second[0], moving.y.second[0]])
