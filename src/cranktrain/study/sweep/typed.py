"""Values of a sweep as they are typed: `130..160 mm:200`, `1000, 1500 rpm`, `cage, shunt`, `["0 deg", "90 deg"]`."""

import re
import tomllib
from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from math import lcm

from cranktrain.errors import InputError, Problem
from cranktrain.language import Words, _
from cranktrain.one_line import short
from cranktrain.quantities import Dimension, is_unit
from cranktrain.quantities.number import Measured, measured

DEFAULT_POINTS = 21
"""Of a range that does not say how many."""
MOST_POINTS = 1_000_000
"""Of one range."""
_KEPT = 256
"""Units of which it is kept whether they are any."""
_COUNT = re.compile(r"\d{1,99}")
_DECIMALS = re.compile(r"(?<![\w,/])(?<!\d\.)(?<!\d[-−])\d+,\d+(?:,\d+,\d+)*(?!\d|[,./]\d)")
"""Whole numbers in pairs with nothing but a comma between: each pair may be one number whose decimals it divides."""
_PAIR = re.compile(r"(\d+),(\d+)")


def values_typed(path: str, text: str) -> tuple[object, ...]:
    """Read values of one number, or words, of a file.

    Parameters
    ----------
    path : str
        Where they stand in the file.
    text : str
        A range `FROM..TO:N` of N values, both ends with it; values with commas between, of which those without a unit
        have that of the next one with it; or a list of TOML, each item of which is a value, as a list of throws is.
        Where semicolons stand between values a comma divides decimals.

    Returns
    -------
    tuple of object
        As `Machine.with_` takes them.

    Raises
    ------
    InputError

    Examples
    --------
    >>> values_typed("mechanism.rod_length", "130..136 mm:4")
    ('130 mm', '132 mm', '134 mm', '136 mm')
    >>> values_typed("shaft.main.speed", "1000, 1500 rpm")
    ('1000 rpm', '1500 rpm')
    >>> values_typed("drive.motor.kind", "cage, shunt")
    ('cage', 'shunt')
    >>> values_typed("mechanism.rod_length", "130,5; 136 mm")
    ('130.5 mm', '136 mm')
    """
    typed = text.strip()
    if typed.startswith("["):
        return tuple(_of_list(path, typed))
    found: list[object] = []
    unit = ""
    for word in reversed(_words(path, typed)):
        if not word.strip():
            raise _refused(path, text, _("must be values with commas between, such as 1000, 1500 rpm"))
        values, unit = _of_range(path, word, unit) if ".." in word else _alone(word, unit)
        found[:0] = values
    return tuple(found)


def n_values_typed(text: str) -> int:
    """How many values a text stands for, none of which is read; at least 1."""
    typed = text.strip()
    if typed.startswith("["):
        return 1
    return sum(map(_n_values, typed.split(";" if ";" in typed else ",")))


def _n_values(word: str) -> int:
    """How many values a value or a range is; 1 of what is none, or has more than any may have: it is refused unmade."""
    if ".." not in word:
        return 1
    _ends, colon, count = word.rpartition(":")
    n_values = int(count) if _COUNT.fullmatch(count.strip()) else 1 if colon else DEFAULT_POINTS
    return n_values if n_values <= MOST_POINTS else 1


def _words(path: str, typed: str) -> list[str]:
    """Values and ranges one by one, with decimal points; refuse a comma that may be one of decimals, or between two."""
    if ";" in typed:
        return [_pointed(word) for word in typed.split(";")]
    if _DECIMALS.search(typed):
        allowed = _("has a comma between digits, which may divide decimals or values")
        several = re.sub(r",\s*", ", ", typed)
        repair = _('write "{point}", or "{several}" for several values', point=_pointed(typed), several=several)
        raise _refused(path, typed, allowed, repair)
    return typed.split(",")


