"""What an engineer would ask about a diagram: its level, its compression, a jump that it misses; and what is found."""

from collections.abc import Iterator

import numpy as np

from cranktrain.fluids.indicator.card import Card
from cranktrain.fluids.indicator.chamber import Chamber
from cranktrain.fluids.indicator.curve import CubicCurve, crest, steps_between
from cranktrain.fluids.indicator.cycle import Samples
from cranktrain.fluids.indicator.pegging import polytropic_exponent
from cranktrain.fluids.indicator.reading import peg_advice
from cranktrain.language import Listed, Words, _
from cranktrain.motion import Array, single
from cranktrain.numerics import around_zero
from cranktrain.numerics.ties import first_largest, first_smallest
from cranktrain.quantities import shown
from cranktrain.saying.wording import precise

_START, _END = np.radians(-80.0), np.radians(-40.0)
"""A piece of the compression with closed ports and valves and before the fire, from firing. [rad]"""
_FEWEST = 3
_COMPRESSED = 1.5
"""Pressures that rise by less there are no compression: steam is still let out."""
_LOWEST, _HIGHEST = 1.2, 1.45
"""Exponents of compressions, with some reserve: 1.25 to 1.4 are usual."""
_LARGE_STEP = 0.1
"""Steps of less cannot hide a jump that is worth a word, in parts of the range."""
_STEEP, _STEEPER = 5.0, 2.0
"""How much steeper a step is that may hide a jump: than steps beside it in its own sense; than any beside it."""

_LOWEST_USUAL, _HIGHEST_LOWEST, _HIGHEST_USUAL, _LOWEST_PEAK = 0.3e5, 8e5, 350e5, 3e5
"""Lowest pressure of a cycle below or above which, and peak above or below which, a unit is flagged. [Pa]"""


def compression_flags(samples: Samples, chamber: Chamber) -> Iterator[Words]:
    """Flag a fired cycle whose compression is no polytrope of a usual exponent.

    Parameters
    ----------
    samples : Samples
        Counted from the chamber's nominal firing.
    chamber : Chamber

    Yields
    ------
    Words

    Notes
    -----
    Gauge pressures taken as absolute raise the exponent, absolute ones taken as gauge lower it: supercharged, both are
    pressures that an engine could have.
    """
    from_firing = around_zero(samples.angles, chamber.cycle)
    # A sample of no pressure has no logarithm, and is no compression.
    chosen = (from_firing >= _START) & (from_firing <= _END) & (samples.pressures > 0)
    pressures = samples.pressures[chosen]
    volume = chamber.volume(np.append(samples.angles, samples.angles[0]))
    work = np.trapezoid(np.append(samples.pressures, samples.pressures[0]), volume)
    if work <= 0 or np.count_nonzero(chosen) < _FEWEST or np.max(pressures) < _COMPRESSED * np.min(pressures):
        return
    exponent = polytropic_exponent(pressures, volume[:-1][chosen])
    if not _LOWEST <= exponent <= _HIGHEST:
        yield _(
            "Compression from 80° to 40° before firing has the exponent {exponent:.2f}; 1.25 to 1.4 are usual: are the"
            " level of the pressures (absolute or gauge), the zero of the angles and the compression ratio right?",
            exponent=exponent,
        )


def lost_jump_flags(samples: Samples, cycle: float) -> Iterator[Words]:
    """Flag steps so much steeper than those beside them that a jump may be lost in them.

    Parameters
    ----------
    samples : Samples
        In any count.
    cycle : float
        [rad]

    Yields
    ------
    Words

    Notes
    -----
    A burning cycle in steps of 10° has no step more than three times as steep as the next one in its sense, an ideal
    cycle whose jump is lost one of twelve. Up and down again is noise, and no jump.
    """
    places, lengths, starts, ends, _jumps = steps_between(samples.angles, samples.pressures, cycle)
    slopes = (ends - starts) / lengths
    beside = np.stack([np.roll(slopes, 1), np.roll(slopes, -1)])
    onward = np.max(beside * np.sign(slopes), axis=0)
    steep = (np.abs(slopes) > _STEEP * onward) & (np.abs(slopes) > _STEEPER * np.max(np.abs(beside), axis=0))
    found = np.flatnonzero(steep & (np.abs(ends - starts) > _LARGE_STEP * np.ptp(samples.pressures)))
    if found.size:
        largest = int(found[first_largest(np.abs(ends - starts)[found])])
        start, end = places[largest], places[largest] + lengths[largest]
        before, after = (f"{shown(float(pressure[largest]), 'bar'):.4g}" for pressure in (starts, ends))
        start, end = (f"{shown(float(angle), 'deg') + 0.0:.6g}°" for angle in (start, end))
        told = _(
            "Between {start} and {end} the pressure goes from {before} to {after} bar in one step, far steeper than"
            " beside it"
        ).format(start=start, end=end, before=before, after=after)
        if found.size > 1:
            told = _("{told}, and so in {n} other steps", told=told, n=found.size - 1)
        yield _(
            "{told}: if it jumps, give the jump as two rows of one angle (or place), before and after; else give more"
            " rows there. A jump lost between rows takes from the mean pressure, 2 % in steps of 10°.",
            told=told,
        )


