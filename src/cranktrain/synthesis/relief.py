"""Unknowns that relieve the bearings of a shaft best: the largest load over all crank angles, or the mean."""

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics import Peak
from cranktrain.synthesis.least_loads import Least, Vectors, least_largest, least_mean
from cranktrain.synthesis.weighted_shaft import ASIDE, WeightedShaft

_REACHED = 1e-7
"""Of the largest load: by how much the machine's own may be above that of the points chosen."""
_NEAR = 1e-2
"""Peaks that are lower by more than this part may wait."""
_EVERY, _MOST_ROUNDS = 15, 100


def least_mean_load(shaft: WeightedShaft, *, turns: bool) -> Least:
    """Least mean of the loads of some bearings together, by quadrature over the cycle between events.

    Parameters
    ----------
    shaft : WeightedShaft
    turns : bool
        As `least_largest` takes it.

    Returns
    -------
    Least
        [N]
    """
    angle, weight = shaft.quadrature()
    base, change = shaft.vectors(angle)
    n_bearings = len(base)
    vectors = Vectors(base.reshape(-1, 2), change.reshape(-1, 2, change.shape[-1]))
    return least_mean(vectors, np.tile(weight, n_bearings) / n_bearings, turns=turns)


def least_largest_load(shaft: WeightedShaft, *, turns: bool) -> Least:
    """Least of the largest loads of some bearings over all crank angles.

    Parameters
    ----------
    shaft : WeightedShaft
    turns : bool
        As `least_largest` takes it.

    Returns
    -------
    Least
        [N]

    Notes
    -----
    Of the crank angles a few count. What is found for these has its peaks elsewhere; with these it is found anew, until
    no peak of the machine's own curves is higher. docs/theory/synthesis, eq. (8.36).
    """
    grid = shaft.crank_angle.shown
    base, change = shaft.vectors(grid)
    counts = np.zeros(base.shape[:2], dtype=np.bool_)
    counts[:, ::_EVERY] = True
    between = Vectors(np.empty((0, 2)), np.empty((0, 2, change.shape[-1])))
    for _round in range(_MOST_ROUNDS):
        chosen = Vectors(*map(np.concatenate, zip((base[counts], change[counts]), between, strict=True)))
        least = least_largest(chosen, turns=turns)
        sizes = np.hypot(*np.moveaxis(base + change @ least.unknown, -1, 0))
        peak = shaft.largest(least.unknown, sizes)
        top = float(np.max(peak.value))
        if top <= least.value * (1 + _REACHED):
            break
        counts |= _peaks(sizes) & (sizes > (1 - _NEAR) * least.value)
        more = _between(shaft, sizes, peak, (1 - _NEAR) * least.value)
        between = Vectors(*map(np.concatenate, zip(between, more, strict=True)))
    return least._replace(value=top)


def _peaks(sizes: Array) -> NDArray[np.bool_]:
    """Which points of the grid are as high as those beside them, shape (bearing, n)."""
    return (sizes >= np.roll(sizes, 1, axis=-1)) & (sizes >= np.roll(sizes, -1, axis=-1))


def _between(shaft: WeightedShaft, sizes: Array, peak: Peak, least: float) -> Vectors:
    """Loads at the peaks between the grid's points: of the highest by the machine, of others by parabolas."""
    grid = shaft.crank_angle.shown
    bearing, place = np.nonzero(_peaks(sizes) & (sizes > least))
    before, at, after = (sizes[bearing, (place + away) % grid.size] for away in (-1, 0, 1))
    bend = 2 * at - before - after
    way = np.where(bend > 0, (after - before) / (2 * np.where(bend > 0, bend, 1.0)), 0.0)
    highest = np.flatnonzero(peak.value > least)
    angle = np.append(grid[place] + way * (grid[1] - grid[0]), peak.angle[highest] + ASIDE * peak.side[highest])
    own = np.append(bearing, highest)
    base, change = shaft.vectors(angle)
    return Vectors(base[own, np.arange(own.size)], change[own, np.arange(own.size)])
