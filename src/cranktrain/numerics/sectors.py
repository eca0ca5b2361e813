"""How much of a plane vector points where: its size, integrated while its direction is within each sector.

Between breaks the vector is smooth; on every panel it is the polynomial through Gauss's points, and where that crosses
an edge of a sector is found on it, so that nothing depends on a grid.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.roots import bracketed_roots
from cranktrain.numerics.series import around_zero
from cranktrain.numerics.subintervals import Subintervals, interpolation, leggauss

_TRIED = np.linspace(-1.0, 1.0, 41)
"""Where on a panel the direction is looked at first."""
_ON_EDGE = 1e-12
"""A vector whose part across an edge is smaller, in parts of its largest, points along that edge."""
_FEW = 3
"""Gauss's points from sample to sample, for the size, which is no polynomial and nearly has a kink at nothing."""
_TURNING = 1e-9
"""Directions that turn by less from sample to sample and back do not turn. [rad]"""


class Sectors(NamedTuple):
    """Integral of a vector's size by its direction, shape (..., n): in [φ's unit · the vector's].

    Attributes
    ----------
    within : Array
        While it points between edge k and edge k + 1; edge k is at 2πk/n from the first axis toward the second.
    along : Array
        While it points along edge k, as a vector that does not turn may.
    """

    within: Array
    along: Array


class _Panels(NamedTuple):
    """Both parts of a vector at Gauss's points of panels that have as many, shape (row, n).

    half: half a panel's width; largest: the vector's largest size over all panels; shape (row,).
    """

    x: Array
    y: Array
    half: Array
    largest: Array

    def at(self, row: NDArray[np.intp], way: Array) -> tuple[Array, Array]:
        """Both parts at ways in [−1, 1] of some panels, shape (k,)."""
        weight = interpolation(way, self.x.shape[1])
        return np.sum(self.x[row] * weight, axis=-1), np.sum(self.y[row] * weight, axis=-1)

    def between(self, row: NDArray[np.intp], start: Array, end: Array) -> Array:
        """Integral of the size from one way to another near to it."""
        node, weight = leggauss(_FEW)
        ways = start[:, np.newaxis] + (end - start)[:, np.newaxis] * (node + 1) / 2
        shares = interpolation(ways, self.x.shape[1])
        sizes = np.hypot(np.einsum("kn,kjn->kj", self.x[row], shares), np.einsum("kn,kjn->kj", self.y[row], shares))
        return self.half[row] * (end - start) / 2 * (sizes @ weight)

    def along(self) -> Array:
        """Integral of the size from the start to every way of `_TRIED`, shape (row, way)."""
        node, weight = leggauss(_FEW)
        ways = (_TRIED[:-1, np.newaxis] + np.diff(_TRIED)[:, np.newaxis] * (node + 1) / 2).ravel()
        shares = interpolation(ways, self.x.shape[1]).T
        sizes = np.hypot(self.x @ shares, self.y @ shares).reshape(len(self.x), -1, _FEW)
        parts = self.half[:, np.newaxis] * np.diff(_TRIED) / 2 * (sizes @ weight)
        return np.concatenate([np.zeros((len(parts), 1)), np.cumsum(parts, axis=1)], axis=1)


class _Samples(NamedTuple):
    """Of every panel, shape (row, sample): where, in which direction, and the integral of the size up to there.

    code: 2k where it points along edge k, 2k + 1 where between edge k and the next.
    """

    way: Array
    code: NDArray[np.intp]
    integral: Array
    n_sectors: int


class _Steps(NamedTuple):
    """From sample to sample: which panel, after which sample, its code, and how many codes the next is ahead."""

    row: NDArray[np.intp]
    place: NDArray[np.intp]
    start: NDArray[np.intp]
    ahead: NDArray[np.intp]


_Parts = tuple[NDArray[np.intp], NDArray[np.intp], Array]
"""Rows of panels, codes of directions, and parts of the integral that belong there."""


def size_by_sector(of: Subintervals, x: Array, y: Array, n_sectors: int) -> Sectors:
    """Integrate the size of vectors over one period, apart by where they point.

    Parameters
    ----------
    of : Subintervals
    x, y : Array, shape (curve, point)
        Parts of each vector at the panels' points.
    n_sectors : int

    Returns
    -------
    Sectors, shape (curve, n_sectors)
        NaN for a vector that is NaN anywhere.

    Notes
    -----
    To some 1e-9 of the whole; to 1e-7 where a vector comes near to nothing, and to 1e-5 where a direction turns back
    within a fortieth of a panel beyond an edge.

    Examples
    --------
    A vector of size 1 that goes round once:

    >>> from cranktrain.numerics.subintervals import subintervals
    >>> cut = subintervals(np.array([0.3]), 1.0, 2 * np.pi)
    >>> found = size_by_sector(cut, np.cos(cut.angle)[np.newaxis], np.sin(cut.angle)[np.newaxis], 4)
    >>> np.round(found.within * 4 / (2 * np.pi), 9).tolist()
    [[1.0, 1.0, 1.0, 1.0]]
    """
    size = np.hypot(x, y)
    known = np.flatnonzero(np.all(np.isfinite(size), axis=-1))
    found = np.full((len(x), 2 * n_sectors), np.nan)
    found[known] = 0.0
    for n_nodes in np.unique(of.size).tolist() if known.size else ():
        chosen = np.flatnonzero(of.size == n_nodes)
        place: NDArray[np.intp] = of.first[chosen, np.newaxis] + np.arange(n_nodes, dtype=np.intp)
        parts = (part[known][:, place].reshape(-1, n_nodes) for part in (x, y))
        largest = np.repeat(np.max(size[known], axis=-1, initial=0.0), chosen.size)
        panels = _Panels(*parts, half=np.tile(of.width[chosen] / 2, known.size), largest=largest)
        curve = np.repeat(known, chosen.size)
        for row, code, value in _by_direction(panels, n_sectors):
            np.add.at(found, (curve[row], code % (2 * n_sectors)), value)
    return Sectors(within=found[:, 1::2], along=found[:, 0::2])