def rounded_jump_flags(samples: Samples) -> Iterator[Words]:
    """Flag a spline, or smoothing, of samples that jump.

    Parameters
    ----------
    samples : Samples

    Yields
    ------
    Words
    """
    if np.any(np.diff(samples.angles) == 0.0):
        yield _("The file's pressures jump; a spline rounds that off, and so does smoothing: leave these out.")


def refuse_not_positive(card: Card, curve: CubicCurve) -> None:
    """Refuse absolute pressures that cannot be, once their level is found and their noise is smoothed.

    Parameters
    ----------
    card : Card
        As which the curve was pegged and smoothed.
    curve : CubicCurve
        Absolute pressure over the crank angle from nominal firing. [rad, Pa]

    Raises
    ------
    InputError
        With the lowest pressure that is left, and what would raise it.
    """
    lowest = first_smallest(curve.starts)
    if curve.starts[lowest] > 0:
        return
    allowed = _("has {n} absolute pressures that are not more than 0, the lowest {lowest} bar at {angle}° from firing")
    angle = float(around_zero(single(float(curve.places[lowest])), curve.period))
    said = allowed.format(
        n=np.count_nonzero(curve.starts <= 0),
        lowest=f"{shown(float(curve.starts[lowest]), 'bar'):.4g}",
        angle=f"{shown(angle, 'deg') + 0.0:.4g}",
    )
    repair = peg_advice()
    if card.peg is not None and card.smoothing is None:
        repair = _('if that is noise, write smoothing, such as smoothing = "2 deg"; else give another peg')
    elif card.peg is not None and card.smoothing is not None:
        repair = _("if that is noise, smooth over more than {width}; else give another peg")
        repair = repair.format(width=precise(card.smoothing, "deg"))
    raise card.trace.refused(said, repair=repair)


def level_flags(pressures: Array) -> Iterator[Words]:
    """Flag pressures as no engine has them: gauge for absolute, a wrong level, or a unit that is off by ten.

    Parameters
    ----------
    pressures : Array
        Of a cycle, absolute. [Pa]

    Yields
    ------
    Words
    """
    lowest, highest = float(np.min(pressures)), float(np.max(pressures))
    low, high = (f"{shown(pressure, 'bar'):.4g}" for pressure in (lowest, highest))
    if lowest < _LOWEST_USUAL:
        yield _(
            "The lowest pressure is {low} bar absolute, too low for an engine: gauge pressures, or another unit?",
            low=low,
        )
    if lowest > _HIGHEST_LOWEST or highest > _HIGHEST_USUAL:
        yield _("Pressures of {low} to {high} bar are too high for an engine: is the unit right?", low=low, high=high)
    elif highest < _LOWEST_PEAK:
        yield _("The peak of {high} bar is too low for an engine: is the unit right?", high=high)


def curve_findings(curve: CubicCurve, samples: Samples, highest: int, dead_centre: float) -> Iterator[Words]:
    """Say what the samples show and what the curve makes of them.

    Parameters
    ----------
    curve : CubicCurve
    samples : Samples
        What the curve was laid through, before it was smoothed.
    highest : int
        Which of them is the file's largest pressure.
    dead_centre : float
        Where the true dead centre at firing is, in the samples' count. [rad]

    Yields
    ------
    Words
    """
    crest_at, crest_pressure = crest(curve)
    sentence = _(
        "The largest sample is {sample} bar at {sample_at} from firing, the curve's crest {crest} bar at {crest_at}."
    )
    yield sentence.format(
        sample=_bar(float(samples.pressures[highest])),
        sample_at=_from_firing(float(samples.angles[highest]) - dead_centre, curve.period),
        crest=_bar(crest_pressure),
        crest_at=_from_firing(crest_at - dead_centre, curve.period),
    )
    befores = np.roll(curve.ends, 1)
    jumps = [
        _(
            "at {angle} from {before} to {after} bar",
            angle=_from_firing(place - dead_centre, curve.period),
            before=_bar(before),
            after=_bar(after),
        )
        for place, before, after in zip(curve.places.tolist(), befores.tolist(), curve.starts.tolist(), strict=True)
        if before != after
    ]
    if jumps:
        yield _("The pressure jumps where the file gives two, from firing: {jumps}.", jumps=Listed(jumps))


def _bar(pressure: float) -> str:
    """Write a pressure in bar."""
    return f"{shown(pressure, 'bar'):.4g}" if pressure < 1e6 else f"{shown(pressure, 'bar'):.2f}"


def _from_firing(angle: float, cycle: float) -> str:
    """Write an angle in degrees from firing, half a cycle before it to half a cycle after; no −0."""
    return f"{shown(float(around_zero(single(angle), cycle)), 'deg') + 0.0:.2f}°"
