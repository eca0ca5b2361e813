"""What a result holds, as data beside each array: symbol, unit, dimensions, sentence, source."""

import re
from dataclasses import dataclass, field, fields
from functools import cache
from operator import attrgetter
from typing import Any

from cranktrain.language import _

_COORDINATE = re.compile("displacement|angle|position")
"""The word in a coordinate's name for which the names of its derivatives have another."""
_DERIVATIVES = {".first": "velocity_coefficient", ".second": "acceleration_coefficient"}


@dataclass(frozen=True)
class Entry:
    """One quantity of the catalogue.

    Attributes
    ----------
    name, symbol : str
        Name in Python, files and the terminal; symbol as printed.
    unit : str
        Unit in files. Arrays are SI and radians inside; a crank angle is written in `deg`.
    dimensions : tuple of str
        Of the array, after the leading design axis.
    sentence : str
        What it is, in the user's language.
    source : str
        Where its formula is derived: a page of docs/theory or an equation of a source.
    path : str
        Where in a stage's result its array is: `stroke`, or `rod_angle.first` where a field holds several.
    """

    name: str
    symbol: str
    unit: str
    dimensions: tuple[str, ...]
    sentence: str
    source: str
    path: str

    def __repr__(self) -> str:
        """Show name, symbol, unit and sentence."""
        return f"<{self.name} {self.symbol} [{self.unit}]: {self.sentence}>"

    @property
    def shown(self) -> str:
        """What `scales` finds its unit for people by: speeds of shafts are in rpm, natural frequencies in Hz."""
        if self.unit == "rad/s" and "speed" in self.name:
            return "rpm"
        return "Hz" if self.name.endswith("frequency") else self.unit

    @property
    def words(self) -> str:
        """Its name in words; a flywheel moment is called GD², as an inertia has kg·m², too."""
        words = self.name.replace("_", " ")
        return words.replace("flywheel moment", "flywheel moment GD²")

    @property
    def is_fact(self) -> bool:
        """Whether it stands for the whole cycle, not for each crank angle."""
        return "crank_angle" not in self.dimensions


def quantity(symbol: str, unit: str, dimensions: tuple[str, ...], sentence: str, source: str) -> Any:
    """Declare a field of a result class as a quantity of the catalogue; the arguments are those of `Entry`."""
    return _declared(dimensions, source, ("", symbol, unit, sentence))


def extreme(symbol: str, unit: str, dimensions: tuple[str, ...], value: str, angle: str, source: str) -> Any:
    """Declare a field that holds an `Extreme` or a `Peak` as two quantities: of `x`, how much it is, and `x_at`, where.

    `value` and `angle` are their sentences, each as it is read, so that it can be translated.
    """
    return _declared(dimensions, source, (".value", symbol, unit, value), (".angle", f"φ({symbol})", "deg", angle))


def coefficients(
    symbol: str, unit: str, dimensions: tuple[str, ...], value: str, first: str, second: str, source: str
) -> Any:
    """Declare a field that holds a `Coefficient` as three quantities: a coordinate and its derivatives.

    Of `rod_angle` these are `rod_velocity_coefficient` and `rod_acceleration_coefficient`; of a displacement or a
    position likewise; of `point_x` they are `point_x_velocity_coefficient` and so on. `value`, `first` and `second` are
    their sentences.
    """
    return _declared(
        dimensions,
        source,
        (".value", symbol, unit, value),
        (".first", f"{symbol}′", f"{unit}/rad", first),
        (".second", f"{symbol}″", f"{unit}/rad^2", second),
    )


def _declared(dimensions: tuple[str, ...], source: str, *parts: tuple[str, str, str, str]) -> Any:
    """Field with the quantities that it holds: of each its path in the field's value, symbol, unit and sentence."""
    return field(metadata={"entries": [(*part, dimensions, source) for part in parts]})


@cache
def entries(result_class: type) -> tuple[Entry, ...]:
    """Give the catalogue entries of a result class, in the order of its fields."""
    return tuple(
        Entry(_name(held.name, part), symbol, unit, dimensions, _(sentence), source, held.name + part)
        for held in fields(result_class)
        for part, symbol, unit, sentence, dimensions, source in held.metadata.get("entries", ())
    )


def _name(held: str, part: str) -> str:
    """Name of a quantity, by the name of the field that holds it."""
    if part in _DERIVATIVES:
        named, n_words = _COORDINATE.subn(_DERIVATIVES[part], held)
        return named if n_words else f"{held}_{_DERIVATIVES[part]}"
    return f"{held}_at" if part == ".angle" else held


def values(outcome: object, entry: Entry) -> Any:
    """Array of a quantity in a stage's result, in SI and radians, with the design axis."""
    return attrgetter(entry.path)(outcome)