def _by_direction(panels: _Panels, n_sectors: int) -> Iterator[_Parts]:
    """Share the integral over every panel out among directions."""
    samples = _samples(panels, n_sectors)
    row, place = np.indices((len(samples.way), samples.way.shape[1] - 1)).reshape(2, -1)
    start, end = samples.code[row, place], samples.code[row, place + 1]
    ahead = (end - start + n_sectors) % (2 * n_sectors) - n_sectors
    # What turns round along a line points nowhere between.
    is_turned = (np.abs(ahead) == n_sectors) & (start % 2 == 0) & (end % 2 == 0)
    yield from _turned_round(panels, samples, _Steps(*(part[is_turned] for part in (row, place, start, ahead))))
    yield from _crossed(panels, samples, _Steps(*(part[~is_turned] for part in (row, place, start, ahead))))


def _turned_round(panels: _Panels, samples: _Samples, steps: _Steps) -> Iterator[_Parts]:
    """Share out what turns round along an edge: before it is nothing, and after."""
    row, place, start, ahead = steps
    begin, end = samples.way[row, place], samples.way[row, place + 1]
    n_sectors = samples.n_sectors
    nowhere = _crossing(panels, row, (start.astype(np.float64) + n_sectors / 2) * (np.pi / n_sectors), begin, end)
    yield row, start, panels.between(row, begin, nowhere)
    yield row, start + ahead, panels.between(row, nowhere, end)


def _crossed(panels: _Panels, samples: _Samples, steps: _Steps) -> Iterator[_Parts]:
    """Share out what crosses edges, none or several from sample to sample."""
    row, place, start, ahead = steps
    sense = np.where(ahead < 0, -1, 1)
    # Between two samples only sectors count: an edge is where the vector stays.
    first = np.where((ahead != 0) & (start % 2 == 0), start + sense, start)
    last = start + ahead - np.where((ahead != 0) & ((start + ahead) % 2 == 0), sense, 0)
    yield row, last, samples.integral[row, place + 1] - samples.integral[row, place]
    n_edges = np.abs(last - first) // 2
    several = np.repeat(np.arange(row.size), n_edges)
    if several.size == 0:
        return
    number = np.arange(several.size) - np.repeat(np.cumsum(n_edges) - n_edges, n_edges)
    row, place, sense = row[several], place[several], sense[several]
    before = first[several] + 2 * number * sense
    begin, end = samples.way[row, place], samples.way[row, place + 1]
    edge = (before + sense).astype(np.float64) * (np.pi / samples.n_sectors)
    until = panels.between(row, begin, _crossing(panels, row, edge, begin, end))
    yield row, before, until
    yield row, before + 2 * sense, -until


def _samples(panels: _Panels, n_sectors: int) -> _Samples:
    """Look at every panel, also where directions turn back."""
    n_nodes = panels.x.shape[1]
    weight = interpolation(_TRIED, n_nodes).T
    way = np.tile(_TRIED, (len(panels.x), 1))
    x, y = panels.x @ weight, panels.y @ weight
    integral = panels.along()
    ahead = around_zero(np.diff(np.arctan2(y, x), axis=-1), 2 * np.pi)
    row, place = np.nonzero(ahead[:, :-1] * ahead[:, 1:] < -(_TURNING**2))
    one, other = ahead[row, place], ahead[row, place + 1]
    way[row, place + 1] += (_TRIED[1] - _TRIED[0]) * (one + other) / (2 * (one - other))
    x[row, place + 1], y[row, place + 1] = panels.at(row, way[row, place + 1])
    integral[row, place + 1] += panels.between(row, _TRIED[place + 1], way[row, place + 1])
    size = np.hypot(x, y)
    part = np.mod(np.arctan2(y, x), 2 * np.pi) * (n_sectors / (2 * np.pi))
    nearest = np.rint(part)
    across = size * np.abs(part - nearest) * (2 * np.pi / n_sectors)
    is_along = across <= _ON_EDGE * panels.largest[:, np.newaxis]
    code = np.where(is_along, 2 * nearest, 2 * np.floor(part) + 1).astype(np.intp) % (2 * n_sectors)
    return _Samples(way, code, integral, n_sectors)


def _crossing(panels: _Panels, row: NDArray[np.intp], edge: Array, low: Array, high: Array) -> Array:
    """Where between two ways the vectors of some panels cross edges; the second where they do not."""
    normal_x, normal_y = -np.sin(edge)[:, np.newaxis], np.cos(edge)[:, np.newaxis]
    nodes = panels.x[row] * normal_x + panels.y[row] * normal_y

    def across(way: Array) -> Array:
        return np.sum(nodes * interpolation(way, panels.x.shape[1]), axis=-1)

    found = bracketed_roots(across, low, high)
    return np.where(np.isnan(found), high, found)
