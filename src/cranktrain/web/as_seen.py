"""What of a picture no number is read: with as many points and bits as it takes that no eye tells it from the whole."""

from collections.abc import Iterator, Sequence
from math import frexp

import numpy as np

from cranktrain.motion import Array

_STEPS = (16, 8, 4, 2)
"""Between points, at most and at least, where some are left out."""
_BITS = 12
"""Of the largest value: of an arrow of 120 pixels a thirtieth of one."""


def in_bits_seen(values: Array, largest: float) -> Array:
    """Round values, whose largest has a size, to a power of two: their last bytes are 0, and compressed nothing."""
    _part, power = frexp(largest)
    grain = 2.0 ** (power - _BITS)
    return np.round(values / grain) * grain


def outlined(lines: Sequence[Array], far: float) -> Iterator[Array]:
    """Leave points of lines out, as long as what is drawn without them is near.

    Parameters
    ----------
    lines : sequence of Array, shape (2, n)
        Points in order, whose distances along each line are alike in some way, as those at even crank angles are.
    far : float
        How far from a point that is left out the line may pass; in the unit of the lines.

    Yields
    ------
    Array, shape (2, k)
        Each line with its ends and the points that it needs.
    """
    for line in lines:
        n = line.shape[-1] - 1
        is_needed = np.ones(n + 1, np.bool_)
        for step in _STEPS:
            if n % step == 0:
                is_near = _missed(line, step) <= far
                within = is_needed[:-1].reshape(-1, step)[:, 1:]  # a view: all but the beginning of each piece
                within[is_near] = False
        yield line[:, is_needed]


def _missed(line: Array, step: int) -> Array:
    """How far at most the points of each piece are from where they would be on its chord, evenly."""
    part = np.arange(step) / step
    ends = line[:, ::step, np.newaxis]
    chords = ends[:, :-1] + (ends[:, 1:] - ends[:, :-1]) * part
    away = line[:, :-1].reshape(2, -1, step) - chords
    return np.max(np.hypot(*away), axis=-1)
