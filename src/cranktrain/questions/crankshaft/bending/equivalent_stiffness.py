"""The stiffness of the straight beam that bends as a throw does: one for each use, as no single one fits all."""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.grouping import places_of_equal
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.bent_spans import (
    CrankLine,
    Inner,
    along_piece,
    along_web,
    crank_line,
    unbent,
)
from cranktrain.questions.crankshaft.bending.designs_alike import Alike
from cranktrain.questions.crankshaft.bending.frame_spans import bent_spans
from cranktrain.questions.crankshaft.bending.shaft_loads import ActingPlaces
from cranktrain.questions.crankshaft.bending.walked_spans import span_by_span
from cranktrain.questions.crankshaft.metal.shaft import Crankshaft


class EquivalentStiffness(NamedTuple):
    """EI of straight spans that give as much, in the plane of a throw and across it, shape (design, throw, 2). [N·m²]

    Attributes
    ----------
    constant_moment : Array
        By the angle between both ends, under equal moments at both.
    near_end : Array
        By the rotation of the first end under a moment there.
    far_end : Array
        By the rotation of one end under a moment at the other.
    mid_pin : Array
        By the displacement under a force at the middle of the pin, of a straight span under one in the middle.
    """

    constant_moment: Array
    near_end: Array
    far_end: Array
    mid_pin: Array


class EndSlopes(NamedTuple):
    """Slope of each span's first end by a moment there and at the other end, and of its last by one there.

    Matrices of the shape (design, span, 2, 2). [rad/(N·m)]
    """

    near: Array
    far: Array
    last: Array


def end_slopes(shaft: Crankshaft) -> EndSlopes:
    """How the ends of spans turn, of designs whose webs lie between the same bearings."""
    alike = Alike(np.array([], dtype=np.intp), _spans_of_webs(shaft), is_isotropic=True, is_steady=True)
    bent = bent_spans(shaft, _no_loads(shaft.supports.place.shape[0]), alike)
    first, last = bent.first.slope, bent.last.slope
    return EndSlopes(-first[:, :, 0], -first[:, :, 1], last[:, :, 1])


def equivalent_stiffness(
    shaft: Crankshaft, ends: EndSlopes, spans: NDArray[np.intp], pins: NDArray[np.intp]
) -> EquivalentStiffness:
    """Stiffness of straight spans in place of throws.

    Parameters
    ----------
    shaft : Crankshaft
        Designs whose webs lie between the same bearings.
    ends : EndSlopes
        Of all spans, as `end_slopes` gives them.
    spans : array of int, shape (throw,)
        Between which bearings each throw is: this and the next.
    pins : array of int, shape (throw,)
        Which piece the pin of each is.

    Returns
    -------
    EquivalentStiffness

    Notes
    -----
    A force across the throw turns the pin about the shaft's axis as well: its torque goes on to the last end, which
    does not twist. docs/theory/crankshaft, eqs. (24.25) to (24.28).
    """
    length = _lengths(shaft)[:, spans, np.newaxis]
    near, far, last = (_along(values[:, spans], _axes(shaft.pieces.angle[:, pins])) for values in ends)
    return EquivalentStiffness(
        length / (near + last + 2 * far),
        length / (3 * near),
        length / (6 * far),
        length**3 / (48 * pin_displacement(shaft, spans, pins)),
    )


def straight_bending(shaft: Crankshaft, ends: EndSlopes) -> Array:
    """EI of the straight beams in place of spans, however many throws these have, shape (design, span).

    Parameters
    ----------
    shaft : Crankshaft
        Designs whose webs lie between the same bearings.
    ends : EndSlopes
        Of all spans, as `end_slopes` gives them.

    Returns
    -------
    Array, shape (design, span)
        The mean of its stiffness in both principal planes of the angle between its ends, under equal moments at both;
        so it is the same from whatever direction the shaft's angles count, and from whichever end.

    Notes
    -----
    docs/theory/crankshaft, eq. (24.25) in both principal planes.
    """
    near, far, last = ends
    bent = near + far + np.swapaxes(far, -1, -2) + last
    trace = bent[..., 0, 0] + bent[..., 1, 1]
    determinant = bent[..., 0, 0] * bent[..., 1, 1] - bent[..., 0, 1] * bent[..., 1, 0]
    return _lengths(shaft) * trace / (2 * determinant)


