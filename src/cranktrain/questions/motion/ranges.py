"""Ranges of a mechanism that does not turn all round: of its crank, its links and its points, and what blocks it."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import field
from functools import partial
from typing import ClassVar, NamedTuple, TypeAlias

import numpy as np

from cranktrain.language import N_, Said
from cranktrain.layout.closing import closed_ranges, open_places
from cranktrain.layout.crank_angle import CrankAngle, within
from cranktrain.layout.design import Designs
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.layout.places import PlacedMechanism
from cranktrain.linkage import LinkPoint
from cranktrain.mechanisms.kind import AnyKind, AnyMotion, ClosingPart
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import bracketed_roots
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.ties import first_smallest
from cranktrain.questions.motion.points import LinkPoints, moving_point
from cranktrain.record import record
from cranktrain.references import THEORY_OF_GROUPS as _GROUPS
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult

_THEORY = "docs/theory/closing-margin"
_CRANK = ("mechanism", "crank_range")
_LINK = ("ranged_link", "crank_range")
_POINT = ("point", "crank_range")
_NEAR = 0.05
"""How near to an end of a range values are taken for the limit there, in parts of the range."""
_ROOTS: Array = (1 - np.cos((2 * np.arange(14) + 1) * (np.pi / 28))) / 2
"""Square roots of how near, Chebyshev's points of (0, 1): of these a value at the end of a branch is a polynomial."""
_AT_END: Array = np.prod(
    np.where(np.eye(14, dtype=np.bool_), 1.0, _ROOTS / (_ROOTS - _ROOTS[:, np.newaxis] + np.eye(14))), axis=1
)
"""Weights of its values there for that at 0."""
_INSIDE = (1 - np.cos(np.linspace(0, np.pi, 362)[1:-1])) / 2
"""Places in a range between which turning points are looked for, closer toward its ends."""


@record
class OpenMechanisms:
    """Mechanisms whose links cannot close all round, where a file is accepted with them.

    Attributes
    ----------
    ranges : tuple of mapping of int to list of (float, float)
        Of each design, by the place of the mechanism: over which angles φ its links close. [rad]
    names : tuple of str
        Links of these mechanisms, `1.rod`.
    links : tuple of (int, str)
        Of each the mechanism and its own name.
    blocked : tuple of mapping of int to list of (str, str)
        As the ranges: the part that blocks the crank before each and after; nothing of a mechanism of one part.
    """

    reads: ClassVar[tuple[str, ...]] = ("[mechanism]",)

    ranges: tuple[dict[int, list[tuple[float, float]]], ...]
    names: tuple[str, ...]
    links: tuple[tuple[int, str], ...]
    blocked: tuple[dict[int, list[tuple[str, str]]], ...]

    @property
    def labels(self) -> dict[str, tuple[str, ...]]:
        """Numbers of the ranges, and names of the links."""
        most = max((len(own) for of_design in self.ranges for own in of_design.values()), default=0)
        return {"crank_range": tuple(str(i + 1) for i in range(max(most, 1))), "ranged_link": self.names}


def open_mechanisms_of(designs: Designs) -> OpenMechanisms | None:
    """Find the mechanisms that cannot turn all round; None where all can."""
    stuck = sorted({i for design in designs.different for i in design.once(open_places)})
    if not stuck:
        return None
    each = [{i: closed_ranges(ranges) for i, ranges in design.once(open_places).items()} for design in designs.each]
    places = designs.places
    links = tuple((i, link) for i in stuck for link in places[i].kind.links)
    of_designs = list(zip(designs.each, each, strict=True))
    return OpenMechanisms(
        tuple({i: _shown(design.places[i], ranges) for i, ranges in own.items()} for design, own in of_designs),
        tuple(f"{places[i].name}.{link}" for i, link in links),
        links,
        tuple({i: _blocking(design.places[i], ranges) for i, ranges in own.items()} for design, own in of_designs),
    )


_Ranges: TypeAlias = Sequence[tuple[float, float]]


def _shown(place: PlacedMechanism, ranges: _Ranges) -> list[tuple[float, float]]:
    """Ranges of a mechanism's own crank as φ. [rad]"""
    return [(start - float(place.phase), end - float(place.phase)) for start, end in ranges]


def _blocking(place: PlacedMechanism, ranges: _Ranges) -> list[tuple[str, str]]:
    """Parts that lack most of what it takes to close at the ends of ranges of a mechanism's own crank."""
    said = place.kind.closing_advice(place.geometry)
    parts: Sequence[ClosingPart] = () if isinstance(said, Said | str) else said
    if not parts:
        return [("", "") for _range in ranges]
    with np.errstate(all="ignore"):
        gaps = np.array([part.gap(np.ravel(ranges)) for part in parts])
    names = [parts[first_smallest(np.nan_to_num(own, nan=np.inf))].name for own in gaps.T]
    return [(names[i], names[i + 1]) for i in range(0, len(names), 2)]


def is_stuck(stuck: OpenMechanisms | None) -> bool:
    """Whether any mechanism cannot turn all round: of no other anybody asks."""
    return stuck is not None


@record
class CrankRanges(StageResult):
    """Over which crank angles mechanisms close that cannot turn all round, and how far their links go there.

    Attributes
    ----------
    blocked : tuple of mapping of int to list of (str, str)
        Of each design, by mechanism and range, the part that blocks the crank before and behind it.
    """

    crank_range_start: Array = quantity(
        "φ_1", "deg", _CRANK, N_("Crank angle from which on the links close"), _THEORY, "5.1", is_place=True
    )
    crank_range_end: Array = quantity(
        "φ_2", "deg", _CRANK, N_("Crank angle up to which the links close"), _THEORY, "5.1", is_place=True
    )
    link_angle_from: Array = quantity(
        "θ_min",
        "rad",
        _LINK,
        N_("Smallest direction of the link over the range, from the mechanism's x"),
        _GROUPS,
        "1.2",
    )
    link_angle_to: Array = quantity(
        "θ_max",
        "rad",
        _LINK,
        N_("Largest direction of the link over the range, from the mechanism's x"),
        _GROUPS,
        "1.2",
    )
    blocked: tuple[dict[int, list[tuple[str, str]]], ...] = field(kw_only=True)


