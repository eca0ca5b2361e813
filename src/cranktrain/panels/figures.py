"""Numbers as pictures write them: four figures, a true minus, no powers of ten."""

from collections.abc import Sequence

import numpy as np

from cranktrain.motion import Array
from cranktrain.saying.scales import Scale
from cranktrain.saying.wording import ABSENT, decimals_for, signless, true_minus

_DIGITS = 4
_NOTHING = 1e-9


def figure(value: float) -> str:
    """Write a number with four figures, and a true minus.

    Examples
    --------
    >>> figure(-0.012345), figure(180.0), figure(20994.0), figure(float("nan"))
    ('−0.01235', '180.0', '20990', '–')
    """
    return _written(value, decimals_for(abs(value), _DIGITS))


def column(values: Sequence[float], scale: Scale) -> list[str]:
    """Write SI values of a column in a unit, with four figures each; what is rounding beside the largest is 0.

    Examples
    --------
    >>> column([47780.0, 9318.0, 82.61, 0.0], Scale("kN"))
    ['47.78', '9.318', '0.08261', '0']
    """
    shown = [float(scale.of(value)) for value in values]
    nothing = _NOTHING * max(1.0, *(abs(value) for value in shown if np.isfinite(value)), 0.0)
    return [_written(value, decimals_for(abs(value), _DIGITS), nothing) for value in shown]


def aligned(values: Array) -> list[str]:
    """Write numbers of a column with four figures each, what is rounding as 0 of the largest, and a true minus.

    Examples
    --------
    >>> aligned(np.array([135.84, 0.06127, 1e-14]))
    ['135.8', '0.06127', '0.0']
    """
    most = float(np.nanmax(np.abs(values), initial=0.0))
    nothing = _NOTHING * max(1.0, most)
    usual = decimals_for(most if most > _NOTHING else 0.0, _DIGITS)
    decimals = [decimals_for(abs(value), _DIGITS) if abs(value) > nothing else usual for value in values.tolist()]
    return [_written(value, own, nothing=0.0) for value, own in zip(values.tolist(), decimals, strict=True)]


def rounded(value: float) -> str:
    """Write a number with two decimals, or with fewer so that it has four figures; and a true minus.

    Examples
    --------
    >>> rounded(3.109), rounded(-110.28), rounded(-0.001)
    ('3.11', '−110.3', '0.00')
    """
    return _written(value, min(2, decimals_for(abs(value), _DIGITS)) if abs(value) >= 1.0 else 2, nothing=0.0)


def degrees(value: float) -> str:
    """Write an angle in degrees with two decimals, and a true minus."""
    return _written(value, 2, nothing=0.0)


def with_unit(value: float, scale: Scale) -> str:
    """Write an SI value with its unit.

    Examples
    --------
    >>> with_unit(-1234.5, Scale("N"))
    '−1234 N'
    """
    return f"{figure(float(scale.of(value)))} {scale.label}".rstrip()


def _written(value: float, decimals: int, nothing: float = _NOTHING) -> str:
    """Write a number with some decimals, or tens; what is nothing is a bare 0."""
    if not np.isfinite(value):
        return ABSENT
    if abs(value) < nothing:
        return "0"
    return true_minus(signless(f"{round(value, decimals):.{max(0, decimals)}f}"))
