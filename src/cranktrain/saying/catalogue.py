"""What a result holds, as data beside each array: symbol, unit, dimensions, sentence, source, equation."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from functools import cache
from operator import attrgetter
from string import Formatter
from typing import Any, Literal, NamedTuple, TypeAlias

from cranktrain.language import N_
from cranktrain.language import said as _
from cranktrain.saying.names import said_name

Worst: TypeAlias = Literal["smallest", "largest"]
"""Which end of the values of several members is the worst, and says more than the other."""

DEFINITION = "definition"
"""The equation of what has none: an input as given, a count, a label, or what its sentence alone defines."""

_NUMBER = re.compile(r"\d+\.\d+")
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
    message : str
        What it is, as it is translated for people.
    source : str
        Where its formula is derived: a page of docs/theory, or the conventions.
    equation : str
        Numbers of that page's equations which give it, `13.35, 13.36` or `1.4 to 1.6`; of the end or the mean of a
        curve those of the curve; `definition` where no equation has a number.
    path : str
        Where in a stage's result its array is: `stroke`, or `rod_angle.first` where a field holds several.
    shown : str
        By what `scales` finds its unit for people: speeds of shafts are in rpm, natural frequencies in Hz.
    worst : "smallest" or "largest", or None
        Which end of its members' values is the worst; None where one says as little as the other.
    of : str
        Of a fact that is the end of a curve, the name of the curve; a curve's screens tell it by such facts.
    is_place : bool
        Whether it is a crank angle at which something is, of which a part in percent says nothing.
    line : str
        Where it is one line of other quantities, that line with their names, `{top_position} − {bottom_position}`; `Σ`
        is the sum over the members of what stands behind it.
    """

    name: str
    symbol: str
    unit: str
    dimensions: tuple[str, ...]
    message: str
    source: str
    equation: str
    path: str
    shown: str
    worst: Worst | None = None
    of: str = ""
    is_place: bool = False
    line: str = ""

    def __repr__(self) -> str:
        """Show name, symbol, unit and sentence."""
        return f"<{self.name} {self.symbol} [{self.unit}]: {self.sentence}>"

    @property
    def sentence(self) -> str:
        """What it is, in the reader's language."""
        return _(self.message)

    @property
    def words(self) -> str:
        """Its name in words; what has the symbol GD² is called so, as an inertia has kg·m², too."""
        words = said_name(self.name)
        return f"{words} GD²" if "GD²" in self.symbol else words

    @property
    def numbers(self) -> str:
        """Numbers of its equations as texts cite them, `(1.4) to (1.6)`; nothing where it has none."""
        return "" if self.equation == DEFINITION else _NUMBER.sub(r"(\g<0>)", self.equation)

    @property
    def citation(self) -> str:
        """Where its formula stands: `docs/theory/gas, eq. (14.8)`; the page alone where it has no number."""
        return cited(self.source, self.numbers)

    def in_symbols(self, catalogue: Mapping[str, "Entry"]) -> str:
        """Write its line with the symbols of its quantities, `S = H − h`; nothing where one of these is missing."""
        symbols = {name: catalogue[name].symbol for name in self.line_of if name in catalogue}
        is_whole = symbols and len(symbols) == len(set(self.line_of))
        return f"{self.symbol} = {self.line.format_map(symbols)}" if is_whole else ""

    @property
    def line_of(self) -> tuple[str, ...]:
        """Names of the quantities in its line."""
        return tuple(name for _text, name, _form, _sign in Formatter().parse(self.line) if name)

    @property
    def at(self) -> str:
        """Of an extreme, the name of the quantity that says at which crank angle it is."""
        return _name(self.name, ".angle")

    @property
    def is_fact(self) -> bool:
        """Whether it stands for the whole cycle, not for each crank angle."""
        return "crank_angle" not in self.dimensions


