"""Closing margin: how little one length may change before the crank cannot turn; and where links cannot close."""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.mechanisms.kind import scaled
from cranktrain.motion import Array
from cranktrain.numerics import Extreme, bracketed_roots, smallest, turn_grid

Gap = Callable[[Array, Any], Array]

_SCAN = 10.0 ** np.linspace(-6, 3, 37)
_GRID = turn_grid(180)


class ClosingMargin(NamedTuple):
    """Smallest relative change of one length that opens the links, of shape (..., 1).

    margin [1], length: index of the length, angle: of the mechanism's crank where they open [rad]. NaN and −1 where the
    links cannot close as they are.
    """

    margin: Array
    length: NDArray[np.intp]
    angle: Array


def closing_margin(gap: Gap, geometry: Any, lengths: Sequence[str]) -> ClosingMargin:
    """Find, for each length and both ways of changing it, the least change at which the links part.

    Parameters
    ----------
    gap : kernel (angle, geometry) → Array
        By how much the links close. [m]
    geometry : NamedTuple of arrays, shape (..., 1)
    lengths : sequence of str
        Dotted names of the geometry's lengths.

    Returns
    -------
    ClosingMargin, shape (..., 1)

    Notes
    -----
    The least gap over a turn is followed along each length's factor 1 ± ε: the first ε of a scan that opens the links
    brackets the root. docs/theory/closing-margin.
    """
    with np.errstate(all="ignore"):
        shape = np.shape(gap(np.zeros(1), geometry))
        ways = [(name, way) for name in lengths for way in (-1.0, 1.0)]

        def least(growth: Array) -> Extreme:
            """Least gap with each length in turn multiplied or divided by 1 + growth, shape (way, ..., *shape)."""
            changed = geometry
            for k, (name, way) in enumerate(ways):
                factor = np.ones(growth.shape)
                factor[k] = (1 + growth[k]) ** way
                changed = scaled(changed, name, factor)
            return smallest(lambda phi: gap(phi, changed), grid=_GRID)

        scan = least(np.broadcast_to(_SCAN.reshape((-1,) + (1,) * len(shape)), (len(ways), len(_SCAN), *shape)))
        opens = scan.value < 0
        first = np.argmax(opens, axis=1)
        low = np.where(first > 0, _SCAN[first - 1], 0.0)
        high = np.where(np.any(opens, axis=1), _SCAN[first], np.nan)
        growth = bracketed_roots(lambda trial: least(trial).value, low, high, precision=1e-12)
        signs = np.array([way for _, way in ways]).reshape((-1,) + (1,) * len(shape))
        change = np.where(np.isnan(growth), np.inf, np.abs((1 + growth) ** signs - 1))
        best = np.argmin(change, axis=0)[np.newaxis]
        margin = np.take_along_axis(change, best, axis=0)[0]
        angle = np.take_along_axis(least(np.nan_to_num(growth)).angle, best, axis=0)[0]
        closes = smallest(lambda phi: gap(phi, geometry), grid=_GRID).value > 0
    return ClosingMargin(
        margin=np.where(closes, margin, np.nan),
        length=np.where(closes, best[0] // 2, -1),
        angle=np.where(closes, np.mod(angle, 2 * np.pi), np.nan),
    )


class OpenRange(NamedTuple):
    """Crank angles between which the links cannot close [rad], and by how much they are short there [m]."""

    start: float
    end: float
    short: float


def open_ranges(gap: Gap, geometry: Any) -> tuple[OpenRange, ...]:
    """Give the angles of the mechanism's crank over which one mechanism cannot close, with edges to rounding.

    Parameters
    ----------
    gap : kernel (angle, geometry) → Array. [m]
    geometry : NamedTuple of floats

    Returns
    -------
    tuple of OpenRange
        In order of the angle within [0, 2π); a range across 0 ends beyond 2π. One range of a full turn where the links
        never close.
    """

    def curve(phi: Array) -> Array:
        return gap(phi, geometry)

    with np.errstate(all="ignore"):
        grid = turn_grid()
        deepest = smallest(curve, grid=grid)
        samples = curve(grid)
        # The least gap may lie between two grid points.
        grid = np.unique(np.append(grid, np.mod(deepest.angle, 2 * np.pi)))
        samples = curve(grid)
        is_open = ~(samples >= 0)
        if not np.any(is_open):
            return ()
        if np.all(is_open):
            return (OpenRange(0.0, 2 * np.pi, float(-deepest.value[0])),)
        start_at = np.flatnonzero(is_open & ~np.roll(is_open, 1))
        end_at = np.flatnonzero(is_open & ~np.roll(is_open, -1))
        if end_at[0] < start_at[0]:
            end_at = np.roll(end_at, -1)
        ranges: list[OpenRange] = []
        for first, last in zip(start_at.tolist(), end_at.tolist(), strict=True):
            before, after = _neighbour(grid, first, -1), _neighbour(grid, last, +1)
            start = bracketed_roots(curve, before, grid[first : first + 1])
            end = bracketed_roots(curve, grid[last : last + 1], after)
            end = end + 2 * np.pi * (end < start)
            inside = np.linspace(float(start[0]), float(end[0]), 91)
            ranges.append(OpenRange(float(start[0]), float(end[0]), float(-np.nanmin(curve(inside)))))
    return tuple(ranges)


def _neighbour(grid: Array, index: int, step: int) -> Array:
    """Angle beside a grid point, across the end of the turn where need be."""
    other = index + step
    turn = 2 * np.pi * (other // len(grid))
    return grid[[other % len(grid)]] + turn