def _pointed(text: str) -> str:
    """Numbers with decimal points whose decimals a comma divides; pairs of a row apart."""
    return _DECIMALS.sub(lambda row: ", ".join(".".join(pair) for pair in _PAIR.findall(row[0])), text)


def _of_list(path: str, text: str) -> Sequence[object]:
    """Items of a list of TOML."""
    try:
        items: list[object] = tomllib.loads(f"values = {text}")["values"]
    except (tomllib.TOMLDecodeError, RecursionError):
        items = []
    if not items:
        allowed = _("must be a list of TOML, each item of which is a value")
        raise _refused(path, text, allowed, _('write like [["0 deg", "90 deg"], ["0 deg", "180 deg"]]'))
    return items


def _alone(word: str, unit: str) -> tuple[list[object], str]:
    """One value, and the unit that is said up to here, from behind."""
    text = word.strip()
    number = quantity_typed(text)
    if number is None:
        return [_plain(text)], unit
    if number.unit or not unit:
        return [text if number.unit else _plain(text)], number.unit or unit
    return [f"{text} {unit}"], unit


def _plain(text: str) -> object:
    """A number, truth or quoted text as TOML has it; all else is text."""
    try:
        value: object = tomllib.loads(f"value = {text}")["value"]
    except (tomllib.TOMLDecodeError, RecursionError):
        return text
    return value if isinstance(value, bool | int | float | str) else text


def _of_range(path: str, word: str, unit: str) -> tuple[list[object], str]:
    """Values of a range, evenly from its one end to the other."""
    ends, colon, count = word.rpartition(":")
    first, _dots, last = (ends if colon else word).partition("..")
    one, other = _measured(first), _measured(last)
    n_values = int(count.strip()) if _COUNT.fullmatch(count.strip()) else DEFAULT_POINTS if not colon else 0
    allowed = _("must be FROM..TO:N, with a unit, such as 130..160 mm:31")
    if one is None or other is None or n_values < 1 or "..." in word:
        raise _refused(path, word.strip(), allowed)
    own = other.unit or unit
    if one.unit and one.unit != own:
        raise _refused(path, word.strip(), _("must have one unit for both ends"), _("write it once, behind the second"))
    if n_values < 2 or one.number == other.number:
        repair = _("write at least 2 values, and ends that differ")
        raise _refused(path, word.strip(), _("is no range"), repair)
    if n_values > MOST_POINTS:
        raise _refused(path, word.strip(), _("has more values than any range may have, {most}", most=MOST_POINTS))
    numbers = _evenly(one.number, other.number, n_values)
    return [f"{_number_text(number)} {own}" if own else number for number in numbers], own


def _evenly(first: Fraction, last: Fraction, n_values: int) -> list[float]:
    """Numbers from one to another, each the nearest double: a quotient of whole numbers is rounded once."""
    step = (last - first) / (n_values - 1)
    below = lcm(first.denominator, step.denominator)
    start, each = int(first * below), int(step * below)
    return [(start + each * place) / below for place in range(n_values)]


def _number_text(number: float) -> str:
    """A number as one would type it."""
    return repr(number).removesuffix(".0")


def quantity_typed(text: str) -> Measured | None:
    """A number with its unit; None of what is none, as an order of firing.

    Examples
    --------
    >>> quantity_typed("130 mm").unit, quantity_typed("1 3 4 2")
    ('mm', None)
    """
    found = _measured(text)
    return found if found is not None and (not found.unit or _is_unit(found.unit)) else None


def _measured(text: str) -> Measured | None:
    """A number and whatever stands behind it; None of what begins with none."""
    try:
        return measured(text.strip())
    except (ZeroDivisionError, OverflowError):
        return None


@lru_cache(maxsize=_KEPT)
def _is_unit(text: str) -> bool:
    """Whether a text names a unit of anything."""
    return any(is_unit(text, dimension) for dimension in Dimension)


def _refused(path: str, given: str, allowed: Words, repair: Words | None = None) -> InputError:
    return InputError([Problem(path, short(given), allowed, repair)])
