"""Where in a step something falls through 0: no event is stepped over."""

import math
from collections.abc import Callable

import numpy as np

from cranktrain.motion import Array
from cranktrain.transient.clutched.equation import N_PRESS_FED
from cranktrain.transient.clutched.step import INTERPOLANT

LOOKS = np.linspace(0.0, 1.0, 17)
"""Parts of a step at which it is looked at."""
FEW_LOOKS = np.linspace(0.0, 1.0, 5)
"""For what takes long to look at, and is as smooth as the step."""
_MOST_TRIALS = 100
_LOOK_BACK = 4
"""After so many trials the bracket is to be half as wide."""
_MOST_HALVINGS = 40


def states_within(state: Array, slopes: Array, width: float, parts: Array) -> Array:
    """Flywheel's speed, crank's angle and speed at parts of a step, shape (parts, 3), by the step's interpolant."""
    rates = INTERPOLANT.T @ slopes[:, :N_PRESS_FED]
    powers = parts[:, np.newaxis] ** np.arange(1, 5)
    return state[:N_PRESS_FED] + width * powers @ rates


def first_fall(
    curve: Callable[[Array], Array], parts: Array, values: Array, tolerance: float
) -> tuple[float, float] | None:
    """Bracket of the first part of a step at which a curve falls from above below 0; None where it does not.

    Parameters
    ----------
    curve : callable
        Of parts of the step, shape (n,).
    parts, values : Array, shape (n,)
        Where it has been looked at, in even steps from 0 to 1, and what was seen there.
    tolerance : float
        Below 0 by no more is rounding.

    Notes
    -----
    Between three looks of which the middle one is least, where a parabola has its bottom is looked at, too.

    Examples
    --------
    >>> first_fall(lambda part: 0.52 - part, FEW_LOOKS, 0.52 - FEW_LOOKS, 0.0)
    (0.5, 0.75)
    >>> first_fall(lambda part: (part - 0.6) ** 2 - 1e-4, FEW_LOOKS, (FEW_LOOKS - 0.6) ** 2 - 1e-4, 0.0)
    (0.5, 0.6)
    """
    bottom = (values[1:-1] < values[:-2]) & (values[1:-1] <= values[2:]) & (values[1:-1] >= 0)
    if bottom.any():
        at = np.flatnonzero(bottom) + 1
        left, middle, right = values[at - 1], values[at], values[at + 1]
        moved = parts[at] + 0.5 * (left - right) / (left - 2 * middle + right) * parts[1]
        parts = np.concatenate([parts, moved])
        values = np.concatenate([values, curve(moved)])
        order = np.argsort(parts)
        parts, values = parts[order], values[order]
    below = np.flatnonzero(values < -tolerance)
    if not len(below):
        return None
    last = below[0]
    above = np.flatnonzero(values[:last] > 0)
    return float(parts[above[-1]] if len(above) else 0.0), float(parts[last])


def least_within(values: Array) -> float:
    """Least value of a smooth curve over a step, by a parabola about the least of its looks."""
    at = int(np.argmin(values))
    if at in (0, len(values) - 1):
        return float(values[at])
    left, middle, right = values[at - 1 : at + 2]
    bend = left - 2 * middle + right
    return float(middle - 0.125 * (left - right) ** 2 / bend) if bend > 0 else float(middle)


def fallen_at(curve: Callable[[float], float], low: float, high: float, rounding: float = 0.0) -> float:
    """Where a curve, above 0 at `low` and below at `high`, passes 0: where it is not above any more, to rounding.

    Of the place or of the curve: below 0 by no more than `rounding` will do. By false position with the weight of an
    end that stays twice halved (Illinois), and by halving where that is slow.
    """
    value_low, value_high = curve(low), curve(high)
    if not value_low > 0:
        # it begins at 0: above it at once, if only for a moment, or not at all
        nearer = (low + (high - low) * 0.5**n for n in range(1, _MOST_HALVINGS))
        above = next((part for part in nearer if curve(part) > 0), None)
        if above is None:
            return low
        low, value_low = above, curve(above)
    stays, before = 0, high - low
    for trial in range(1, _MOST_TRIALS):
        if high - low <= 4 * math.ulp(high):
            break
        at = low + (high - low) * value_low / (value_low - value_high)
        if trial % _LOOK_BACK == 0:
            at = at if high - low < 0.5 * before else 0.5 * (low + high)
            before = high - low
        at = at if low < at < high else 0.5 * (low + high)
        value = curve(at)
        if value > 0:
            value_high *= 0.5 if stays > 0 else 1.0
            low, value_low, stays = at, value, 1
        else:
            value_low *= 0.5 if stays < 0 else 1.0
            high, value_high, stays = at, value, -1
            if value >= -rounding:
                break
    return high
