"""Unknowns that relieve the bearings of a shaft best: the largest load over all crank angles, or the mean."""

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics import Peak
from cranktrain.synthesis.least_loads import Least, least_largest, least_mean
from cranktrain.synthesis.plane_loads import Rest, Vectors, mean_square
from cranktrain.synthesis.relieved_bearings import ASIDE, WeightedShaft

Progress: TypeAlias = Callable[[float, float], None]
"""Is given, now and then, what has been reached, and what nothing goes below. [N]"""

_REACHED = 1e-7
"""Of the largest load: by how much the machine's own may be above that of the points chosen."""
_NEAR = 1e-2
"""Peaks that are lower by more than this part may wait."""
_IDLE = 1e-6
"""Of the largest load: an unknown that changes loads by less may as well be 0."""
_EVERY, _MOST_ROUNDS = 15, 100


def least_mean_load(shaft: WeightedShaft, *, turns: bool, progress: Progress | None = None) -> Least:
    """Least mean of the loads of some bearings together, by quadrature over the cycle between events.

    Parameters
    ----------
    shaft : WeightedShaft
    turns : bool
        As `least_largest` takes it.
    progress : callable, optional

    Returns
    -------
    Least
        [N]
    """
    angle, weight = shaft.quadrature()
    base, change = shaft.relieved(angle)
    n_bearings = len(base)
    share = np.tile(weight, n_bearings) / n_bearings
    if progress is not None:
        progress(float(share @ np.hypot(*base.reshape(-1, 2).T)), 0.0)
    return least_mean(_in_line(base, change), share, _of_all(shaft), turns=turns)


def least_largest_load(shaft: WeightedShaft, *, turns: bool, progress: Progress | None = None) -> Least:
    """Least of the largest loads of some bearings over all crank angles.

    Parameters
    ----------
    shaft : WeightedShaft
    turns : bool
        As `least_largest` takes it.
    progress : callable, optional

    Returns
    -------
    Least
        [N]

    Notes
    -----
    Of the crank angles a few count. What is found for these has its peaks elsewhere; with these it is found anew, until
    no peak of the machine's own curves is higher. docs/theory/synthesis, eqs. (8.33) and (8.34).
    """
    grid = shaft.crank_angle.shown
    base, change = shaft.relieved(grid)
    rest = _of_all(shaft)
    counts = np.zeros(base.shape[:2], dtype=np.bool_)
    counts[:, ::_EVERY] = True
    between = Vectors(np.empty((0, 2)), np.empty((0, 2, change.shape[-1])))
    least, top = Least(np.zeros(change.shape[-1]), np.inf, 0.0), np.inf
    for _round in range(_MOST_ROUNDS):
        chosen = Vectors(*map(np.concatenate, zip((base[counts], change[counts]), between, strict=True)))
        least = least_largest(chosen, rest, turns=turns)
        sizes = np.hypot(*np.moveaxis(base + change @ least.unknown, -1, 0))
        peak = shaft.largest(least.unknown, sizes)
        top = float(np.max(peak.value))
        if progress is not None:
            progress(top, least.bound)
        if top <= least.value * (1 + _REACHED):
            break
        counts |= _peaks(sizes) & (sizes > (1 - _NEAR) * least.value)
        more = _between(shaft, sizes, peak, (1 - _NEAR) * least.value)
        between = Vectors(*map(np.concatenate, zip(between, more, strict=True)))
    return least._replace(value=top)


def _in_line(base: Array, change: Array) -> Vectors:
    """Loads of several bearings one after another."""
    return Vectors(base.reshape(-1, 2), change.reshape(-1, 2, change.shape[-1]))


def _of_all(shaft: WeightedShaft) -> Rest:
    """What decides among unknowns that are as good: the mean square of the loads of all bearings."""
    vectors = _in_line(*shaft.vectors(shaft.crank_angle.shown))
    return mean_square(vectors, np.full(len(vectors.base), 1 / len(vectors.base)))


def without_idle(shaft: WeightedShaft, unknown: Array, *, turns: bool) -> Array:
    """Unknowns, of which those are 0 that change next to nothing."""
    base, change = shaft.vectors(shaft.crank_angle.shown)
    most = np.max(np.abs(change * unknown), axis=(0, 1, 2)).reshape(2 if turns else 1, -1)
    is_idle = np.max(most, axis=0) < _IDLE * np.max(np.abs(base))
    return np.where(np.tile(is_idle, 2 if turns else 1), 0.0, unknown)


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
    base, change = shaft.relieved(angle)
    return Vectors(base[own, np.arange(own.size)], change[own, np.arange(own.size)])
