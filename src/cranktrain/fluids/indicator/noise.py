"""Noise of a diagram's samples: how much there is, what smoothing leaves of it, and what it takes off the crest."""

from collections.abc import Iterator

import numpy as np

from cranktrain.fluids.indicator.curve import crest
from cranktrain.fluids.indicator.cycle import Samples
from cranktrain.fluids.indicator.diagram import Diagram, Interpolation, passed, smoothed
from cranktrain.language import Words, _
from cranktrain.quantities import shown
from cranktrain.saying.wording import precise

_FINE = np.radians(2.01)
"""Up to such steps the fourth differences are noise, not the curve. [rad]"""
_NOISY = 0.005
"""Noise that is flagged, in parts of the peak."""
_OF_NOISE = 0.6745 * np.sqrt(70.0)
"""Median size of the fourth differences of white noise of standard deviation 1."""
_EATEN = 0.01
"""What smoothing may take off the crest before it is flagged, in parts of the crest."""


def noise_of(samples: Samples) -> float:
    """Standard deviation of the noise of samples, by the median of their fourth differences; 0 in coarse steps.

    Parameters
    ----------
    samples : Samples

    Returns
    -------
    float
        [Pa]

    Notes
    -----
    A smooth curve in fine steps hardly has fourth differences.
    """
    if np.median(np.diff(samples.angles)) > _FINE:
        return 0.0
    return float(np.median(np.abs(np.diff(samples.pressures, 4))) / _OF_NOISE)


def noise_passed(n_points: int, cycle: float, smoothing: float | None) -> float:
    """What smoothing leaves of white noise in even steps, in parts of its standard deviation; all without one.

    Parameters
    ----------
    n_points : int
        Of a cycle.
    cycle : float
        [rad]
    smoothing : float or None
        σ. [rad]

    Returns
    -------
    float

    Examples
    --------
    Of fine steps h there is √(0.476 h/σ) left.

    >>> round(noise_passed(7200, 4 * np.pi, np.radians(1.0)), 4), round((0.476 * 0.1) ** 0.5, 4)
    (0.2182, 0.2182)
    """
    if smoothing is None:
        return 1.0
    both_signs = np.asarray(np.fft.fftfreq(n_points, 1 / n_points), dtype=np.float64)
    return float(np.sqrt(np.mean(passed(both_signs * (2 * np.pi / cycle), smoothing) ** 2)))


def noise_flags(samples: Samples) -> Iterator[Words]:
    """Flag samples that scatter.

    Parameters
    ----------
    samples : Samples

    Yields
    ------
    Words
    """
    noise = noise_of(samples)
    peak = float(np.max(samples.pressures))
    if noise > _NOISY * peak:
        yield _(
            "The pressures scatter by {percent:.2g} % of the peak from sample to sample: write smoothing, such as"
            ' smoothing = "1 deg", or forces and torque will have that noise.',
            percent=100 * noise / peak,
        )


def eaten_flags(raw: Diagram, own: Diagram, width: float, interpolation: Interpolation) -> Iterator[Words]:
    """Flag smoothing that takes more off the crest than noise stood on it.

    Parameters
    ----------
    raw : Diagram
        As it was before.
    own : Diagram
        The same, smoothed.
    width : float
        σ. [rad]
    interpolation : "limited" or "spline"

    Yields
    ------
    Words

    Notes
    -----
    What is taken goes with σ⁴, so that 4/3 of what it is more than with σ/√2 is all of it; noise is out of both.
    """
    finer = crest(smoothed(raw, width / np.sqrt(2), interpolation).curve)[1]
    left = crest(own.curve)[1]
    eaten = 4 / 3 * (finer - left)
    if eaten > _EATEN * left:
        sentence = _("Smoothing over {width} takes some {eaten} bar off the crest: a smaller width leaves more of it.")
        yield sentence.format(width=precise(width, "deg"), eaten=f"{shown(eaten, 'bar'):.2g}")
