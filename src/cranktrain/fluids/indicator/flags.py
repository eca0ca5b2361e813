"""What an engineer would ask about a diagram: is its compression one, is it smooth, does it miss a jump."""

from collections.abc import Iterator

import numpy as np

from cranktrain.fluids.indicator.chamber import Chamber
from cranktrain.fluids.indicator.curve import steps_between
from cranktrain.fluids.indicator.cycle import Samples
from cranktrain.fluids.indicator.pegging import polytropic_exponent
from cranktrain.language import _
from cranktrain.numerics import around_zero
from cranktrain.numerics.ties import first_largest
from cranktrain.quantities import shown

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


def compression_flags(samples: Samples, chamber: Chamber) -> Iterator[str]:
    """Flag a fired cycle whose compression is no polytrope of a usual exponent.

    Parameters
    ----------
    samples : Samples
        Counted from the chamber's nominal firing.
    chamber : Chamber

    Yields
    ------
    str

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
            " level of the pressures (absolute or gauge), the zero of the angles and the compression ratio right?"
        ).format(exponent=exponent)


def lost_jump_flags(samples: Samples, cycle: float) -> Iterator[str]:
    """Flag steps so much steeper than those beside them that a jump may be lost in them.

    Parameters
    ----------
    samples : Samples
        In any count.
    cycle : float
        [rad]

    Yields
    ------
    str

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
        sentence = _(
            "Between {start} and {end} the pressure goes from {before} to {after} bar in one step, far steeper than"
            " beside it{more}: if it jumps, give the jump as two rows of one angle (or place), before and after; else"
            " give more rows there. A jump lost between rows takes from the mean pressure, 2 % in steps of 10°."
        )
        more = _(", and so in {n} other steps").format(n=found.size - 1) if found.size > 1 else ""
        start, end = places[largest], places[largest] + lengths[largest]
        before, after = (f"{shown(float(pressure[largest]), 'bar'):.4g}" for pressure in (starts, ends))
        start, end = (f"{shown(float(angle), 'deg') + 0.0:.6g}°" for angle in (start, end))
        yield sentence.format(start=start, end=end, before=before, after=after, more=more)


def rounded_jump_flags(samples: Samples) -> Iterator[str]:
    """Flag a spline, or smoothing, of samples that jump.

    Parameters
    ----------
    samples : Samples

    Yields
    ------
    str
    """
    if np.any(np.diff(samples.angles) == 0.0):
        yield _("The file's pressures jump; a spline rounds that off, and so does smoothing: leave these out.")
