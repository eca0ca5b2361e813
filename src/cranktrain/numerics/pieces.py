"""Largest values of curves that are smooth between known breaks only: kinks and jumps, of gas and of friction.

A grid shows near which of its points a peak stands; about each of these the curve is laid through Chebyshev's points of
every piece between breaks, so that nothing is smoothed across one, and an end of a piece is the limit from its side.
Where its polynomial's last orders have not ended, as beside a pole, it is laid once more, through points nearer to the
top.
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
from cranktrain.numerics.windows import ONE_BREAK, Windows, windows_about, windows_between

_N_NODES = 9
_NODES = np.cos((2 * np.arange(_N_NODES) + 1) * (np.pi / (2 * _N_NODES)))
_TO_POWERS: Array = np.linalg.inv(np.vander(_NODES, increasing=True))
"""From values at the nodes of (−1, 1) to the polynomial's coefficients, by rising powers."""
_TRIED = np.linspace(-1.0, 1.0, 65)
_TRIED_POWERS: Array = np.vander(_TRIED, _N_NODES, increasing=True)
_FROM_ENDS: Array = np.vander(np.array([-1.0, 1.0]), _N_NODES, increasing=True)
"""From coefficients to a polynomial's values at both ends."""
_LAST_ORDERS: Array = (2 / _N_NODES) * np.cos(np.outer(np.arccos(_NODES), (_N_NODES - 2, _N_NODES - 1)))
"""From values at the nodes to the last two of the polynomial's coefficients by Chebyshev's."""
_HAS_ENDED = 1e-11
"""Of a curve's largest size: a polynomial whose last orders are smaller is the curve itself."""
_NEARER = 8.0
"""Times narrower than before is where a polynomial is laid once more: its last order falls with the eighth power."""
_MOST_TIMES = 6
"""Times a polynomial is laid anew."""
_NEWTON_STEPS = 4
_LEVEL = 1e-12
"""The same along one piece, whose values are exact to rounding."""
_AT_END = 1 - 1e-6
"""A top from there on stands at the end of its piece: where it is level there, rounding moves it so far."""
_MOST_MOVES = 8
"""Windows in which one is gone after."""


class Peak(NamedTuple):
    """Largest value of each curve, shapes (...): where [rad], how much, and on which side of a jump.

    side is 1 where the value is the limit from just after the angle, −1 from just before it, 0 where both are one.
    """

    angle: Array
    value: Array
    side: Array


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
    return _peaks_of(curves, windows_about(centre, breaks, scale, wide, period))


def _peaks_of(curves: Curves, windows: Windows) -> Peak:
    """Largest value of each curve in its windows, shapes of their leading axes."""
    with np.errstate(all="ignore"):
        best = _first_of_the_best(_tops(curves, windows), windows)
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


class _Looks(NamedTuple):
    """What polynomials on pieces say, shapes (p,).

    way: where in [−1, 1] each is largest, value: how large, off: by how much that may be wrong, is_level: whether it is
    level there, ends: its values at both ends, shape (2, p).
    """

    way: Array
    value: Array
    off: Array
    is_level: NDArray[np.bool_]
    ends: Array


def _tops(curves: Curves, windows: Windows) -> _Tops:
    """Find the top of every piece."""
    is_piece, scale = windows.is_piece, windows.scale[:, np.newaxis, np.newaxis]
    look = _looked_at(curves, windows)
    _look_nearer(curves, windows, look)
    top, angle, at = np.full((3, *is_piece.shape), np.nan)
    top[is_piece], angle[is_piece], at[is_piece] = look.value, windows.middle + windows.half * look.way, look.way
    ends, off = np.full((2, *is_piece.shape), np.nan), np.zeros(is_piece.shape)
    ends[:, is_piece], off[is_piece] = look.ends, look.off
    sides = _sides(at, ends, ALIKE * scale, off)
    is_unsure = (np.abs(at) >= _AT_END) & (sides == 0.0)
    is_unsure[is_piece] |= look.is_level
    return _Tops(angle, np.where(np.isnan(top), -np.inf, top), sides, is_unsure)


