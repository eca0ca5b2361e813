"""Rows of a long load curve that are next to no corners: steps may pass over some of them."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.load_laws import ByAngle
from cranktrain.motion import Array
from cranktrain.numerics.polyline import Polyline

_GENTLE = 1e-5
"""Of a curve's largest size: by how much straight lines at a gentle row may miss a smooth curve through the rows."""
_SAME = 1e-9
"""Angles closer than this are one. [rad]"""


def gentle_rows(laws: Sequence[ByAngle], corners: Array, zero: Array, cycle: float) -> NDArray[np.bool_]:
    """Which corners are rows of load curves whose lines bend there as those along a smooth curve do, and nothing else.

    Parameters
    ----------
    laws : sequence of ByAngle
    corners : Array, shape (design, corner)
        φ, as often as there is something; NaN fills up. [rad]
    zero : Array, shape (design,)
        φ where the shown angle is 0. [rad]
    cycle : float
        [rad]

    Returns
    -------
    Array of bool, shape (design, corner)
    """
    found = np.zeros(corners.shape, dtype=np.bool_)
    for design, own in enumerate(corners):
        curves = [law.polylines[min(design, len(law.angles) - 1)] for law in laws]
        rows = [_gentle(curve, cycle) + zero[min(design, len(zero) - 1)] for curve in curves]
        at = np.mod(own + _SAME, cycle)
        gentle = np.mod(np.concatenate([*rows, np.empty(0)]) + _SAME, cycle)
        n_gentle = _n_near(gentle, at)
        found[design] = (n_gentle > 0) & (n_gentle == _n_near(at[np.isfinite(at)], at))
    return found


def _gentle(curve: Polyline, cycle: float) -> Array:
    """Angles of a curve's gentle rows within a cycle. [rad]"""
    angles, values, period = curve
    before, after = angles - np.roll(angles, 1), np.roll(angles, -1) - angles
    before[0], after[-1] = before[0] + period, after[-1] + period
    bend = (np.roll(values, -1) - values) / after - (values - np.roll(values, 1)) / before
    misses = np.abs(bend) * (before + after) / 16
    own = angles[misses <= _GENTLE * np.max(np.abs(values))]
    return (own[:, np.newaxis] + np.arange(0.0, cycle - period / 2, period)).ravel()


def _n_near(angles: Array, at: Array) -> NDArray[np.intp]:
    """How many of some angles lie at each of others."""
    ordered = np.sort(angles)
    return np.searchsorted(ordered, at + _SAME, side="right") - np.searchsorted(ordered, at - _SAME)
