"""The number before a unit, by a strict rule: laxer readers take `1,5 m` for 15 m and `7 1/16 in` for 0.4375 in."""

import math
import re
from decimal import Decimal
from fractions import Fraction
from typing import NamedTuple

# Sign; whole number, numerator, denominator, or a decimal number. Python and JSON schema (JavaScript) read it alike.
PATTERN = (
    r"^\s*([+-]?)"
    r"(?:(?:([0-9]+)\s+)?([0-9]+)/([0-9]+)|((?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?))"
    r"(?![0-9.,_/+-]|\s+\.)"
)


class Measured(NamedTuple):
    """A text taken apart: its number, exactly, and the text of its unit."""

    number: Fraction
    unit: str


def measured(text: str) -> Measured | None:
    """Take a text apart at the end of its number.

    Parameters
    ----------
    text : str
        A number and a unit. The number: sign, digits with a decimal point and an exponent, or a whole number with
        a fraction.

    Returns
    -------
    Measured or None
        None where the text does not begin with a number.

    Raises
    ------
    ZeroDivisionError
        For a fraction with the denominator 0.
    OverflowError
        For a number that no double holds, large or small.

    Examples
    --------
    >>> measured("-7 1/16 in")
    Measured(number=Fraction(-113, 16), unit='in')
    """
    found = re.match(PATTERN, text)
    if found is None:
        return None
    sign, whole, numerator, denominator, decimal = found.groups()
    size = (
        _decimal(decimal) if decimal else _integer(whole or "0") + Fraction(_integer(numerator), _integer(denominator))
    )
    return Measured(-size if sign == "-" else size, text[found.end() :].strip())


def rounded(exact: Fraction) -> float:
    """Round once, to the nearest double.

    Raises
    ------
    OverflowError
        If none is near, large or small.
    """
    nearest = float(exact)
    if nearest == 0.0 and exact:
        raise OverflowError
    return nearest


def _decimal(digits: str) -> Fraction:
    """Read a decimal number exactly, unless its exponent alone would fill the memory."""
    approximate = float(digits)
    if math.isinf(approximate) or (approximate == 0.0 and re.match(r"[0.]*[1-9]", digits)):
        raise OverflowError
    return Fraction(Decimal(digits)) if approximate else Fraction(0)


def _integer(digits: str) -> int:
    """Read a whole number of any length; `int` of a text stops at 4300 digits."""
    return int(Decimal(digits))
