"""The level of a diagram's pressures: refused where it cannot be, flagged where no engine has it."""

from collections.abc import Iterator

import numpy as np

from cranktrain.fluids.indicator.card import Card
from cranktrain.fluids.indicator.curve import CubicCurve
from cranktrain.fluids.indicator.reading import peg_advice
from cranktrain.language import _
from cranktrain.motion import Array, single
from cranktrain.numerics import around_zero
from cranktrain.numerics.ties import first_smallest
from cranktrain.quantities import shown
from cranktrain.wording import precise

_LOWEST_USUAL, _HIGHEST_LOWEST, _HIGHEST_USUAL, _LOWEST_PEAK = 0.3e5, 8e5, 350e5, 3e5
"""Lowest pressure of a cycle below or above which, and peak above or below which, a unit is flagged. [Pa]"""


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


def level_flags(pressures: Array) -> Iterator[str]:
    """Flag pressures as no engine has them: gauge for absolute, a wrong level, or a unit that is off by ten.

    Parameters
    ----------
    pressures : Array
        Of a cycle, absolute. [Pa]

    Yields
    ------
    str
    """
    lowest, highest = float(np.min(pressures)), float(np.max(pressures))
    low, high = (f"{shown(pressure, 'bar'):.4g}" for pressure in (lowest, highest))
    if lowest < _LOWEST_USUAL:
        yield _(
            "The lowest pressure is {low} bar absolute, too low for an engine: gauge pressures, or another unit?"
        ).format(low=low)
    if lowest > _HIGHEST_LOWEST or highest > _HIGHEST_USUAL:
        yield _("Pressures of {low} to {high} bar are too high for an engine: is the unit right?").format(
            low=low, high=high
        )
    elif highest < _LOWEST_PEAK:
        yield _("The peak of {high} bar is too low for an engine: is the unit right?").format(high=high)
