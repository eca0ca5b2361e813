"""What a result holds, as data beside each array: symbol, unit, dimensions, sentence, source."""

from dataclasses import dataclass, field, fields
from typing import Any

from cranktrain.language import translated


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
    """

    name: str
    symbol: str
    unit: str
    dimensions: tuple[str, ...]
    sentence: str
    source: str

    @property
    def is_fact(self) -> bool:
        """Whether it stands for the whole cycle, not for each crank angle."""
        return "crank_angle" not in self.dimensions


def quantity(symbol: str, unit: str, dimensions: tuple[str, ...], sentence: str, source: str) -> Any:
    """Declare a field of a result class as a quantity of the catalogue; the arguments are those of `Entry`."""
    return field(metadata={"entry": (symbol, unit, dimensions, sentence, source)})


def entries(result_class: type) -> tuple[Entry, ...]:
    """Give the catalogue entries of a result class, in the order of its fields."""
    return tuple(
        Entry(part.name, symbol, unit, dimensions, translated(sentence), source)
        for part in fields(result_class)
        if "entry" in part.metadata
        for symbol, unit, dimensions, sentence, source in [part.metadata["entry"]]
    )
