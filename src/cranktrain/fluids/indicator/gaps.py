"""Gaps between the samples of a cycle, judged by what may be lost in them."""

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import InputError
from cranktrain.fluids.indicator.reading import Trace
from cranktrain.language import Words, _
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.quantities import shown

_DOUBTFUL = 3.5
"""Usual steps from which one is a gap."""
_WIDEST_STEP = np.radians(31.0)
"""Wider ones are gaps even among their like: textbooks print a sample each 30°. [rad]"""
_WIDEST = np.radians(60.0)
"""Over a wider gap nothing is known, however flat the pressure is beside it. [rad]"""
_MOST_LOST = 0.01
"""Area of pressure over angle that a gap may cost, in parts of the range of pressures times a radian.

Of the mean pressure, which is a sixth to a tenth of that range, it is 2 to 3 %.
"""
_RADIANS = 15.0
"""A cycle of fewer degrees may be in radians."""


def gap_flags(
    trace: Trace, angles: Array, pressures: Array, lines: NDArray[np.intp], cycle: float
) -> tuple[Words, ...]:
    """Refuse gaps that may cost too much, and flag the others.

    Parameters
    ----------
    trace : Trace
        For messages.
    angles, pressures : Array, shape (n,)
        One cycle in order. [rad, Pa]
    lines : array of int, shape (n,)
        Of the file.
    cycle : float
        [rad]

    Returns
    -------
    tuple of Words

    Raises
    ------
    InputError
        With the gap that may cost most.
    """
    steps = np.diff(angles, append=angles[0] + cycle)
    step = float(np.median(steps[steps > 0]))
    gaps = np.flatnonzero(steps > min(_DOUBTFUL * step, _WIDEST_STEP))
    if not gaps.size:
        return ()
    errors = bridging_errors(angles, pressures, gaps, cycle)
    costs = np.where(steps[gaps] > _WIDEST, np.inf, errors * steps[gaps])
    worst = first_largest(costs)
    if costs[worst] > _MOST_LOST * np.ptp(pressures):
        raise _refused(trace, angles, int(gaps[worst]), float(steps[gaps[worst]]), float(errors[worst]), lines)
    widest = first_largest(steps)
    start, end = _degrees(angles[widest]), _degrees(angles[widest] + steps[widest])
    if gaps.size == 1:
        said = _("There are no samples between {start} and {end}: the curve bridges them.")
    else:
        said = _("Samples are missing at {n} places, most of all between {start} and {end}: the curve bridges them.")
    return (said.format(n=gaps.size, start=start, end=end),)


def bridging_errors(angles: Array, pressures: Array, gaps: NDArray[np.intp], cycle: float) -> Array:
    """By how much a curve that bridges gaps may be off.

    Parameters
    ----------
    angles, pressures : Array, shape (n,)
        One cycle in order. [rad, Pa]
    gaps : array of int, shape (k,)
        The samples before them.
    cycle : float
        [rad]

    Returns
    -------
    Array, shape (k,)
        g/4 · max |s − c|, with the width g, the chord c over the gap and the slopes s beside it. [Pa]

    Notes
    -----
    By so much a straight line and a parabola that leaves with the slope differ at most: nothing where the pressure is
    flat, a quarter of the step where it jumps, all of the crest above a chord. docs/theory/gas, "Gaps".
    """
    n_samples = len(angles)
    around = np.concatenate([angles - cycle, angles, angles + cycle])
    levels = np.tile(pressures, 3)
    found = np.empty(len(gaps))
    for row, before in enumerate((gaps + n_samples).tolist()):
        after = before + 1
        width = around[after] - around[before]
        first = min(int(np.searchsorted(around, around[before] - width / 2)), before - 1)
        last = max(int(np.searchsorted(around, around[after] + width / 2, side="right")) - 1, after + 1)
        beside = (slice(first, after), slice(after, last + 1))
        chord = (levels[after] - levels[before]) / width
        found[row] = width / 4 * max(abs(_slope(around[side], levels[side]) - chord) for side in beside)
    return found


def _slope(places: Array, values: Array) -> float:
    """Slope of the straight line through samples, by least squares; 0 where they stand at one place."""
    about = places - np.mean(places)
    spread = float(np.sum(about * about))
    return float(np.sum(about * values)) / spread if spread > 0 else 0.0


def _refused(trace: Trace, angles: Array, gap: int, width: float, error: float, lines: NDArray[np.intp]) -> InputError:
    """Give the error of a gap that costs too much."""
    allowed = _(
        "has no samples between {start} and {end}, a gap of {gap}, in which the pressure may be {error} bar off"
    )
    said = allowed.format(
        start=_degrees(angles[gap]),
        end=_degrees(angles[gap] + width),
        gap=_degrees(width),
        error=f"{shown(error, 'bar'):.2g}",
    )
    repair = _("give what is missing, or a whole cycle")
    if shown(float(np.ptp(angles)), "deg") < _RADIANS:
        repair = _('if the file\'s angles are radians, write axis_unit = "rad"')
    return trace.refused(said, int(lines[gap]), repair)


def _degrees(angle: float) -> str:
    """Write an angle in degrees."""
    return f"{shown(float(angle), 'deg'):.7g}°"
