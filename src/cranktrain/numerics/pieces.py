"""Largest values of curves that are smooth between known breaks only: kinks and jumps, of gas and of friction.

A grid shows near which of its points a peak stands; about each of these the curve is laid through Chebyshev's points of
every piece between breaks, so that nothing is smoothed across one, and an end of a piece is the limit from its side.
"""

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.polynomials import polynomial_value, value_and_first
from cranktrain.numerics.products import product
from cranktrain.numerics.series import around_zero
from cranktrain.numerics.ties import ALIKE

_ABOUT = 1.2
"""How far from a grid point that is a peak the curve's own may be, in steps: a break on the next point lies within."""
_N_NODES = 9
_NODES = np.cos((2 * np.arange(_N_NODES) + 1) * (np.pi / (2 * _N_NODES)))
_TO_POWERS: Array = np.linalg.inv(np.vander(_NODES, increasing=True))
"""From values at the nodes of (−1, 1) to the polynomial's coefficients, by rising powers."""
_TRIED = np.linspace(-1.0, 1.0, 65)
_TRIED_POWERS: Array = np.vander(_TRIED, _N_NODES, increasing=True)
_FROM_ENDS: Array = np.vander(np.array([-1.0, 1.0]), _N_NODES, increasing=True)
"""From coefficients to a polynomial's values at both ends."""
_NEWTON_STEPS = 4
_LEVEL = 1e-12
"""The same along one piece, whose values are exact to rounding."""
_ONE_BREAK = 1e-9
"""Breaks that are closer are one. [rad]"""
_AT_END = 1 - 1e-6
"""A top from there on stands at the end of its piece: where it is level there, rounding moves it so far."""
_MOST = 48
"""Peaks of one curve that are looked at."""
_MOST_MOVES = 8
"""Windows in which one is gone after."""


class Peak(NamedTuple):
    """Largest value of each curve, shapes (...): where [rad], how much, and on which side of a jump.

    side is 1 where the value is the limit from just after the angle, −1 from just before it, 0 where both are one.
    """

    angle: Array
    value: Array
    side: Array


