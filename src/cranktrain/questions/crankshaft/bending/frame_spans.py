"""Spans as crank frames: what moments at their ends and loads on journals, webs and pins do to them."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.grouping import grouped
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.bent_spans import Bent, crank_line
from cranktrain.questions.crankshaft.bending.blocks import applied, turned_by
from cranktrain.questions.crankshaft.bending.designs_alike import Alike
from cranktrain.questions.crankshaft.bending.shaft_loads import ActingPlaces, ShaftLoads, torques
from cranktrain.questions.crankshaft.bending.support_moments import SpanFlexibility
from cranktrain.questions.crankshaft.bending.walked_spans import walked_spans
from cranktrain.questions.crankshaft.metal.shaft import Crankshaft


class BentSpans(NamedTuple):
    """Spans under unit moments at their ends.

    Attributes
    ----------
    first, last : Bent
        Their ends, arrays of the shape (design, span, …).
    points : dict of int → Bent
        Where loads act that lie in them, arrays of the shape (design, …).
    """

    first: Bent
    last: Bent
    points: dict[int, Bent]


def frame_spans(bent: BentSpans, thrust: int, loads: ShaftLoads, spans: NDArray[np.intp]) -> SpanFlexibility:
    """How crank frames bend, in axes that turn with the shaft.

    Parameters
    ----------
    bent : BentSpans
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
    first, last = bent.first.slope, bent.last.slope
    slopes = _slopes_by_loads(bent, thrust % (first.shape[1] + 1), loads, spans)
    return SpanFlexibility(
        _by_moment(-first[:, :, 0]),
        _by_moment(-first[:, :, 1]),
        _by_moment(last[:, :, 1]),
        np.stack([one[:, 0] for one in slopes], axis=1),
        np.stack([one[:, 1] for one in slopes], axis=1),
    )


def _by_moment(slope: Array) -> Array:
    """Slopes by the direction of the moment as a matrix that is applied to moments, shape (design, span, 2, 2, 1)."""
    return np.swapaxes(slope, -1, -2)[..., np.newaxis]


def bent_spans(shaft: Crankshaft, places: ActingPlaces, alike: Alike) -> BentSpans:
    """Every span under unit moments at its ends, whatever the loads are that act at some places.

    Notes
    -----
    docs/theory/crankshaft, eqs. (24.15) to (24.18).
    """
    line, (n_designs, n_bearings) = crank_line(shaft), shaft.supports.place.shape
    n_webs = ((int(np.sum(alike.webs == span + 1)), span) for span in range(n_bearings - 1))
    order: list[int] = []
    ends: list[tuple[Bent, Bent]] = []
    points: dict[int, Bent] = {}
    for spans in grouped(n_webs).values():
        walked = walked_spans(line, shaft.supports, alike.webs, np.array(spans, dtype=np.intp))
        order += spans
        ends.append(walked.ends())
        points |= walked.points(places, alike.loads)
    first, last = (_by_span(each, order, n_designs) for each in zip(*ends, strict=True))
    return BentSpans(first, last, points)


def _by_span(each: Sequence[Bent], spans: Sequence[int], n_designs: int) -> Bent:
    """Those of all spans side by side, of the shape (design, span, …)."""
    place = np.argsort(spans)
    rows = (np.concatenate(parts) for parts in zip(*each, strict=True))
    return Bent(*(part.reshape(len(spans), n_designs, *part.shape[1:])[place].swapaxes(0, 1) for part in rows))


def _slopes_by_loads(bent: BentSpans, thrust: int, loads: ShaftLoads, spans: NDArray[np.intp]) -> list[Array]:
    """Rotations of both ends of every span by loads, each of shape (design, end, 2, angle)."""
    force = turned_by(loads.force, loads.turned)
    couple = None if loads.couple is None else turned_by(loads.couple, loads.turned)
    about_axis = torques(loads, force)
    slopes: list[Array] = []
    for span in range(bent.first.twist.shape[1]):
        through = _passing(about_axis, spans <= span)
        slope = bent.first.twist[:, span, ..., np.newaxis] * through
        if loads.thrust is not None:
            end, sides = (bent.first, spans <= span) if thrust > span else (bent.last, spans > span + 1)
            slope = slope + end.along[:, span, ..., np.newaxis] * _passing(loads.thrust, sides)
        for load in np.flatnonzero(spans == span + 1).tolist():
            if load not in bent.points:
                slope = slope * np.nan
                continue
            at = bent.points[load]
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
