"""The least of a convex function within bounds, along its centres: Newton's method inside a barrier."""

from collections.abc import Callable, Iterator
from typing import NamedTuple, cast

import numpy as np

from cranktrain.motion import Array

_GROWTH = 10.0
"""Of the sharpness, from centre to centre."""
_CENTRED, _MOST_STEPS, _MOST_HALVINGS = 1e-9, 60, 50
_KEPT = 0.1
"""Of what a step promises, that it has to keep."""
_ROUNDING = 1e-15
"""Of the value: what a step promises below that cannot be seen."""
_RIDGE = 1e-14
"""Of the curvature: less is rounding, along which nothing is known."""


class BarrierValue(NamedTuple):
    """Value, slope and curvature of a function with its barrier."""

    value: float
    slope: Array
    curvature: Array


class BarrierCentre(NamedTuple):
    """The least of sharpness times a function, with the barrier added."""

    place: Array
    sharpness: float


Barred = Callable[[Array, float], BarrierValue]
"""A function times a sharpness, with its barrier; infinite outside."""


def centres(measured: Barred, start: Array, parameter: float, left: float) -> Iterator[BarrierCentre]:
    """Follow the centres from a place inside to the minimum.

    Parameters
    ----------
    measured : callable (place, sharpness) → BarrierValue
    start : Array, shape (n,)
    parameter : float
        Of the barrier: over the sharpness it is what a centre may be above the minimum.
    left : float
        How far above it the last one may be, if nothing were rounded.

    Yields
    ------
    BarrierCentre
        Each nearer to the minimum than the one before.
    """
    place, sharpness = start, 1.0
    while True:
        place = _centre(measured, place, sharpness)
        yield BarrierCentre(place, sharpness)
        if sharpness >= parameter / left:
            return
        sharpness = min(_GROWTH * sharpness, parameter / left)


def _centre(measured: Barred, start: Array, sharpness: float) -> Array:
    """Least of the function with its barrier, by Newton's method."""
    place, here = start, measured(start, sharpness)
    for _time in range(_MOST_STEPS):
        step = _step(here)
        promised = -float(here.slope @ step)
        if not promised > _CENTRED + _ROUNDING * abs(here.value):
            break
        share, ahead = 1.0, measured(place + step, sharpness)
        for _halving in range(_MOST_HALVINGS):
            if ahead.value <= here.value - _KEPT * share * promised:
                break
            share /= 2
            ahead = measured(place + share * step, sharpness)
        else:
            break  # all that is left is rounding
        place, here = place + share * step, ahead
    return place


def _step(here: BarrierValue) -> Array:
    """Newton's step, in measures in which all unknowns bend alike."""
    measure = 1 / np.sqrt(np.diag(here.curvature))
    bends = here.curvature * measure * measure[:, np.newaxis] + _RIDGE * np.eye(measure.size)
    return -measure * cast(Array, np.linalg.solve(bends, measure * here.slope))


def outside(n: int) -> BarrierValue:
    """What a function is where nothing may be."""
    return BarrierValue(np.inf, np.zeros(n), np.eye(n))
