"""Numbers and names put into sentences."""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from math import floor, log10
from string import digits
from typing import TypeVar

import numpy as np

from cranktrain.grouping import places_of_equal
from cranktrain.language import N_, Listed, Said, Words, _
from cranktrain.motion import Array
from cranktrain.quantities import Given, chosen_unit, of_result, shown

Chosen = TypeVar("Chosen", bound=Words)

Names = Mapping[str, Sequence[str]]
"""Labels of each dimension: the pistons', the chambers', …"""

ABSENT = "–"
"""Stands for a number that there is not."""

_DECIMALS = {
    "mm": 2,
    "deg": 2,
    "m/s": 2,
    "m/s^2": 0,
    "L": 3,
    "cm^3": 1,
    "rpm": 1,
    "%": 2,
    "N*m": 1,
    "N": 1,
    "kN": 2,
    "kW": 1,
    "J": 1,
    "Hz": 2,
    "m³/h": 2,
}
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")

_FIGURES = 4
"""Of a number that is not round."""

_SLOW_TOO = {"m/s", "m/s^2", "N*m", "N", "kN", "kW", "J", "kg*m^2", "Hz", "m³/h", "s"}
"""Units in which a slow or small machine's numbers need more decimals: three figures at least."""
_PLAIN = {"1": 1.0, "%": 100.0, "m/s^2": 1.0, "J": 1.0, "m³/h": 3600.0}
"""Units that are no input's, and how many of them one in SI is."""


@dataclass(frozen=True, slots=True, repr=False, eq=False)
class _Number(Said):
    """An SI value, said in a unit or the one that a reader chose for it; those that are said alike are one."""

    value: float
    unit: str

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Number) and (self.unit, self._usual) == (other.unit, other._usual)

    def __hash__(self) -> int:
        return hash((self.unit, self._usual))

    @property
    def _usual(self) -> str:
        """How it is written where nobody chose another unit."""
        return _usual_figure(self.value, self.unit) if np.isfinite(self.value) else ABSENT

    def said(self, say: Callable[[object], object]) -> str:
        """Say it."""
        if self.unit == "1" or not np.isfinite(self.value):
            return figure(self.value, self.unit)
        return f"{figure(self.value, self.unit)} {chosen_unit(self.unit) or self.unit}"


def number(value: float, unit: str) -> Said:
    """Give an SI value to be said in a unit, as `figure` writes it, with its unit, or with the one that a reader chose.

    Examples
    --------
    >>> str(number(0.18, "mm"))
    '180.00 mm'
    """
    return _Number(value, unit)


@dataclass(frozen=True, slots=True, repr=False)
class FigureOf(Said):
    """An SI value as `figure` writes it in a unit that stands elsewhere."""

    value: float
    unit: str

    def said(self, say: Callable[[object], object]) -> str:
        """Say it."""
        return figure(self.value, self.unit)


@dataclass(frozen=True, slots=True, repr=False)
class UnitOf(Said):
    """A unit by itself, or the one that a reader chose for it; none of a plain number."""

    unit: str

    def said(self, say: Callable[[object], object]) -> str:
        """Say it."""
        return chosen_unit(self.unit) or ("" if self.unit == "1" else self.unit)


@dataclass(frozen=True, slots=True, repr=False)
class _AsGiven(Said):
    """A number of the file, said as it was typed, or in the unit that was chosen for what usually has one."""

    given: Given
    usual: str

    def said(self, say: Callable[[object], object]) -> str:
        """Say it."""
        chosen = chosen_unit(self.usual)
        if chosen is None or self.given.text.endswith(chosen):
            return self.given.text.replace("-", "−")
        return str(number(self.given.si, chosen))


def as_given(given: Given, usual: str) -> Said:
    """Give a number of the file to be said as it was typed; in the unit that was chosen for what usually has one.

    Examples
    --------
    >>> str(as_given(Given(157.07963267948966, "1500 rpm"), "rpm"))
    '1500 rpm'
    """
    return _AsGiven(given, usual)


