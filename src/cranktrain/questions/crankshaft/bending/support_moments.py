"""Bending moments of a continuous shaft over its bearings: equations of three moments, of five where bearings give."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.bearing_loads import end_moments
from cranktrain.questions.crankshaft.bending.blocks import applied, band_solution, transposed
from cranktrain.questions.crankshaft.bending.cut_shaft import CutShaft


class SpanFlexibility(NamedTuple):
    """How a span bends, as a simple beam between two bearings, in any axes across the shaft.

    Attributes
    ----------
    first, last : Array, shape (design, bearing − 1, 2, 2, angle or 1)
        Rotation of an end for a unit moment there, of the first and the last end. [rad/(N·m)]
    cross : Array, likewise
        Rotation of the first end for a unit moment at the last one.
    first_slope, last_slope : Array, shape (design, bearing − 1, 2, angle)
        Rotations of both ends by the loads; as those by moments, positive where these are. [rad]
    """

    first: Array
    cross: Array
    last: Array
    first_slope: Array
    last_slope: Array


class Bearings(NamedTuple):
    """Where bearings stand and how they give, in the axes of the spans.

    Attributes
    ----------
    place : Array, shape (design, bearing)
    settlement : Array, shape (design, bearing, 2, angle or 1)
    compliance : Array, shape (design, bearing, 2, 2, angle or 1), or None
        None where they are rigid.
    """

    place: Array
    settlement: Array
    compliance: Array | None


def support_moments(bearings: Bearings, spans: SpanFlexibility, cut: CutShaft) -> Array:
    """Bending moments over all bearings.

    Parameters
    ----------
    bearings : Bearings
    spans : SpanFlexibility
    cut : CutShaft

    Returns
    -------
    Array, shape (design, bearing, 2, angle)
        Those of what hangs over among them. [N·m]

    Notes
    -----
    The two ends that meet over a bearing turn alike. With a rigid or isotropic bearing no coefficient depends on the
    angle, and the elimination is of one angle. docs/theory/crankshaft, eqs. (24.8) to (24.10).
    """
    n = bearings.place.shape[1]
    moments = end_moments(n, cut)
    if n < 3:
        return moments
    matrices, right = _of_spans(spans, moments)
    shares = _shares(bearings.place)
    free = bearings.settlement
    if bearings.compliance is not None:
        _add_bearings(matrices, shares, bearings.compliance)
        free = free - applied(bearings.compliance, _with_end_moments(cut.reaction, shares, moments))
    for row in range(n - 2):
        for bearing in range(row, row + 3):
            right[row] = right[row] + shares[row + 1, bearing] * free[:, bearing]
    for row, moment in enumerate(band_solution(matrices, right)):
        moments[:, row + 1] = moment
    return moments


def _of_spans(spans: SpanFlexibility, moments: Array) -> tuple[dict[tuple[int, int], Array], list[Array]]:
    """Blocks and right sides of rigid bearings in line: a row for each bearing between the outer ones."""
    n_rows = moments.shape[1] - 2
    matrices: dict[tuple[int, int], Array] = {}
    right: list[Array] = []
    for row in range(n_rows):
        matrices[row, row] = spans.last[:, row] + spans.first[:, row + 1]
        if row + 1 < n_rows:
            matrices[row, row + 1] = spans.cross[:, row + 1]
        right.append(-(spans.last_slope[:, row] + spans.first_slope[:, row + 1]))
    right[0] = right[0] - applied(transposed(spans.cross[:, 0]), moments[:, 0])
    right[-1] = right[-1] - applied(spans.cross[:, -1], moments[:, -1])
    return matrices, right


def _shares(place: Array) -> dict[tuple[int, int], Array]:
    """What the moment over one bearing adds to the reaction of another, shape (design, 1, 1). [1/m]"""
    per_length = (1 / np.diff(place, axis=1))[:, :, np.newaxis, np.newaxis]
    shares = {(bearing, bearing): np.zeros_like(per_length[:, 0]) for bearing in range(place.shape[1])}
    for span in range(per_length.shape[1]):
        for one, other in ((span, span + 1), (span + 1, span)):
            shares[one, other] = per_length[:, span]
            shares[one, one] = shares[one, one] - per_length[:, span]
    return shares


def _add_bearings(
    matrices: dict[tuple[int, int], Array], shares: dict[tuple[int, int], Array], compliance: Array
) -> None:
    """Add how bearings give: each joins the moments over itself and its neighbours."""
    n = compliance.shape[1]
    for row in range(n - 2):
        for column in range(row, min(row + 3, n - 2)):
            for bearing in range(column, row + 3):
                by_one, by_other = shares[row + 1, bearing], shares[column + 1, bearing]
                added = (by_one * by_other)[..., np.newaxis] * compliance[:, bearing]
                matrices[row, column] = matrices[row, column] + added if (row, column) in matrices else added


def _with_end_moments(reaction: Array, shares: dict[tuple[int, int], Array], moments: Array) -> Array:
    """Reactions with what the moments of what hangs over add to them."""
    found = reaction.copy()
    last = reaction.shape[1] - 1
    for end, neighbour in ((0, 1), (last, last - 1)):
        for bearing in (end, neighbour):
            found[:, bearing] += shares[end, bearing] * moments[:, end]
    return found
