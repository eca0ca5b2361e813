"""The indicator diagram: pressure over the crank angle from firing, as a periodic cubic spline."""

from collections.abc import Callable

import numpy as np

from cranktrain.gas.indicator.cycle import Samples
from cranktrain.gas.indicator.spline import periodic_slopes, spline_at
from cranktrain.motion import Array
from cranktrain.record import record

_GAUSS_POINTS = 6
"""Exact to degree 11: a cubic times V′ over a step of some degrees is less to all digits."""


@record
class Diagram:
    """An indicator diagram, ready for use.

    Attributes
    ----------
    cycle : float
        2π or 4π. [rad]
    angles : Array, shape (n,)
        From firing, rising in [0, cycle). [rad]
    pressures : Array, shape (n,)
        Absolute. [Pa]
    slopes : Array, shape (n,)
        dp/dφ of the periodic cubic spline. [Pa/rad]
    findings, doubts : tuple of str
        What was found in the file and changed, and what may be meant otherwise, as sentences.
    """

    cycle: float
    angles: Array
    pressures: Array
    slopes: Array
    findings: tuple[str, ...] = ()
    doubts: tuple[str, ...] = ()


def diagram_through(samples: Samples, cycle: float) -> Diagram:
    """Lay a periodic cubic spline through the samples of one cycle.

    Parameters
    ----------
    samples : Samples
        Angles from firing, rising in [0, cycle).
    cycle : float
        2π or 4π. [rad]

    Returns
    -------
    Diagram
        It goes through every sample. A jump, as of an ideal cycle at the dead centre, makes it ring: take the ideal
        cycle itself for that.
    """
    slopes = periodic_slopes(samples.angles, samples.pressures, cycle)
    return Diagram(cycle, samples.angles, samples.pressures, slopes, samples.findings, samples.doubts)


def pressure_at(diagram: Diagram, angle_from_firing: Array) -> Array:
    """Pressure by the crank angle from firing.

    Parameters
    ----------
    diagram : Diagram
    angle_from_firing : Array, any shape
        Any multiple of the cycle may be added. [rad]

    Returns
    -------
    Array, of that shape
        Absolute pressure; at a sample's angle the sample itself. [Pa]
    """
    return spline_at(diagram.angles, diagram.pressures, diagram.slopes, diagram.cycle, angle_from_firing)


def diagram_work(diagram: Diagram, volume_slope: Callable[[Array], Array]) -> float:
    """Work of the interpolated diagram over the cycle, exactly.

    Parameters
    ----------
    diagram : Diagram
    volume_slope : callable
        dV/dφ of the mechanism at angles from firing, (..., k) to (..., k). [m³/rad]

    Returns
    -------
    float
        ∮ p dV [J]

    Notes
    -----
    Gauss's quadrature from sample to sample: on a step of the spline p is a cubic, and V′ smooth.
    `indicated_work` is the sum over equal steps.
    """
    nodes, weights = np.polynomial.legendre.leggauss(_GAUSS_POINTS)
    steps = np.diff(diagram.angles, append=diagram.angles[0] + diagram.cycle)
    angles = diagram.angles[:, np.newaxis] + steps[:, np.newaxis] * (1 + nodes) / 2
    power = pressure_at(diagram, angles) * volume_slope(angles)
    return float(np.sum(power @ weights * steps / 2))


def breaks(diagram: Diagram) -> Array:
    """Crank angles between which the interpolant is one polynomial, rising in [0, cycle); a jump stands there once."""
    return diagram.angles


def jumps(diagram: Diagram) -> Array:
    """Crank angles at which the pressure jumps, rising in [0, cycle)."""
    return diagram.angles[:0]


def smoothed(diagram: Diagram, width: float) -> Diagram:
    """Take noise out of a diagram, round the cycle.

    Parameters
    ----------
    diagram : Diagram
    width : float
        σ of the Gaussian. [rad]

    Returns
    -------
    Diagram
        At as many equal steps; its mean pressure is the same.

    Notes
    -----
    The cycle's Fourier series times (1 + ½k²σ²) exp(−½k²σ²), a Gaussian that leaves every parabola, and so the peak, as
    it is. docs/theory/gas, eq. (14.11).
    """
    n_points = len(diagram.angles)
    angles = np.arange(n_points, dtype=np.float64) * (diagram.cycle / n_points)
    order = np.arange(n_points // 2 + 1) * (2 * np.pi / diagram.cycle)
    half_square = (order * width) ** 2 / 2
    series = np.fft.rfft(pressure_at(diagram, angles)) * (1 + half_square) * np.exp(-half_square)
    pressures: Array = np.fft.irfft(series, n_points)
    return diagram_through(Samples(angles, pressures, diagram.findings, diagram.doubts), diagram.cycle)
