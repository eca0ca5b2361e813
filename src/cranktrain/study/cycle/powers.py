"""A power in plain arithmetic, which loops take for several points at once; the library's own is called for each."""

import numpy as np

_BIT = 52
"""Where the exponent of two begins in the bits of a number."""
_BIAS = 1023
_ROOT_OF_HALF = 0x3FE6A09E667F3BCD
"""Bits of √½."""
_LAST_IS_ONE = 6755399441055744.0
"""1.5 · 2⁵²: what is added to it stands in its last bits as an integer."""
_LOG_2 = 0.6931471805599453
_LOG_2_HIGH, _LOG_2_LOW = 6.93147180369123816490e-01, 1.90821492927058770002e-10
"""ln 2 in two parts, of which the first times an exponent of two is exact."""
_MOST = 700.0
"""Logarithm of the largest power; of larger ones none is found, nor of smaller ones than its inverse."""


def power(base: float, exponent: float) -> float:
    """Power of a positive number; NaN of others, and of what is beyond 10³⁰⁴ or below its inverse.

    Notes
    -----
    x = 2ᵏm with m in [√½, √2); ln m = 2 artanh s by its series in s = (m − 1)/(m + 1), and eᵠ by its own, after another
    power of two is taken out. To 2e-15 for powers up to 10⁷.
    """
    bits = np.float64(base).view(np.int64)
    of_two = (bits - _ROOT_OF_HALF) >> _BIT
    rest = np.int64(bits - (of_two << _BIT)).view(np.float64)
    last = np.float64(_LAST_IS_ONE).view(np.int64)
    s = (rest - 1.0) / (rest + 1.0)
    log = (np.int64(last + of_two).view(np.float64) - _LAST_IS_ONE) * _LOG_2 + (2.0 * s + s * s * s * _artanh(s * s))
    wanted = exponent * log
    twos = float(np.rint(wanted * (1.0 / _LOG_2)))
    found = _exponential(wanted - twos * _LOG_2_HIGH - twos * _LOG_2_LOW)
    scale = np.int64((np.float64(twos + _LAST_IS_ONE).view(np.int64) + _BIAS) << _BIT).view(np.float64)
    return float(found * scale) if base > 0.0 and abs(wanted) < _MOST else np.nan


def _artanh(square: float) -> float:
    """2(artanh s − s)/s³ by s² up to 0.03."""
    found = 2 / 21 + square * (2 / 23)
    found = 2 / 19 + square * found
    found = 2 / 17 + square * found
    found = 2 / 15 + square * found
    found = 2 / 13 + square * found
    found = 2 / 11 + square * found
    found = 2 / 9 + square * found
    found = 2 / 7 + square * found
    found = 2 / 5 + square * found
    return 2 / 3 + square * found


def _exponential(power: float) -> float:
    """Exponential of up to ½ ln 2, either way."""
    found = 1.0 + power * (1 / 13)
    found = 1.0 + power * (1 / 12) * found
    found = 1.0 + power * (1 / 11) * found
    found = 1.0 + power * (1 / 10) * found
    found = 1.0 + power * (1 / 9) * found
    found = 1.0 + power * (1 / 8) * found
    found = 1.0 + power * (1 / 7) * found
    found = 1.0 + power * (1 / 6) * found
    found = 1.0 + power * (1 / 5) * found
    found = 1.0 + power * (1 / 4) * found
    found = 1.0 + power * (1 / 3) * found
    found = 1.0 + power * (1 / 2) * found
    return 1.0 + power * found
