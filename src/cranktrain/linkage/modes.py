"""All the ways in which a triad can be put together at one crank angle."""

from itertools import combinations
from typing import NamedTuple

import numpy as np

from cranktrain.linkage.triad import Leg, Pose, Triad, TriadDriver, TriadEnds, triad
from cranktrain.motion import Array, Link
from cranktrain.numerics import turn_grid
from cranktrain.numerics.harmonics import ComplexArray

_HIGHEST = 3  # multiple of the link's angle in the equation for it
_SAMPLES = 16
_NOTHING = 1e-13  # of the largest coefficient
_ALIKE = 1e-6  # of the link's radius, and radians


class _PlaneLeg(NamedTuple):
    """A leg in complex numbers: its point on the link and its end, length or shift, kind, left normal of a guide."""

    point: complex
    end: complex
    length: float
    is_guide: bool
    normal: complex


class _Line(NamedTuple):
    """A line on which the first leg's point P lies, n·P = b."""

    normal: ComplexArray
    level: Array


def triad_modes(ends: TriadEnds, geometry: Triad) -> Pose:
    """Every pose in which the legs close: at most six with two or three rods, four with one, two with guides alone.

    Parameters
    ----------
    ends : TriadEnds, coefficients of one crank angle: numbers
    geometry : Triad, fields numbers

    Returns
    -------
    Pose, shape (n_modes,)
        By rising angle in (−π, π]. Empty where the legs cannot close.

    Notes
    -----
    One leg's point is eliminated; what remains is a polynomial in exp iθ, of sixth degree at most, whose coefficients
    come from samples by their Fourier transform. Every root's angle, with every position that two legs allow there, is
    offered to the kernel as a start: what it closes is a mode. docs/theory/groups-2, eqs. (7.20) to (7.23).
    """
    pairs = zip(ends, geometry, strict=True)
    legs = sorted((_plane_leg(end, leg) for end, leg in pairs), key=lambda leg: leg.is_guide)
    with np.errstate(all="ignore"):
        angle = _possible_angles(legs)
        positions = np.stack(_positions(legs, angle)) - legs[0].point * np.exp(1j * angle)
        start = Pose(positions.real, positions.imag, np.broadcast_to(angle, positions.shape))
        link = triad(TriadDriver(ends, start), geometry).link
    size = max(abs(leg.point) for leg in legs)
    found = np.stack([link.origin.x.value, link.origin.y.value, link.angle.value]).reshape(3, -1)
    return _different(found[:, ~np.isnan(found[0])], size)


def _plane_leg(end: Link, leg: Leg) -> _PlaneLeg:
    return _PlaneLeg(
        complex(leg.point.radius * np.exp(1j * leg.point.angle)),
        complex(end.origin.x.value, end.origin.y.value),
        float(leg.length),
        bool(leg.kind == 1.0),
        complex(-end.sin, end.cos),
    )


def _dot(one: ComplexArray, other: ComplexArray) -> Array:
    return np.real(np.conj(one) * other)


def _line(leg: _PlaneLeg, first: _PlaneLeg, angle: Array) -> _Line:
    """Take a guide as it is, and of a rod's equation the difference from the first rod's: the squares cancel."""
    vector = (leg.point - first.point) * np.exp(1j * angle) - leg.end  # the leg, counted from the first leg's point
    if leg.is_guide:
        normal = np.full_like(vector, leg.normal)
        return _Line(normal, leg.length - _dot(normal, vector))
    squares = leg.length**2 - first.length**2 - np.abs(vector) ** 2 + abs(first.end) ** 2
    return _Line(vector + first.end, 0.5 * squares)


def _crossing(one: _Line, other: _Line) -> tuple[ComplexArray, Array]:
    """Point where two lines cross, times the cross product of their normals, and that product."""
    return 1j * (other.level * one.normal - one.level * other.normal), np.imag(np.conj(one.normal) * other.normal)


def _condition(legs: list[_PlaneLeg], angle: Array) -> Array:
    """Zero where the first leg's point, put where the other two legs hold it, is where the first leg holds it."""
    first, second, third = legs
    point, product = _crossing(_line(second, first, angle), _line(third, first, angle))
    vector = point - first.end * product
    if first.is_guide:
        return _dot(np.full_like(vector, first.normal), vector) - first.length * product
    return np.abs(vector) ** 2 - (first.length * product) ** 2


def _possible_angles(legs: list[_PlaneLeg]) -> Array:
    """Arguments of the roots of the condition's polynomial: those near the unit circle can be modes."""
    samples = _condition(legs, turn_grid(_SAMPLES))
    coefficients = np.fft.fft(samples)[np.arange(_HIGHEST, -_HIGHEST - 1, -1)]
    size = np.abs(coefficients)
    roots = np.roots(np.where(size > _NOTHING * np.max(size), coefficients, 0.0))
    return np.arctan2(roots.imag, roots.real)


def _positions(legs: list[_PlaneLeg], angle: Array) -> list[ComplexArray]:
    """Where two legs at a time can hold the first leg's point, at a given angle of the link."""
    first = legs[0]
    if first.is_guide:
        crossings = (_crossing(*pair) for pair in combinations([_line(leg, first, angle) for leg in legs], 2))
        return [point / product for point, product in crossings]
    positions: list[ComplexArray] = []
    for normal, level in (_line(leg, first, angle) for leg in legs[1:]):
        square = np.abs(normal) ** 2
        distance = level - _dot(normal, np.full_like(normal, first.end))
        half_chord = np.sqrt(np.maximum(first.length**2 * square - distance**2, 0.0))
        positions += [first.end + normal * (distance + 1j * sign * half_chord) / square for sign in (-1.0, 1.0)]
    return positions


def _different(found: Array, size: float) -> Pose:
    """One of each, in order of the angle."""
    kept: list[Array] = []
    for pose in found.T[np.argsort(found[2], kind="stable")]:
        change = np.array(kept) - pose if kept else np.empty((0, 3))
        change[:, 2] = size * (change[:, 2] - 2 * np.pi * np.round(change[:, 2] / (2 * np.pi)))
        if not np.any(np.all(np.abs(change) < _ALIKE * size, axis=1)):
            kept.append(pose)
    x, y, angle = np.array(kept).reshape(-1, 3).T
    return Pose(x, y, angle)
