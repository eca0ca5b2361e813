"""ClosingOfMany margin: how little one length may change before the crank cannot turn; and where links cannot close."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.mechanisms.kind import Geometry, Kind, Motion, Openings, named_part, rows
from cranktrain.motion import Array
from cranktrain.numerics import Extreme, bracketed_roots, near_roots, smallest, turn_grid
from cranktrain.numerics.nested import each_changed, leaves, mapped
from cranktrain.numerics.ties import first_largest_along

if TYPE_CHECKING:
    from cranktrain.mechanisms.change_points import ChangePoints

_GRID, _SCAN_GRID, _COARSE_GRID = turn_grid(360), turn_grid(72), turn_grid(24)
_CHANGES = 10.0 ** np.linspace(-7, 3, 21)
"""Relative changes tried for a first bound of the margin: where the links are open anywhere, they open before."""
_CELLS = 4
"""Cells below that bound, at whose ends all changes are tried."""
_BLOCK = 1024
"""Mechanisms of which it is found at once whether they close: some megabytes."""
_ROUNDING = 16 * np.finfo(float).eps
"""Links that close by less, in parts of all their lengths, stand at a change point or cannot close at all."""
_FAR, _NEAR = 8, 1e-9
"""Links that close by so many times as much as their gap bends, close between the points at which it is known; if they
close by less than the other, in parts of all their lengths, they may be locked."""


class ClosingMargin(NamedTuple):
    """Smallest relative change of one length that opens the links, of shape (..., 1).

    margin [1], length: index of the length, angle: of the mechanism's crank where they open [rad]. NaN and −1 where the
    links cannot close as they are.
    """

    margin: Array
    length: NDArray[np.intp]
    angle: Array


class Way(NamedTuple):
    """Which length is changed, and whether it is made longer, +1, or shorter, −1; arrays that broadcast."""

    length: NDArray[np.intp]
    sign: Array


def closing_margin(kind: Kind[Motion, Geometry], geometry: Geometry) -> ClosingMargin:
    """Find, for each length and both ways of changing it, the least change at which the links part.

    Parameters
    ----------
    kind : Kind
    geometry : NamedTuple of arrays, shape (..., 1)

    Returns
    -------
    ClosingMargin, shape (..., 1)

    Notes
    -----
    The least gap over a turn is followed as each length is multiplied by 1 ± c. A coarse scan bounds the change c that
    opens the links; of the ways that open them in the first cell below that bound, the roots are found. A kind whose
    gap has to be walked for has its own way, and one with a closed form needs none. docs/theory/closing-margin.
    """
    if kind.change_points is not None:
        return _of_change_points(kind, geometry, kind.change_points)
    if kind.least_gap is not None:
        return _of_longest(kind, geometry, kind.least_gap(geometry))
    shape = np.broadcast_shapes(*(np.shape(leaf) for leaf in leaves(geometry)))
    flat = rows(geometry, np.arange(np.prod(shape)))
    margin, angle = np.full((2, np.prod(shape), 1), np.nan)
    length = np.full(margin.shape, -1, dtype=np.intp)
    with np.errstate(all="ignore"):
        closes = _close_by_far(kind, flat, kind.gap(_GRID, flat))
        unclear = np.flatnonzero(~closes)
        if len(unclear) > 0:
            own = rows(flat, unclear)
            closes[unclear] = (_least_gap(kind, own).value > _rounding(kind, own))[..., 0]
        able = np.flatnonzero(closes)
        if len(able) > 0:
            found = (kind.openings or partial(_openings, kind))(rows(flat, able))
            order = np.lexsort((found.change, found.row))
            row, first = np.unique(found.row[order], return_index=True)
            best, at = order[first], able[row]
            margin[at, 0], angle[at, 0], length[at, 0] = found.change[best], found.angle[best], found.length[best]
    return ClosingMargin(margin.reshape(shape), length.reshape(shape), angle.reshape(shape))


def _close_by_far(kind: Kind[Motion, Geometry], geometry: Geometry, gaps: Array) -> NDArray[np.bool_]:
    """Whether links close by far more than their gap bends from point to point of a turn, and so between them too."""
    return _seen_from_far(kind, geometry, gaps)[0]


def _seen_from_far(
    kind: Kind[Motion, Geometry], geometry: Geometry, gaps: Array
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Whether links close by far, and whether they are open at one of some angles by more than nothing."""
    near = _NEAR * _all_lengths(kind, geometry)
    bend = _bend(gaps)
    least = gaps.min(axis=-1, keepdims=True)
    return ((least > _FAR * bend) & (least > near))[..., 0], (least < -near)[..., 0]