def figure(value: float, unit: str) -> str:
    """Write an SI value in a unit, not written here, with decimals that suit it; one that is not finite is absent."""
    if not np.isfinite(value):
        return ABSENT
    if (chosen := chosen_unit(unit)) is not None:
        size = of_result(value, chosen, unit)
        return signless(f"{size:.{max(decimals_for(abs(size), 4), 0)}f}")
    return _usual_figure(value, unit)


def _usual_figure(value: float, unit: str) -> str:
    """Write it where nobody chose another unit."""
    size = value * _PLAIN[unit] if unit in _PLAIN else of_result(value, unit, unit)
    decimals = _DECIMALS.get(unit, 3)
    if unit == "%":
        decimals = min(decimals, max(decimals_for(abs(size), 4), 0))
    if unit in _SLOW_TOO and 1e-6 < abs(size) < 100:
        decimals = max(decimals, 2 - floor(log10(abs(size))))
    return signless(f"{size:.{decimals}f}")


def decimals_for(size: float, figures: int) -> int:
    """How many decimals so many figures take; less than none where there are more before the point.

    Examples
    --------
    >>> decimals_for(180.0, 4), decimals_for(9.9996, 4), decimals_for(123456.0, 4)
    (1, 2, -2)
    """
    return figures - 1 - floor(log10(float(f"{size:.{figures - 1}e}"))) if 0 < size < np.inf else 0


def seen(size: float, decimals: int) -> int:
    """As many decimals as are wanted, or as show the first figure of what is less.

    Examples
    --------
    >>> seen(0.006, 2), seen(0.0023, 2)
    (2, 3)
    """
    return decimals if size >= 0.5 * 10.0**-decimals else decimals_for(size, 1)


def in_print(sentence: str) -> str:
    """Write the signs and units of a sentence as they are printed: a true minus, dots and powers.

    Examples
    --------
    >>> in_print("1L-2R: from -3.5 N*m, 2 kg*m^2, 9 m/s^2")
    '1L-2R: from −3.5 N·m, 2 kg·m², 9 m/s²'
    """
    for pattern, instead in _PRINTED:
        sentence = re.sub(pattern, instead, sentence)
    return sentence


@dataclass(frozen=True, slots=True, repr=False)
class InPrint(Said):
    """Words with signs and units as they are printed."""

    words: Words

    def said(self, say: Callable[[object], object]) -> str:
        """Say them."""
        return in_print(str(say(self.words)))

    def each(self) -> Iterable[object]:
        """Give them."""
        return (self.words,)


_PRINTED = (
    (r"(?<![\w.)-])-(?=\d)", "−"),
    (r"\b(k?N|kg)\*m\b", r"\1·m"),
    (r"\b(m?m/s|kg·m|[a-z]+/rad)\^2(?!\d)", r"\1²"),
)


def signless(text: str) -> str:
    """Take the sign from what is shown as 0."""
    return text.lstrip("-") if float(text) == 0.0 else text


def around_turn(angles: Array) -> Array:
    """Round crank angles to the digits that `number` shows, so that none is said to be at 360.00 deg. [rad]"""
    return np.radians(np.mod(np.round(shown(angles, "deg"), _DECIMALS["deg"]), 360.0))


def precise(limit: float, unit: str) -> str:
    """Write what is a limit in a unit, with the digits that a limit needs."""
    return f"{shown(limit, unit):.7g} {unit}"


@dataclass(frozen=True, slots=True, repr=False, eq=False)
class _Limit(Said):
    """A limit, said in its usual unit or the one that was chosen for it; those that are said alike are one."""

    value: float
    unit: str

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Limit) and precise(self.value, self.unit) == precise(other.value, other.unit)

    def __hash__(self) -> int:
        return hash(precise(self.value, self.unit))

    def said(self, say: Callable[[object], object]) -> str:
        """Say it."""
        return precise(self.value, chosen_unit(self.unit) or self.unit)


def as_limit(value: float, unit: str = "mm") -> Said:
    """Give a limit, a length unless said, to be said with the digits that it needs, in the unit chosen for it.

    Examples
    --------
    >>> from cranktrain.quantities import shown_by, units_by_dimension
    >>> least = as_limit(0.0889)
    >>> with shown_by(units_by_dimension(["in"])):
    ...     str(least)
    '3.5 in'
    """
    return _Limit(value, unit)


