"""The samples of one cycle: unwrapped, sorted, each angle once or, where the pressure jumps, twice; without gaps."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.fluids.indicator.gaps import gap_flags
from cranktrain.fluids.indicator.reading import Trace
from cranktrain.language import Words, _
from cranktrain.motion import Array
from cranktrain.quantities import shown

_TURN = 2 * np.pi
_SAME = 1e-3
"""Angles closer than this, in steps, are one."""
_FEWEST = 24
"""Samples of a cycle: textbooks print one each 30°."""
_AN_END = np.radians(15.0)
"""A recorded turn may lack so much."""
_IN_ORDER = 0.9
"""Share of the rows that go on in one sense, turns apart, in a file whose rows are in order."""
_CLOSED = 0.01
"""First and last sample of a closed cycle differ by less, in parts of the peak."""
_ALIKE = 1e-4
"""Pressures of one angle that differ by less, in parts of the peak, are one that was rounded."""
_MOST_JUMPS = 8
"""Of a cycle; an ideal four-stroke has four. More are angles that were rounded."""


class Samples(NamedTuple):
    """One cycle: angles rising within one cycle [rad], absolute pressures [Pa], what was found, and flags.

    Where the pressure jumps, the angle stands twice, before and after.
    """

    angles: Array
    pressures: Array
    findings: tuple[Words, ...]
    flags: tuple[Words, ...]


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
    Samples, in the file's own counting, but without its jumps by whole turns

    Raises
    ------
    InputError
        If it is not just one cycle of this machine, has a gap, or two pressures for many angles.
    """
    _refuse_few(trace, len(trace.places), cycle)
    angles, is_in_order = _without_turns(trace.places)
    rows = np.arange(len(angles))
    rows = rows if np.median(np.diff(angles)) >= 0 else rows[::-1]
    order = rows[np.argsort(angles[rows], kind="stable")]
    steps = np.diff(angles[order])
    step = float(np.median(steps[steps > 0])) if np.any(steps > 0) else 0.0
    samples = Samples(angles[order], trace.pressures[order], (), ())
    samples, lines = _each_once(samples, trace, trace.lines[order], step, is_in_order)
    _refuse_few(trace, len(samples.angles), cycle)
    samples, lines = _open_ended(samples, lines, cycle, step)
    _refuse_another_cycle(trace, samples.angles, step, cycle)
    return samples._replace(flags=(*samples.flags, *gap_flags(trace, samples.angles, samples.pressures, lines, cycle)))


def once_or_jump(
    angles: Array, pressures: Array, width: float, alike: float = _ALIKE
) -> tuple[Array, NDArray[np.intp]]:
    """Take the last of samples that stand at one angle, and the first of them too where the pressure jumps there.

    Parameters
    ----------
    angles, pressures : Array, shape (m,)
        Angles never falling; of one angle the first is before a jump and the last after it.
    width : float
        Angles not farther apart than this are one. [rad]
    alike : float
        Pressures that differ by no more, in parts of the peak, are no jump.

    Returns
    -------
    angles : Array, shape (n,)
    kept : array of int, shape (n,)
        Which samples they are.
    """
    group = np.concatenate([[0], np.cumsum(np.diff(angles) > width)])
    last = np.flatnonzero(np.append(np.diff(group) > 0, True))
    first = np.concatenate([[0], last[:-1] + 1])
    jumps = np.abs(pressures[last] - pressures[first]) > alike * np.max(pressures)
    kept = np.sort(np.concatenate([first[jumps], last]))
    return angles[last][group[kept]], kept


def _refuse_few(trace: Trace, n_samples: int, cycle: float) -> None:
    """Refuse what is too little for a cycle."""
    fewest = round(_FEWEST * cycle / (2 * _TURN))
    if n_samples < fewest:
        allowed = _("has {n} samples; a cycle needs {fewest} at least")
        raise trace.refused(allowed.format(n=n_samples, fewest=fewest))


