"""The stiffness of the straight beam that bends as a throw does: one for each use, as no single one fits all."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bent_spans import Inner, along_piece, along_web, crank_line, unbent
from cranktrain.questions.crankshaft.designs_alike import Alike
from cranktrain.questions.crankshaft.frame_spans import bent_span
from cranktrain.questions.crankshaft.shaft import Crankshaft
from cranktrain.questions.crankshaft.shaft_loads import ActingPlaces


class EquivalentStiffness(NamedTuple):
    """EI of a straight span that gives as much, in the plane of a throw and across it, shape (design, 2). [N·m²]

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
    """Slope of a span's first end by a moment there and at the other end, and of its last by one there.

    Matrices of the shape (design, 2, 2). [rad/(N·m)]
    """

    near: Array
    far: Array
    last: Array


def end_slopes(shaft: Crankshaft, span: int) -> EndSlopes:
    """How the ends of a span turn, of designs whose webs lie between the same bearings."""
    alike = Alike(np.array([], dtype=np.intp), _spans_of_webs(shaft), is_isotropic=True)
    none = _no_loads(shaft.supports.place.shape[0])
    bent = bent_span(shaft, crank_line(shaft), none, alike, span)
    return EndSlopes(-bent.first.slope[:, 0], -bent.first.slope[:, 1], bent.last.slope[:, 1])


def equivalent_stiffness(shaft: Crankshaft, ends: EndSlopes, span: int, pin: int) -> EquivalentStiffness:
    """Stiffness of a straight span in place of a throw.

    Parameters
    ----------
    shaft : Crankshaft
        Designs whose webs lie between the same bearings.
    ends : EndSlopes
        Of the span, as `end_slopes` gives them.
    span : int
        Between which bearings: this and the next.
    pin : int
        Which piece the pin is.

    Returns
    -------
    EquivalentStiffness

    Notes
    -----
    A force across the throw turns the pin about the shaft's axis as well: its torque goes on to the last end, which
    does not twist. docs/theory/crankshaft, eqs. (24.25) to (24.28).
    """
    length = _length(shaft, span)[:, np.newaxis]
    near, far, last = (_along(values, _axes(shaft.pieces.angle[:, pin])) for values in ends)
    return EquivalentStiffness(
        length / (near + last + 2 * far),
        length / (3 * near),
        length / (6 * far),
        length**3 / (48 * pin_displacement(shaft, span, pin)),
    )


def straight_bending(shaft: Crankshaft, ends: EndSlopes, span: int) -> Array:
    """EI of the straight beam in place of a span, however many throws it has, shape (design,). [N·m²]

    Parameters
    ----------
    shaft : Crankshaft
        Designs whose webs lie between the same bearings.
    ends : EndSlopes
        Of the span, as `end_slopes` gives them.
    span : int
        Between which bearings: this and the next.

    Returns
    -------
    Array, shape (design,)
        The mean of its stiffness in both principal planes of the angle between its ends, under equal moments at both;
        so it is the same from whatever direction the shaft's angles count, and from whichever end.

    Notes
    -----
    docs/theory/crankshaft, eq. (24.25) in both principal planes.
    """
    near, far, last = ends
    bent = near + far + np.swapaxes(far, -1, -2) + last
    trace = bent[:, 0, 0] + bent[:, 1, 1]
    determinant = bent[:, 0, 0] * bent[:, 1, 1] - bent[:, 0, 1] * bent[:, 1, 0]
    return _length(shaft, span) * trace / (2 * determinant)


def pin_displacement(shaft: Crankshaft, span: int, pin: int) -> Array:
    """Displacement of a pin's middle by a unit force there, in the throw's plane and across, shape (design, 2). [m/N]

    Notes
    -----
    docs/theory/crankshaft, eq. (24.28).
    """
    webs = _spans_of_webs(shaft)
    begin, end = (int(np.sum(webs <= which)) for which in (span, span + 1))
    left, right = shaft.supports.place[:, span], shaft.supports.place[:, span + 1]
    middle = 0.5 * (shaft.pieces.bounds[:, pin] + shaft.pieces.bounds[:, pin + 1])
    line = crank_line(shaft)
    arm = line.axes[:, pin]
    before, after = _of_unit_force(left, right, middle, arm)
    at, z, found = unbent(left.size), left, unbent(left.size)
    for piece in range(begin, end + 1):
        until = right if piece == end else shaft.pieces.bounds[:, piece + 1]
        inner = before if piece < pin else after
        if piece == pin:
            at = found = along_piece(at, before, line, piece, z, middle - z)
            z = middle
        at, z = along_piece(at, inner, line, piece, z, until - z), until
        if piece < end:
            at = along_web(at, inner, line, piece, np.full_like(left, np.inf))
    slope = -at.shift / (right - left)[:, np.newaxis, np.newaxis, np.newaxis]
    shift = found.shift + slope * (middle - left)[:, np.newaxis, np.newaxis, np.newaxis]
    twist = -at.twist[..., np.newaxis] * np.stack([-arm[..., 1], arm[..., 0]], axis=-1)
    return _along((shift + twist)[:, 0], _axes(shaft.pieces.angle[:, pin]))


def _of_unit_force(left: Array, right: Array, middle: Array, arm: Array) -> tuple[Inner, Inner]:
    """What a span gives on, before a unit force on the pin and behind it, where its torque goes."""
    both = np.eye(2)[np.newaxis, np.newaxis]
    share = ((right - middle) / (right - left))[:, np.newaxis, np.newaxis, np.newaxis]
    nothing = np.zeros_like(share * both)
    torque = arm[..., 0] * both[..., 1] - arm[..., 1] * both[..., 0]
    before = Inner(left, nothing, -share * both, np.zeros_like(torque))
    return before, Inner(middle, before.moment_at(middle), (1 - share) * both, torque)


def _length(shaft: Crankshaft, span: int) -> Array:
    place = shaft.supports.place
    return place[:, span + 1] - place[:, span]


def _spans_of_webs(shaft: Crankshaft) -> NDArray[np.intp]:
    return np.sum(shaft.pieces.bounds[0, 1:-1, np.newaxis] > shaft.supports.place[0], axis=-1)


def _axes(angle: Array) -> Array:
    """Directions in the plane of a throw and across it, shape (design, 2, component)."""
    return np.stack(
        [np.stack([np.cos(angle), np.sin(angle)], axis=-1), np.stack([np.sin(angle), -np.cos(angle)], axis=-1)], axis=1
    )


def _along(matrix: Array, axes: Array) -> Array:
    """Own part of matrices, shape (design, 2, 2), in each of two directions."""
    return np.sum(axes[:, :, :, np.newaxis] * matrix[:, np.newaxis] * axes[:, :, np.newaxis, :], axis=(-2, -1))


def _no_loads(n_designs: int) -> ActingPlaces:
    nowhere = np.zeros((n_designs, 0))
    return ActingPlaces(np.array([], dtype=np.intp), np.array([], dtype=np.bool_), nowhere, nowhere, nowhere)
