"""Extremes of curves that are smooth between known breaks only: kinks and jumps, of gas and of friction.

A grid shows near which of its points a peak stands; about each of these the curve is laid through Chebyshev's points of
every piece between breaks, so that nothing is smoothed across one, and an end of a piece is the limit from its side.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.roots import Curve

_ABOUT = 1.2
"""How far from a grid point that is a peak the curve's own may be, in steps: a break on the next point lies within."""
_N_NODES = 9
_NODES = np.cos((2 * np.arange(_N_NODES) + 1) * (np.pi / (2 * _N_NODES)))
_TO_POWERS: Array = np.linalg.inv(np.vander(_NODES, increasing=True))
"""From values at the nodes of (−1, 1) to the polynomial's coefficients, by rising powers."""
_TRIED = np.linspace(-1.0, 1.0, 65)
_TRIED_POWERS: Array = np.vander(_TRIED, _N_NODES, increasing=True)
_NEWTON_STEPS = 4
_ALIKE = 1e-9
"""Values that differ by less, in parts of the curve's largest, are one: rounding must not choose between them."""
_LEVEL = 1e-12
"""The same along one piece, whose values are exact to rounding."""
_ONE_BREAK = 1e-9
"""Breaks that are closer are one. [rad]"""
_MOST = 48
"""Peaks of one curve that are looked at."""


class Peak(NamedTuple):
    """An extreme of each curve, shapes (..., 1): where [rad], how much, and on which side of a jump.

    side is 1 where the value is the limit from just after the angle, −1 from just before it, 0 where both are one.
    """

    angle: Array
    value: Array
    side: Array


class Peaks(NamedTuple):
    """Smallest and largest value of each curve."""

    smallest: Peak
    largest: Peak


def extremes_between(curve: Curve, grid: Array, samples: Array, breaks: Array | None) -> Peaks:
    """Smallest and largest value of each curve over its period.

    Parameters
    ----------
    curve : Curve
        Gives (..., k) for angles (..., k), each curve at its own.
    grid : Array, shape (n,)
        Equal steps over the period. [rad]
    samples : Array, shape (..., n)
        The curve on the grid.
    breaks : Array, shape broadcastable to (..., m), or None
        Where the curve may jump or have kinks; NaN for none. [rad]

    Returns
    -------
    Peaks, shapes (..., 1)
        An angle may lie a step beside the grid's period. Of alike peaks the first one in the period. NaN where the
        curve is NaN all over, or about its highest points.
    """
    found = _found(curve, grid, samples, breaks, (-1.0, 1.0))
    return Peaks(*(Peak(*(part[place] for part in found)) for place in range(2)))


def largest_between(curve: Curve, grid: Array, samples: Array, breaks: Array | None) -> Peak:
    """Largest value of each curve; as `extremes_between`."""
    return Peak(*(part[0] for part in _found(curve, grid, samples, breaks, (1.0,))))