def _without_turns(angles: Array) -> tuple[Array, bool]:
    """Take whole turns out of the steps, so that 719° → 0° goes on to 720°; say whether rows are in order at all."""
    steps = np.diff(angles)
    usual = float(np.median(steps))
    turns = np.rint((steps - usual) / _TURN)
    onward = np.count_nonzero((steps - _TURN * turns) * usual >= 0.0) / len(steps)
    if onward < _IN_ORDER:
        return angles, False
    return angles - _TURN * np.concatenate([[0.0], np.cumsum(turns)]), True


def _each_once(
    samples: Samples, trace: Trace, lines: NDArray[np.intp], step: float, is_in_order: bool
) -> tuple[Samples, NDArray[np.intp]]:
    """Leave one of samples that are repeated, and both where the pressure jumps; refuse more than can be jumps."""
    angles, kept = once_or_jump(samples.angles, samples.pressures, _SAME * step)
    jumps = np.flatnonzero(np.diff(angles) == 0.0)
    if jumps.size > (_MOST_JUMPS if is_in_order else 0):
        first, again = sorted(int(line) for line in lines[kept[[jumps[0], jumps[0] + 1]]])
        allowed = _("has two pressures for the angle {angle}, the first in line {line} ({n} angles are given twice)")
        repair = _("keep one row for each angle, or the mean of both; rows in order may have {most} jumps")
        allowed = allowed.format(angle=_degrees(float(angles[jumps[0]])), line=first, n=jumps.size)
        raise trace.refused(allowed, again, repair.format(most=_MOST_JUMPS))
    n_left_out = len(samples.angles) - len(kept)
    sentences = (_("{n} samples that were given twice are left out.", n=n_left_out),) if n_left_out else ()
    return Samples(angles, samples.pressures[kept], sentences, ()), lines[kept]


def _open_ended(
    samples: Samples, lines: NDArray[np.intp], cycle: float, step: float
) -> tuple[Samples, NDArray[np.intp]]:
    """Join the last sample to the first one where it is that of the next cycle: one sample, or a jump."""
    angles, pressures, findings, flags = samples
    if abs(angles[-1] - angles[0] - cycle) > _SAME * step:
        return samples, lines
    starts, ends = np.flatnonzero(angles == angles[0]), np.flatnonzero(angles == angles[-1])
    after, before = int(starts[-1]), int(ends[0])
    inner = np.arange(after, before)
    first, last = _degrees(angles[0]), _degrees(angles[-1])
    apart = abs(pressures[before] - pressures[after]) / np.max(pressures)
    if apart <= _ALIKE:
        sentence = _("First and last sample are the same angle, {first} and {last}: the last is left out.")
        findings = (*findings, sentence.format(first=first, last=last))
        return Samples(angles[inner], pressures[inner], findings, flags), lines[inner]
    if apart > _CLOSED:
        differ = _(
            "The pressures at {first} and {last} differ by {percent:.2g} % of the peak: if they do not jump there, the"
            " cycle does not close."
        )
        flags = (*flags, differ.format(first=first, last=last, percent=100 * float(apart)))
    kept = np.append(before, inner)
    return Samples(np.append(angles[0], angles[inner]), pressures[kept], findings, flags), lines[kept]


def _refuse_another_cycle(trace: Trace, angles: Array, step: float, cycle: float) -> None:
    """Refuse one turn for a four-stroke, and more than a cycle."""
    recorded = float(angles[-1] - angles[0])
    own, needed = _degrees(recorded + step), _degrees(cycle)
    if recorded > cycle - _SAME * step:
        allowed = _("holds {own} of crank angle, more than one cycle of {needed}; give one cycle, or the mean of many")
        raise trace.refused(allowed.format(own=own, needed=needed))
    if cycle > 1.5 * _TURN and abs(recorded + step - _TURN) < max(1.5 * step, _AN_END):
        allowed = _("holds one turn, {own}, and a four-stroke's cycle has two; the turn of gas exchange is missing")
        raise trace.refused(allowed.format(own=own))


def _degrees(angle: float) -> str:
    """Write an angle in degrees."""
    return f"{shown(float(angle), 'deg'):.7g}°"
