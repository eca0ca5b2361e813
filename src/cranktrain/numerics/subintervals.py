"""Integrals of curves that are smooth between known breaks: Gauss's points panel by panel, so that few are exact."""

from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array, Coefficient
from cranktrain.numerics.products import product

_NODES = ((0.04, 3), (0.2, 5), (0.6, 8), (np.inf, 12))
"""Panels up to a part of the widest, and how many points are enough there for 13 digits."""
_NARROWEST = 1e-13
"""Breaks that are closer are one. [rad]"""
_RESOLVED = 1e-10
"""Last orders of a curve in a panel that are small, in parts of the curve: its integral is then exact to rounding."""
_ASIDE = 1e-11
"""How far beside an angle a side of it is, past what rounding leaves of a break there. [rad]"""

_NO_WAY = 1e-300
"""From one of Gauss's points to itself: what is so near to it has its value alone."""


class Subintervals(NamedTuple):
    """One period cut at breaks, and further where that leaves wide pieces.

    Attributes
    ----------
    start, width : Array, shape (panel,)
        Rising from the first edge. [rad]
    first, size : array of int, shape (panel,)
        Which of the points are in each panel.
    angle, weight : Array, shape (point,)
        Gauss's points and their weights. [rad]
    """

    start: Array
    width: Array
    first: NDArray[np.intp]
    size: NDArray[np.intp]
    angle: Array
    weight: Array


class _Placed(NamedTuple):
    """In which panel angles lie, at which way in [−1, 1] there, and after how many whole periods, shape (k,)."""

    panel: NDArray[np.intp]
    way: Array
    turns: Array


def subintervals(breaks: Array, widest: float, period: float, n_more: int = 0) -> Subintervals:
    """Cut one period into panels.

    Parameters
    ----------
    breaks : Array, shape (n,)
        Any angles; NaN for none. [rad]
    widest : float
        How wide a panel may be for the curve to be smooth in it as far as Gauss's points see. [rad]
    period : float
        [rad]
    n_more : int
        By how many points panels have more than the integral needs, so that a curve between them is as exact.

    Returns
    -------
    Subintervals
    """
    known = np.mod(breaks[~np.isnan(breaks)], period)
    n_parts = int(np.ceil(period / widest - _NARROWEST))
    marks = np.arange(n_parts) * (period / n_parts) + (known[0] if known.size else 0.0)
    edges = np.sort(np.concatenate([known, np.mod(marks, period)]))
    edges = np.append(edges, edges[0] + period)
    is_one: NDArray[np.bool_] = np.diff(edges) > _NARROWEST
    start, width = edges[:-1][is_one], np.diff(edges)[is_one]
    bounds, few = zip(*_NODES, strict=True)
    sizes = [n_nodes + n_more for n_nodes in few]
    size: NDArray[np.intp] = np.array(sizes, dtype=np.intp)[np.searchsorted(np.array(bounds) * widest, width)]
    first: NDArray[np.intp] = np.cumsum(size, dtype=np.intp) - size
    angle, weight = np.empty((2, int(np.sum(size))))
    for n_nodes in set(size.tolist()):
        chosen = size == n_nodes
        node, share = leggauss(n_nodes)
        place: NDArray[np.intp] = first[chosen, np.newaxis] + np.arange(n_nodes, dtype=np.intp)
        half = width[chosen, np.newaxis] / 2
        angle[place] = start[chosen, np.newaxis] + half * (1 + node)
        weight[place] = half * share
    return Subintervals(start, width, first, size, angle, weight)


def shows(of: Subintervals, values: Array) -> bool:
    """Whether the points of the widest panels show a curve, shape (..., point): its last orders there are small."""
    most = int(np.max(of.size))
    place: NDArray[np.intp] = of.first[of.size == most, np.newaxis] + np.arange(most, dtype=np.intp)
    last = np.abs(product(values[..., place], to_series(most)[-2:].T))
    return not np.any(last > _RESOLVED * np.max(np.abs(values)))


