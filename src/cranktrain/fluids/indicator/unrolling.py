"""From pressure over volume or stroke to pressure over the crank angle: which stroke is which, and where it turned."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.fluids.indicator.chamber import Chamber
from cranktrain.fluids.indicator.curve import CubicCurve, curve_at
from cranktrain.fluids.indicator.cycle import Samples, once_or_jump
from cranktrain.fluids.indicator.flags import lost_jump_flags
from cranktrain.fluids.indicator.reading import Trace
from cranktrain.language import Words, _
from cranktrain.motion import Array
from cranktrain.numerics import around_zero, bracketed_roots, extremes, turn_grid
from cranktrain.numerics.ties import falling, first_largest
from cranktrain.quantities import shown

_JUMP = 0.5
"""A step over more of the stroke than this goes back to where the next branch begins."""
_BEYOND = 0.02
"""By how much volumes of the file may lie beyond those of the machine, in parts of the swept volume."""
_SAME_PLACE = 1e-9
_STEEP = 0.05
"""Pressures at one place within a stroke that differ by more jump, in parts of the peak; less is rounding."""
_ALIKE = 1e-3
"""The same where two strokes meet, each of which has its own pressure there."""
_AT_NOMINAL = 1e-8
"""Angles closer than this are one. [rad]"""
_WIDEST_STEP = np.radians(1.0)
_EXPONENT = 1.35

OutwardAngle = Callable[[Array], Array]
"""From the travelled part of the stroke, 0 to 1 from the top, to the crank angle of the outward stroke. [rad]"""


CurveThrough = Callable[[Array, Array, float], CubicCurve]
"""From places, values and period to the curve through them."""


class _Branch(NamedTuple):
    """One stroke of the file: travelled part of the stroke, never falling, and the pressures. [1, Pa]"""

    travelled: Array
    pressures: Array


class ChamberDeadCentres(NamedTuple):
    """Where a chamber's volume is smallest, next to nominal firing, and where it is largest after that. [rad]"""

    top: float
    bottom: float


def dead_centres_of(volume: Callable[[Array], Array]) -> ChamberDeadCentres:
    """True dead centres of a chamber, from nominal firing.

    Parameters
    ----------
    volume : callable
        From crank angles since nominal firing to volumes; periodic over a turn. [m³]

    Returns
    -------
    ChamberDeadCentres
        What is within 1e-8 of 0 or π stands there: a curve without its derivative says no more.
    """
    found = extremes(volume, samples=volume(turn_grid()))
    top = float(around_zero(found.smallest.angle[0]))
    bottom = float(np.mod(found.largest.angle[0] - top, 2 * np.pi)) + top
    return ChamberDeadCentres(
        0.0 if abs(top) < _AT_NOMINAL else top, np.pi if abs(bottom - np.pi) < _AT_NOMINAL else bottom
    )