def crank_ranges(stuck: OpenMechanisms, mechanisms: Mechanisms, crank_angle: CrankAngle) -> CrankRanges:
    """Edges of the ranges, and directions of links: turning points as roots, ends of a branch as limits."""
    n_designs, n_ranges = len(stuck.ranges), len(stuck.labels["crank_range"])
    edges = np.full((2, n_designs, len(mechanisms.names), n_ranges), np.nan)
    angles = np.full((2, n_designs, len(stuck.links), n_ranges), np.nan)
    for one in _each_range(stuck, mechanisms):
        zero = crank_angle.zero[min(one.design, len(crank_angle.zero) - 1), 0, 0]
        edges[:, one.design, one.mechanism, one.number] = within(np.array(one.own) - zero, TURN)
        for place, (of, link) in enumerate(stuck.links):
            if of == one.mechanism:
                turned = _without_jumps(partial(_link_angle, one, link), one.own)
                angles[:, one.design, place, one.number] = _extent(turned, one.own)
    return CrankRanges(*edges, *angles, blocked=stuck.blocked)


@record
class PointRanges:
    """How far points go of mechanisms that cannot turn all round."""

    point_x_from: Array = quantity("x_min", "m", _POINT, N_("Smallest x of the point over the range"), _GROUPS, "1.3")
    point_x_to: Array = quantity("x_max", "m", _POINT, N_("Largest x of the point over the range"), _GROUPS, "1.3")
    point_y_from: Array = quantity("y_min", "m", _POINT, N_("Smallest y of the point over the range"), _GROUPS, "1.3")
    point_y_to: Array = quantity("y_max", "m", _POINT, N_("Largest y of the point over the range"), _GROUPS, "1.3")


def point_ranges(stuck: OpenMechanisms, mechanisms: Mechanisms, points: LinkPoints) -> PointRanges:
    """Extents of points: turning points as roots, ends of a branch as limits."""
    found = np.full((2, 2, len(stuck.ranges), len(points.names), len(stuck.labels["crank_range"])), np.nan)
    for one in _each_range(stuck, mechanisms):
        for place in np.flatnonzero(points.mechanism == one.mechanism).tolist():
            for axis in range(2):
                along = partial(_point_place, one, points, place, axis)
                found[axis, :, one.design, place, one.number] = _extent(along, one.own)
    return PointRanges(*found[0], *found[1])


class _OneRange(NamedTuple):
    """One range of a mechanism of a design: its number, from where to where φ goes [rad], the motion at φ."""

    design: int
    mechanism: int
    number: int
    own: tuple[float, float]
    kind: AnyKind
    motion: Callable[[Array], AnyMotion]


def _each_range(stuck: OpenMechanisms, mechanisms: Mechanisms) -> Iterator[_OneRange]:
    """Go through all ranges."""
    for design, of_design in enumerate(stuck.ranges):
        for mechanism, ranges in of_design.items():
            kind = next(batch.kind for batch in mechanisms.batches if mechanism in batch.index)
            motion = partial(mechanisms.alone, design, mechanism)
            for number, own in enumerate(ranges):
                yield _OneRange(design, mechanism, number, own, kind, motion)


_Along: TypeAlias = Callable[[Array], Coefficient]


def _link_angle(of: _OneRange, link: str, angle: Array) -> Coefficient:
    """Direction of a link at φ, shape (n,). [rad]"""
    return Coefficient(*(part[0] for part in of.kind.named(of.motion(angle), link).angle))


def _point_place(of: _OneRange, points: LinkPoints, place: int, axis: int, angle: Array) -> Coefficient:
    """One coordinate of a point at φ, shape (n,). [m]"""
    geometry = LinkPoint(*(numbers[[of.design], place] for numbers in points.geometry))
    moving = moving_point(of.kind.named(of.motion(angle), points.parts[place]), geometry)
    return Coefficient(*(part[0] for part in moving[axis]))


def _without_jumps(turned: _Along, own: tuple[float, float]) -> _Along:
    """A direction counted on from where it is in the middle of a range, in which it turns by less than half a turn."""
    middle = float(turned(np.array([sum(own) / 2])).value[0])

    def counted(angle: Array) -> Coefficient:
        found = turned(angle)
        return found._replace(value=middle + np.remainder(found.value - middle + np.pi, TURN) - np.pi)

    return counted


def _extent(along: _Along, own: tuple[float, float]) -> tuple[float, float]:
    """Smallest and largest value over a range.

    Near its ends, where the links lie in one line, a value is a polynomial of the square root of how far that is.
    """
    start, end = own
    near = _NEAR * (end - start)
    limits = [
        float(np.sum(_AT_END * along(edge + sense * near * _ROOTS * _ROOTS).value))
        for edge, sense in ((start, 1.0), (end, -1.0))
    ]
    inside = start + (end - start) * _INSIDE
    found = along(inside)
    turns = np.flatnonzero(np.diff(np.sign(found.first)) != 0)
    roots = bracketed_roots(lambda angle: along(angle).first, inside[turns], inside[turns + 1])
    values = np.concatenate([np.array(limits), found.value, along(roots).value if roots.size else np.empty(0)])
    return float(np.nanmin(values)), float(np.nanmax(values))
