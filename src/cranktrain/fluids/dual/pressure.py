"""The ideal cycle with gas exchange: polytropes, and heat at constant volume, at constant pressure, or both."""

from typing import NamedTuple

import numpy as np

from cranktrain.fluids.polytrope import polytropic_slope, polytropic_work
from cranktrain.fluids.state import ChamberState
from cranktrain.fluids.work import MeanPressures
from cranktrain.motion import Array, chosen


class IdealCycle(NamedTuple):
    """Absolute pressures [Pa], exponents of the polytropes and ratios of heat addition [1].

    `pressure_ratio` ψ: by how much heat at constant volume raises the pressure; 1 in the Diesel cycle.
    `cut_off_ratio` ρ: volume when heat at constant pressure ends, over the smallest; 1 in the Otto cycle.
    """

    start_pressure: Array
    inlet_pressure: Array
    exhaust_pressure: Array
    compression_exponent: Array
    expansion_exponent: Array
    pressure_ratio: Array
    cut_off_ratio: Array


class CornerPressures(NamedTuple):
    """Pressures at the corners of the cycle: end of compression, peak, end of expansion. [Pa]"""

    compressed: Array
    peak: Array
    expanded: Array


def corner_pressures(cycle: IdealCycle, compression_ratio: Array) -> CornerPressures:
    """Pressures at the corners of the ideal cycle.

    Parameters
    ----------
    cycle : IdealCycle, fields of any shape
    compression_ratio : Array, broadcastable
        ε, largest volume over smallest. [1]

    Returns
    -------
    CornerPressures, of the broadcast shape. [Pa]

    Notes
    -----
    p₂ = p₁ε^n₁, p₃ = ψp₂, p₄ = p₃(ρ/ε)^n₂. docs/theory/gas, eq. (14.3).
    """
    compressed = cycle.start_pressure * np.power(compression_ratio, cycle.compression_exponent)
    peak = cycle.pressure_ratio * compressed
    expanded = peak * np.power(cycle.cut_off_ratio / compression_ratio, cycle.expansion_exponent)
    return CornerPressures(compressed, peak, expanded)


def ideal_pressure(state: ChamberState, cycle: IdealCycle) -> Array:
    """Pressure of the ideal cycle by the volume and its branch.

    Parameters
    ----------
    state : ChamberState, shape (..., n)
    cycle : IdealCycle, fields broadcastable to (..., 1)

    Returns
    -------
    Array, shape (..., n)
        Absolute pressure [Pa]. At a dead centre, where it jumps, as just after it: the peak at firing, the start of
        compression at the bottom. NaN where heat would still come in at the bottom dead centre, ρ > ε.

    Notes
    -----
    Compression p₁(V₁/V)^n₁, then p₃ as far as ρV_c, then p₃(ρV_c/V)^n₂; in the gas exchange the inlet's pressure while
    the volume grows, the exhaust's while it shrinks. docs/theory/gas, eq. (14.4).
    """
    corners = corner_pressures(cycle, state.largest / state.smallest)
    cut_off = cycle.cut_off_ratio * state.smallest
    grows = state.sense > 0
    heated = chosen(cut_off > state.largest, np.nan, corners.peak)
    # One power for both branches: it takes longer than all else.
    start = chosen(grows, heated, cycle.start_pressure)
    ratio = chosen(grows, cut_off / np.maximum(state.volume, cut_off), state.largest / state.volume)
    exponent = chosen(grows, cycle.expansion_exponent, cycle.compression_exponent)
    exchange = chosen(grows, cycle.inlet_pressure, cycle.exhaust_pressure)
    return chosen(state.turn > 0, start * np.power(ratio, exponent), exchange)


def ideal_slope(state: ChamberState, pressure: Array, volume_slope: Array, cycle: IdealCycle) -> Array:
    """Derivative of `ideal_pressure` by the crank angle, for the volume's; of a jump it has nothing. [Pa/rad]

    p′ = −n p V′/V. docs/theory/gas, eq. (14.24).
    """
    expands = chosen(state.volume > cycle.cut_off_ratio * state.smallest, cycle.expansion_exponent, 0.0)
    exponent = chosen(state.sense > 0, expands, cycle.compression_exponent)
    return polytropic_slope(pressure, chosen(state.turn > 0, exponent, 0.0), state.volume, volume_slope)


def ideal_mean_pressures(cycle: IdealCycle, compression_ratio: Array) -> MeanPressures:
    """Indicated mean pressures of the ideal four-stroke cycle, in closed form; of a two-stroke, `gross` alone.

    Parameters
    ----------
    cycle : IdealCycle, fields of any shape
    compression_ratio : Array, broadcastable
        ε, largest volume over smallest. [1]

    Returns
    -------
    MeanPressures, of the broadcast shape
        NaN where heat would still come in at the bottom dead centre, ρ > ε. Work is mean pressure times swept volume.

    Notes
    -----
    docs/theory/gas, eqs. (14.6) and (14.7); the form of Grinevetsky and Mazing with absolute pressures.

    Examples
    --------
    >>> dual = IdealCycle(1.2e5, 1.2e5, 1.1e5, 1.36, 1.25, 1.55, 1.45)
    >>> round(float(ideal_mean_pressures(dual, 16.0).net), 3)
    1052208.306
    """
    corners = corner_pressures(cycle, compression_ratio)
    cut_off = cycle.cut_off_ratio
    expansion = polytropic_work(corners.peak * cut_off, cut_off / compression_ratio, cycle.expansion_exponent)
    compression = polytropic_work(corners.compressed, 1 / compression_ratio, cycle.compression_exponent)
    sum_of_works = corners.peak * (cut_off - 1) + expansion - compression
    gross = chosen(cut_off > compression_ratio, np.nan, sum_of_works / (compression_ratio - 1))
    pumping = cycle.inlet_pressure - cycle.exhaust_pressure
    return MeanPressures(gross, pumping, gross + pumping)
