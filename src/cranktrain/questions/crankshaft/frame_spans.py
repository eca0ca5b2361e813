"""Spans as crank frames: what moments at their ends and loads on journals, webs and pins do to them."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bent_spans import (
    Bent,
    CrankLine,
    along_piece,
    along_web,
    crank_line,
    displaced,
    of_unit_moments,
    polar,
    unbent,
    web_line,
)
from cranktrain.questions.crankshaft.blocks import applied, turned_by
from cranktrain.questions.crankshaft.designs_alike import Alike
from cranktrain.questions.crankshaft.shaft import Crankshaft
from cranktrain.questions.crankshaft.shaft_loads import ActingPlaces, ShaftLoads, torques
from cranktrain.questions.crankshaft.support_moments import SpanFlexibility


class BentSpan(NamedTuple):
    """A span under unit moments at its ends.

    Attributes
    ----------
    first, last : Bent
        Its ends.
    points : dict of int → Bent
        Where loads act that lie in it.
    """

    first: Bent
    last: Bent
    points: dict[int, Bent]


def frame_spans(bent: Sequence[BentSpan], thrust: int, loads: ShaftLoads, spans: NDArray[np.intp]) -> SpanFlexibility:
    """How crank frames bend, in axes that turn with the shaft.

    Parameters
    ----------
    bent : sequence of BentSpan
        As `bent_spans` gives them.
    thrust : int
        Which bearing takes axial forces, as in `Supports`.
    loads : ShaftLoads
    spans : array of int, shape (load,)
        As `spans_of` says.

    Returns
    -------
    SpanFlexibility
        NaN where a load acts on a piece that is not in its span.

    Notes
    -----
    docs/theory/crankshaft, eqs. (24.14) to (24.19).
    """
    slopes = _slopes_by_loads(bent, thrust % (len(bent) + 1), loads, spans)
    return SpanFlexibility(
        np.stack([_by_moment(-one.first.slope[:, 0]) for one in bent], axis=1),
        np.stack([_by_moment(-one.first.slope[:, 1]) for one in bent], axis=1),
        np.stack([_by_moment(one.last.slope[:, 1]) for one in bent], axis=1),
        np.stack([one[:, 0] for one in slopes], axis=1),
        np.stack([one[:, 1] for one in slopes], axis=1),
    )


def _by_moment(slope: Array) -> Array:
    """Slopes by the direction of the moment as a matrix that is applied to moments, shape (design, 2, 2, 1)."""
    return np.swapaxes(slope, -1, -2)[..., np.newaxis]


def bent_spans(shaft: Crankshaft, places: ActingPlaces, alike: Alike) -> list[BentSpan]:
    """Every span under unit moments at its ends, whatever the loads are that act at some places."""
    line = crank_line(shaft)
    return [bent_span(shaft, line, places, alike, span) for span in range(shaft.supports.place.shape[1] - 1)]


def bent_span(shaft: Crankshaft, line: CrankLine, loads: ActingPlaces, alike: Alike, span: int) -> BentSpan:
    """Go along a span, from its first bearing to its last, by where loads act.

    Notes
    -----
    docs/theory/crankshaft, eqs. (24.15) to (24.18).
    """
    left, right = shaft.supports.place[:, span], shaft.supports.place[:, span + 1]
    places = polar(loads.radius, loads.angle)
    inner, begin = of_unit_moments(left, right), int(np.sum(alike.webs <= span))
    end = int(np.sum(alike.webs <= span + 1))
    within = np.flatnonzero(alike.loads == span + 1).tolist()
    points: dict[int, Bent] = {}
    at, z = unbent(left.size), left
    for piece in range(begin, end + 1):
        until = right if piece == end else line.pieces.bounds[:, piece + 1]
        axis = line.axes[:, piece]
        for load in (one for one in within if loads.piece[one] == piece and not loads.on_web[one]):
            way = np.clip(loads.z[:, load] - z, 0.0, until - z)
            here = along_piece(at, inner, line, piece, z, way)
            points[load] = displaced(here, places[:, load] - axis, loads.z[:, load] - z - way)
        at, z = along_piece(at, inner, line, piece, z, until - z), until
        if piece < end:
            along, length = web_line(line, piece)
            for load in (one for one in within if loads.piece[one] == piece and loads.on_web[one]):
                arm = places[:, load] - axis
                way = np.clip(np.sum(arm * along, axis=-1)[:, 0, 0], 0.0, length)
                here = along_web(at, inner, line, piece, way)
                rest = arm - along * way[:, np.newaxis, np.newaxis, np.newaxis]
                points[load] = displaced(here, rest, loads.z[:, load] - z)
            at = along_web(at, inner, line, piece, length)
    to_right = shaft.supports.thrust % shaft.supports.place.shape[1] > span
    return _held(unbent(left.size), at, points, loads.z, places, left, right, holds_right=to_right)


def _held(
    first: Bent,
    last: Bent,
    points: dict[int, Bent],
    z: Array,
    places: Array,
    left: Array,
    right: Array,
    *,
    holds_right: bool,
) -> BentSpan:
    """Turn and shift the whole span so that both ends stay at their bearings.

    Its last end does not twist, as torque goes on to the flywheel; and that end does not move along which is toward the
    thrust bearing.
    """
    slope = -last.shift / _wide(right - left)
    twist, along = -last.twist, -last.along if holds_right else np.zeros_like(last.along)
    rigid = Bent(np.zeros_like(slope), slope, twist, along)

    def moved(one: Bent, arm: Array, at: Array) -> Bent:
        added = displaced(rigid, arm, at - left)
        return Bent(*(own + gained for own, gained in zip(one, added, strict=True)))

    axis = np.zeros((left.size, 1, 1, 2))
    return BentSpan(
        moved(first, axis, left),
        moved(last, axis, right),
        {load: moved(one, places[:, load], z[:, load]) for load, one in points.items()},
    )


def _slopes_by_loads(bent: Sequence[BentSpan], thrust: int, loads: ShaftLoads, spans: NDArray[np.intp]) -> list[Array]:
    """Rotations of both ends of every span by loads, each of shape (design, end, 2, angle)."""
    force = turned_by(loads.force, loads.turned)
    couple = None if loads.couple is None else turned_by(loads.couple, loads.turned)
    about_axis = torques(loads)
    slopes: list[Array] = []
    for span, one in enumerate(bent):
        through = _passing(about_axis, spans <= span)
        slope = one.first.twist[..., np.newaxis] * through
        if loads.thrust is not None:
            end, sides = (one.first, spans <= span) if thrust > span else (one.last, spans > span + 1)
            slope = slope + end.along[..., np.newaxis] * _passing(loads.thrust, sides)
        for load in np.flatnonzero(spans == span + 1).tolist():
            if load not in one.points:
                slope = slope * np.nan
                continue
            at = one.points[load]
            slope = slope + applied(at.shift[..., np.newaxis], force[:, np.newaxis, load])
            if couple is not None:
                slope = slope + applied(at.slope[..., np.newaxis], couple[:, np.newaxis, load])
            if loads.torque is not None:
                slope = slope + at.twist[..., np.newaxis] * loads.torque[:, load, np.newaxis, np.newaxis]
            if loads.thrust is not None:
                slope = slope + at.along[..., np.newaxis] * loads.thrust[:, load, np.newaxis, np.newaxis]
        slopes.append(slope)
    return slopes


def _passing(values: Array, passes: NDArray[np.bool_]) -> Array:
    """Sum of what passes a span, one after another, shape (design, 1, 1, angle)."""
    total = np.zeros_like(values[:, 0] if values.shape[1] else values.sum(axis=1))
    for load in np.flatnonzero(passes).tolist():
        total = total + values[:, load]
    return total[:, np.newaxis, np.newaxis]


def _wide(values: Array) -> Array:
    return values[:, np.newaxis, np.newaxis, np.newaxis]