@dataclass(frozen=True, slots=True, repr=False)
class _Shared(Said):
    """Values by name, those together that are said alike."""

    names: Sequence[str]
    values: tuple[float, ...]
    unit: str

    def said(self, say: Callable[[object], object]) -> str:
        """Say them."""
        alike = places_of_equal(str(number(value, self.unit)) for value in self.values)
        if len(alike) == 1:
            return next(iter(alike))
        return ", ".join(f"{text} ({ranged(self.names, members)})" for text, members in alike.items())


def shared(names: Sequence[str], values: Array, unit: str) -> Said:
    """Give values to be said by name, equal ones together; one value alone if all agree.

    Parameters
    ----------
    names : sequence of str, length n
    values : Array, shape (n,)
        In SI.
    unit : str
        To show.

    Examples
    --------
    >>> str(shared(("1L", "2L", "1R"), np.array([0.18, 0.18, 0.1867]), "mm"))
    '180.00 mm (1L, 2L), 186.70 mm (1R)'
    """
    return _Shared(names, tuple(np.asarray(values, dtype=float).tolist()), unit)


def ranged(names: Sequence[str], members: Sequence[int]) -> str:
    """Name some of many: runs of neighbours as `1L–6L`, the rest one by one; a run ends with its bank, but of all."""
    is_all = len(members) == len(names)
    runs: list[list[int]] = []
    for member in members:
        if (
            runs
            and member == runs[-1][-1] + 1
            and (is_all or names[member].lstrip(digits) == names[member - 1].lstrip(digits))
        ):
            runs[-1].append(member)
        else:
            runs.append([member])
    return ", ".join(
        names[run[0]] if len(run) == 1 else f"{names[run[0]]}{'–' if len(run) > 2 else ', '}{names[run[-1]]}"
        for run in runs
    )


def in_words(names: Sequence[Words]) -> Words:
    """Give names as a list in words: `a, b and c`."""
    *first, last = names
    return _("{first} and {last}", first=Listed(first), last=last) if first else last


def all_of(names: Sequence[Words]) -> Words:
    """Give names of which each may be a list itself: `a and b and c`; nothing of none."""
    return _in_turn(N_("{first} and {last}"), names)


def once_each(needs: Sequence[Words]) -> list[Words]:
    """Leave out of what a file lacks the tables of which a key is named, too.

    Examples
    --------
    >>> once_each(["[evenness]", "[evenness] coefficient", "[masses]"])
    ['[evenness] coefficient', '[masses]']
    """
    said = list(map(str, needs))
    return [need for need, own in zip(needs, said, strict=True) if not any(one.startswith(f"{own} ") for one in said)]


def either_of(names: Sequence[Words]) -> Words:
    """Give names of which one is meant: `a or b or c`; nothing of none."""
    return _in_turn(N_("{first} or {last}"), names)


def _in_turn(message: str, names: Sequence[Words]) -> Words:
    """Put each name behind those before it."""
    said, *others = names or ("",)
    for other in others:
        said = _(message, first=said, last=other)
    return said


def first_that_holds(*cases: tuple[bool, Chosen]) -> Chosen:
    """Give the first of some sentences whose case it is."""
    return next(sentence for holds, sentence in cases if holds)


def power_of_ten(value: float) -> str:
    """Write a very small number by its power of ten.

    Examples
    --------
    >>> power_of_ten(3.24e-16), power_of_ten(0.0)
    ('3.2·10⁻¹⁶', '0')
    """
    if value == 0.0:
        return "0"
    mantissa, _e, exponent = f"{value:.1e}".partition("e")
    return f"{true_minus(mantissa)}·10{str(int(exponent)).translate(_RAISED)}"


def true_minus(text: str) -> str:
    """Write the minus of a number as it is printed."""
    return text.replace("-", "−")


def plain(value: float) -> str:
    """Write a round number as it is, and one that is not with four figures.

    Examples
    --------
    >>> plain(0.00005), plain(25.0), plain(0.196850394)
    ('0.00005', '25', '0.1969')
    """
    exact = Decimal(f"{value:.6g}")
    short = Decimal(f"{value:.{_FIGURES}g}")
    return true_minus(f"{(exact if len(exact.normalize().as_tuple().digits) < _FIGURES else short).normalize():f}")
