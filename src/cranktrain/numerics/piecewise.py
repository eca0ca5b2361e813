"""Curves of polynomials from node to node, wherever nodes stand: laid through known ends, and their extremes.

A node at every break of a curve leaves pieces that are smooth; of a break both sides are known, and an extreme may
stand there with a corner as well as in a piece where the slope is 0.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array, Coefficient
from cranktrain.numerics.extremes import Extremes
from cranktrain.numerics.subintervals import leggauss
from cranktrain.numerics.tops import Extreme

_NARROWEST = 1e-9
"""In narrower pieces nothing is looked for but their ends. [rad]"""
_STEPS = 5
_STOOD = 1e-9
"""Of a piece: after such a step of Newton's method the next one is less than rounding."""
_ALIKE = 1e-9
"""Extremes that differ by less, in parts of the curve's, are one height, of which the first counts."""
_N_MEAN = 4
"""Gauss's points in each piece."""

ByShare = Callable[[Array], Coefficient]
"""Value and derivatives of a curve at a share of each of its pieces, broadcastable to (..., piece)."""
Among = Callable[[NDArray[np.bool_] | None], ByShare]
"""That of those pieces that are chosen of that shape, or of all for None."""


class PiecePlaces(NamedTuple):
    """Where pieces of curves begin, the first at 0, and how wide they are, shape (design, piece). [rad]"""

    start: Array
    width: Array


def pieces_from(starts: Array, cycle: float) -> PiecePlaces:
    """Pieces that begin at some angles, rising from 0, of which several may be one, up to the cycle. [rad]"""
    return PiecePlaces(starts, np.diff(starts, axis=-1, append=np.full((*starts.shape[:-1], 1), cycle)))


def quintics(before: Coefficient, after: Coefficient, width: Array) -> Array:
    """Coefficients of the quintics with given values and derivatives at the ends of their pieces.

    Parameters
    ----------
    before, after : Coefficient, shape (..., piece)
        At each piece's end, and at its start.
    width : Array, shape (..., piece)
        [rad]

    Returns
    -------
    Array, shape (6, ..., piece)
        By powers of the share of the piece.

    Examples
    --------
    >>> start, end = (np.array([power * x ** max(power - 1, 0) for x in (0.0, 2.0)]) for power in (0, 1))
    >>> motion = lambda x: Coefficient(x**5, 5 * x**4, 20 * x**3)
    >>> found = quintics(motion(np.array([2.0])), motion(np.array([0.0])), np.array([2.0]))
    >>> np.round(found[:, 0], 9).tolist()
    [0.0, 0.0, 0.0, 0.0, 0.0, 32.0]
    """
    rise = before.value - after.value
    v, w = after.first * width, before.first * width
    a, b = after.second * width**2, before.second * width**2
    return np.stack(
        np.broadcast_arrays(
            after.value,
            v,
            a / 2,
            10 * rise - 6 * v - 4 * w - 1.5 * a + 0.5 * b,
            -15 * rise + 8 * v + 7 * w + 1.5 * a - b,
            6 * rise - 3 * v - 3 * w - 0.5 * a + 0.5 * b,
        )
    )


def piece_extremes(among: Among, pieces: PiecePlaces) -> Extremes:
    """Smallest and largest value of a continuous curve of pieces.

    Parameters
    ----------
    among : Among
    pieces : PiecePlaces

    Returns
    -------
    Extremes, shapes (..., 1)
        Angles in [0, cycle). NaN where the curve is NaN anywhere.
    """
    starts, width = pieces
    start, end = map(among(None), (np.zeros(()), np.ones(())))
    rises = np.sign(start.first)
    turns = (rises * end.first < 0) & (width > _NARROWEST)
    # Most pieces rise or fall throughout.
    motion, own_width = among(turns), np.broadcast_to(width, turns.shape)[turns]
    level = _level(motion, start.first[turns], end.first[turns], own_width)
    share, inside = np.zeros_like(start.value), np.array(start.value)
    share[turns], inside[turns] = level, motion(level).value
    found: list[Extreme] = []
    for sign in (-1.0, 1.0):
        own = np.where(turns & (rises == sign) & (sign * (inside - start.value) > 0), share, 0.0)
        value = sign * np.where(own > 0, inside, start.value)
        best = np.max(value, axis=-1, keepdims=True)
        scale = np.max(np.abs(start.value), axis=-1, keepdims=True)
        first = np.argmax(value >= best - _ALIKE * scale, axis=-1, keepdims=True)
        angle = np.take_along_axis(np.broadcast_to(starts + own * width, value.shape), first, axis=-1)
        found.append(Extreme(np.where(np.isnan(best), np.nan, angle), sign * best))
    return Extremes(*found)


def _level(motion: ByShare, start: Array, end: Array, width: Array) -> Array:
    """Share at which the slope passes through 0 of pieces, by those at their ends; by Newton's method between bounds.

    The secant's step is the first.
    """
    low, high, rises = np.zeros_like(start), np.ones_like(start), np.sign(start)
    with np.errstate(all="ignore"):
        share = np.clip(np.nan_to_num(start / (start - end), nan=0.5), 0.0, 1.0)
        for _step in range(_STEPS):
            found = motion(share)
            is_before = rises * found.first > 0
            low, high = np.where(is_before, share, low), np.where(is_before, high, share)
            newton = share - found.first / (found.second * width)
            better = np.where((newton >= low) & (newton <= high), newton, (low + high) / 2)
            move, share = np.abs(better - share), better
            if np.max(move, initial=0.0) < _STOOD:
                break
    return share


def mean_shares() -> tuple[Array, Array]:
    """Gauss's points as shares of a piece, and their weights, of sum 1."""
    node, weight = leggauss(_N_MEAN)
    return (1 + node) / 2, weight / 2
