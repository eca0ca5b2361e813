"""Windows in which curves may be largest, cut into pieces at known breaks; and angles that are asked for together."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.series import around_zero
from cranktrain.numerics.ties import ALIKE

_ABOUT = 1.2
"""How far from a grid point that is a peak the curve's own may be, in steps: a break on the next point lies within."""
ONE_BREAK = 1e-9
"""Breaks that are closer are one. [rad]"""
_MOST = 48
"""Peaks of one curve that are looked at."""


class Windows(NamedTuple):
    """Windows about angles at which curves may be largest, cut into pieces at breaks.

    Attributes
    ----------
    row : array of int, shape (p,)
        Of which curve each piece is, counted through all leading axes.
    middle, half : Array, shape (p,)
        Of each piece, and half of its width. [rad]
    level : Array, shape (p,)
        Where in (−1, 1) a piece that is level begins.
    is_piece : array of bool, shape (curve, peak, piece)
    scale : Array, shape (curve,)
        Largest size of each curve, about.
    wide : float
        Half the width of a window. [rad]
    period : float
        [rad]
    shape : tuple of int
        Leading axes of the curves.
    """

    row: NDArray[np.intp]
    middle: Array
    half: Array
    level: Array
    is_piece: NDArray[np.bool_]
    scale: Array
    wide: float
    period: float
    shape: tuple[int, ...]


def windows_between(grid: Array, samples: Array, breaks: Array) -> Windows:
    """Windows about the peaks of a grid: parameters as of `largest_between`."""
    shape, n_points = samples.shape[:-1], samples.shape[-1]
    step = float(grid[1] - grid[0])
    known = np.fmax(samples.reshape(-1, n_points), -np.inf)
    scale = np.fmax.reduce(np.abs(samples), axis=-1, initial=0.0).reshape(-1)
    own_breaks = np.broadcast_to(breaks, (*shape, breaks.shape[-1])).reshape(len(known), breaks.shape[-1])
    places = _places(known, scale[:, np.newaxis], _at_breaks(own_breaks, grid, n_points))
    centre = np.where(places >= 0, grid[places], np.nan)
    return windows_about(centre, own_breaks, scale, _ABOUT * step, step * n_points)._replace(shape=shape)


def windows_about(centre: Array, breaks: Array, scale: Array, wide: float, period: float) -> Windows:
    """Windows about some angles: parameters as of `largest_about`."""
    edges = _edges(breaks, np.where(np.isnan(centre), 0.0, centre), wide, period)
    is_piece = (np.diff(edges, axis=-1) > 0.0) & ~np.isnan(centre)[..., np.newaxis]
    row, peak, piece = np.nonzero(is_piece)
    start, end = edges[row, peak, piece], edges[row, peak, piece + 1]
    half, middle = (end - start) / 2, centre[row, peak] + (end + start) / 2
    # What is level from before its grid point on begins, for us, there.
    level = np.where((piece == 0) & (start * end < 0), -(end + start) / (end - start), -1.0)
    return Windows(row, middle, half, level, is_piece, scale, wide, period, scale.shape)


class _GridBreaks(NamedTuple):
    """Breaks of curves beside the points of a grid.

    near: whether there is one next to each point, shape (curve, n); between: whether on both sides of it; on: the
    points, by curve and place, on which one stands.
    """

    near: NDArray[np.bool_]
    between: NDArray[np.bool_]
    on: tuple[NDArray[np.intp], NDArray[np.intp]]


def _at_breaks(breaks: Array, grid: Array, n_points: int) -> _GridBreaks:
    """Find where breaks stand on a grid."""
    row, _place = at = np.nonzero(~np.isnan(breaks))
    step = grid[1] - grid[0]
    steps = (breaks[at] - grid[0]) / step
    below, nearest = (change(steps).astype(np.intp) for change in (np.floor, np.rint))
    is_on = np.abs(steps - nearest) * step < ONE_BREAK
    on = row[is_on], nearest[is_on] % n_points
    near, after = np.zeros((2, len(breaks), n_points), dtype=np.bool_)
    for beside in range(-1, 3):
        near[row, (below + beside) % n_points] = True
    after[row, below % n_points] = True
    after[on], after[on[0], on[1] - 1] = True, True
    between = after & np.concatenate([after[:, -1:], after[:, :-1]], axis=-1)
    return _GridBreaks(near, between, on)


