"""Points on links: coupler curves, centres of mass, whatever a machine file asks to follow."""

from collections.abc import Sequence
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.catalogue import quantity
from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.layout.places import PlacedMechanism
from cranktrain.linkage import LinkPoint, point
from cranktrain.motion import Array, Link
from cranktrain.numerics.nested import Nested, mapped
from cranktrain.record import record

_CURVE = ("point", "crank_angle")
_THEORY = "docs/theory/groups"


@record
class LinkPoints:
    """Points that are followed.

    Attributes
    ----------
    names : tuple of str
        `1.balance`: the mechanism and the point's own name.
    mechanism : array of int, shape (point,)
        Which of all mechanisms carries it.
    carriers : tuple of str
        Which link of it, or which joint.
    geometry : LinkPoint of arrays, shape (design, point, 1)
        On the link; nothing for a joint.
    """

    needs: ClassVar[str] = N_("[mechanism.points.NAME] link, along, across")

    names: tuple[str, ...]
    mechanism: NDArray[np.intp]
    carriers: tuple[str, ...]
    geometry: LinkPoint

    @property
    def labels(self) -> dict[str, tuple[str, ...]]:
        """Names of the points."""
        return {"point": self.names}


def point_problems(places: Sequence[PlacedMechanism]) -> tuple[Problem, ...]:
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


def link_points_of(designs: Sequence[Sequence[PlacedMechanism]]) -> LinkPoints | None:
    """Collect the points of every mechanism, and its joints that have names; None where there are none."""
    first = [
        (i, place, name, is_joint)
        for i, place in enumerate(designs[0])
        for names, is_joint in ((place.spec.points, False), (place.kind.joints, True))
        for name in names
    ]
    if not first:
        return None

    def lengths(field: str) -> Array:
        return np.array(
            [
                [
                    [0.0 if is_joint else getattr(design[i].spec.points[name], field).si]
                    for i, _p, name, is_joint in first
                ]
                for design in designs
            ]
        )

    along, across = lengths("along"), lengths("across")
    sense = np.array([[[design[i].sense] for i, *_rest in first] for design in designs])
    return LinkPoints(
        names=tuple(f"{place.name}.{name}" for _i, place, name, _j in first),
        mechanism=np.array([i for i, _p, _n, _j in first], dtype=np.intp),
        carriers=tuple(name if is_joint else place.spec.points[name].link for _i, place, name, is_joint in first),
        geometry=LinkPoint(np.hypot(along, across), sense * np.arctan2(across, along)),
    )


@record
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


def point_motion(points: LinkPoints, mechanisms: Mechanisms, crank_angle: CrankAngle) -> PointMotion:
    """Paths of all points, with derivatives by the crank angle."""
    shape = (len(crank_angle.zero), len(points.names), crank_angle.shown.size)
    curves = np.empty((6, *shape))
    for batch in mechanisms.batches:
        on_batch = np.isin(points.mechanism, batch.index)
        motion = batch.kind.motion(crank_angle.angle + batch.members.phase, batch.members.geometry)
        for carrier in (*batch.kind.links, *batch.kind.joints):
            chosen = np.flatnonzero(on_batch & (np.array(points.carriers) == carrier))
            carried = _members(batch.kind.part(motion, carrier), np.searchsorted(batch.index, points.mechanism[chosen]))
            geometry = LinkPoint(points.geometry.radius[:, chosen], points.geometry.angle[:, chosen])
            moving = point(carried, geometry) if isinstance(carried, Link) else carried
            for curve, values in zip(curves, (*moving.x, *moving.y), strict=True):
                curve[:, chosen] = values
    x, x_first, x_second, y, y_first, y_second = curves
    return PointMotion(x, y, x_first, y_first, x_second, y_second)


def _members(motion: Nested, index: NDArray[np.intp]) -> Nested:
    """Take some members of a link: nested NamedTuples of arrays, shape (design, member, n)."""
    return mapped(lambda _name, values: values[:, index], motion)