def points_together(breaks: Array, widest: float, period: float, n_more: int = 0) -> tuple[Array, Array]:
    """Gauss's points of several designs and their weights, laid side by side; beyond a design's own the weight is 0.

    Parameters
    ----------
    breaks : Array, shape (design, n)
        Where each design's curves may have kinks or jump; NaN for none. [rad]
    widest, period : float
        As `subintervals` takes them. [rad]
    n_more : int
        Likewise.

    Returns
    -------
    angle, weight : Array, shape (design, 1, point)
        [rad]

    Examples
    --------
    >>> angle, weight = points_together(np.array([[0.5], [np.nan]]), 1.0, 6.0)
    >>> np.round(np.sum(np.cos(2 * np.pi * angle / 6.0) ** 2 * weight, axis=-1), 9).tolist()
    [[3.0], [3.0]]
    """
    cuts = [subintervals(own, widest, period, n_more) for own in breaks]
    angle, weight = np.zeros((2, len(cuts), 1, max(cut.angle.size for cut in cuts)))
    for design, cut in enumerate(cuts):
        angle[design, 0, : cut.angle.size], weight[design, 0, : cut.angle.size] = cut.angle, cut.weight
    return angle, weight


def integral_to(of: Subintervals, values: Array, angle: Array) -> Array:
    """Integral of a periodic curve from the first edge of the panels to some angles.

    Parameters
    ----------
    of : Subintervals
    values : Array, shape (..., point)
        At the panels' points.
    angle : Array, shape (k,)
        Within one period of each other or not. [rad]

    Returns
    -------
    Array, shape (..., k)
        Of the polynomial through the points of each panel.
    """
    panel, way, turns = _placed(of, angle, 0.0)
    total = _whole_panels(of, values, panel, turns)
    for chosen, place, n_nodes in _by_size(of, panel):
        part = np.sum(values[..., place] * partial_integrals(way[chosen], n_nodes), axis=-1)
        total[..., chosen] += of.width[panel[chosen]] / 2 * part
    return total


def integral_motion(of: Subintervals, values: Array, angle: Array) -> tuple[Coefficient, Coefficient]:
    """Integral of a periodic curve as `integral_to` has it, with the curve and its slope on both sides of the angles.

    Parameters
    ----------
    of : Subintervals
    values : Array, shape (..., point)
    angle : Array, shape (k,)
        [rad]

    Returns
    -------
    before, after : Coefficient, shape (..., k)
        The integral, the curve, its slope: just before and just after the angles, which at a break differ.
    """
    after, before = _placed(of, angle, _ASIDE), _placed(of, angle, -_ASIDE)
    differs = np.flatnonzero(before.panel != after.panel)
    asked = _Placed(
        np.concatenate([after.panel, before.panel[differs]]),
        np.concatenate([after.way, before.way[differs]]),
        np.concatenate([after.turns, before.turns[differs]]),
    )
    both = _beside(of, values, asked)
    found = Coefficient(*(part[..., : angle.size] for part in both))
    same = Coefficient(*(part.copy() for part in found))
    for part, own in zip(same, both, strict=True):
        part[..., differs] = own[..., angle.size :]
    return same, found


def _beside(of: Subintervals, values: Array, placed: _Placed) -> Coefficient:
    """Integral, curve and slope at places in panels, shape (..., k)."""
    panel, way, turns = placed
    found = np.empty((3, *values.shape[:-1], panel.size))
    size = of.size[panel]
    for n_nodes in np.unique(size).tolist():
        chosen, own = np.flatnonzero(size == n_nodes), np.flatnonzero(of.size == n_nodes)
        # Panels are few beside the places in them.
        series = series_of_motion(values[..., of.first[own, np.newaxis] + np.arange(n_nodes)])[:3]
        at = np.moveaxis(series, -1, 1)[..., np.searchsorted(own, panel[chosen])]
        legendre = _legendre(way[chosen], n_nodes).T
        found[..., chosen] = np.sum(at * legendre.reshape(-1, *(1,) * (values.ndim - 1), chosen.size), axis=1)
    half = of.width[panel] / 2
    integral, curve, slope = found
    return Coefficient(_whole_panels(of, values, panel, turns) + half * integral, curve, slope / half)


def _placed(of: Subintervals, angle: Array, aside: float) -> _Placed:
    """Place of each angle in the panels, or of what is aside of it."""
    period = float(np.sum(of.width))
    turns = np.floor((angle + aside - of.start[0]) / period)
    inside = angle - turns * period
    # The first panel begins where the period does.
    panel = np.asarray(np.searchsorted(of.start[1:], inside + aside, side="right"), dtype=np.intp)
    return _Placed(panel, np.clip(2 * (inside - of.start[panel]) / of.width[panel] - 1, -1.0, 1.0), turns)


