"""Level of the pressures by the compression, a polytrope: its exponent, and what makes it the one that is known.

Pegging: a pressure sensor measures changes only, so the level is found by one known pressure or by compression.
"""

import numpy as np

from cranktrain.motion import Array


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