def _of_longest(kind: Kind[Motion, Geometry], geometry: Geometry, least: Extreme) -> ClosingMargin:
    """Margin where every length takes as much of the gap as it changes: that of the longest."""
    lengths = np.abs(np.stack([named_part(geometry, name) for name in kind.lengths]))
    closes = least.value > _rounding(kind, geometry)
    return ClosingMargin(
        np.where(closes, least.value / np.max(lengths, axis=0), np.nan),
        np.where(closes, first_largest_along(np.moveaxis(lengths, 0, -1)), -1),
        np.where(closes, np.mod(least.angle, 2 * np.pi), np.nan),
    )


def _of_change_points(kind: Kind[Motion, Geometry], geometry: Geometry, through: "ChangePoints") -> ClosingMargin:
    """Margin of links that come through change points only where lengths are just alike: none, at the first."""
    angle = through.angle(geometry)[..., :1]
    length = np.full(angle.shape, kind.lengths.index(through.length), dtype=np.intp)
    return ClosingMargin(np.zeros(angle.shape), length, angle)


def _openings(kind: Kind[Motion, Geometry], geometry: Geometry) -> Openings:
    """Roots of the least gap over a turn, for the ways that open the links soonest."""
    found = _first_openings(kind, geometry)
    way, low, high = found.way, found.low, found.high
    opened = rows(geometry, found.row)
    fall = (found.gap_low - found.gap_high) / (high - low)

    tried: list[Extreme] = []

    def least_gap(change: Array) -> Array:
        """In parts of the fall, as most gaps shrink in proportion to the change."""
        tried.append(_least_gap(kind, changed(kind.lengths, opened, way, change)))
        return -tried[-1].value / fall

    change = near_roots(least_gap, low + found.gap_low / fall, low, high, found.row[:, np.newaxis])
    # The last change that was tried is the root but for rounding.
    angle = np.mod(tried[-1].angle, 2 * np.pi)
    return Openings(found.row, way.length[:, 0], change[:, 0], angle[:, 0])


class _Bracket(NamedTuple):
    """Ways that open the links soonest: each with the row of its mechanism, and two changes with their least gaps.

    Between the changes the gap becomes negative; all of shape (found, 1), row of (found,).
    """

    way: Way
    row: NDArray[np.intp]
    low: Array
    high: Array
    gap_low: Array
    gap_high: Array


def _first_openings(kind: Kind[Motion, Geometry], geometry: Geometry) -> _Bracket:
    """Scan coarsely for the ways that open the links soonest."""
    n_rows = len(leaves(geometry)[0])
    # A part of nothing is nothing: it opens no links.
    lengths = [place for place, name in enumerate(kind.lengths) if named_part(geometry, name).any()]
    ways = Way(np.repeat(lengths, 2), np.tile([-1.0, 1.0], len(lengths)))

    def tried(change: Array) -> Geometry:
        """Every way of changing every mechanism: from (trial, row) to (way, trial, row, 1)."""
        column = Way(ways.length.reshape(-1, 1, 1, 1), ways.sign.reshape(-1, 1, 1, 1))
        return changed(kind.lengths, geometry, column, change[..., np.newaxis])

    gaps = kind.gap(_COARSE_GRID, tried(np.repeat(_CHANGES[:, np.newaxis], n_rows, axis=1)))
    bound = _CHANGES[np.argmax(np.any(gaps < 0, axis=(0, -1)), axis=0)]
    cell = bound / _CELLS
    gap = _about_least(kind, tried(cell * np.arange(_CELLS + 1)[:, np.newaxis]))
    is_open = gap[:, 1:] < 0
    first = np.where(np.any(is_open, axis=1), np.argmax(is_open, axis=1), _CELLS)
    way, row = np.nonzero((first == np.min(first, axis=0)) & (first < _CELLS))
    place = first[way, row]
    return _Bracket(
        Way(ways.length[way, np.newaxis], ways.sign[way, np.newaxis]),
        row,
        *((cell[row] * (place + end))[:, np.newaxis] for end in (0, 1)),
        *(gap[way, place + end, row][:, np.newaxis] for end in (0, 1)),
    )


