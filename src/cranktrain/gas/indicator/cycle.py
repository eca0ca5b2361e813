"""The samples of one cycle: unwrapped, sorted, each angle once, without gaps."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import InputError, Position, Problem
from cranktrain.gas.indicator.reading import Trace
from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.quantities import shown

_TURN = 2 * np.pi
_SAME = 1e-3
"""Angles closer than this, in steps, are one."""
_FEWEST = 24
"""Samples of a cycle: textbooks print one each 30°."""
_WIDEST_STEP = np.radians(31.0)
_WIDEST_GAP = np.radians(15.0)
"""In a trace of finer steps."""
_RADIANS = 15.0
"""A cycle of fewer degrees may be in radians."""
_DOUBTFUL_GAP = 3.5
"""Steps over which the spline's word is doubted."""
_IN_ORDER = 0.9
"""Share of the rows that go on in one sense, jumps apart, in a file whose rows are in order."""
_ALIKE = 0.01
"""First and last sample of a closed cycle differ by less, in parts of the peak."""


class Samples(NamedTuple):
    """One cycle: angles rising within one cycle [rad], absolute pressures [Pa], what was found, and what is doubted."""

    angles: Array
    pressures: Array
    findings: tuple[str, ...]
    doubts: tuple[str, ...]


def one_cycle(trace: Trace, cycle: float) -> Samples:
    """Put a trace over the crank angle in order.

    Parameters
    ----------
    trace : Trace
        With `axis` "angle".
    cycle : float
        Of the machine: 2π or 4π. [rad]

    Returns
    -------
    Samples, in the file's own counting, but without jumps

    Raises
    ------
    InputError
        If it is not just one cycle of this machine, has a gap, or two pressures for one angle.
    """
    _refuse_few(trace, len(trace.places), cycle)
    unwrapped = _without_jumps(trace.places)
    order = np.argsort(unwrapped, kind="stable")
    samples = Samples(unwrapped[order], trace.pressures[order], (), ())
    samples, lines = _each_once(samples, trace, trace.lines[order])
    _refuse_few(trace, len(samples.angles), cycle)
    step = float(np.median(np.diff(samples.angles)))
    samples, lines = _open_ended(samples, lines, cycle, step)
    _refuse_another_cycle(trace, samples.angles, step, cycle)
    return samples._replace(doubts=(*samples.doubts, *_gap_doubts(trace, samples.angles, lines, cycle, step)))


def _refuse_few(trace: Trace, n_samples: int, cycle: float) -> None:
    """Refuse what is too little for a cycle."""
    fewest = round(_FEWEST * cycle / (2 * _TURN))
    if n_samples < fewest:
        allowed = _("has {n} samples; a cycle needs {fewest} at least")
        _refuse(trace, allowed.format(n=n_samples, fewest=fewest))


def _without_jumps(angles: Array) -> Array:
    """Take whole turns out of the steps, so that 719° → 0° goes on to 720°; rows in no order have none to take out."""
    steps = np.diff(angles)
    usual = float(np.median(steps))
    turns = np.rint((steps - usual) / _TURN)
    onward = np.count_nonzero((steps - _TURN * turns) * usual >= 0.0) / len(steps)
    return angles if onward < _IN_ORDER else angles - _TURN * np.concatenate([[0.0], np.cumsum(turns)])


def _each_once(samples: Samples, trace: Trace, lines: NDArray[np.intp]) -> tuple[Samples, NDArray[np.intp]]:
    """Leave one of samples that are repeated; refuse two pressures for one angle."""
    angles, pressures = samples.angles, samples.pressures
    steps = np.diff(angles)
    usual = float(np.median(steps[steps > 0])) if np.any(steps > 0) else 0.0
    repeated = np.flatnonzero(steps <= _SAME * usual)
    if not repeated.size:
        return samples, lines
    different = repeated[pressures[repeated] != pressures[repeated + 1]]
    if different.size:
        at = int(different[0])
        first, again = sorted((int(lines[at]), int(lines[at + 1])))
        allowed = _("has two pressures for the angle {angle}, the first in line {line} ({n} angles are given twice)")
        repair = _("keep one row for each angle, or the mean of both")
        _refuse(trace, allowed.format(angle=_degrees(angles[at]), line=first, n=different.size), again, repair)
    kept = np.ones(len(angles), dtype=np.bool_)
    kept[repeated + 1] = False
    told = _("{n} samples that were given twice are left out.").format(n=repeated.size)
    return Samples(angles[kept], pressures[kept], (told,), ()), lines[kept]


