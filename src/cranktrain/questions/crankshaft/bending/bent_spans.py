"""How a crank frame bends, from piece to web to piece, in closed form: under a unit moment at either end of a span.

What a load does to the ends of its span is, by reciprocity, what a moment at that end does to the load's point.
Arrays of the shape (row, end, direction, component): a row is a span of one design, as many pieces long as the others;
the first or the last end of the span, the direction of the moment's loads there, and the component of what it causes;
what has no components is without the last.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.metal.shaft import Crankshaft, Pieces, Webs


class Bent(NamedTuple):
    """A cross-section of a bent span.

    Attributes
    ----------
    shift : Array, shape (row, 2, 2, 2)
        Displacement across the shaft. [m/(N·m)]
    slope : Array, shape (row, 2, 2, 2)
        Rotation, by the direction in which points further along the shaft move. [rad/(N·m)]
    twist : Array, shape (row, 2, 2)
        Rotation about the shaft's axis, from X toward Y. [rad/(N·m)]
    along : Array, shape (row, 2, 2)
        Displacement along the shaft. [m/(N·m)]
    """

    shift: Array
    slope: Array
    twist: Array
    along: Array

    def of(self, rows: NDArray[np.intp] | tuple[NDArray[np.intp], NDArray[np.intp]]) -> "Bent":
        """Those of some rows."""
        return Bent(*(part[rows] for part in self))


class CrankLine(NamedTuple):
    """The line along which forces are handed on.

    Attributes
    ----------
    pieces : Pieces
    webs : Webs
    axes : Array, shape (row, piece, 1, 1, 2)
        Axis of each piece from the shaft's, in axes that turn with the shaft. [m]
    """

    pieces: Pieces
    webs: Webs
    axes: Array

    def part(self, rows: NDArray[np.intp], first: NDArray[np.intp], n_pieces: int) -> "CrankLine":
        """So many pieces one after another, each time from a first one of a row on, and the webs between them."""
        row, piece = rows[:, np.newaxis], first[:, np.newaxis] + np.arange(n_pieces + 1, dtype=np.intp)
        bounds, *others = self.pieces
        pieces = Pieces(bounds[row, piece], *(part[row, piece[:, :-1]] for part in others))
        webs = Webs(*(part[row, piece[:, :-2]] for part in self.webs))
        return CrankLine(pieces, webs, self.axes[row, piece[:, :-1]])


def crank_line(shaft: Crankshaft) -> CrankLine:
    """The line of a shaft, of which a row is a design."""
    return CrankLine(shaft.pieces, shaft.webs, polar(shaft.pieces.radius, shaft.pieces.angle))


class Inner(NamedTuple):
    """What the part of a span before a section gives on to the part behind it.

    Attributes
    ----------
    z : Array, shape (row,)
        Where the moment is taken.
    moment : Array, shape (row, 2, 2, 2)
        Bending moment there.
    shear : Array, shape (row, 2, 2, 2)
        Sum of the forces before the section.
    torque : Array, shape (row, 2, 2)
        Sum of the torques about the shaft's axis before the section.
    """

    z: Array
    moment: Array
    shear: Array
    torque: Array

    def moment_at(self, z: Array) -> Array:
        """Bending moment at another place, where no force acts in between."""
        return self.moment + self.shear * _wide(z - self.z)

    def of(self, rows: NDArray[np.intp]) -> "Inner":
        """Those of some rows."""
        return Inner(*(part[rows] for part in self))


def of_unit_moments(left: Array, right: Array) -> Inner:
    """Unit moments at both ends of a span, shape (row,); docs/theory/crankshaft, eq. (24.15)."""
    per_length = (1 / (right - left))[:, np.newaxis, np.newaxis]
    ends = np.array([-1.0, 1.0])[:, np.newaxis, np.newaxis] * np.eye(2)
    n_rows = left.size
    moment = np.zeros((n_rows, 2, 2, 2))
    moment[:, 0] = np.eye(2)
    return Inner(left, moment, ends * per_length[..., np.newaxis], np.zeros((n_rows, 2, 2)))


def unbent(n_rows: int) -> Bent:
    """The first end of a span, where it begins."""
    shape = (n_rows, 2, 2)
    return Bent(np.zeros((*shape, 2)), np.zeros((*shape, 2)), np.zeros(shape), np.zeros(shape))


def along_piece(start: Bent, inner: Inner, line: CrankLine, piece: int, z: Array, length: Array) -> Bent:
    """Go a length, shape (row,), along a piece from z.

    Notes
    -----
    docs/theory/crankshaft, eq. (24.16).
    """
    pieces, arm, way = line.pieces, line.axes[:, piece], _wide(length)
    shear, moment, stiffness = inner.shear, inner.moment_at(z), _wide(pieces.bending[:, piece])
    gained = (moment * way + shear * way**2 / 2) / stiffness
    bent = (moment * way**2 / 2 + shear * way**3 / 6) / stiffness
    turning = arm[..., 0] * shear[..., 1] - arm[..., 1] * shear[..., 0] - inner.torque
    twist = turning * way[..., 0] / _wide(pieces.torsion[:, piece])[..., 0]
    return Bent(
        start.shift + start.slope * way + bent - shear * way / _wide(pieces.shear[:, piece]),
        start.slope + gained,
        start.twist + twist,
        start.along,
    )


def along_web(start: Bent, inner: Inner, line: CrankLine, web: int, way: Array) -> Bent:
    """Go a way, shape (row,), along a web from its first end; not beyond its ends.

    Notes
    -----
    docs/theory/crankshaft, eq. (24.17).
    """
    first = line.axes[:, web]
    along, whole = web_line(line, web)
    before, after = line.webs.rigid[:, web, 0], line.webs.rigid[:, web, 1]
    begun = np.clip(way, 0.0, before)
    strained = np.clip(way - before, 0.0, np.maximum(whole - before - after, 0.0))
    rest = np.clip(way, 0.0, whole) - begun - strained
    at = displaced(start, along * _wide(begun), None)
    gives = _Gives(line.pieces.bounds[:, web + 1], first + along * _wide(begun), along, strained)
    return displaced(_strained(at, inner, line.webs, web, gives), along * _wide(rest), None)


def web_line(line: CrankLine, web: int) -> tuple[Array, Array]:
    """Direction of a web's line, shape (row, 1, 1, 2), none of a shoulder; and its length, shape (row,)."""
    across = line.axes[:, web + 1] - line.axes[:, web]
    length = np.hypot(across[..., 0], across[..., 1])
    return across / np.where(length > 0, length, 1.0)[..., np.newaxis], length[:, 0, 0]