def pin_displacement(shaft: Crankshaft, spans: NDArray[np.intp], pins: NDArray[np.intp]) -> Array:
    """Displacement of pins' middles by a unit force there, in the throw's plane and across, shape (design, throw, 2).

    Parameters
    ----------
    shaft : Crankshaft
        Designs whose webs lie between the same bearings.
    spans, pins : array of int, shape (throw,)
        As `equivalent_stiffness` takes them.

    Returns
    -------
    Array, shape (design, throw, 2)
        [m/N]

    Notes
    -----
    docs/theory/crankshaft, eq. (24.28).
    """
    webs, line = _spans_of_webs(shaft), crank_line(shaft)
    first, end = (np.sum(webs <= which[:, np.newaxis], axis=-1) for which in (spans, spans + 1))
    shapes = zip((end - first).tolist(), (pins - first).tolist(), strict=True)
    found = np.empty((shaft.supports.place.shape[0], pins.size, 2))
    for (n_webs, pin), throws in places_of_equal(shapes).items():
        found[:, throws] = _displaced_pin(shaft, line, spans[throws], first[throws], n_webs + 1, pin)
    return found


def _displaced_pin(
    shaft: Crankshaft, line: CrankLine, spans: NDArray[np.intp], first: NDArray[np.intp], n_pieces: int, pin: int
) -> Array:
    """Displacement of the pins of some spans, each the piece of the same place among as many, (design, span, 2)."""
    own, bounds = span_by_span(line, shaft.supports.place, spans, first, n_pieces)
    left, right = bounds[0], bounds[-1]
    middle = 0.5 * (own.pieces.bounds[:, pin] + own.pieces.bounds[:, pin + 1])
    arm = own.axes[:, pin]
    before, behind = _of_unit_force(left, right, middle, arm)
    at = found = unbent(left.size)
    for piece, (z, until) in enumerate(pairwise(bounds)):
        inner = before if piece < pin else behind
        if piece == pin:
            at = found = along_piece(at, before, own, piece, z, middle - z)
            at = along_piece(at, inner, own, piece, middle, until - middle)
        else:
            at = along_piece(at, inner, own, piece, z, until - z)
        if piece < n_pieces - 1:
            at = along_web(at, inner, own, piece, np.full_like(left, np.inf))
    slope = -at.shift / (right - left)[:, np.newaxis, np.newaxis, np.newaxis]
    shift = found.shift + slope * (middle - left)[:, np.newaxis, np.newaxis, np.newaxis]
    twist = -at.twist[..., np.newaxis] * np.stack([-arm[..., 1], arm[..., 0]], axis=-1)
    moved = _along((shift + twist)[:, 0], _axes(own.pieces.angle[:, pin]))
    return moved.reshape(spans.size, -1, 2).swapaxes(0, 1)


def _of_unit_force(left: Array, right: Array, middle: Array, arm: Array) -> tuple[Inner, Inner]:
    """What a span gives on, before a unit force on the pin and behind it, where its torque goes."""
    both = np.eye(2)[np.newaxis, np.newaxis]
    share = ((right - middle) / (right - left))[:, np.newaxis, np.newaxis, np.newaxis]
    nothing = np.zeros_like(share * both)
    torque = arm[..., 0] * both[..., 1] - arm[..., 1] * both[..., 0]
    before = Inner(left, nothing, -share * both, np.zeros_like(torque))
    return before, Inner(middle, before.moment_at(middle), (1 - share) * both, torque)


def _lengths(shaft: Crankshaft) -> Array:
    return np.diff(shaft.supports.place, axis=1)


def _spans_of_webs(shaft: Crankshaft) -> NDArray[np.intp]:
    return np.sum(shaft.pieces.bounds[0, 1:-1, np.newaxis] > shaft.supports.place[0], axis=-1)


def _axes(angle: Array) -> Array:
    """Directions in the plane of throws and across it, shape (…, 2, component), of angles of the shape (…)."""
    return np.stack(
        [np.stack([np.cos(angle), np.sin(angle)], axis=-1), np.stack([np.sin(angle), -np.cos(angle)], axis=-1)], axis=-2
    )


def _along(matrix: Array, axes: Array) -> Array:
    """Own part of matrices, shape (…, 2, 2), in each of two directions."""
    by_component = axes[..., :, :, np.newaxis] * matrix[..., np.newaxis, :, :] * axes[..., :, np.newaxis, :]
    return np.sum(by_component, axis=(-2, -1))


def _no_loads(n_designs: int) -> ActingPlaces:
    nowhere = np.zeros((n_designs, 0))
    return ActingPlaces(np.array([], dtype=np.intp), np.array([], dtype=np.bool_), nowhere, nowhere, nowhere)
