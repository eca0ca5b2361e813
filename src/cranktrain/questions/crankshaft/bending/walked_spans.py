"""Crank frames gone along from bearing to bearing: spans of as many pieces side by side, and the loads in them."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.bent_spans import (
    Bent,
    CrankLine,
    Inner,
    along_piece,
    along_web,
    displaced,
    of_unit_moments,
    polar,
    unbent,
    web_line,
)
from cranktrain.questions.crankshaft.bending.shaft_loads import ActingPlaces
from cranktrain.questions.crankshaft.metal.shaft import Supports


class WalkedSpans(NamedTuple):
    """Spans of as many pieces under unit moments at their ends; a row is a span of one design, span by span.

    Attributes
    ----------
    line : CrankLine
        Of the shaft, of all designs.
    spans : array of int, shape (span,)
        Which they are, rising.
    first : array of int, shape (span,)
        The piece with which each begins.
    bounds : Array, shape (piece + 1, row)
        z of the left bearing, of the middle of every web, and of the right bearing.
    inner : Inner
        What each hands on.
    pieces, webs : Bent
        Where pieces and webs begin, arrays of the shape (piece, row, …), (web, row, …).
    end : Bent
        Where spans end.
    rigid : Bent
        How far a span turns and shifts as a whole, so that both ends stay at their bearings.
    """

    line: CrankLine
    spans: NDArray[np.intp]
    first: NDArray[np.intp]
    bounds: Array
    inner: Inner
    pieces: Bent
    webs: Bent
    end: Bent
    rigid: Bent

    def ends(self) -> tuple[Bent, Bent]:
        """Both ends of spans."""
        left, right = self.bounds[0], self.bounds[-1]
        axis = np.zeros((left.size, 1, 1, 2))
        rows = np.arange(left.size, dtype=np.intp)
        return self._held(unbent(left.size), rows, axis, left), self._held(self.end, rows, axis, right)

    def points(self, places: ActingPlaces, between: NDArray[np.intp]) -> dict[int, Bent]:
        """Where loads act that lie in these spans, arrays of the shape (design, …).

        Parameters
        ----------
        places : ActingPlaces
        between : array of int, shape (load,)
            Between which bearings each lies, as `spans_of` says.

        Returns
        -------
        dict of int → Bent
            Without loads on what is not in their span.
        """
        is_own = np.isin(between - 1, self.spans)
        slot = np.searchsorted(self.spans, np.where(is_own, between - 1, self.spans[0]))
        part = places.piece - self.first[slot]
        found: dict[int, Bent] = {}
        for on_web, begins, at in ((False, self.pieces, self._on_pieces), (True, self.webs, self._on_webs)):
            loads = np.flatnonzero(is_own & (places.on_web == on_web) & (part >= 0) & (part < len(begins.twist)))
            if loads.size:
                here = at(places, loads, slot[loads], part[loads])
                of_loads = (values.reshape(loads.size, -1, *values.shape[1:]) for values in here)
                found |= {load: Bent(*own) for load, *own in zip(loads.tolist(), *of_loads, strict=True)}
        return found

    def _on_pieces(
        self, places: ActingPlaces, loads: NDArray[np.intp], slot: NDArray[np.intp], piece: NDArray[np.intp]
    ) -> Bent:
        """Where loads act on pieces: fixed to the section in which they stand, or to the nearest end of their piece."""
        load, rows, designs, piece = self._rows(loads, slot, piece)
        part = self.line.part(designs, places.piece[load], 1)
        begin, end, z = self.bounds[piece, rows], self.bounds[piece + 1, rows], places.z[designs, load]
        way = np.clip(z - begin, 0.0, end - begin)
        here = along_piece(self.pieces.of((piece, rows)), self.inner.of(rows), part, 0, begin, way)
        arm = polar(places.radius, places.angle)[designs, load]
        return self._held(displaced(here, arm - part.axes[:, 0], z - begin - way), rows, arm, z)

    def _on_webs(
        self, places: ActingPlaces, loads: NDArray[np.intp], slot: NDArray[np.intp], web: NDArray[np.intp]
    ) -> Bent:
        """Where loads act on webs: fixed to the section of the web's line that they are beside."""
        load, rows, designs, web = self._rows(loads, slot, web)
        part = self.line.part(designs, places.piece[load], 2)
        arm = polar(places.radius, places.angle)[designs, load]
        aside, (along, length) = arm - part.axes[:, 0], web_line(part, 0)
        way = np.clip(np.sum(aside * along, axis=-1)[:, 0, 0], 0.0, length)
        here = along_web(self.webs.of((web, rows)), self.inner.of(rows), part, 0, way)
        z = places.z[designs, load]
        rest = aside - along * way[:, np.newaxis, np.newaxis, np.newaxis]
        return self._held(displaced(here, rest, z - self.bounds[web + 1, rows]), rows, arm, z)

    def _rows(
        self, loads: NDArray[np.intp], slot: NDArray[np.intp], part: NDArray[np.intp]
    ) -> tuple[NDArray[np.intp], NDArray[np.intp], NDArray[np.intp], NDArray[np.intp]]:
        """Each load once for every design: which it is, its row of these spans, its design, its piece or web."""
        n_designs = self.bounds.shape[1] // self.spans.size
        design = np.arange(n_designs, dtype=np.intp)
        rows: NDArray[np.intp] = slot[:, np.newaxis] * n_designs + design
        return np.repeat(loads, n_designs), rows.ravel(), np.tile(design, loads.size), np.repeat(part, n_designs)

    def _held(self, at: Bent, rows: NDArray[np.intp], arm: Array, z: Array) -> Bent:
        """What is at an arm from the axis and at z, in spans of which both ends stay at their bearings."""
        added = displaced(self.rigid.of(rows), arm, z - self.bounds[0, rows])
        return Bent(*(own + gained for own, gained in zip(at, added, strict=True)))


