"""Firing orders that the crank pins allow, beside one that they do not: the most even ones, the likest first."""

import itertools
from collections.abc import Sequence

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN

MOST_TOLD = 3
_MOST_CYLINDERS = 16
"""Of more there are too many choices of turns to try."""
_ROUNDING = 1e-6
"""Of sums of squared intervals, as a part of the smallest."""


def likest_orders(tops: Array, cycle: float, wanted: Sequence[int]) -> list[tuple[int, ...]]:
    """Give the most even orders that the crank pins allow, those first that differ least from a wanted one.

    Parameters
    ----------
    tops : Array, shape (cylinder,)
        Crank angle in [0, 2π) at which each cylinder's piston is nominally at its top. [rad]
    cycle : float
        2π or 4π. [rad]
    wanted : sequence of int
        Cylinders as they were to fire; −1 for what is no cylinder.

    Returns
    -------
    list of tuple of int
        At most three orders, each from the first cylinder of the wanted one.

    Examples
    --------
    >>> likest_orders(np.radians([0, 180, 180, 0]), 4 * np.pi, [0, 1, 2, 3])
    [(0, 1, 3, 2), (0, 2, 3, 1)]
    """
    n_turns, n_cylinders = round(cycle / TURN), tops.size
    if n_cylinders < 2 or n_cylinders > _MOST_CYLINDERS:
        return []
    first = next((i for i in wanted if i >= 0), 0)
    start = next((place for place, i in enumerate(wanted) if i >= 0), 0)
    asked = [*wanted[start:], *wanted[:start]]
    orders = _most_even(tops, n_turns, first)

    def likeness(order: tuple[int, ...]) -> tuple[int, tuple[int, ...]]:
        return (-sum(one == other for one, other in zip(order, asked, strict=False)), order)

    return sorted(orders, key=likeness)[:MOST_TOLD]


def has_even_order(tops: Array, cycle: float, tolerance: float) -> bool:
    """Whether some order fires evenly, with a tolerance in parts of the interval; `tops` as of `likest_orders`.

    Examples
    --------
    >>> has_even_order(np.radians([0, 180, 180, 0]), 4 * np.pi, 0.01)
    True
    >>> has_even_order(np.radians([0, 90, 270, 180]), 4 * np.pi, 0.01)
    False
    """
    step: float = cycle / tops.size

    def places(angles: Array) -> Array:
        within = np.mod(angles, TURN)
        return np.sort(np.where(within > TURN - tolerance * step, within - TURN, within))

    # An even order has a piston at its top at every step of the cycle, wherever in the turn that is.
    wanted = places(np.linspace(0.0, cycle, tops.size, endpoint=False))
    return bool(np.all(np.abs(places(tops - tops[0]) - wanted) <= tolerance * step))


def _most_even(tops: Array, n_turns: int, first: int) -> list[tuple[int, ...]]:
    """Try every choice of turns, and keep the orders whose squared intervals add up to the least."""
    n_cylinders, cycle = tops.size, TURN * n_turns
    after = np.mod(tops - tops[first], TURN)
    after[after > TURN - _ROUNDING] = 0.0
    choices = [[0.0] if i == first else [TURN * turn for turn in range(n_turns)] for i in range(n_cylinders)]
    angles = after + np.array(list(itertools.product(*choices)))
    order = np.argsort(angles, axis=-1, kind="stable")
    in_order = np.take_along_axis(angles, order, axis=-1)
    last = in_order[:, :1] + cycle
    unevenness = np.sum(np.diff(np.concatenate([in_order, last], axis=-1)) ** 2, axis=-1)
    best = order[unevenness <= np.min(unevenness) * (1 + _ROUNDING)]
    return [(*row[row.index(first) :], *row[: row.index(first)]) for row in best.tolist()]
