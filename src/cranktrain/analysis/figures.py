"""Numbers of results as tables in Python and comparisons write them: in units of the drawing office, four digits."""

import numpy as np

from cranktrain.motion import Array
from cranktrain.saying.scales import Scale, scale_for
from cranktrain.saying.sections import ComparedFact
from cranktrain.saying.wording import decimals_for, signless

ABSENT = "—"
"""Stands for a number that one of several machines has not."""

_DIGITS, _DIGITS_OF_DIFFERENCE = 4, 3
_ROUNDING = 1e-9
"""Of the larger of two values: a difference that is less is none."""

_NOTHING = 1e-9
"""What is smaller in a unit of the drawing office is 0."""


def shown_in(unit: str, values: Array) -> Scale:
    """Choose the unit for values, in the catalogue's unit; parts of less than one are shown in %.

    Examples
    --------
    >>> shown_in("Pa", np.array([5e6])).label
    'bar'
    """
    sizes = np.abs(values[np.isfinite(values)])
    is_part = unit == "1" and np.all(sizes < 1) and np.any(sizes > 0)
    return scale_for("%" if is_part else unit, float(np.max(sizes, initial=0.0)))


def text_in(scale: Scale, value: float) -> str:
    """Write one value of the catalogue in a unit, without that."""
    return significant(float(scale.of(value)))


def significant(value: float, digits: int = _DIGITS) -> str:
    """Write a number with some significant digits, no exponent, and a true minus.

    Examples
    --------
    >>> significant(180.0), significant(-0.012345), significant(123456.0), significant(14.0)
    ('180.0', '−0.01235', '123456', '14.00')
    """
    if not np.isfinite(value):
        return ABSENT
    size = abs(value)
    if size < _NOTHING:
        return "0"
    return signless(f"{value:.{max(0, decimals_for(size, digits))}f}").replace("-", "−")


def difference(first: float, second: float) -> str:
    """Write by how much the second value is more, with its sign; no more than rounding is 0."""
    if not np.isfinite(second - first):
        return ABSENT
    if abs(second - first) <= max(_NOTHING, _ROUNDING * max(abs(first), abs(second))):
        return "0"
    return _signed(second - first, significant(second - first, _DIGITS_OF_DIFFERENCE))


def percent(value: float) -> str:
    """Write a percentage with its sign; a very small one is below what is shown."""
    if not np.isfinite(value):
        return ABSENT
    if abs(value) < 1e-7:
        return "0 %"
    if abs(value) < 0.005:
        return "< 0.01 %"
    decimals = 2 if abs(value) < 9.995 else 1 if abs(value) < 999.5 else 0
    return _signed(value, f"{value:.{decimals}f}".replace("-", "−") + " %")


def _signed(value: float, text: str) -> str:
    return f"+{text}" if value > 0 else text


def compared_texts(fact: ComparedFact) -> tuple[str, ...]:
    """Both values, their unit, their difference in it, and in percent."""
    shown = shown_in(fact.unit, np.array([fact.first, fact.second]))
    first, second = (float(shown.of(value)) for value in (fact.first, fact.second))
    return significant(first), significant(second), shown.label, difference(first, second), percent(fact.percent)
