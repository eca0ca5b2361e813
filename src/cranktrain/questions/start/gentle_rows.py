"""Rows of a long load curve that are next to no corners: steps may pass over some of them."""

from functools import lru_cache

import numpy as np

from cranktrain.motion import Array

_GENTLE = 100.0
"""Tolerances of a run: so much of the largest size lines at a gentle row may miss; works then err by few of them."""
_SEEN = 2.5e-6
"""Of the largest size: what lines through the rows that are counted miss; what rises between few of them is seen."""
_SAME = 1e-9
"""Angles closer than this are one. [rad]"""


def corners_and_rows(angles: Array, misses: Array, cycle: float, tolerance: float) -> tuple[Array, Array]:
    """Part what ends the steps of a run from rows of load curves that bend there as along a smooth one.

    Parameters
    ----------
    angles : Array, shape (event,)
        φ, as often as there is something; NaN for nothing. [rad]
    misses : Array, shape (event,)
        As those of `ForceEvents`.
    cycle : float
        [rad]
    tolerance : float
        Of the run.

    Returns
    -------
    corners, rows : Array
        Within the cycle, each once; of the rows no more than straight lines need that are as close to a smooth curve
        as a step asks for, so that finer curves take no more steps. [rad]

    Notes
    -----
    docs/theory/transient, eq. (26.15).
    """
    return _parted(angles.tobytes(), misses.tobytes(), cycle, tolerance)


@lru_cache(maxsize=64)
def _parted(angles_in_bytes: bytes, misses_in_bytes: bytes, cycle: float, tolerance: float) -> tuple[Array, Array]:
    """The same of their bytes: many starts have the same."""
    angles, misses = np.frombuffer(angles_in_bytes), np.frombuffer(misses_in_bytes)
    happens = np.isfinite(angles)
    within = np.mod(angles[happens] + _SAME, cycle) - _SAME
    order = np.argsort(within)
    within, missed = within[order], misses[happens][order]
    first = np.flatnonzero(np.diff(within, prepend=-np.inf) > _SAME)
    if first.size == 0:
        return within, within
    at, largest = within[first], np.maximum.reduceat(missed, first)
    is_gentle = largest <= _GENTLE * tolerance
    # n times as many lines miss n² times less
    needed = np.floor(np.cumsum(np.sqrt(largest[is_gentle] / _SEEN)))
    return at[~is_gentle], at[is_gentle][np.diff(needed, prepend=0.0) > 0]
