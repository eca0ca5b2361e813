"""The indicator diagram: pressure over the crank angle from firing, as a periodic curve of cubics."""

from collections.abc import Callable
from math import ceil
from typing import Literal, TypeAlias

import numpy as np

from cranktrain.fluids.indicator.curve import CubicCurve, along, curve_at, spline_curve
from cranktrain.fluids.indicator.cycle import Samples
from cranktrain.fluids.indicator.limited import limited_curve
from cranktrain.language import Words
from cranktrain.motion import Array
from cranktrain.numerics.products import product
from cranktrain.record import record

Interpolation: TypeAlias = Literal["limited", "spline"]

CURVES: dict[Interpolation, Callable[[Array, Array, float], CubicCurve]] = {
    "limited": limited_curve,
    "spline": spline_curve,
}
"""The curve through places and values of one period."""

_GAUSS_POINTS = 6
"""Exact to degree 11: a cubic times V′ over a step of some degrees is less to all digits."""
_AT_ONCE = 4096
"""Steps whose Gauss points are asked for together: a file of many rows would ask for too much memory."""


@record
class Diagram:
    """An indicator diagram, ready for use.

    Attributes
    ----------
    curve : CubicCurve
        Absolute pressure over the crank angle from firing, its places in [0, cycle). [rad, Pa]
    findings, flags : tuple of Words
        What was found in the file and changed, and what may be meant otherwise, as sentences.
    """

    curve: CubicCurve
    findings: tuple[Words, ...] = ()
    flags: tuple[Words, ...] = ()


def diagram_through(samples: Samples, cycle: float, interpolation: Interpolation = "limited") -> Diagram:
    """Lay a curve through the samples of one cycle.

    Parameters
    ----------
    samples : Samples
        Angles from firing, never falling, in [0, cycle); an angle given twice, before and after, is a jump.
    cycle : float
        2π or 4π. [rad]
    interpolation : "limited" or "spline"
        Cubics with limited slopes, or the periodic cubic spline, which takes no jumps.

    Returns
    -------
    Diagram
        It goes through every sample. A spline rings beside plateaus and corners.
    """
    curve = CURVES[interpolation](samples.angles, samples.pressures, cycle)
    return Diagram(curve, samples.findings, samples.flags)


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
        Absolute pressure; at a sample's angle the sample itself, at a jump the one just after it. [Pa]
    """
    return curve_at(diagram.curve, angle_from_firing)


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
    Gauss's quadrature from sample to sample: on a step of the curve p is a cubic, and V′ smooth.
    """
    nodes, weights = np.polynomial.legendre.leggauss(_GAUSS_POINTS)
    curve = diagram.curve
    work = 0.0
    for first in range(0, len(curve.places), _AT_ONCE):
        chosen = np.arange(first, min(first + _AT_ONCE, len(curve.places)))[:, np.newaxis]
        share = (1 + nodes) / 2
        power = along(curve, chosen, share) * volume_slope(curve.places[chosen] + share * curve.steps[chosen])
        work += float(np.sum(product(power, weights) * curve.steps[chosen[:, 0]] / 2))
    return work


def passed(order: Array, width: float) -> Array:
    """What smoothing over a width σ [rad] leaves of waves per turn: (1 + ½k²σ²) exp(−½k²σ²), eq. (14.11)."""
    half_square = (order * width) ** 2 / 2
    return (1 + half_square) * np.exp(-half_square)


def smoothed(diagram: Diagram, width: float, interpolation: Interpolation = "limited") -> Diagram:
    """Take noise out of a diagram, round the cycle.

    Parameters
    ----------
    diagram : Diagram
    width : float
        σ of the Gaussian. [rad]
    interpolation : "limited" or "spline"
        Of the smoothed samples.

    Returns
    -------
    Diagram
        At as many equal steps, or more where these would be wider than σ; its mean pressure is the same. Jumps are
        rounded off.

    Notes
    -----
    The cycle's Fourier series times (1 + ½k²σ²) exp(−½k²σ²), a Gaussian that leaves every parabola, and so the peak, as
    it is. docs/theory/gas, eq. (14.11).
    """
    cycle = diagram.curve.period
    n_points = max(len(diagram.curve.places), ceil(cycle / width))
    angles = np.arange(n_points, dtype=np.float64) * (cycle / n_points)
    order = np.arange(n_points // 2 + 1, dtype=np.float64) * (2 * np.pi / cycle)
    series = np.fft.rfft(pressure_at(diagram, angles)) * passed(order, width)
    pressures: Array = np.fft.irfft(series, n_points)
    return diagram_through(Samples(angles, pressures, diagram.findings, diagram.flags), cycle, interpolation)