def _places(known: Array, scale: Array, breaks: _GridBreaks) -> NDArray[np.intp]:
    """Places of those peaks of the grid about which the largest value may stand, shape (curve, peak): −1 for none."""
    same = np.where(scale > 0, ALIKE * scale, 1.0)
    ring = np.concatenate([known[:, -1:], known, known[:, :1]], axis=-1)
    lower = ring - same
    # Between breaks on both of its sides a curve may rise again beside a point that is no peak.
    is_peak = breaks.between | ((known >= lower[:, :-2]) & (known >= lower[:, 2:]))
    row, place = np.divmod(np.flatnonzero(is_peak), known.shape[-1])
    is_known = known[row, place] > -np.inf
    row, place = row[is_known], place[is_known]
    before, at, after = ring[row, place], known[row, place], ring[row, place + 2]
    with np.errstate(all="ignore"):
        # By how much a parabola's top is higher, and what a curve may rise to at a break.
        bend = 2 * at - before - after
        rise = np.where(breaks.near[row, place], at - np.minimum(before, after), (after - before) ** 2 / (8 * bend))
        hope = at + _known_or_0(2.0 * rise)
        turn = _known_or_0((after - before) / same[row, 0])
    # Between the sides of a jump a curve may have a value that it has on neither: it counts no more than beside.
    of, there = breaks.on
    surely = known.copy()
    surely[breaks.on] = np.minimum(known[breaks.on], np.maximum(ring[of, there], ring[of, there + 2]))
    may_be = hope >= (surely.max(axis=-1) - same[:, 0])[row]
    row, place, turn = row[may_be], place[may_be], np.rint(turn[may_be])
    height = np.rint(hope[may_be] / same[row, 0])
    # What is alike on the grid, and beside it too, is the same peak of another throw: the first stands for all.
    order = np.lexsort((place, turn, -height, row))
    keys = np.stack([row, height, turn])[:, order]
    is_first = np.ones(order.size, dtype=np.bool_)
    is_first[1:] = np.any(keys[:, 1:] != keys[:, :-1], axis=0)
    row, place = row[order][is_first], place[order][is_first]
    rank = np.arange(row.size) - np.searchsorted(row, row)
    kept = rank < _MOST
    places = np.full((len(known), int(rank[kept].max(initial=0)) + 1), -1, dtype=np.intp)
    places[row[kept], rank[kept]] = place[kept]
    return places


def _known_or_0(values: Array) -> Array:
    """Values of which those are 0 that are infinite or NaN."""
    return np.where(np.isfinite(values), values, 0.0)


def _edges(breaks: Array, centre: Array, wide: float, period: float) -> Array:
    """Ends of the pieces about each peak, from where it may stand, shape (curve, peak, piece + 1). [rad]"""
    off = breaks[:, np.newaxis, :] - centre[..., np.newaxis]
    # Of a recorded card each degree is a break, and few of them are near: only those are counted exactly.
    is_near = np.abs(off - period * np.rint(off / period)) < 2 * wide
    away = around_zero(off[is_near], period)
    is_inside = np.abs(away) < wide - ONE_BREAK
    curve, peak = (index[is_inside] for index in np.nonzero(is_near)[:2])
    place: NDArray[np.intp] = curve * centre.shape[-1] + peak
    rank: NDArray[np.intp] = np.arange(place.size) - np.searchsorted(place, place)
    inside = np.full((*centre.shape, int(rank.max(initial=-1)) + 1), wide)
    inside[curve, peak, rank] = away[is_inside]
    inside.sort(axis=-1)
    if inside.shape[-1]:
        inside[..., 1:][np.diff(inside, axis=-1) < ONE_BREAK] = wide
        inside.sort(axis=-1)
        inside = inside[..., : int((inside < wide).sum(axis=-1).max(initial=0))]
    ends = np.full((*centre.shape, 1), wide)
    return np.concatenate([-ends, inside, ends], axis=-1)


def in_slots(which: NDArray[np.intp], angle: Array, n_rows: int) -> tuple[Array, NDArray[np.intp]]:
    """Lay angles of some rows side by side, to be asked for together.

    Parameters
    ----------
    which : array of int, shape (p,)
        Which row each is of.
    angle : Array, shape (p, k)
    n_rows : int

    Returns
    -------
    Array, shape (n_rows, slots, k)
        0 where a row has fewer.
    array of int, shape (p,)
        In which slot each stands.
    """
    order = np.argsort(which, kind="stable")
    ranked = which[order]
    slot = np.empty_like(which)
    slot[order] = np.arange(which.size) - np.searchsorted(ranked, ranked)
    laid = np.zeros((n_rows, int(slot.max(initial=0)) + 1, angle.shape[-1]))
    laid[which, slot] = angle
    return laid, slot


def in_windows(which: NDArray[np.intp], angle: Array, n_rows: int) -> tuple[Array, NDArray[np.intp]]:
    """The same, with one slot for all that ask of a row at the same angles, as tops of several curves are together."""
    # What is asked of one row at one first and one last angle stands together, and mostly is one window.
    order = np.lexsort((angle[:, -1], angle[:, 0], which))
    asked = np.column_stack([which, angle])[order]
    is_new = np.ones(order.size, dtype=np.bool_)
    is_new[1:] = np.any(asked[1:] != asked[:-1], axis=-1)
    number = np.empty_like(which)
    number[order] = np.cumsum(is_new) - 1
    first = order[is_new]
    laid, slot = in_slots(which[first], angle[first], n_rows)
    return laid, slot[number]
