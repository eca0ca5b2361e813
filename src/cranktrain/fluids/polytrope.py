"""Work along a polytrope, p Vⁿ = const, for any exponent."""

import numpy as np

from cranktrain.motion import Array, chosen


def polytropic_work(pressure_volume: Array, ratio: Array, exponent: Array) -> Array:
    """Work of a gas that changes its volume along a polytrope.

    Parameters
    ----------
    pressure_volume : Array
        p₁V₁ at the start [J]; or p₁ alone, for work per volume V₁ [Pa].
    ratio : Array, broadcastable
        V₁/V₂: below 1 the gas expands. [1]
    exponent : Array, broadcastable
        n [1]; 1 is the isotherm of an ideal gas, and no exception.

    Returns
    -------
    Array, of the broadcast shape
        ∫ p dV, positive in expansion. [J or Pa]

    Notes
    -----
    p₁V₁ G(V₁/V₂, n) with G(r, n) = (1 − r^(n−1))/(n − 1), written −ln r · (eˣ − 1)/x with x = (n − 1) ln r, which
    keeps its digits near n = 1. docs/theory/gas, eq. (14.5).

    Examples
    --------
    >>> round(float(polytropic_work(100.0, 0.5, 1.4)), 6), round(float(polytropic_work(100.0, 0.5, 1.0)), 6)
    (60.535429, 69.314718)
    """
    log = np.log(ratio)
    x = (exponent - 1) * log
    growth = chosen(x == 0.0, 1.0, np.expm1(x) / chosen(x == 0.0, 1.0, x))
    return -pressure_volume * log * growth


def polytropic_slope(pressure: Array, exponent: Array, volume: Array, volume_slope: Array) -> Array:
    """Derivative of the pressure along a polytrope: −n p V′/V, by whatever V′ is the derivative. [Pa/rad]"""
    return -exponent * pressure * volume_slope / volume
