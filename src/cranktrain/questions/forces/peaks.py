"""Largest forces: the one way to find them, on the mechanisms between the points of the grid, split at events."""

from collections.abc import Callable, Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import Listed, Words, _
from cranktrain.layout.crank_angle import CrankAngle, within
from cranktrain.motion import Array
from cranktrain.numerics import Curve, Peak, in_windows, largest_between
from cranktrain.questions.forces.events import ForceEvents
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.record import record
from cranktrain.saying.wording import number

_ROUNDING = 1e-12
"""Forces smaller than this part of the largest are none."""
_NAMED = 4
"""How many one-sided extremes a sentence names."""


@record
class MachineCurves:
    """Curves of forces.

    Attributes
    ----------
    rows : array of int, shape (curve,)
        Of which mechanism each is; −1 of the machine as a whole.
    samples : Array, shape (design, curve, n)
        On the grid.
    pick : callable
        From what `LoadedMachine.solved` gives to all of them, shape (design, curve, …).
    """

    rows: NDArray[np.intp]
    samples: Array
    pick: Callable[[tuple[SolvedBatch, ...]], Array]


@record
class ForcePeaks:
    """Largest values of curves, shapes (design, curve), by the class of these."""

    by_class: Mapping[type[MachineCurves], Peak]

    def of(self, curves: MachineCurves) -> Peak:
        """Largest values of those curves."""
        return self.by_class[type(curves)]


def largest_together(
    loaded: LoadedMachine, events: ForceEvents, crank_angle: CrankAngle, each: Sequence[MachineCurves]
) -> list[Peak]:
    """Largest values of curves over the cycle, for which the machine is solved once.

    Parameters
    ----------
    loaded : LoadedMachine
    events : ForceEvents
    crank_angle : CrankAngle
    each : sequence of MachineCurves

    Returns
    -------
    list of Peak, shapes (design, curve)
        Angles as shown, in [0, cycle). [rad]
    """
    rows = np.concatenate([one.rows for one in each])
    shown, zero = crank_angle.shown, crank_angle.zero
    samples = np.concatenate([one.samples for one in each], axis=1)

    def picked(angle: Array) -> Array:
        solved = loaded.solved(angle)
        return np.concatenate([one.pick(solved) for one in each], axis=1)

    def curves(which: NDArray[np.intp], angle: Array) -> Array:
        return loaded.of_each(rows, which, angle + zero[which // rows.size, 0], picked)

    found = largest_between(curves, shown, samples, _breaks(events, rows) - zero)
    ends = np.cumsum([one.rows.size for one in each])[:-1]
    apart = zip(*(np.split(part, ends, axis=1) for part in found), strict=True)
    return [counted(Peak(*parts), crank_angle) for parts in apart]


def _breaks(events: ForceEvents, rows: NDArray[np.intp]) -> Array:
    """φ of the events of each curve, of one mechanism or of the whole machine, shape (design, curve, event). [rad]"""
    whole = rows < 0
    if not np.any(whole):
        return events.angle[:, rows]
    found = np.full((len(events.whole), rows.size, events.whole.shape[-1]), np.nan)
    found[:, whole] = events.whole[:, np.newaxis]
    found[:, ~whole, : events.angle.shape[-1]] = events.angle[:, rows[~whole]]
    return found


def largest_of_machine(curve: Curve, samples: Array, events: ForceEvents, crank_angle: CrankAngle) -> Peak:
    """Largest value of curves of the whole machine, over the cycle.

    Parameters
    ----------
    curve : Curve
        Gives (design, curve, k) for φ of shape (design, 1, k). [rad]
    samples : Array, shape (design, curve, n)
        On the grid.
    events : ForceEvents
    crank_angle : CrankAngle

    Returns
    -------
    Peak, shapes (design, curve)
        Angles as shown, in [0, cycle). [rad]
    """
    n_designs, n_curves = samples.shape[:2]

    def curves(which: NDArray[np.intp], shown: Array) -> Array:
        design, place = np.divmod(which, n_curves)
        asked, slot = in_windows(design, shown, n_designs)
        found = curve(asked.reshape(n_designs, 1, -1) + crank_angle.zero)
        return found.reshape(n_designs, n_curves, *asked.shape[1:])[design, place, slot]

    breaks = events.whole[:, np.newaxis] - crank_angle.zero
    return counted(largest_between(curves, crank_angle.shown, samples, breaks), crank_angle)


def counted(peak: Peak, crank_angle: CrankAngle) -> Peak:
    """Peaks of shape (design, curve), with angles from the grid's zero in [0, cycle) [rad]; nothing stands nowhere."""
    gross = np.fmax.reduce(np.abs(peak.value), axis=-1, keepdims=True, initial=0.0)
    return without_rounding(peak._replace(angle=within(peak.angle, crank_angle.cycle)), gross)


def without_rounding(peak: Peak, gross: Array) -> Peak:
    """Peaks of which those that are rounding beside something gross are 0, and stand nowhere."""
    is_clear = ~(np.abs(peak.value) <= _ROUNDING * gross)
    value, side = (np.where(is_clear, part, 0.0) for part in (peak.value, peak.side))
    return Peak(np.where(is_clear, peak.angle, np.nan), value, side)


def relative(difference: Array, whole: Array) -> Array:
    """Largest difference in parts of the largest value, shapes (..., n); NaN where there is nothing."""
    peak = np.abs(whole).max(axis=-1)
    return np.abs(difference).max(axis=-1) / np.where(peak > 0, peak, np.nan)


def one_sided(peaks: Sequence[tuple[Words, Peak]], labels: Sequence[str] = ("",)) -> Iterator[Words]:
    """Say which extremes stand at a jump, where a value just beside is another.

    Parameters
    ----------
    peaks : sequence of (Words, Peak)
        What it is, and its peaks, shape (design, …) along `labels`.
    labels : sequence of str
    """
    each: dict[Words, None] = {}
    for words, peak in peaks:
        side = np.where(np.isnan(peak.angle), 0.0, peak.side).reshape(len(peak.side), -1)
        for design, place in zip(*np.nonzero(side), strict=True):
            at = number(float(peak.angle.reshape(side.shape)[design, place]), "deg")
            where = _("just after {at}") if side[design, place] > 0 else _("just before {at}")
            each.setdefault(Listed(tuple(filter(None, (words, str(labels[place]), where.format(at=at)))), " "))
    if each:
        named = list(each)[:_NAMED]
        more = len(each) - len(named)
        said = Listed([*named, *([_("and {n} more", n=more)] if more else [])], "; ")
        yield _("Values at a jump are those of the side on which they are largest: {peaks}.", peaks=said)