def _found(curve: Curve, grid: Array, samples: Array, breaks: Array | None, signs: Sequence[float]) -> Peak:
    """Largest value of each curve times each of some signs, given as the curve's own, shape (sign, ..., 1)."""
    shape, n_points = samples.shape[:-1], samples.shape[-1]
    step = float(grid[1] - grid[0])
    scale = np.tile(np.fmax.reduce(np.abs(samples), axis=-1, initial=0.0).reshape(-1, 1), (len(signs), 1))
    sign = np.repeat(signs, len(scale) // len(signs))[:, np.newaxis]
    known = np.fmax(sign * np.tile(samples.reshape(-1, n_points), (len(signs), 1)), -np.inf)
    own_breaks = _own_breaks(breaks, shape)
    near = np.tile(_near_breaks(own_breaks, grid, n_points), (len(signs), 1))
    centre = grid[_places(known, scale, near)]
    edges = _edges(np.tile(own_breaks, (len(signs), 1)), centre, step, n_points)
    half, middle = np.diff(edges, axis=-1) / 2, (edges[..., 1:] + edges[..., :-1]) / 2
    asked = (centre[..., np.newaxis] + middle)[..., np.newaxis] + half[..., np.newaxis] * _NODES
    with np.errstate(all="ignore"):
        # All that is asked of one curve stands side by side.
        together = np.moveaxis(asked.reshape(len(signs), *shape, -1), 0, -2)
        given = curve(together.reshape(*shape, -1)).reshape(together.shape)
        found = sign[..., np.newaxis, np.newaxis] * np.moveaxis(given, -2, 0).reshape(asked.shape)
        is_known = np.max(known, axis=-1)[:, np.newaxis, np.newaxis] > -np.inf
        is_piece = is_known & (half > 0.0) & ~np.any(np.isnan(found), axis=-1)
        base = found[..., _N_NODES // 2]
        powers = (found - base[..., np.newaxis]) @ _TO_POWERS.T
        # What is level from before its grid point on begins, for us, there.
        at_point = np.where(np.abs(middle) < half, -middle / half, -1.0)
        way = _top(powers, scale[..., np.newaxis], np.where(edges[..., :-1] <= edges[..., :1], at_point, -1.0))
        top = np.where(is_piece, base + _value(powers, way), -np.inf)
        angle = centre[..., np.newaxis] + middle + half * way
        side = _sides(way, base, powers, is_piece, scale[..., np.newaxis])
    best = _first_of_the_best(angle, top, side, scale, step * n_points)
    return Peak(*(part.reshape(len(signs), *shape, 1) for part in (best.angle, sign * best.value, best.side)))


def _own_breaks(breaks: Array | None, shape: tuple[int, ...]) -> Array:
    """Breaks of each curve, shape (curve, m)."""
    given = np.empty((1, 0)) if breaks is None else breaks
    return np.broadcast_to(given, (*shape, given.shape[-1])).reshape(int(np.prod(shape)), given.shape[-1])


def _near_breaks(breaks: Array, grid: Array, n_points: int) -> NDArray[np.bool_]:
    """Whether there is a break next to each point of the grid, shape (curve, n)."""
    near = np.zeros((len(breaks), n_points), dtype=np.bool_)
    row, _place = at = np.nonzero(~np.isnan(breaks))
    below = np.floor((breaks[at] - grid[0]) / (grid[1] - grid[0])).astype(np.intp)
    for beside in range(-1, 3):
        near[row, (below + beside) % n_points] = True
    return near


def _places(known: Array, scale: Array, has_break: NDArray[np.bool_]) -> NDArray[np.intp]:
    """Places of those peaks of the grid about which the largest value may stand, shape (curve, peak)."""
    same = np.where(scale > 0, _ALIKE * scale, 1.0)
    ring = np.concatenate([known[:, -1:], known, known[:, :1]], axis=-1)
    is_top = (known >= ring[:, :-2] - same) & (known >= ring[:, 2:] - same) & (known > -np.inf)
    row, place = np.nonzero(is_top)
    before, at, after = ring[row, place], known[row, place], ring[row, place + 2]
    with np.errstate(all="ignore"):
        # By how much a parabola's top is higher, and what a curve may rise to at a break.
        bend = 2 * at - before - after
        rise = np.where(has_break[row, place], at - np.minimum(before, after), (after - before) ** 2 / (8 * bend))
        hope = at + np.nan_to_num(2.0 * rise, nan=0.0, posinf=0.0, neginf=0.0)
        turn = np.nan_to_num((after - before) / same[row, 0], nan=0.0, posinf=0.0, neginf=0.0)
    may_be = hope >= (np.max(known, axis=-1) - same[:, 0])[row]
    row, place, turn = row[may_be], place[may_be], np.rint(turn[may_be])
    height = np.rint(hope[may_be] / same[row, 0])
    # What is alike on the grid, and beside it too, is the same peak of another throw: the first stands for all.
    order = np.lexsort((place, turn, -height, row))
    keys = np.stack([row, height, turn])[:, order]
    is_first = np.any(np.diff(keys, axis=-1, prepend=np.nan) != 0, axis=0)
    row, place = row[order][is_first], place[order][is_first]
    rank = np.arange(row.size) - np.searchsorted(row, row)
    kept = rank < _MOST
    places = np.zeros((len(known), int(np.max(rank[kept], initial=0)) + 1), dtype=np.intp)
    # Curves with fewer peaks have their highest again.
    places[row[rank == 0]] = place[rank == 0, np.newaxis]
    places[row[kept], rank[kept]] = place[kept]
    return places


def _edges(breaks: Array, centre: Array, step: float, n_points: int) -> Array:
    """Ends of the pieces about each peak, from its grid point, shape (curve, peak, piece + 1). [rad]"""
    wide, period = _ABOUT * step, step * n_points
    away = np.mod(breaks[:, np.newaxis, :] - centre[..., np.newaxis] + period / 2, period) - period / 2
    inside = np.sort(np.where(np.abs(away) < wide - _ONE_BREAK, away, wide), axis=-1)
    if inside.shape[-1]:
        inside[..., 1:][np.diff(inside, axis=-1) < _ONE_BREAK] = wide
        inside = np.sort(inside, axis=-1)
        inside = inside[..., : int(np.max(np.sum(inside < wide, axis=-1), initial=0))]
    ends = np.full((*centre.shape, 1), wide)
    return np.concatenate([-ends, inside, ends], axis=-1)


def _top(powers: Array, scale: Array, level: Array) -> Array:
    """Where in [−1, 1] the polynomial is largest; where it is so from −1 on, at `level`; shape (...)."""
    tried = powers @ _TRIED_POWERS.T
    # The first of what is level: rounding must not move an extreme along a level stretch.
    is_top = tried >= np.max(tried, axis=-1, keepdims=True) - _LEVEL * scale[..., np.newaxis]
    place = np.argmax(is_top, axis=-1)
    start, apart = _TRIED[place], float(_TRIED[1] - _TRIED[0])
    is_level = np.sum(is_top, axis=-1) > 1
    way = start
    for _step in range(_NEWTON_STEPS):
        first, second = _derivatives(powers, way)
        move = np.where(second < 0, -first / second, np.sign(first) * apart)
        way = np.clip(way + np.nan_to_num(move), np.maximum(start - apart, -1.0), np.minimum(start + apart, 1.0))
    return np.where(is_level, np.where(place == 0, level, start), way)


def _value(powers: Array, way: Array) -> Array:
    """Polynomial by rising powers."""
    total = np.zeros_like(way)
    for part in reversed(range(_N_NODES)):
        total = total * way + powers[..., part]
    return total


def _derivatives(powers: Array, way: Array) -> tuple[Array, Array]:
    """First and second derivative of the polynomial."""
    first = second = np.zeros_like(way)
    for part in reversed(range(1, _N_NODES)):
        second = second * way + first
        first = first * way + part * powers[..., part]
    return first, second


def _sides(way: Array, base: Array, powers: Array, is_piece: NDArray[np.bool_], scale: Array) -> Array:
    """On which side of a jump a piece's top stands: 0 where its neighbour goes on from the same value."""
    ends = base + np.stack([powers @ (-1.0) ** np.arange(_N_NODES), np.sum(powers, axis=-1)])
    leap = np.abs(ends[0, ..., 1:] - ends[1, ..., :-1]) > _ALIKE * scale
    jump = np.where(is_piece[..., 1:] & is_piece[..., :-1], leap, False)
    none = np.zeros_like(is_piece[..., :1])
    after, before = np.concatenate([none, jump], axis=-1), np.concatenate([jump, none], axis=-1)
    return np.where((way <= -1.0) & after, 1.0, np.where((way >= 1.0) & before, -1.0, 0.0))


def _first_of_the_best(angle: Array, top: Array, side: Array, scale: Array, period: float) -> Peak:
    """Choose the highest of each curve's pieces, of alike ones the first in the period; shapes (curve, 1)."""
    angle, top, side = (part.reshape(len(scale), -1) for part in (angle, top, side))
    best = np.max(top, axis=-1, keepdims=True)
    turn = np.mod(angle + _ONE_BREAK, period)
    first = np.argmin(np.where(top >= best - _ALIKE * scale, turn, np.inf), axis=-1)[:, np.newaxis]
    is_known = best > -np.inf
    at, which = (np.where(is_known, np.take_along_axis(part, first, axis=-1), np.nan) for part in (angle, side))
    return Peak(at, np.where(is_known, best, np.nan), which)