def quantity(
    symbol: str,
    unit: str,
    dimensions: tuple[str, ...],
    sentence: str,
    source: str,
    equation: str,
    *,
    shown: str | None = None,
    worst: Worst | None = None,
    is_place: bool = False,
    line: str = "",
) -> Any:
    """Declare a field of a result class as a quantity of the catalogue; the arguments are those of `Entry`.

    It is shown in its own unit unless another is given.
    """
    return _declared(
        dimensions,
        source,
        equation,
        _Part("", symbol, unit, sentence, shown or unit, worst, is_place=is_place, line=line),
    )


def extreme(
    symbol: str,
    unit: str,
    dimensions: tuple[str, ...],
    value: str,
    angle: str,
    source: str,
    equation: str,
    *,
    shown: str | None = None,
    worst: Worst | None = None,
    of: str = "",
) -> Any:
    """Declare a field that holds an `Extreme` or a `Peak` as two quantities: of `x`, how much it is, and `x_at`, where.

    `value` and `angle` are their sentences, each as it is read, so that it can be translated; `of` is the curve whose
    end it is.
    """
    return _declared(
        dimensions,
        source,
        equation,
        _Part(".value", symbol, unit, value, shown or unit, worst, of),
        _Part(".angle", f"φ({symbol})", "deg", angle, "deg", worst, is_place=True),
    )


def coefficients(
    symbol: str,
    unit: str,
    dimensions: tuple[str, ...],
    value: str,
    first: str,
    second: str,
    source: str,
    equation: str,
) -> Any:
    """Declare a field that holds a `Coefficient` as three quantities: a coordinate and its derivatives.

    Of `rod_angle` these are `rod_velocity_coefficient` and `rod_acceleration_coefficient`; of a displacement or a
    position likewise; of `point_x` they are `point_x_velocity_coefficient` and so on. `value`, `first` and `second` are
    their sentences, `equation` is that of all three.
    """
    by_angle, by_its_square = f"{unit}/rad", f"{unit}/rad^2"
    return _declared(
        dimensions,
        source,
        equation,
        _Part(".value", symbol, unit, value, unit),
        _Part(".first", f"{symbol}′", by_angle, first, by_angle),
        _Part(".second", f"{symbol}″", by_its_square, second, by_its_square),
    )


class _Part(NamedTuple):
    """A quantity that a field holds: its path in the field's value; the others are those of `Entry`."""

    path: str
    symbol: str
    unit: str
    sentence: str
    shown: str
    worst: Worst | None = None
    of: str = ""
    is_place: bool = False
    line: str = ""


def _declared(dimensions: tuple[str, ...], source: str, equation: str, *parts: _Part) -> Any:
    """Field with the quantities that it holds."""
    return field(metadata={"entries": [(part, dimensions, source, equation) for part in parts]})


@cache
def entries(result_class: type) -> tuple[Entry, ...]:
    """Give the catalogue entries of a result class, in the order of its fields."""
    return tuple(
        Entry(
            _name(held.name, part.path),
            part.symbol,
            part.unit,
            dimensions,
            part.sentence,
            source,
            equation,
            held.name + part.path,
            part.shown,
            part.worst,
            part.of,
            part.is_place,
            part.line,
        )
        for held in fields(result_class)
        for part, dimensions, source, equation in held.metadata.get("entries", ())
    )


def cited(page: str, numbers: str) -> str:
    """Cite a page with the numbers of its equations, if any: `docs/theory/groups, eqs. (1.4) to (1.6)`."""
    if not numbers:
        return page
    words = N_("{page}, eq. {numbers}") if numbers.count("(") == 1 else N_("{page}, eqs. {numbers}")
    return _(words, page=page, numbers=numbers)


def _name(held: str, part: str) -> str:
    """Name of a quantity, by the name of the field that holds it."""
    if part in _DERIVATIVES:
        named, n_words = _COORDINATE.subn(_DERIVATIVES[part], held)
        return named if n_words else f"{held}_{_DERIVATIVES[part]}"
    return f"{held}_at" if part == ".angle" else held


def values(outcome: object, entry: Entry) -> Any:
    """Array of a quantity in a stage's result, in SI and radians, with the design axis."""
    return attrgetter(entry.path)(outcome)