def _looked_at(curves: Curves, windows: Windows) -> _Looks:
    """Lay polynomials through the curves at the nodes of all pieces, and find their tops."""
    values = curves(windows.row, windows.middle[:, np.newaxis] + windows.half[:, np.newaxis] * _NODES)
    base = values[:, _N_NODES // 2]
    above = values - base[:, np.newaxis]
    powers = product(above, _TO_POWERS.T)
    way, is_level = _top(powers, windows.scale[windows.row], windows.level)
    off = np.abs(product(above, _LAST_ORDERS)).sum(axis=-1)
    ends = base + product(powers, _FROM_ENDS.T).T
    return _Looks(way, base + polynomial_value(powers.T, way), off, is_level, ends)


def _look_nearer(curves: Curves, windows: Windows, look: _Looks) -> None:
    """Look nearer to those tops that may be the highest and are not sure; changes `look`, but not its `off`."""
    off, half = look.off.copy(), windows.half / _NEARER
    for _time in range(_MOST_TIMES):
        surely = np.full(len(windows.scale), -np.inf)
        np.fmax.at(surely, windows.row, look.value - off)
        is_high = look.value + off >= surely[windows.row]
        these = np.flatnonzero(is_high & (off > _HAS_ENDED * windows.scale[windows.row]))
        if not these.size:
            break
        row, middle, whole = windows.row[these], windows.middle[these], windows.half[these]
        room = 1 - half[these] / whole
        centre = np.minimum(np.maximum(look.way[these], -room), room)
        near = windows._replace(row=row, middle=middle + whole * centre, half=half[these], level=np.full_like(room, -1))
        nearer = _looked_at(curves, near)
        look.way[these], look.value[these] = centre + nearer.way * half[these] / whole, nearer.value
        is_at_end = np.abs(look.way[these]) >= _AT_END
        ends = these[is_at_end]
        look.ends[(look.way[ends] > 0).astype(np.intp), ends] = look.value[ends]
        # A top at the end of where it is looked for, but not of its piece, is beyond that.
        is_beyond = (np.abs(nearer.way) >= _AT_END) & ~is_at_end
        off[these] = np.where(is_beyond, np.inf, nearer.off)
        half[these] /= np.where(is_beyond, 1.0, _NEARER)


def _top(powers: Array, scale: Array, level: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Where in [−1, 1] each polynomial is largest, shape (p,): from −1 on, at `level`; and whether it is level."""
    tried, alike = product(powers, _TRIED_POWERS.T), _LEVEL * scale
    # The first of what is level: rounding must not move an extreme along a level stretch.
    highest = tried.max(axis=-1)
    is_top = tried >= (highest - alike)[:, np.newaxis]
    place = np.argmax(is_top, axis=-1)
    start, apart = _TRIED[place], float(_TRIED[1] - _TRIED[0])
    slopes = (powers[:, 1:] * np.arange(1, _N_NODES)).T
    way, low, high = start, np.maximum(start - apart, -1.0), np.minimum(start + apart, 1.0)
    for _step in range(_NEWTON_STEPS):
        first, second = value_and_first(slopes, way)
        move = np.where(second < 0, -first / second, np.sign(first) * apart)
        way = np.minimum(np.maximum(way + np.where(np.isnan(move), 0.0, move), low), high)
    # Places that are alike may have the top between them.
    is_level = (is_top.sum(axis=-1) > 1) & ~(polynomial_value(powers.T, way) > highest + alike)
    return np.where(is_level, np.where(place == 0, level, start), way), is_level


def _sides(way: Array, ends: Array, alike: Array, off: Array) -> Array:
    """On which side of a jump a piece's top stands: 0 where its neighbour goes on from the same value."""
    jump = np.abs(ends[0, ..., 1:] - ends[1, ..., :-1]) > alike + off[..., 1:] + off[..., :-1]
    none = np.zeros((*jump.shape[:-1], 1), dtype=np.bool_)
    after, before = np.concatenate([none, jump], axis=-1), np.concatenate([jump, none], axis=-1)
    return np.where((way <= -_AT_END) & after, 1.0, np.where((way >= _AT_END) & before, -1.0, 0.0))


def _first_of_the_best(tops: _Tops, windows: Windows) -> Peak:
    """Choose the highest of each curve's pieces, of alike ones the first in the period; shapes (curve,)."""
    scale = windows.scale[:, np.newaxis]
    n_pieces = int(np.prod(tops.value.shape[1:]))  # of no curves at all, too
    angle, top, side, is_unsure = (part.reshape(len(scale), n_pieces) for part in tops)
    best = top.max(axis=-1)
    # What is not sure stands behind what it may belong to.
    turn = np.mod(angle + ONE_BREAK, windows.period) + np.where(is_unsure, 2 * windows.wide, 0.0)
    first = np.argmin(np.where(top >= best[:, np.newaxis] - ALIKE * scale, turn, np.inf), axis=-1)
    row, is_known = np.arange(len(scale)), best > -np.inf
    return Peak(*(np.where(is_known, part, np.nan) for part in (angle[row, first], best, side[row, first])))
