"""Points on links: coupler curves, centres of mass, whatever a machine file asks to follow."""

from typing import ClassVar

import numpy as np

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.design import Design, Designs
from cranktrain.linkage import LinkPoint, point
from cranktrain.motion import ZERO, Array, Coefficient, Link, Point
from cranktrain.questions.motion.followed import Followed, followed_parts
from cranktrain.questions.motion.grid_motion import GridMotion
from cranktrain.record import record
from cranktrain.references import THEORY_OF_GROUPS as _THEORY
from cranktrain.saying.catalogue import coefficients

_CURVE = ("point", "crank_angle")


@record
class LinkPoints(Followed):
    """Points that are followed; of one on a link that is not a joint, `parts` has the link.

    Attributes
    ----------
    geometry : LinkPoint of arrays, shape (design, point, 1)
        On the link; nothing for a joint.
    band, toward : Array, shape (design, point)
        How far within the end of its path it counts as being there [m], and the direction of that end [rad]; NaN of one
        that is not asked for it.
    is_joint : tuple of bool
        Whether each has its name of the mechanism, and not of the file.
    """

    needs: ClassVar[str] = N_("[mechanism.points.NAME] link, along, across")
    dimension: ClassVar[str] = "point"

    geometry: LinkPoint
    band: Array
    toward: Array
    is_joint: tuple[bool, ...]


def point_problems(design: Design) -> tuple[Problem, ...]:
    """Find points on links that the mechanism does not have."""
    return tuple(
        Problem(
            f"{place.path}.points.{name}.link",
            spec.link,
            _("must be a link of this mechanism: {links}", links=", ".join(place.kind.links)),
        )
        for place in {place.path: place for place in design.places}.values()
        for name, spec in place.spec.points.items()
        if spec.link not in place.kind.links
    )


def link_points_of(designs: Designs) -> LinkPoints | None:
    """Collect the points of every mechanism, and its joints that have names; None where there are none."""
    found = [
        (i, place, name, is_joint)
        for i, place in enumerate(designs.places)
        for names, is_joint in ((place.spec.points, False), (place.kind.joints, True))
        for name in names
    ]
    if not found:
        return None

    def lengths(field: str) -> Array:
        numbers = [
            ZERO if is_joint else getattr(place.spec.points[name], field).array for _i, place, name, is_joint in found
        ]
        return designs.by_design(numbers)[..., np.newaxis]

    along, across = lengths("along"), lengths("across")
    asked = [None if is_joint else place.spec.points[name] for _i, place, name, is_joint in found]
    bands, toward = ([getattr(spec, key, None) for spec in asked] for key in ("band", "toward"))
    sense = np.array([[place.sense] for _i, place, *_rest in found])
    return LinkPoints(
        names=tuple(f"{place.name}.{name}" for _i, place, name, _j in found),
        mechanism=np.array([i for i, _p, _n, _j in found], dtype=np.intp),
        parts=tuple(name if is_joint else place.spec.points[name].link for _i, place, name, is_joint in found),
        geometry=LinkPoint(np.hypot(along, across), sense * np.arctan2(across, along)),
        band=designs.by_design([np.nan if band is None else band.array for band in bands]),
        toward=sense[:, 0] * designs.by_design([0.0 if one is None else one.array for one in toward]),
        is_joint=tuple(is_joint for *_point, is_joint in found),
    )


@record
class PointMotion:
    """Paths of points on links, in the axes of their mechanism."""

    point_x: Coefficient = coefficients(
        "x_P",
        "m",
        _CURVE,
        N_("Point's x in its mechanism's axes"),
        N_("Derivative of x by the crank angle"),
        N_("Second derivative of x by the crank angle"),
        _THEORY,
        "1.2, 1.3",
    )
    point_y: Coefficient = coefficients(
        "y_P",
        "m",
        _CURVE,
        N_("Point's y in its mechanism's axes"),
        N_("Derivative of y by the crank angle"),
        N_("Second derivative of y by the crank angle"),
        _THEORY,
        "1.2, 1.3",
    )


def point_motion(points: LinkPoints, motion: GridMotion) -> PointMotion:
    """Paths of all points, with derivatives by the crank angle."""

    def moving(part: Link | Point, place: int) -> Point:
        return moving_point(part, LinkPoint(*(numbers[:, [place]] for numbers in points.geometry)))

    return PointMotion(*followed_parts(points, motion, moving))


def moving_point(part: Link | Point, geometry: LinkPoint) -> Point:
    """Motion of a point on a link; of a joint it is the part itself."""
    return point(part, geometry) if isinstance(part, Link) else part
