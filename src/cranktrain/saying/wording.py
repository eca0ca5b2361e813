"""Numbers and names put into sentences."""

import re
from collections.abc import Mapping, Sequence
from math import floor, log10
from string import digits

import numpy as np

from cranktrain.grouping import places_of_equal
from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.quantities import Given, chosen_unit, of_result, shown

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
_SLOW_TOO = {"m/s", "m/s^2", "N*m", "N", "kN", "kW", "J", "kg*m^2", "Hz", "m³/h", "s"}
"""Units in which a slow or small machine's numbers need more decimals: three figures at least."""
_PLAIN = {"1": 1.0, "%": 100.0, "m/s^2": 1.0, "J": 1.0, "m³/h": 3600.0}
"""Units that are no input's, and how many of them one in SI is."""


def number(value: float, unit: str) -> str:
    """Write an SI value in a unit, as `figure` does, with its unit, or with the one that a reader chose."""
    if unit == "1" or not np.isfinite(value):
        return figure(value, unit)
    return f"{figure(value, unit)} {chosen_unit(unit) or unit}"


def as_given(given: Given, usual: str) -> str:
    """Write a given number as it was typed; in the unit that was chosen for what usually has one, where there is one.

    Examples
    --------
    >>> as_given(Given(157.07963267948966, "1500 rpm"), "rpm")
    '1500 rpm'
    """
    chosen = chosen_unit(usual)
    if chosen is None or given.text.endswith(chosen):
        return given.text.replace("-", "−")
    return number(given.si, chosen)


def figure(value: float, unit: str) -> str:
    """Write an SI value in a unit, not written here, with decimals that suit it; one that is not finite is absent."""
    if not np.isfinite(value):
        return ABSENT
    if (chosen := chosen_unit(unit)) is not None:
        size = of_result(value, chosen, unit)
        return signless(f"{size:.{max(decimals_for(abs(size), 4), 0)}f}")
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


_PRINTED = (
    (r"(?<![\w.)-])-(?=\d)", "−"),
    (r"\b(k?N|kg)\*m\b", r"\1·m"),
    (r"\b(m?m/s|kg·m|m?m/rad)\^2(?!\d)", r"\1²"),
)


def signless(text: str) -> str:
    """Take the sign from what is shown as 0."""
    return text.lstrip("-") if float(text) == 0.0 else text


def around_turn(angles: Array) -> Array:
    """Round crank angles to the digits that `number` shows, so that none is said to be at 360.00 deg. [rad]"""
    return np.radians(np.mod(np.round(shown(angles, "deg"), _DECIMALS["deg"]), 360.0))


def precise(limit: float, unit: str = "mm") -> str:
    """Write a length or angle that is a limit with the digits that a limit needs."""
    return f"{shown(limit, unit):.7g} {unit}"


def shared(names: Sequence[str], values: Array, unit: str) -> str:
    """Say values by name, equal ones together: `180.00 mm (1L–6L), 186.70 mm (1R–6R)`; one value alone if all agree.

    Parameters
    ----------
    names : sequence of str, length n
    values : Array, shape (n,)
        In SI.
    unit : str
        To show.
    """
    written = places_of_equal(number(float(value), unit) for value in np.asarray(values))
    if len(written) == 1:
        return next(iter(written))
    return ", ".join(f"{text} ({ranged(names, members)})" for text, members in written.items())


def shared_known(names: Sequence[str], values: Array, unit: str) -> str:
    """Say values by name, as `shared` does, of those alone that have one: NaN stands for none."""
    known = np.flatnonzero(~np.isnan(values)).tolist()
    return shared([names[i] for i in known], values[known], unit)


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


def in_words(names: Sequence[str]) -> str:
    """Give names as a list in words: `a, b and c`."""
    *first, last = names
    return _("{first} and {last}", first=", ".join(first), last=last) if first else last
