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
    x = 2ᵏm with m in [√½, √2); ln m = 2 artanh s with s = (m − 1)/(m + 1), and eᵠ after another power of two is taken
    out, both by polynomials. To 2e-15 for powers up to 10⁷.
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
    """2(artanh s − s)/s³ by s² up to 0.03; coefficients, as below, of least error, by `mpmath.chebyfit`.

    Pairs of terms, and pairs of these, stand by themselves: a processor finds them at once.
    """
    fourth = square * square
    low = (0.666666666666667 + square * 0.3999999999989938) + fourth * (
        0.28571428626031065 + square * 0.2222221112572281
    )
    high = (0.18182889786191042 + square * 0.15331699633543858) + fourth * 0.14616721179861816
    return low + fourth * fourth * high


def _exponential(power: float) -> float:
    """Exponential of up to ½ ln 2, either way."""
    square = power * power
    fourth = square * square
    low = (0.5000000000000001 + power * 0.16666666666666669) + square * (
        0.04166666666662413 + power * 0.008333333333330062
    )
    middle = (0.0013888888917213717 + power * 0.00019841269863053618) + square * (
        2.4801521295954376e-05 + power * 2.7557268459997064e-06
    )
    high = 2.7620088445409746e-07 + power * 2.510038549551032e-08
    return 1.0 + (power + square * (low + fourth * (middle + fourth * high)))