def _about_least(kind: Kind[Motion, Geometry], geometry: Geometry) -> Array:
    """Least gap over a turn, shape (...): of the right sign; where it is next to nothing, the very one."""
    gaps = np.broadcast_arrays(kind.gap(_SCAN_GRID, geometry))[0]
    least, bend = gaps.min(axis=-1), _bend(gaps)[..., 0]
    is_unclear = (least >= 0) & (least < bend)
    if np.any(is_unclear):
        shape = (*least.shape, 1)
        own = each_changed(lambda value: np.broadcast_to(value, shape)[is_unclear], geometry)
        least[is_unclear] = _least_gap(kind, own, _SCAN_GRID, gaps[is_unclear]).value[..., 0]
    return least


def _bend(gaps: Array) -> Array:
    """By how much gaps bend from point to point of a turn at most, shape (..., 1)."""
    return np.abs(np.diff(gaps, 2, append=gaps[..., :2])).max(axis=-1, keepdims=True)


def changed(lengths: Sequence[str], geometry: Geometry, way: Way, change: Array) -> Geometry:
    """Change one length of each mechanism, another in each where `way` says so; none becomes less than nothing.

    Parameters
    ----------
    lengths : sequence of str
        Dotted names of the lengths that may be meant.
    geometry : NamedTuple of arrays
    way : Way
    change : Array
        Relative change, not negative; broadcastable with geometry and way. [1]
    """
    factor = np.maximum(1 + way.sign * change, 0.0)
    places = {name: place for place, name in enumerate(lengths)}

    def scaled(name: str, value: Array) -> Array:
        return value * np.where(way.length == places[name], factor, 1.0) if name in places else value

    return mapped(scaled, geometry)


def _least_gap(
    kind: Kind[Motion, Geometry], geometry: Geometry, grid: Array = _GRID, gaps: Array | None = None
) -> Extreme:
    """By how much the links close where they do so least, over a turn; `gaps`: on the grid, where they are known."""
    return smallest(lambda phi: kind.gap(phi, geometry), grid=grid, samples=gaps)


def _rounding(kind: Kind[Motion, Geometry], geometry: Geometry) -> Array:
    """Gap that may be rounding. [m]"""
    return _ROUNDING * _all_lengths(kind, geometry)


def _all_lengths(kind: Kind[Motion, Geometry], geometry: Geometry) -> Array:
    """All lengths of a mechanism together. [m]"""
    return np.sum([np.abs(named_part(geometry, name)) for name in kind.lengths], axis=0)


class ClosingOfMany(NamedTuple):
    """Whether links close all round, and whether it is too close to say of many at once; truths of shape (n,)."""

    closes: NDArray[np.bool_]
    is_unclear: NDArray[np.bool_]


