"""The compressor with clearance: two lines and two polytropes, by the volume and the sense in which it goes."""

from typing import NamedTuple

import numpy as np

from cranktrain.fluids.polytrope import polytropic_slope, polytropic_work
from cranktrain.fluids.state import ChamberState, VolumeLimits
from cranktrain.motion import Array, chosen


class Compressor(NamedTuple):
    """A compressor's numbers.

    Attributes
    ----------
    suction_pressure, discharge_pressure : Array
        In the chamber while a valve is open, absolute. [Pa]
    compression_exponent, expansion_exponent : Array
        Of compression and of re-expansion. [1]
    line_pressure, temperature : Array
        Of what it takes in. [Pa, K]
    discharge_line : Array
        Pressure of the line that it delivers into. [Pa]
    """

    suction_pressure: Array
    discharge_pressure: Array
    compression_exponent: Array
    expansion_exponent: Array
    line_pressure: Array
    temperature: Array
    discharge_line: Array


class Corners(NamedTuple):
    """Where the valves open and close.

    Attributes
    ----------
    peak : Array
        Largest pressure: the discharge's, or less where the piston works on one closed polytrope. [Pa]
    expansion_exponent : Array
        That of re-expansion with which there is a steady cycle. [1]
    suction_opens, discharge_opens : Array
        Volumes; suction closes at the largest volume, discharge at the smallest. [m³]
    """

    peak: Array
    expansion_exponent: Array
    suction_opens: Array
    discharge_opens: Array


def corners(compressor: Compressor, limits: VolumeLimits) -> Corners:
    """Where valves open and close, whether anything is delivered or not.

    Parameters
    ----------
    compressor : Compressor, fields of any shape
    limits : VolumeLimits, broadcastable

    Returns
    -------
    Corners, of the broadcast shape

    Notes
    -----
    With r = V₁/V_c and π = p_d/p_s: from π = r^n_c on the discharge valve stays shut and the piston works on one
    polytrope. Where only one of r^n_c and r^n_e is above π no cycle is steady, as more would come in than goes out or
    less; then n_e is taken as n_c. docs/theory/gas, eqs. (14.16) and (14.17).
    """
    suction, discharge, compression, expansion = compressor[:4]
    ratio = limits.largest / limits.smallest
    both = np.power(ratio, np.minimum(compression, expansion)) > discharge / suction
    exponent = chosen(both, expansion, compression)
    reached = suction * np.power(ratio, compression)
    delivers, peak = reached > discharge, np.minimum(discharge, reached)
    return Corners(
        peak,
        exponent,
        chosen(delivers, limits.smallest * np.power(peak / suction, 1 / exponent), limits.largest),
        chosen(delivers, limits.largest * np.power(suction / peak, 1 / compression), limits.smallest),
    )


def compressor_pressure(state: ChamberState, compressor: Compressor) -> Array:
    """Pressure in the chamber by its volume and the sense in which that goes.

    Parameters
    ----------
    state : ChamberState, shape (..., n)
    compressor : Compressor, fields broadcastable to (..., 1)

    Returns
    -------
    Array, shape (..., n)
        Absolute pressure. [Pa]

    Notes
    -----
    docs/theory/gas, eq. (14.16); Frenkel; Bloch and Hoefner, Reciprocating Compressors, ch. 3.
    """
    found = corners(compressor, VolumeLimits(state.smallest, state.largest))
    suction, discharge, exponent = compressor[:3]
    expands = state.sense > 0
    # One power for both branches: it takes longer than all else.
    ratio = chosen(expands, state.smallest, state.largest) / state.volume
    pressure = chosen(expands, found.peak, suction) * np.power(
        ratio, chosen(expands, found.expansion_exponent, exponent)
    )
    return chosen(expands, np.maximum(suction, pressure), np.minimum(discharge, pressure))


def compressor_slope(state: ChamberState, pressure: Array, volume_slope: Array, compressor: Compressor) -> Array:
    """Derivative of `compressor_pressure` by the crank angle, for the volume's: 0 while a valve is open. [Pa/rad]

    docs/theory/gas, eq. (14.24).
    """
    found = corners(compressor, VolumeLimits(state.smallest, state.largest))
    expands = chosen(pressure > compressor.suction_pressure, found.expansion_exponent, 0.0)
    compresses = chosen(pressure < compressor.discharge_pressure, compressor.compression_exponent, 0.0)
    return polytropic_slope(pressure, chosen(state.sense > 0, expands, compresses), state.volume, volume_slope)


def compressor_work(compressor: Compressor, limits: VolumeLimits) -> Array:
    """Work of the gas on the piston over a turn, in closed form: negative, as the piston drives it.

    Parameters
    ----------
    compressor : Compressor, fields of any shape
    limits : VolumeLimits, broadcastable. [m³]

    Returns
    -------
    Array, of the broadcast shape
        ∮ p dV. [J]

    Notes
    -----
    docs/theory/gas, eq. (14.19).
    """
    found = corners(compressor, limits)
    suction, exponent = compressor.suction_pressure, compressor.compression_exponent
    opens, discharges = found.suction_opens, found.discharge_opens
    return (
        polytropic_work(found.peak * limits.smallest, limits.smallest / opens, found.expansion_exponent)
        + suction * (limits.largest - opens)
        + polytropic_work(suction * limits.largest, limits.largest / discharges, exponent)
        - found.peak * (discharges - limits.smallest)
    )


def capacity(compressor: Compressor, limits: VolumeLimits) -> Array:
    """Part of the swept volume that is taken in, λ_v; nothing where the discharge valve stays shut.

    Notes
    -----
    1 + c − cπ^(1/n_e). docs/theory/gas, eq. (14.18).
    """
    opens = corners(compressor, limits).suction_opens
    return (limits.largest - opens) / (limits.largest - limits.smallest)


def discharge_temperature(compressor: Compressor, limits: VolumeLimits) -> Array:
    """Temperature at which the gas is delivered; NaN where none is. [K]

    Notes
    -----
    From the end of suction along the polytrope, T₁ π^((n_c − 1)/n_c). docs/theory/gas, eq. (14.28).
    """
    rise = compressor.discharge_pressure / compressor.suction_pressure
    start = compressor.temperature * suction_heating(compressor, limits)
    return start * rise ** (1 - 1 / compressor.compression_exponent)


def suction_heating(compressor: Compressor, limits: VolumeLimits) -> Array:
    """Temperature at the end of suction over that of what is taken in, T₁/T_s, by which the masses close.

    1 for n_c = n_e; NaN where nothing is delivered. docs/theory/gas, eq. (14.20).
    """
    found = corners(compressor, limits)
    delivered = (found.discharge_opens - limits.smallest) / found.discharge_opens
    taken = (limits.largest - found.suction_opens) / limits.largest
    return chosen(found.discharge_opens > limits.smallest, delivered / chosen(taken > 0, taken, 1.0), np.nan)