def walked_spans(line: CrankLine, supports: Supports, webs: NDArray[np.intp], spans: NDArray[np.intp]) -> WalkedSpans:
    """Go along spans with as many webs each.

    Parameters
    ----------
    line : CrankLine
    supports : Supports
    webs : array of int, shape (web,)
        Between which bearings each lies, as `spans_of` says.
    spans : array of int, shape (span,)
        Rising.
    """
    n_designs, n_bearings = supports.place.shape
    first = np.sum(webs <= spans[:, np.newaxis], axis=-1)
    n_pieces = int(np.sum(webs == spans[0] + 1)) + 1
    own, bounds = span_by_span(line, supports.place, spans, first, n_pieces)
    left, right = bounds[0], bounds[-1]
    inner, at = of_unit_moments(left, right), unbent(left.size)
    pieces: list[Bent] = []
    before_webs: list[Bent] = []
    for piece in range(n_pieces):
        pieces.append(at)
        at = along_piece(at, inner, own, piece, bounds[piece], bounds[piece + 1] - bounds[piece])
        if piece < n_pieces - 1:
            before_webs.append(at)
            at = along_web(at, inner, own, piece, np.full_like(left, np.inf))
    # The last end does not twist, as torque goes on to the flywheel; and that end does not move along which is toward
    # the thrust bearing.
    slope = -at.shift / (right - left)[:, np.newaxis, np.newaxis, np.newaxis]
    holds_right = np.repeat(supports.thrust % n_bearings > spans, n_designs)
    along = np.where(holds_right[:, np.newaxis, np.newaxis], -at.along, 0.0)
    rigid = Bent(np.zeros_like(slope), slope, -at.twist, along)
    return WalkedSpans(line, spans, first, np.stack(bounds), inner, _stacked(pieces), _stacked(before_webs), at, rigid)


def span_by_span(
    line: CrankLine, place: Array, spans: NDArray[np.intp], first: NDArray[np.intp], n_pieces: int
) -> tuple[CrankLine, list[Array]]:
    """Lines of spans with as many pieces each, from a first one on, a row for each design; and z of their bounds.

    Bounds are the left bearing, the middle of every web, and the right bearing.
    """
    n_designs = len(place)
    own = line.part(np.tile(np.arange(n_designs, dtype=np.intp), spans.size), np.repeat(first, n_designs), n_pieces)
    left, right = (place[:, which].T.ravel() for which in (spans, spans + 1))
    return own, [left, *own.pieces.bounds[:, 1:-1].T, right]


def _stacked(each: Sequence[Bent]) -> Bent:
    """One behind another; of none, none."""
    return Bent(*(np.stack(parts) for parts in zip(*each, strict=True))) if each else unbent(0)
