"""From the text of a quantity to its SI value, or to an error that says what to write."""

import re
from functools import lru_cache
from itertools import zip_longest
from math import trunc
from typing import NamedTuple

from cranktrain.language import Words, _
from cranktrain.quantities.dimensions import TURN, Dimension, Unit, expected, plain, spellings
from cranktrain.quantities.number import Measured, measured, rounded
from cranktrain.quantities.refusal import Instead, QuantityError, nearest, written

# Ways to write a number that others read and we do not, each with ours; 1,500 may be 1.5 or 1500, so it is no repair.
_HABITS = (
    (re.compile(r"[−–]"), "-"),
    (re.compile(r"(?<=\d)[ _](?=\d{3}(?!\d))"), ""),
    (re.compile(r"(?<=\d),(?=\d)"), "."),
    (re.compile(r"(?<=\d)-(?=\d+/\d)"), " "),
)
_BASE = re.compile(r"^[GMkhdcmµμnГМкгдсмн](\D.*)")
"""A unit with a prefix, and what it is without."""
_THOUSANDS = re.compile(r"^[+-]?\d{1,3}(?:,\d{3})+(?![\d,])", re.ASCII)


_METRES = 10
"""A length below this without a unit may be meant in metres as well as in millimetres."""

_MANY_TURNS = TURN / 360 * 10**5
"""Directions of so much and more count no turns. [rad]"""

_KEPT = 1024
"""Texts whose reading is kept: a machine has some hundred."""


class Reading(NamedTuple):
    """A quantity that was understood: SI value, text without needless blanks, unit (None for a plain number)."""

    si: float
    text: str
    unit: Unit | None


def read(text: object, dimension: Dimension) -> float:
    """SI value of a quantity with its unit.

    Parameters
    ----------
    text : str, or int or float for a plain number
        As in a machine file: "180 mm", "7 1/16 in", "15 кгс·м"; for `Dimension.RATIO` also 14.5 or "8 %".
    dimension : Dimension

    Returns
    -------
    float
        In SI and radians, rounded once; a pressure absolute, a flywheel moment as GD² in kg·m².

    Raises
    ------
    QuantityError
        If it is anything else.

    Examples
    --------
    >>> read("180 mm", Dimension.LENGTH), read("1 ati", Dimension.PRESSURE)
    (0.18, 199391.5)
    """
    return reading(text, dimension).si


def reading(given: object, dimension: Dimension, *, is_direction: bool = False, example: str | None = None) -> Reading:
    """Read a quantity with all that is known about it; refuse as `read` does.

    Of a direction of 1e5 deg and more whole turns are left out while it is exact: rounding would take digits of it.
    What is refused is told with an example, that of the dimension unless given; to a number without a unit that of the
    example is proposed.
    """
    return _reading(_text(given, dimension, example), dimension, is_direction, example)


@lru_cache(maxsize=_KEPT)
def _reading(text: str, dimension: Dimension, is_direction: bool, example: str | None) -> Reading:
    """Read a text: once, as who changes one number of a machine gives all others again."""
    try:
        parts = measured(text)
        if parts is None:
            raise _no_number(text, dimension, example)
        unit = _unit(parts, text, dimension, example)
        exact = parts.number if unit is None else unit.scale * parts.number + unit.offset
        if is_direction and abs(exact) >= _MANY_TURNS:
            exact -= TURN * trunc(exact / TURN)
        return Reading(rounded(exact), text, unit)
    except ZeroDivisionError:
        raise QuantityError(text, _("must be a fraction whose denominator is not 0")) from None
    except OverflowError:
        allowed = _("must be within what a computer number holds, in SI units 5e-324 to 1.8e308")
        raise QuantityError(text, allowed) from None