def _open_ended(
    samples: Samples, lines: NDArray[np.intp], cycle: float, step: float
) -> tuple[Samples, NDArray[np.intp]]:
    """Leave out the last sample where it is the first one of the next cycle."""
    angles, pressures, findings, doubts = samples
    if abs(angles[-1] - angles[0] - cycle) > _SAME * step:
        return samples, lines
    told = _("First and last sample are the same angle, {first} and {last}: the last is left out.")
    told = told.format(first=_degrees(angles[0]), last=_degrees(angles[-1]))
    apart = abs(pressures[-1] - pressures[0]) / np.max(pressures)
    if apart > _ALIKE:
        differ = _(
            "The pressures at {first} and {last} differ by {percent:.2g} % of the peak: the cycle does not close."
        ).format(first=_degrees(angles[0]), last=_degrees(angles[-1]), percent=100 * float(apart))
        doubts = (*doubts, differ)
    return Samples(angles[:-1], pressures[:-1], (*findings, told), doubts), lines[:-1]


def _refuse_another_cycle(trace: Trace, angles: Array, step: float, cycle: float) -> None:
    """Refuse one turn for a four-stroke, and more than a cycle."""
    recorded = float(angles[-1] - angles[0])
    own, needed = _degrees(recorded + step), _degrees(cycle)
    if recorded > cycle - _SAME * step:
        allowed = _("holds {own} of crank angle, more than one cycle of {needed}; give one cycle, or the mean of many")
        _refuse(trace, allowed.format(own=own, needed=needed))
    if cycle > 1.5 * _TURN and abs(recorded + step - _TURN) < max(1.5 * step, _WIDEST_GAP):
        allowed = _("holds one turn, {own}, and a four-stroke's cycle has two; the turn of gas exchange is missing")
        _refuse(trace, allowed.format(own=own))


def _gap_doubts(trace: Trace, angles: Array, lines: NDArray[np.intp], cycle: float, step: float) -> tuple[str, ...]:
    """Refuse gaps over which nothing is known, and doubt smaller ones."""
    steps = np.diff(angles, append=angles[0] + cycle)
    widest = int(np.argmax(steps))
    gap = float(steps[widest])
    if gap <= min(_DOUBTFUL_GAP * step, _WIDEST_STEP):
        return ()
    start, end = _degrees(angles[widest]), _degrees(angles[widest] + gap)
    if gap > _WIDEST_STEP or gap > max(_WIDEST_GAP, _DOUBTFUL_GAP * step):
        allowed = _("has no samples between {start} and {end}, a gap of {gap}").format(
            start=start, end=end, gap=_degrees(gap)
        )
        repair = _("give what is missing, or a whole cycle")
        if shown(float(np.ptp(angles)), "deg") < _RADIANS:
            repair = _('if the file\'s angles are radians, write axis_unit = "rad"')
        _refuse(trace, allowed, int(lines[widest]), repair)
    missing = _("There are no samples between {start} and {end}: the spline bridges them.")
    return (missing.format(start=start, end=end),)


def _degrees(angle: float) -> str:
    """Write an angle in degrees."""
    return f"{shown(float(angle), 'deg'):.7g}°"


def _refuse(trace: Trace, allowed: str, line: int | None = None, repair: str | None = None) -> None:
    """Refuse the file, at a line of it if it has one."""
    if line is None:
        raise InputError([Problem("file", trace.name, allowed, repair)])
    raise InputError([Problem("", None, allowed, repair, Position(trace.name, line))])