class Windows(NamedTuple):
    """Windows about angles at which curves may be largest, cut into pieces at breaks: what is asked of the curves.

    Attributes
    ----------
    row : array of int, shape (p,)
        Of which curve each piece is, counted through all leading axes.
    angle : Array, shape (p, k)
        At which its values are wanted. [rad]
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
    angle: Array
    middle: Array
    half: Array
    level: Array
    is_piece: NDArray[np.bool_]
    scale: Array
    wide: float
    period: float
    shape: tuple[int, ...]


Curves = Callable[[NDArray[np.intp], Array], Array]
"""Many curves: takes which ones (p,) and angles of each (p, k), gives values (p, k)."""


def largest_between(curves: Curves, grid: Array, samples: Array, breaks: Array) -> Peak:
    """Largest value of each curve over its period.

    Parameters
    ----------
    curves : Curves
        Counted as the rows of `samples` are, through all leading axes.
    grid : Array, shape (n,)
        Equal steps over the period. [rad]
    samples : Array, shape (..., n)
        The curves on the grid.
    breaks : Array, shape broadcastable to (..., m)
        Where each may jump or have kinks; NaN for none. [rad]

    Returns
    -------
    Peak, shapes (...)
        An angle may lie a step beside the grid's period. Of alike peaks the first one in the period. NaN where the
        curve is NaN all over, or about its highest points.
    """
    return _peaks_of(curves, windows_between(grid, samples, breaks))


def windows_between(grid: Array, samples: Array, breaks: Array) -> Windows:
    """What `largest_between` asks of curves: parameters as there."""
    shape, n_points = samples.shape[:-1], samples.shape[-1]
    step = float(grid[1] - grid[0])
    known = np.fmax(samples.reshape(-1, n_points), -np.inf)
    scale = np.fmax.reduce(np.abs(samples), axis=-1, initial=0.0).reshape(-1)
    own_breaks = np.broadcast_to(breaks, (*shape, breaks.shape[-1])).reshape(len(known), breaks.shape[-1])
    places = _places(known, scale[:, np.newaxis], _at_breaks(own_breaks, grid, n_points))
    centre = np.where(places >= 0, grid[places], np.nan)
    return _windows_about(centre, own_breaks, scale, _ABOUT * step, step * n_points)._replace(shape=shape)


def largest_about(curves: Curves, centre: Array, breaks: Array, scale: Array, wide: float, period: float) -> Peak:
    """Largest value of each curve near angles at which it may stand.

    Parameters
    ----------
    curves : Curves
    centre : Array, shape (curve, peak)
        NaN for none. [rad]
    breaks : Array, shape (curve, m)
        Where each may jump or have kinks; NaN for none. [rad]
    scale : Array, shape (curve,)
        Largest size of each curve, about.
    wide : float
        How far from these angles the curve's own tops may be. [rad]
    period : float
        [rad]

    Returns
    -------
    Peak, shapes (curve,)
        As `largest_between` gives it.
    """
    return _peaks_of(curves, _windows_about(centre, breaks, scale, wide, period))


def _windows_about(centre: Array, breaks: Array, scale: Array, wide: float, period: float) -> Windows:
    """What `largest_about` asks of curves."""
    edges = _edges(breaks, np.where(np.isnan(centre), 0.0, centre), wide, period)
    is_piece = (np.diff(edges, axis=-1) > 0.0) & ~np.isnan(centre)[..., np.newaxis]
    row, peak, piece = np.nonzero(is_piece)
    start, end = edges[row, peak, piece], edges[row, peak, piece + 1]
    half, middle = (end - start) / 2, centre[row, peak] + (end + start) / 2
    # What is level from before its grid point on begins, for us, there.
    level = np.where((piece == 0) & (start * end < 0), -(end + start) / (end - start), -1.0)
    angle = middle[:, np.newaxis] + half[:, np.newaxis] * _NODES
    return Windows(row, angle, middle, half, level, is_piece, scale, wide, period, scale.shape)


def _peaks_of(curves: Curves, windows: Windows) -> Peak:
    """Ask curves in windows, and find their largest values."""
    with np.errstate(all="ignore"):
        return peaks_in(windows, curves(windows.row, windows.angle))


def peaks_in(windows: Windows, values: Array) -> Peak:
    """Largest value of each curve, shapes of its leading axes, from its values in the windows, shape (p, k)."""
    best = _first_of_the_best(_tops(windows, values), windows)
    return Peak(*(part.reshape(windows.shape) for part in best))


def largest_near(curves: Curves, centre: Array, breaks: Array, scale: Array, wide: float, period: float) -> Peak:
    """The same near angles that are not sure to be as near: where a top is not within reach, it is gone after."""
    best = largest_about(curves, centre, breaks, scale, wide, period)
    beyond = np.arange(len(scale))
    for _move in range(_MOST_MOVES):
        off = np.abs(around_zero(best.angle[beyond, np.newaxis] - centre, period))
        is_beyond = np.any(np.abs(off - wide) < (1 - _AT_END) * wide, axis=-1)
        if not np.any(is_beyond):
            break
        beyond = beyond[is_beyond]
        centre = best.angle[beyond, np.newaxis]
        moved = largest_about(partial(_some, curves, beyond), centre, breaks[beyond], scale[beyond], wide, period)
        for whole, part in zip(best, moved, strict=True):
            whole[beyond] = part
    return best


def _some(curves: Curves, rows: NDArray[np.intp], which: NDArray[np.intp], angle: Array) -> Array:
    """Some rows of curves as curves."""
    return curves(rows[which], angle)


class _Tops(NamedTuple):
    """Top of every piece, as `Peak` has it, shapes (curve, peak, piece), −∞ for none; and which are not sure.

    Where a piece ends and the curve goes on, and where it is level to rounding, the next piece or window may have the
    top itself.
    """

    angle: Array
    value: Array
    side: Array
    is_unsure: NDArray[np.bool_]


def _tops(windows: Windows, values: Array) -> _Tops:
    """Find the top of every piece."""
    is_piece, scale = windows.is_piece, windows.scale
    with np.errstate(all="ignore"):
        base = values[:, _N_NODES // 2]
        powers = product(values - base[:, np.newaxis], _TO_POWERS.T)
        way, is_level = _top(powers, scale[windows.row], windows.level)
        value = base + polynomial_value(powers.T, way)
    top, angle, at = np.full((3, *is_piece.shape), np.nan)
    top[is_piece], angle[is_piece], at[is_piece] = value, windows.middle + windows.half * way, way
    ends = np.full((2, *is_piece.shape), np.nan)
    ends[0, is_piece], ends[1, is_piece] = base + product(powers, _FROM_ENDS.T).T
    sides = _sides(at, ends, scale[:, np.newaxis, np.newaxis])
    is_unsure = (np.abs(at) >= _AT_END) & (sides == 0.0)
    is_unsure[is_piece] |= is_level
    return _Tops(angle, np.where(np.isnan(top), -np.inf, top), sides, is_unsure)


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
    laid = np.zeros((n_rows, int(np.max(slot, initial=0)) + 1, angle.shape[-1]))
    laid[which, slot] = angle
    return laid, slot


def in_windows(which: NDArray[np.intp], angle: Array, n_rows: int) -> tuple[Array, NDArray[np.intp]]:
    """The same, with one slot for all that ask of a row at the same angles, as tops of several curves are together."""
    # What is asked of one row at one first and one last angle stands together, and mostly is one window.
    order = np.lexsort((angle[:, -1], angle[:, 0], which))
    asked = np.column_stack([which, angle])[order]
    is_new = np.any(np.diff(asked, axis=0, prepend=np.nan) != 0.0, axis=-1)
    number = np.empty_like(which)
    number[order] = np.cumsum(is_new) - 1
    first = order[is_new]
    laid, slot = in_slots(which[first], angle[first], n_rows)
    return laid, slot[number]


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
    is_on = np.abs(steps - nearest) * step < _ONE_BREAK
    on = row[is_on], nearest[is_on] % n_points
    near, after = np.zeros((2, len(breaks), n_points), dtype=np.bool_)
    for beside in range(-1, 3):
        near[row, (below + beside) % n_points] = True
    after[row, below % n_points] = True
    after[on], after[on[0], on[1] - 1] = True, True
    return _GridBreaks(near, after & np.roll(after, 1, axis=-1), on)


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
        hope = at + np.nan_to_num(2.0 * rise, nan=0.0, posinf=0.0, neginf=0.0)
        turn = np.nan_to_num((after - before) / same[row, 0], nan=0.0, posinf=0.0, neginf=0.0)
    # Between the sides of a jump a curve may have a value that it has on neither: it counts no more than beside.
    of, there = breaks.on
    surely = known.copy()
    surely[breaks.on] = np.minimum(known[breaks.on], np.maximum(ring[of, there], ring[of, there + 2]))
    may_be = hope >= (np.max(surely, axis=-1) - same[:, 0])[row]
    row, place, turn = row[may_be], place[may_be], np.rint(turn[may_be])
    height = np.rint(hope[may_be] / same[row, 0])
    # What is alike on the grid, and beside it too, is the same peak of another throw: the first stands for all.
    order = np.lexsort((place, turn, -height, row))
    keys = np.stack([row, height, turn])[:, order]
    is_first = np.any(np.diff(keys, axis=-1, prepend=np.nan) != 0, axis=0)
    row, place = row[order][is_first], place[order][is_first]
    rank = np.arange(row.size) - np.searchsorted(row, row)
    kept = rank < _MOST
    places = np.full((len(known), int(np.max(rank[kept], initial=0)) + 1), -1, dtype=np.intp)
    places[row[kept], rank[kept]] = place[kept]
    return places


def _edges(breaks: Array, centre: Array, wide: float, period: float) -> Array:
    """Ends of the pieces about each peak, from where it may stand, shape (curve, peak, piece + 1). [rad]"""
    off = breaks[:, np.newaxis, :] - centre[..., np.newaxis]
    # Of a recorded card each degree is a break, and few of them are near: only those are counted exactly.
    is_near = np.abs(off - period * np.rint(off / period)) < 2 * wide
    away = around_zero(off[is_near], period)
    is_inside = np.abs(away) < wide - _ONE_BREAK
    curve, peak = (index[is_inside] for index in np.nonzero(is_near)[:2])
    place: NDArray[np.intp] = curve * centre.shape[-1] + peak
    rank: NDArray[np.intp] = np.arange(place.size) - np.searchsorted(place, place)
    inside = np.full((*centre.shape, int(np.max(rank, initial=-1)) + 1), wide)
    inside[curve, peak, rank] = away[is_inside]
    inside.sort(axis=-1)
    if inside.shape[-1]:
        inside[..., 1:][np.diff(inside, axis=-1) < _ONE_BREAK] = wide
        inside.sort(axis=-1)
        inside = inside[..., : int(np.max(np.sum(inside < wide, axis=-1), initial=0))]
    ends = np.full((*centre.shape, 1), wide)
    return np.concatenate([-ends, inside, ends], axis=-1)


def _top(powers: Array, scale: Array, level: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Where in [−1, 1] each polynomial is largest, shape (p,): from −1 on, at `level`; and whether it is level."""
    tried = product(powers, _TRIED_POWERS.T)
    # The first of what is level: rounding must not move an extreme along a level stretch.
    is_top = tried >= np.max(tried, axis=-1, keepdims=True) - _LEVEL * scale[:, np.newaxis]
    place = np.argmax(is_top, axis=-1)
    start, apart = _TRIED[place], float(_TRIED[1] - _TRIED[0])
    slopes = (powers[:, 1:] * np.arange(1, _N_NODES)).T
    way, low, high = start, np.maximum(start - apart, -1.0), np.minimum(start + apart, 1.0)
    for _step in range(_NEWTON_STEPS):
        first, second = value_and_first(slopes, way)
        move = np.where(second < 0, -first / second, np.sign(first) * apart)
        way = np.minimum(np.maximum(way + np.where(np.isnan(move), 0.0, move), low), high)
    is_level = np.sum(is_top, axis=-1) > 1
    return np.where(is_level, np.where(place == 0, level, start), way), is_level