def unrolled(
    trace: Trace, chamber: Chamber, curve_through: CurveThrough, outward: OutwardAngle | None = None
) -> Samples:
    """Unroll pressures over volume or displacement into pressures over the crank angle from nominal firing.

    Parameters
    ----------
    trace : Trace
        With `axis` "volume" or "displacement"; its branches one after the other, or round the loop.
    chamber : Chamber
    curve_through : callable
        What bridges the wide steps beside dead centres.
    outward : callable, optional
        How to find the crank angle of the outward stroke; the way back is then its mirror image. Brix's construction
        is one; exactly, by the mechanism's own volume, unless given.

    Returns
    -------
    Samples
        Angles in [0, cycle), rising; one twice, before and after, where the file's pressures jump.

    Raises
    ------
    InputError
        If the file has not as many strokes as the cycle, they cannot be told apart, or volumes are not the machine's.

    Notes
    -----
    Points are moved to their angles before anything is interpolated: near the dead centres V is quadratic in φ, and
    interpolating in V errs by some per cent of the peak. docs/theory/gas, "From volume to crank angle".
    """
    travelled, findings = _travelled(trace, chamber)
    n_strokes = round(chamber.cycle / np.pi)
    branches = _branches(travelled, trace.pressures)
    if len(branches) != n_strokes:
        allowed = _("has {n} strokes, and a cycle of this machine has {needed}")
        raise trace.refused(allowed.format(n=len(branches), needed=n_strokes))
    ends = dead_centres_of(chamber.volume)
    in_order = _in_order(branches, trace)
    strokes = [
        2 * np.pi * (stroke // 2) + _angles(branch.travelled, stroke % 2 == 0, chamber, ends, outward)
        for stroke, branch in enumerate(in_order)
    ]
    sentence = _("Pressures over the stroke are unrolled over the crank angle: {n} strokes.", n=n_strokes)
    angles, pressures = _joined(strokes, in_order, chamber.cycle)
    flags = tuple(lost_jump_flags(Samples(angles, pressures, (), ()), chamber.cycle))
    return Samples(*_filled(angles, pressures, chamber, curve_through), (*findings, sentence), flags)


def _travelled(trace: Trace, chamber: Chamber) -> tuple[Array, tuple[Words, ...]]:
    """Travelled part of the stroke from the top; a displacement's own ends are those of the stroke."""
    low, high = float(np.min(trace.places)), float(np.max(trace.places))
    if high - low <= _SAME_PLACE * max(abs(low), abs(high)):
        raise trace.refused(_("has one volume only"))
    if trace.axis == "displacement":
        part = (trace.places - low) / (high - low)
        is_turned = bool(part[first_largest(trace.pressures)] > 0.5)
        sentences = [_("The ends of the file's displacements are taken for the dead centres.")]
        if is_turned:
            sentences.append(
                _("They count from the bottom dead centre, as the peak is at their far end: turned round.")
            )
        return (1 - part if is_turned else part), tuple(sentences)
    smallest, largest = chamber.limits
    part = (trace.places - smallest) / (largest - smallest)
    if np.min(part) < -_BEYOND or np.max(part) > 1 + _BEYOND:
        allowed = _("has volumes of {low} to {high} cm³, and the machine has {smallest} to {largest} cm³")
        own = (f"{shown(float(volume), 'cm³'):.6g}" for volume in (low, high, smallest, largest))
        raise trace.refused(allowed.format(**dict(zip(("low", "high", "smallest", "largest"), own, strict=True))))
    is_beyond = (part < -_SAME_PLACE) | (part > 1 + _SAME_PLACE)
    moved = _("{n} volumes a little beyond the machine's are moved to its dead centres.", n=np.sum(is_beyond))
    return np.clip(part, 0.0, 1.0), (moved,) if np.any(is_beyond) else ()


def _branches(travelled: Array, pressures: Array) -> list[_Branch]:
    """Cut the file where the stroke turns or jumps back; what begins within a stroke is joined to its end."""
    steps = np.diff(travelled)
    pieces: list[tuple[Array, Array]] = []
    start, running = 0, 0.0
    for place, step in enumerate((*steps.tolist(), np.inf)):  # the end of the file is a jump, too
        is_jump = abs(step) > _JUMP
        if is_jump or step * running < 0:
            pieces.append((travelled[start : place + 1], pressures[start : place + 1]))
            start = place + 1 if is_jump else place  # where the stroke turns, the point belongs to both
            running = 0.0
        if step and not is_jump:
            running = step
    rises = [bool(part[-1] > part[0]) for part, _level in pieces]
    if len(pieces) % 2 and len(pieces) > 1 and rises[0] == rises[-1]:
        last = pieces.pop()
        pieces[0] = (np.concatenate([last[0], pieces[0][0]]), np.concatenate([last[1], pieces[0][1]]))
    return [_rising(part, level) for part, level in pieces]


def _rising(travelled: Array, pressures: Array) -> _Branch:
    """Sort a branch by the stroke, each place once, or twice where the pressure jumps."""
    falls = travelled[-1] < travelled[0]
    own, level = (travelled[::-1], pressures[::-1]) if falls else (travelled, pressures)
    order = np.argsort(own, kind="stable")
    part, kept = once_or_jump(own[order], level[order], _SAME_PLACE, _STEEP)
    return _Branch(part, level[order][kept])


def _in_order(branches: Sequence[_Branch], trace: Trace) -> Sequence[_Branch]:
    """Put the strokes in order: expansion, exhaust, inlet, compression; expansion and compression of a two-stroke."""
    middle = np.linspace(0.05, 0.95, 91)
    levels = [float(np.mean(np.interp(middle, *branch))) for branch in branches]
    highest, second = falling(levels)[:2]
    n_strokes = len(branches)
    if n_strokes == 2:
        return branches[highest], branches[second]
    if (highest - second) % n_strokes == 1:  # compression comes before expansion, cyclically
        return [branches[(highest + i) % n_strokes] for i in range(n_strokes)]
    if (second - highest) % n_strokes == 1:  # the file runs backwards
        return [branches[(highest - i) % n_strokes] for i in range(n_strokes)]
    raise trace.refused(_("its strokes are in no order in which an engine makes them"))


def _angles(
    travelled: Array, is_outward: bool, chamber: Chamber, ends: ChamberDeadCentres, outward: OutwardAngle | None
) -> Array:
    """Crank angles of one stroke's points, in the first turn. [rad]"""
    if outward is not None:
        angles = outward(travelled)
        return ends.top + (angles if is_outward else 2 * np.pi - angles)
    low, high = (ends.top, ends.bottom) if is_outward else (ends.bottom, ends.top + 2 * np.pi)
    smallest, largest = chamber.limits
    wanted = smallest + travelled * (largest - smallest)
    full = np.full(travelled.shape, low), np.full(travelled.shape, high)
    found = bracketed_roots(lambda angle: chamber.volume(angle) - wanted, *full)
    # At the very ends rounding may leave no change of sign between them.
    end = np.where((travelled < 0.5) == is_outward, low, high)
    return np.where(np.isnan(found) | (travelled <= 0.0) | (travelled >= 1.0), end, found)


def _joined(strokes: Sequence[Array], branches: Sequence[_Branch], cycle: float) -> tuple[Array, Array]:
    """Put all strokes into one cycle; where two meet, both count if their pressures differ: a jump."""
    in_time = [slice(None, None, 1 if stroke % 2 == 0 else -1) for stroke in range(len(strokes))]
    angles = np.mod(np.concatenate([own[sense] for own, sense in zip(strokes, in_time, strict=True)]), cycle)
    angles = np.where(angles > cycle - _AT_NOMINAL, 0.0, angles)
    pressures = np.concatenate([own.pressures[sense] for own, sense in zip(branches, in_time, strict=True)])
    begins = np.concatenate([own[sense] < np.max(own) for own, sense in zip(strokes, in_time, strict=True)])
    order = np.lexsort((begins, np.rint(angles / _AT_NOMINAL)))
    places, kept = once_or_jump(angles[order], pressures[order], _AT_NOMINAL, _ALIKE)
    return places, pressures[order][kept]


def _filled(angles: Array, pressures: Array, chamber: Chamber, curve_through: CurveThrough) -> tuple[Array, Array]:
    """Put points where the stroke's own are far apart in angle, as they are at dead centres.

    Along compression and expansion p Vⁿ hardly changes where p does most, and its curve bridges twice as well; where p
    changes less, as on a plateau, its own curve does.
    """
    steps = np.diff(angles, append=angles[0] + chamber.cycle)
    parts: NDArray[np.intp] = np.maximum(np.ceil(steps / _WIDEST_STEP), 1).astype(np.intp)
    own: NDArray[np.intp] = np.cumsum(parts) - parts
    step: NDArray[np.intp] = np.repeat(np.arange(len(parts)), parts)
    filled: Array = angles[step] + steps[step] * (np.arange(len(step)) - own[step]) / parts[step]
    bent = pressures * chamber.volume(angles) ** _EXPONENT
    by_pressure = curve_at(curve_through(angles, pressures, chamber.cycle), filled)
    by_bent = curve_at(curve_through(angles, bent, chamber.cycle), filled) / chamber.volume(filled) ** _EXPONENT
    between = np.where((_change(bent) < _change(pressures))[step], by_bent, by_pressure)
    between[own] = pressures
    return filled, between


def _change(values: Array) -> Array:
    """How much positive values change from each to the next, round the cycle; ∞ where a raw trace has none."""
    after = np.roll(values, -1)
    is_positive = (values > 0) & (after > 0)
    ratio = np.divide(after, values, where=is_positive, out=np.full_like(values, np.inf))
    return np.abs(np.log(ratio))