def closing_all_round(kind: Kind[Motion, Geometry], geometry: Geometry) -> ClosingOfMany:
    """Find which of many mechanisms have no `open_ranges`.

    Parameters
    ----------
    kind : Kind
    geometry : NamedTuple of arrays, shape (n, 1)

    Returns
    -------
    ClosingOfMany
        Of what is unclear, `open_ranges` has the last word.

    Notes
    -----
    Most close by far more than their gap bends between a few points of a turn, or are open at one of these. The others
    are looked at from point to point, and those that are left at their least gap, unless it is next to nothing.
    """
    n_rows = len(leaves(geometry)[0])
    closes, is_unclear = np.zeros((2, n_rows), dtype=bool)
    is_walked = kind.openings is not None or kind.change_points is not None
    with np.errstate(all="ignore"):
        for start in range(0, n_rows, _BLOCK):
            left = np.arange(start, min(start + _BLOCK, n_rows))
            for grid in (turn_grid(),) if is_walked else (_SCAN_GRID, turn_grid()):
                own = rows(geometry, left)
                far, is_open = _seen_from_far(kind, own, kind.gap(grid, own))
                closes[left[far]] = True
                left = left[~far & ~is_open]
            if left.size:
                own = rows(geometry, left)
                least = (_least_gap(kind, own, turn_grid()).value - _rounding(kind, own))[:, 0]
                closes[left] = least > 0
                is_unclear[left] = ~(np.abs(least) > _NEAR * _all_lengths(kind, own)[:, 0])
    return ClosingOfMany(closes, is_unclear)


class OpenRange(NamedTuple):
    """Crank angles between which the links cannot close [rad], and by how much they are short there [m]."""

    start: float
    end: float
    short: float


def open_ranges(
    kind: Kind[Motion, Geometry], geometry: Geometry, gap: Callable[[Array], Array] | None = None
) -> tuple[OpenRange, ...]:
    """Give the angles of the mechanism's crank over which one mechanism cannot close, with edges to rounding.

    Parameters
    ----------
    kind : Kind
    geometry : NamedTuple of floats
    gap : callable, optional
        By how much a part of it closes, by the angle; the mechanism as a whole unless given. [m]

    Returns
    -------
    tuple of OpenRange
        In order of the angle within [0, 2π); a range across 0 ends beyond 2π. One range of a full turn where the links
        never close. A change point, where they only just close, is a range of hardly any length.
    """
    with np.errstate(all="ignore"):
        rounding = _rounding(kind, geometry)

        def curve(phi: Array) -> Array:
            return (kind.gap(phi, geometry) if gap is None else gap(phi)) - rounding

        known = curve(turn_grid())
        if gap is None and _close_by_far(kind, geometry, known + rounding):
            return ()
        deepest = smallest(curve, samples=known)
        if deepest.value[0] > 0:
            return ()
        # The least gap may lie between two grid points.
        between = np.mod(deepest.angle, 2 * np.pi)
        grid, place = np.unique(np.append(turn_grid(), between), return_index=True)
        is_open = ~(np.append(known, curve(between))[place] > 0)
        if np.all(is_open):
            return (OpenRange(0.0, 2 * np.pi, float(-deepest.value[0])),)
        start_at = np.flatnonzero(is_open & ~np.roll(is_open, 1))
        end_at = np.flatnonzero(is_open & ~np.roll(is_open, -1))
        if end_at[0] < start_at[0]:
            end_at = np.roll(end_at, -1)
        ring = np.concatenate([grid[-1:] - 2 * np.pi, grid, grid[:1] + 2 * np.pi])
        low, high = np.append(ring[start_at], grid[end_at]), np.append(grid[start_at], ring[end_at + 2])
        start, end = np.split(bracketed_roots(curve, low, high), 2)
        end = end + 2 * np.pi * (end < start)
        inside = curve(np.linspace(start, end, 91, axis=-1))
        short = -np.nanmin(inside, axis=-1)
    return tuple(map(OpenRange, start.tolist(), end.tolist(), short.tolist()))


def opens(gap: Callable[[Array], Array], kind: Kind[Motion, Geometry], geometry: Geometry) -> bool:
    """Whether a part of a mechanism, by how much it closes at an angle, cannot close somewhere on the turn."""
    rounding = _rounding(kind, geometry)
    with np.errstate(all="ignore"):
        return not smallest(lambda phi: gap(phi) - rounding).value[0] > 0
