"""Numbers of results as tables in Python and comparisons write them: in units of the drawing office, four digits."""

from math import floor, log10
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.quantities import shown
from cranktrain.wording import signless

ABSENT = "—"
"""Stands for a number that one of several machines has not."""

_DIGITS, _DIGITS_OF_DIFFERENCE = 4, 3
_ROUNDING = 1e-9
"""Of the larger of two values: a difference that is less is none."""

_NOTHING = 1e-9
"""What is smaller in a unit of the drawing office is 0."""

_SMALL_VOLUME = 1e-4
"""Volumes that are all smaller are given in cm³. [m³]"""

_UNITS = {
    "m": "mm",
    "m^2": "cm²",
    "rad": "°",
    "deg": "°",
    "Pa": "bar",
    "W": "kW",
    "N": "kN",
    "N*m": "N·m",
    "kg*m^2": "kg·m²",
    "m/s^2": "m/s²",
    "rad/s^2": "rad/s²",
    "m/rad": "mm/rad",
    "m/rad^2": "mm/rad²",
    "m^3": "L",
}
_FACTORS = {"deg": 1.0, "m/rad": 1e3, "m/rad^2": 1e3}
"""Of what is no unit of an input."""


class ShownUnit(NamedTuple):
    """The unit in which values are shown, and the factor to it; None where the list of units has that."""

    unit: str
    factor: float | None

    def converted(self, values: Array) -> Array:
        """Give values of the catalogue in the unit."""
        return shown(values, self.unit) if self.factor is None else self.factor * values

    def text(self, value: float) -> str:
        """Write one value."""
        return significant(float(self.converted(np.array(value))))


def shown_in(unit: str, values: Array) -> ShownUnit:
    """Choose the unit for values.

    Parameters
    ----------
    unit : str
        Of the catalogue.
    values : Array
        In it: parts of less than one are shown in %, small volumes in cm³.

    Returns
    -------
    ShownUnit

    Examples
    --------
    >>> shown_in("Pa", np.array([5e6])).unit
    'bar'
    """
    sizes = np.abs(values[np.isfinite(values)])
    if unit == "1":
        is_part = np.all(sizes < 1) and np.any(sizes > 0)
        return ShownUnit("%", 100.0) if is_part else ShownUnit("", 1.0)
    if unit == "m^3" and np.all(sizes < _SMALL_VOLUME):
        return ShownUnit("cm³", None)
    if unit in _UNITS:
        return ShownUnit(_UNITS[unit], _FACTORS.get(unit))
    return ShownUnit(_plain(unit), 1.0)


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
    decimals = digits - 1 - floor(log10(size))
    if float(f"{size:.{max(0, decimals)}f}") >= 10.0 ** (floor(log10(size)) + 1):
        decimals -= 1  # 9.9996 is 10.00
    return signless(f"{value:.{max(0, decimals)}f}").replace("-", "−")


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


def _plain(unit: str) -> str:
    """Write a unit as print does."""
    return unit.replace("^2", "²").replace("^3", "³").replace("*", "·")


def _signed(value: float, text: str) -> str:
    return f"+{text}" if value > 0 else text