def _sides(way: Array, ends: Array, scale: Array) -> Array:
    """On which side of a jump a piece's top stands: 0 where its neighbour goes on from the same value."""
    jump = np.abs(ends[0, ..., 1:] - ends[1, ..., :-1]) > ALIKE * scale
    none = np.zeros((*jump.shape[:-1], 1), dtype=np.bool_)
    after, before = np.concatenate([none, jump], axis=-1), np.concatenate([jump, none], axis=-1)
    return np.where((way <= -_AT_END) & after, 1.0, np.where((way >= _AT_END) & before, -1.0, 0.0))


def _first_of_the_best(tops: _Tops, windows: Windows) -> Peak:
    """Choose the highest of each curve's pieces, of alike ones the first in the period; shapes (curve,)."""
    scale = windows.scale[:, np.newaxis]
    n_pieces = int(np.prod(tops.value.shape[1:]))  # of no curves at all, too
    angle, top, side, is_unsure = (part.reshape(len(scale), n_pieces) for part in tops)
    best = np.max(top, axis=-1)
    # What is not sure stands behind what it may belong to.
    turn = np.mod(angle + _ONE_BREAK, windows.period) + np.where(is_unsure, 2 * windows.wide, 0.0)
    first = np.argmin(np.where(top >= best[:, np.newaxis] - ALIKE * scale, turn, np.inf), axis=-1)
    row, is_known = np.arange(len(scale)), best > -np.inf
    return Peak(*(np.where(is_known, part, np.nan) for part in (angle[row, first], best, side[row, first])))
