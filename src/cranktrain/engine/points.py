"""Points on links: coupler curves, centres of mass, whatever a machine file asks to follow."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.catalogue import quantity
from cranktrain.engine.layout import CrankAngle, Mechanisms
from cranktrain.engine.places import Place
from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.linkage import LinkPoint, point
from cranktrain.motion import Array

_CURVE = ("point", "crank_angle")
_THEORY = "docs/theory/groups"


@dataclass(frozen=True)
class LinkPoints:
    """Points that are followed.

    Attributes
    ----------
    names : tuple of str
        `1.balance`: the mechanism and the point's own name.
    mechanism : array of int, shape (point,)
        Which of all mechanisms carries it.
    links : tuple of str
        Which link of it.
    geometry : LinkPoint of arrays, shape (design, point, 1)
    """

    needs: ClassVar[str] = N_("[mechanism.points.NAME] link, along, across")

    names: tuple[str, ...]
    mechanism: NDArray[np.intp]
    links: tuple[str, ...]
    geometry: LinkPoint


def point_problems(places: Sequence[Place]) -> tuple[Problem, ...]:
    """Find points on links that the mechanism does not have."""
    return tuple(
        Problem(
            f"{place.path}.points.{name}.link",
            spec.link,
            _("must be a link of this mechanism: {links}").format(links=", ".join(place.kind.links)),
        )
        for place in {place.path: place for place in places}.values()
        for name, spec in place.spec.points.items()
        if spec.link not in place.kind.links
    )


def link_points_of(designs: Sequence[Sequence[Place]], *, astern: bool) -> LinkPoints | None:
    """Collect the points of every mechanism; None where there are none."""
    first = [(i, place, name) for i, place in enumerate(designs[0]) for name in place.spec.points]
    if not first:
        return None
    sense = -1.0 if astern else 1.0
    along = np.array([[[design[i].spec.points[name].along.si] for i, _p, name in first] for design in designs])
    across = np.array([[[design[i].spec.points[name].across.si] for i, _p, name in first] for design in designs])
    return LinkPoints(
        names=tuple(f"{place.name}.{name}" for _i, place, name in first),
        mechanism=np.array([i for i, _p, _n in first], dtype=np.intp),
        links=tuple(place.spec.points[name].link for _i, place, name in first),
        geometry=LinkPoint(np.hypot(along, across), sense * np.arctan2(across, along)),
    )


@dataclass(frozen=True)
class PointMotion:
    """Paths of points on links, in the axes of their mechanism."""

    point_x: Array = quantity("x_P", "m", _CURVE, N_("Point's x in its mechanism's axes"), _THEORY)
    point_y: Array = quantity("y_P", "m", _CURVE, N_("Point's y in its mechanism's axes"), _THEORY)
    point_x_velocity_coefficient: Array = quantity(
        "x_P′", "m/rad", _CURVE, N_("Derivative of x by the crank angle"), _THEORY
    )
    point_y_velocity_coefficient: Array = quantity(
        "y_P′", "m/rad", _CURVE, N_("Derivative of y by the crank angle"), _THEORY
    )
    point_x_acceleration_coefficient: Array = quantity(
        "x_P″", "m/rad^2", _CURVE, N_("Second derivative of x by the crank angle"), _THEORY
    )
    point_y_acceleration_coefficient: Array = quantity(
        "y_P″", "m/rad^2", _CURVE, N_("Second derivative of y by the crank angle"), _THEORY
    )


class _Flat(NamedTuple):
    """Coefficients of a point, flat."""

    x: Array
    x_first: Array
    x_second: Array
    y: Array
    y_first: Array
    y_second: Array


def point_motion(points: LinkPoints, mechanisms: Mechanisms, crank_angle: CrankAngle) -> PointMotion:
    """Paths of all points, with derivatives by the crank angle."""
    columns: list[_Flat] = []
    for i, (mechanism, link) in enumerate(zip(points.mechanism, points.links, strict=True)):
        group = next(group for group in mechanisms.groups if mechanism in group.index)
        member = int(np.flatnonzero(group.index == mechanism)[0])
        motion = group.kind.motion(crank_angle.angle + group.members.phase, group.members.geometry)
        geometry = LinkPoint(points.geometry.radius[:, [i]], points.geometry.angle[:, [i]])
        moving = point(getattr(motion, link), geometry)
        columns.append(_Flat(*(array[:, member] for array in (*moving.x, *moving.y))))
    flat = _Flat(*(np.stack(arrays, axis=1) for arrays in zip(*columns, strict=True)))
    return PointMotion(flat.x, flat.y, flat.x_first, flat.y_first, flat.x_second, flat.y_second)
