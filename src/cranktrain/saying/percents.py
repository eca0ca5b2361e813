"""Errors in percent, as text."""

from math import floor, isfinite, log10

from cranktrain.saying.wording import ABSENT, signless

_LEAST = 1e-12
"""A smaller error is rounding."""


def percent(error: float) -> str:
    """Write an error in percent with two decimals, a small one with two figures, without the sign of percent.

    Parameters
    ----------
    error : float
        In parts of what it is an error of.

    Returns
    -------
    str

    Examples
    --------
    >>> percent(0.0254), percent(-6.3e-5), percent(1.2e-7), percent(3e-17)
    ('2.54', '-0.0063', '0.000012', '0.00')
    """
    if not isfinite(error):
        return ABSENT
    size = 100.0 * error
    decimals = 2 if abs(error) < _LEAST else max(2, 1 - floor(log10(abs(size))))
    return signless(f"{size:.{decimals}f}")