def _text(given: object, dimension: Dimension, example: str | None) -> str:
    """Take a text, or a bare number where no unit is needed."""
    if isinstance(given, str):
        return " ".join(given.split())
    if isinstance(given, bool) or not isinstance(given, int | float):
        raise QuantityError(written(given), expected(dimension, example))
    if not dimension.needs_unit:
        return str(given)
    raise _no_unit(str(given), dimension, example)


def _unit(parts: Measured, text: str, dimension: Dimension, example: str | None) -> Unit | None:
    """Find the unit in the list of the dimension."""
    if not dimension.needs_unit and not parts.unit:
        return None
    if not parts.unit:
        raise _no_unit(text, dimension, example)
    known = spellings(dimension).get(plain(parts.unit))
    if known is None:
        raise _wrong_unit(parts.unit, text, dimension, example)
    return known[0]


def _no_unit(text: str, dimension: Dimension, example: str | None) -> QuantityError:
    parts = measured(text)
    if parts is None:  # a bare nan or inf
        return _no_number(text, dimension, example)
    usual = measured(example or "")
    repair = Instead((f"{text} {usual.unit if usual else dimension.units[0].name}",))
    if dimension is Dimension.LENGTH and abs(parts.number) < _METRES:
        repair = Instead((f"{text} m", f"{text} mm"))
    return QuantityError(text, expected(dimension, example), repair)


def _no_number(text: str, dimension: Dimension, example: str | None) -> QuantityError:
    if re.match(r"[+-]?(?:nan|inf(?:inity)?)\b", text, re.IGNORECASE):
        return QuantityError(text, _("must be finite; {expected}", expected=expected(dimension, example)))
    return QuantityError(written(text), expected(dimension, example), _other_habit(text, dimension))


def _wrong_unit(unit: str, text: str, dimension: Dimension, example: str | None) -> QuantityError:
    """Say what the unit measures, or which one was meant."""
    number = text.removesuffix(unit).strip()
    key = plain(unit)
    if dimension is Dimension.SPEED and (bare := re.fullmatch(r"1/(min|мин|s|с)|(min|мин|s|с)-1", key)):
        units = ("rpm", "rad/s") if "m" in bare[0] or "м" in bare[0] else ("rad/s", "rpm")
        repair = _('write "{number} {unit}", or the speed in {other}: {given} does not say whether turns or radians')
        repair = repair.format(number=number, unit=units[0], other=units[1], given=unit)
        return QuantityError(text, expected(dimension, example), repair)
    others = [other for other in Dimension if key in spellings(other)]
    if others:
        allowed = _("{unit} measures {noun}; {expected}")
        noun = _(others[0].noun)
        return QuantityError(text, allowed.format(unit=unit, noun=noun, expected=expected(dimension, example)))
    meant = nearest(key, spellings(dimension))
    if meant is not None and _is_of_another_size(key, meant):
        return QuantityError(text, expected(dimension, example))
    repair = Instead((f"{number} {spellings(dimension)[meant][1]}",)) if meant else _other_habit(text, dimension)
    return QuantityError(text, expected(dimension, example), repair)


def _is_of_another_size(given: str, meant: str) -> bool:
    """Whether two units differ by a prefix, as kg·cm² and kg·m²: to write the one for the other changes the value."""
    pairs = list(zip_longest(*(re.split("[·/]", unit) for unit in (given, meant)), fillvalue=""))
    different = [(one, other) for one, other in pairs if one.casefold() != other.casefold()]
    return bool(different) and all(_BASE.sub(r"\1", one) == _BASE.sub(r"\1", other) for one, other in different)


def _other_habit(text: str, dimension: Dimension) -> Words | None:
    """Write the number our way, where that gives a quantity."""
    ours = text
    for habit, replacement in _HABITS:
        ours = habit.sub(replacement, ours)
    if ours == text:
        return None
    try:
        repair = Instead((reading(ours, dimension).text,))
    except QuantityError as error:
        return error.problems[0].repair
    if _THOUSANDS.match(text):
        repair = Instead((ours, text.replace(",", "")))
    return repair
