"""Kloss's formula fitted to a catalogue: from rated point, from start, and from both; they contradict each other."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array

POLE = 2.0
"""Asymmetry from which the full formula has a pole where the motor generates."""


def slip_from_rated(rated_slip: Array, breakdown_ratio: Array) -> Array:
    """Breakdown slip with which the simplified formula passes through the rated point.

    Parameters
    ----------
    rated_slip : Array
    breakdown_ratio : Array, broadcastable
        Breakdown torque over rated torque; NaN comes of less than 1.

    Notes
    -----
    docs/theory/drive, eq. (25.5). The other root lies below the rated slip: that point would be unstable.

    Examples
    --------
    >>> round(float(slip_from_rated(35 / 1500, 3.0)), 8)
    0.13599663
    """
    return rated_slip * (breakdown_ratio + np.sqrt((breakdown_ratio - 1) * (breakdown_ratio + 1)))


def slip_from_start(starting_ratio: Array, breakdown_ratio: Array) -> Array:
    """Breakdown slip with which the simplified formula has the starting torque; both in parts of the rated torque.

    docs/theory/drive, eq. (25.6).
    """
    ratio = breakdown_ratio / starting_ratio
    return 1 / (ratio + np.sqrt((ratio - 1) * (ratio + 1)))


class FullFit(NamedTuple):
    """The full formula through rated point and start; NaN where there is none."""

    breakdown_slip: Array
    asymmetry: Array


def full_fit(rated_slip: Array, breakdown_ratio: Array, starting_ratio: Array) -> FullFit:
    """Both numbers of the full formula that passes through rated point, breakdown and start.

    Notes
    -----
    Either point gives ε by s_b; equal, they are a quadratic in s_b. docs/theory/drive, eq. (25.7).
    """
    start = starting_ratio / (breakdown_ratio - starting_ratio)
    rated = 1 / (breakdown_ratio - 1)
    first = start - rated / rated_slip
    second = 2 * breakdown_ratio * (rated - 1 / (breakdown_ratio - starting_ratio))
    third = start - rated * rated_slip
    found = [_full(sign, (first, second, third), start, starting_ratio, breakdown_ratio) for sign in (1.0, -1.0)]
    is_one = [(slip > rated_slip) & (asymmetry > -POLE) for slip, asymmetry in found]
    return FullFit(
        *(np.where(is_one[0], one, np.where(is_one[1], other, np.nan)) for one, other in zip(*found, strict=True))
    )


def _full(sign: float, powers: tuple[Array, Array, Array], start: Array, starting: Array, breakdown: Array) -> FullFit:
    """One of both roots, and the asymmetry that belongs to it."""
    a, b, c = powers
    with np.errstate(invalid="ignore", divide="ignore"):
        slip = (-b + sign * np.sqrt(b * b - 4 * a * c)) / (2 * a)
        asymmetry = (start * (1 + slip * slip) - 2 * breakdown * slip / (breakdown - starting)) / slip
    return FullFit(slip, asymmetry)


class Contradiction(NamedTuple):
    """What fits of Kloss's formula to one catalogue say; torques in parts of the rated one.

    Attributes
    ----------
    slip_by_rated, start_by_rated : Array
        Breakdown slip of the simplified formula through the rated point; its torque at standstill.
    slip_by_start, rated_by_start : Array
        That of the one with the starting torque; its torque at the rated slip.
    rated_slip_by_start : Array
        Slip at which that one has the rated torque.
    full : FullFit
    has_pole : array of bool
        Whether the full one is of no use where the motor generates.
    """

    slip_by_rated: Array
    start_by_rated: Array
    slip_by_start: Array
    rated_by_start: Array
    rated_slip_by_start: Array
    full: FullFit
    has_pole: NDArray[np.bool_]


def contradiction(rated_slip: Array, breakdown_ratio: Array, starting_ratio: Array) -> Contradiction:
    """How fits to rated point and start contradict each other, as the bars of real cages are deep.

    docs/theory/drive, eqs. (25.5) to (25.7).

    Examples
    --------
    >>> found = contradiction(35 / 1500, 3.0, 2.3)
    >>> round(float(found.start_by_rated), 2), round(float(found.rated_by_start), 2), bool(found.has_pole)
    (0.8, 0.3, True)
    """
    by_rated, by_start = slip_from_rated(rated_slip, breakdown_ratio), slip_from_start(starting_ratio, breakdown_ratio)
    full = full_fit(rated_slip, breakdown_ratio, starting_ratio)
    return Contradiction(
        by_rated,
        2 * breakdown_ratio * by_rated / (1 + by_rated * by_rated),
        by_start,
        2 * breakdown_ratio * rated_slip * by_start / (rated_slip * rated_slip + by_start * by_start),
        by_start / (breakdown_ratio + np.sqrt((breakdown_ratio - 1) * (breakdown_ratio + 1))),
        full,
        full.asymmetry >= POLE,
    )
