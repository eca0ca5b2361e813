"""Where the tops of curves may stand that are known at Gauss's points of panels: near enough to look there closely."""

from functools import cache

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.products import product_by_columns
from cranktrain.numerics.subintervals import Subintervals, interpolation

_TRIED = np.linspace(-1.0, 1.0, 33)
"""Where on a panel its polynomial is looked at, both ends among them."""
_OVER = 0.25
"""Part of the range of a panel's points by which its polynomial may be higher than these."""
_MARGIN = 1e-3
"""Part of the largest size by which a panel's polynomial may be off."""
_LEVEL = 1e-13
"""A curve whose range is a smaller part of its size is level."""
_MOST = 48
"""Tops of one curve that are looked at."""


def tops_in_panels(of: Subintervals, values: Array, nothing: Array) -> Array:
    """Angles near which each curve may be largest.

    Parameters
    ----------
    of : Subintervals
    values : Array, shape (curve, point)
        At the panels' points.
    nothing : Array, shape (curve,)
        What a curve has less of everywhere is rounding.

    Returns
    -------
    Array, shape (curve, top)
        NaN for none: of a curve that is NaN all over, or level, or rounding. [rad]
    """
    known = np.where(np.isnan(values), -np.inf, values)
    best, scale = np.max(known, axis=-1), np.fmax.reduce(np.abs(values), axis=-1, initial=0.0)
    has_tops = (best > -np.inf) & ~(np.ptp(values, axis=-1) <= np.maximum(_LEVEL * scale, nothing))
    rows: list[NDArray[np.intp]] = []
    angles: list[Array] = []
    heights: list[Array] = []
    for n_nodes in np.unique(of.size).tolist():
        panel = np.flatnonzero(of.size == n_nodes)
        place: NDArray[np.intp] = of.first[panel, np.newaxis] + np.arange(n_nodes, dtype=np.intp)
        nodes = values[:, place]
        highest = np.max(nodes, axis=-1)
        may_be = highest + _OVER * (highest - np.min(nodes, axis=-1)) >= best[:, np.newaxis]
        row, at = np.nonzero(may_be & has_tops[:, np.newaxis])
        tried = product_by_columns(_weights(n_nodes), nodes[row, at].T).T
        ends = np.full((len(tried), 1), -np.inf)
        before, after = (np.concatenate(pair, axis=1) for pair in ((ends, tried[:, :-1]), (tried[:, 1:], ends)))
        pair, way = np.nonzero((tried >= before) & (tried >= after))
        slope, bend = (after - before)[pair, way] / 2, (after + before - 2 * tried)[pair, way]
        is_inside = np.isfinite(slope) & (bend < 0)
        aside = np.divide(-slope, bend, out=np.zeros_like(slope), where=is_inside)
        ahead = 1 + _TRIED[way] + (_TRIED[1] - _TRIED[0]) * aside
        rows.append(row[pair])
        angles.append(of.start[panel[at[pair]]] + of.width[panel[at[pair]]] / 2 * ahead)
        heights.append(tried[pair, way] + np.where(is_inside, slope, 0.0) * aside / 2)
    row, angle, height = np.concatenate(rows), np.concatenate(angles), np.concatenate(heights)
    np.maximum.at(best, row, height)
    is_high = height >= (best - _MARGIN * scale)[row]
    return _in_rows(row[is_high], angle[is_high], height[is_high], len(values))


@cache
def _weights(n_nodes: int) -> Array:
    """Of values at Gauss's points for those where a panel is tried, shape (tried, n)."""
    return np.ascontiguousarray(interpolation(_TRIED, n_nodes))


def _in_rows(row: NDArray[np.intp], angle: Array, height: Array, n_rows: int) -> Array:
    """The highest tops of each curve side by side, shape (curve, top)."""
    order = np.lexsort((angle, -height, row))
    row, angle = row[order], angle[order]
    rank = np.arange(row.size) - np.searchsorted(row, row)
    kept = rank < _MOST
    found = np.full((n_rows, int(np.max(rank[kept], initial=0)) + 1), np.nan)
    found[row[kept], rank[kept]] = angle[kept]
    return found
