"""Level of the pressures by the compression, a polytrope: its exponent, and what makes it the one that is known.

Pegging: a pressure sensor measures changes only, so the level is found by one known pressure or by compression.
"""

from typing import NamedTuple

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.fluids.indicator.card import Peg
from cranktrain.fluids.indicator.chamber import Chamber
from cranktrain.fluids.indicator.cycle import Samples
from cranktrain.fluids.indicator.diagram import Diagram, pressure_at
from cranktrain.fluids.indicator.noise import noise_of, noise_passed
from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.numerics import around_zero
from cranktrain.quantities import shown

_TOLD = 1e3
"""Noise of the level from which it is told. [Pa]"""


class Level(NamedTuple):
    """What is to be added to all pressures, and its standard deviation by the noise of the samples. [Pa]"""

    offset: float
    uncertain: float


def pegged(samples: Samples, diagram: Diagram, peg: Peg, chamber: Chamber, smoothing: float | None) -> Samples:
    """Move all pressures to the level that is known.

    Parameters
    ----------
    samples : Samples
        From nominal firing.
    diagram : Diagram
        Through them, smoothed if they are to be: a level that is read off at one angle has the noise that is there.
    peg : Peg
    chamber : Chamber
    smoothing : float or None
        σ of the diagram. [rad]

    Returns
    -------
    Samples
        With how far they were moved among what was found.

    Raises
    ------
    InputError
        If the piece of the compression has no two samples.
    """
    noise = noise_of(samples)
    if peg.pressure is not None:
        offset = peg.pressure - float(pressure_at(diagram, np.array(peg.angle)))
        level = Level(offset, noise * noise_passed(len(diagram.curve.places), chamber.cycle, smoothing))
    else:
        assert peg.exponent is not None  # the spec asks for one of the two
        level = _by_compression(samples, peg, peg.exponent, chamber, noise)
    known = _("the level that is known")
    if peg.pressure is not None:
        known = _("the pressure that is known at {angle}", angle=f"{shown(peg.angle, 'deg'):g}°")
    sentence = _("All pressures are moved by {offset} kPa, to {known}.")
    if level.uncertain > _TOLD:
        sentence = _("All pressures are moved by {offset} kPa, to {known}; noise leaves ±{doubt} kPa.")
    told = {"offset": f"{shown(level.offset, 'kPa'):+.4g}", "doubt": f"{shown(level.uncertain, 'kPa'):.2g}"}
    sentence = sentence.format(known=known, **told)
    return samples._replace(pressures=samples.pressures + level.offset, findings=(*samples.findings, sentence))


def _by_compression(samples: Samples, peg: Peg, exponent: float, chamber: Chamber, noise: float) -> Level:
    """Find the level that makes a piece of the compression a polytrope."""
    from_firing = around_zero(samples.angles, chamber.cycle)
    chosen = (peg.start <= from_firing) & (from_firing <= peg.end)
    if np.count_nonzero(chosen) < 2:
        allowed = _("must be a piece of the compression with two samples at least")
        raise InputError([Problem("peg.start", f"{shown(peg.start, 'deg'):g} deg", allowed)])
    volumes = chamber.volume(from_firing[chosen])
    offset = polytropic_offset(samples.pressures[chosen], volumes, exponent)
    return Level(offset, noise * offset_scatter(volumes, exponent))


def polytropic_offset(pressures: Array, volumes: Array, exponent: float) -> float:
    """Offset that makes a piece of the compression a polytrope.

    Parameters
    ----------
    pressures : Array, shape (n,)
        As measured, with an unknown offset; two at least. [Pa]
    volumes : Array, shape (n,)
        [m³]
    exponent : float
        n of p Vⁿ = const. [1]

    Returns
    -------
    float
        What to add to the measured pressures. [Pa]

    Notes
    -----
    Least squares of p = C V⁻ⁿ − d; with two points d = (p₂V₂ⁿ − p₁V₁ⁿ)/(V₁ⁿ − V₂ⁿ). docs/theory/gas, eq. (14.10).

    Examples
    --------
    >>> volumes = np.array([5e-4, 4e-4, 3e-4])
    >>> round(polytropic_offset(20.0 * volumes**-1.3 - 3e4, volumes, 1.3), 6)
    30000.0
    """
    power = (volumes / np.max(volumes)) ** -exponent
    from_mean = power - np.mean(power)
    level = np.sum(from_mean * pressures) / np.sum(from_mean**2)
    return float(level * np.mean(power) - np.mean(pressures))


def offset_scatter(volumes: Array, exponent: float) -> float:
    """Standard deviation of `polytropic_offset` by white noise of pressures, in parts of that noise.

    Parameters
    ----------
    volumes : Array, shape (n,)
        [m³]
    exponent : float
        n of p Vⁿ = const. [1]

    Returns
    -------
    float
        √(1/n + m²/Σ(x − m)²) with x = (V/V₁)⁻ⁿ and their mean m: that of a straight line at x = 0. [1]

    Examples
    --------
    >>> round(offset_scatter(np.array([2.0, 1.0]), 1.0) ** 2, 9)
    5.0
    """
    power = (volumes / np.max(volumes)) ** -exponent
    mean = np.mean(power)
    return float(np.sqrt(1 / len(power) + mean**2 / np.sum((power - mean) ** 2)))


def polytropic_exponent(pressures: Array, volumes: Array) -> float:
    """Exponent n of the polytrope p Vⁿ = const that fits a piece of the compression best, by least squares of ln p.

    Parameters
    ----------
    pressures : Array, shape (n,)
        Absolute. [Pa]
    volumes : Array, shape (n,)
        [m³]

    Returns
    -------
    float
        n. [1]

    Examples
    --------
    >>> volumes = np.array([5e-4, 4e-4, 3e-4])
    >>> round(polytropic_exponent(20.0 * volumes**-1.3, volumes), 9)
    1.3
    """
    volume, pressure = (np.log(values) - np.mean(np.log(values)) for values in (volumes, pressures))
    return -float(np.sum(volume * pressure) / np.sum(volume * volume))