class _Gives(NamedTuple):
    """What gives of a web: its plane, where it begins, its direction and its length."""

    z: Array
    begin: Array
    direction: Array
    length: Array


def _strained(start: Bent, inner: Inner, webs: Webs, web: int, gives: _Gives) -> Bent:
    """Go along what gives of a web."""
    bending, across, torsion, shear, axial = (
        values[:, web, np.newaxis, np.newaxis]
        for values in (webs.bending, webs.bending_across, webs.torsion, webs.shear, webs.axial)
    )
    along, way = gives.direction, gives.length[:, np.newaxis, np.newaxis]
    normal = _normal(along)
    force, moment = inner.shear, inner.moment_at(gives.z)
    force_along, force_across = _dot(force, along), _dot(force, normal)
    moment_along, moment_across = _dot(moment, along), _dot(moment, normal)
    turning = gives.begin[..., 0] * force[..., 1] - gives.begin[..., 1] * force[..., 0] - inner.torque
    swung = (turning * way**2 / 2 + force_across * way**3 / 6) / across
    aside = start.twist * way + swung - force_across * way / shear
    slope = (moment_along * way / bending)[..., np.newaxis] * along
    return Bent(
        start.shift + aside[..., np.newaxis] * normal - (force_along * way / axial)[..., np.newaxis] * along,
        start.slope + slope + (moment_across * way / torsion)[..., np.newaxis] * normal,
        start.twist + (turning * way + force_across * way**2 / 2) / across,
        start.along - _dot(start.slope, along) * way - moment_along * way**2 / (2 * bending),
    )


def displaced(at: Bent, arm: Array, z: Array | None) -> Bent:
    """What is fixed rigidly to a cross-section, at an arm, shape (row, 1, 1, 2), and by z along, shape (row,)."""
    shift = at.shift + at.twist[..., np.newaxis] * _normal(arm)
    if z is not None:
        shift = shift + at.slope * _wide(z)
    return Bent(shift, at.slope, at.twist, at.along - _dot(at.slope, arm))


def polar(radius: Array, angle: Array) -> Array:
    """Components, shape (design, member, 1, 1, 2), of shape (design, member)."""
    return np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=-1)[:, :, np.newaxis, np.newaxis]


def _wide(values: Array) -> Array:
    return values[:, np.newaxis, np.newaxis, np.newaxis]


def _normal(vector: Array) -> Array:
    """Turned by a right angle, from X toward Y."""
    return vector[..., ::-1] * _TURNED


_TURNED = np.array([-1.0, 1.0])


def _dot(one: Array, other: Array) -> Array:
    return one[..., 0] * other[..., 0] + one[..., 1] * other[..., 1]