def _whole_panels(of: Subintervals, values: Array, panel: NDArray[np.intp], turns: Array) -> Array:
    """Integral from the first edge to the start of each panel that is asked for, shape (..., k)."""
    whole = np.add.reduceat(values * of.weight, of.first, axis=-1)
    before = np.cumsum(whole, axis=-1) - whole
    return before[..., panel] + turns * np.sum(whole, axis=-1, keepdims=True)


def _by_size(of: Subintervals, panel: NDArray[np.intp]) -> Iterator[tuple[NDArray[np.intp], NDArray[np.intp], int]]:
    """Which of the panels that are asked for have so many points, where these are, and how many."""
    for n_nodes in np.unique(of.size[panel]).tolist():
        chosen = np.flatnonzero(of.size[panel] == n_nodes)
        place: NDArray[np.intp] = of.first[panel[chosen], np.newaxis] + np.arange(n_nodes, dtype=np.intp)
        yield chosen, place, n_nodes


@cache
def leggauss(n_nodes: int) -> tuple[Array, Array]:
    """Gauss's points in (−1, 1) and their weights."""
    return np.polynomial.legendre.leggauss(n_nodes)


def interpolation(way: Array, n_nodes: int) -> Array:
    """Weights of values at Gauss's points for the value at some ways in [−1, 1], shape (..., n)."""
    apart = way[..., np.newaxis] - leggauss(n_nodes)[0]
    shares = _barycentric(n_nodes) / np.where(apart == 0.0, _NO_WAY, apart)
    return shares / np.sum(shares, axis=-1, keepdims=True)


def partial_integrals(way: Array, n_nodes: int) -> Array:
    """Weights of values at Gauss's points for the integral from −1 to some ways, shape (k, n)."""
    return product(_legendre_integrals(way, _legendre(way, n_nodes)), to_series(n_nodes))


@cache
def _barycentric(n_nodes: int) -> Array:
    """Weights of Gauss's points in the barycentric formula, of which only the ratios count."""
    node, weight = leggauss(n_nodes)
    return np.sqrt((1 - node * node) * weight) * np.where(np.arange(n_nodes) % 2, -1.0, 1.0)


def series_of_motion(values: Array) -> Array:
    """Legendre series of curves by their values at Gauss's points, shape (..., n): (4, ..., n + 1).

    Of the integral over the way from −1 on, of the curve, its slope and its bend.
    """
    n_nodes = values.shape[-1]
    series = product(values, _to_motion(n_nodes))
    return np.moveaxis(series.reshape(*values.shape[:-1], 4, n_nodes + 1), -2, 0)


@cache
def _to_motion(n_nodes: int) -> Array:
    """From values at Gauss's points to those series one behind the other, shape (n, 4 · (n + 1))."""
    found = np.zeros((4, n_nodes + 1, n_nodes))
    found[1, :-1] = to_series(n_nodes)
    found[0] = np.polynomial.legendre.legint(found[1, :-1], lbnd=-1)
    for order in (2, 3):
        found[order, :-2] = np.polynomial.legendre.legder(found[order - 1, :-1])
    return found.reshape(-1, n_nodes).T


@cache
def to_series(n_nodes: int) -> Array:
    """From values at Gauss's points to the coefficients of Legendre's polynomials, shape (n, n)."""
    node, weight = leggauss(n_nodes)
    order = np.arange(n_nodes)[:, np.newaxis]
    return (order + 0.5) * np.polynomial.legendre.legvander(node, n_nodes - 1).T * weight


def _legendre(way: Array, degree: int) -> Array:
    """Legendre's polynomials up to a degree at some ways, shape (k, degree + 1)."""
    return np.asarray(np.polynomial.legendre.legvander(way, degree), dtype=np.float64)


def _legendre_integrals(way: Array, values: Array) -> Array:
    """Integrals of Legendre's polynomials from −1 to some ways, by the values there, one more, shape (k, n)."""
    order: Array = np.arange(1.0, values.shape[-1] - 1)
    rest = (values[:, 2:] - values[:, :-2]) / (2 * order + 1)
    return np.concatenate([(1 + way)[:, np.newaxis], rest], axis=1)
