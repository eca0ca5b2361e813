"""The chain from motor to crank on paper, in the symbols of kinematic diagrams, its parts numbered as in its table."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.plans.drive_scheme import DriveElement, DriveShaft
from cranktrain.plans.vectors import pair
from cranktrain.viz.paper.page import Box, Page
from cranktrain.viz.paper.sketch import Label, Sketch, bounds_of
from cranktrain.viz.plans.drive_symbols import Seat, line, reach, shafts_apart, symbol_parts

_MOST_APART = 17.0
"""From one symbol to the next. [mm]"""
_NUMBER, _NUMERAL = 2.6, 2.2
"""From a symbol to the middle of its number, from a shaft to that of its own. [mm]"""
_ROMAN = ((10, "X"), (9, "IX"), (5, "V"), (4, "IV"), (1, "I"))


class DrawnPart(NamedTuple):
    """A part of the chain and its drawing: `symbol` is that of its element, or "shaft". [mm of paper]"""

    symbol: str
    number: int
    sketch: Sketch


def chain_drawing(chain: Sequence[DriveShaft], width: float, shaft_letter: str) -> list[DrawnPart]:
    """Draw shafts with their numerals and symbols with their numbers.

    Parameters
    ----------
    chain : sequence of DriveShaft
    width : float
        Room for it along the shafts. [mm]
    shaft_letter : str
        Of the crank's shaft in the mechanism's own scheme.

    Returns
    -------
    list of DrawnPart
        Shafts first, numbered from 1, then symbols, numbered as in the table.
    """
    elements = [element for shaft in chain for element in shaft.elements]
    seats = list(_seats(elements, min(_MOST_APART, width / len(elements))))
    shafts = [
        DrawnPart("shaft", number, sketch) for number, sketch in enumerate(_shafts(chain, seats, shaft_letter), start=1)
    ]
    return shafts + [
        DrawnPart(one.symbol, number, _numbered(one, seat, number))
        for number, (one, seat) in enumerate(zip(elements, seats, strict=True), start=1)
    ]


def bounds_of_chain(parts: Sequence[DrawnPart]) -> tuple[Array, Array]:
    """Lower left and upper right corner of a chain with its words. [mm]"""
    words = [label.position[:, np.newaxis] + _LETTERS for part in parts for label in part.sketch.labels]
    return bounds_of([*(points for part in parts for points in part.sketch.outline()), *words])


def draw_chain(page: Page, parts: Sequence[DrawnPart], box: Box) -> None:
    """Draw a chain in the middle of a room; in an SVG every symbol has a name, such as drive-belt-2."""
    low, high = bounds_of_chain(parts)
    origin = pair(box.middle - 0.5 * (low + high))
    for part in parts:
        artists = page.draw(part.sketch, origin)
        artists[0].set_gid(f"drive-{part.symbol}-{part.number}")


def roman(number: int) -> str:
    """Write a number of shafts as such.

    Examples
    --------
    >>> roman(4), roman(13)
    ('IV', 'XIII')
    """
    written = ""
    for value, sign in _ROMAN:
        while number >= value:
            written, number = written + sign, number - value
    return written


def _seats(elements: Sequence[DriveElement], apart: float) -> Iterator[Seat]:
    """Where symbols stand: shafts step toward the middle, so that the chain stays low."""
    level = 0.5 * shafts_apart("gear")
    for place, one in enumerate(elements):
        beyond = level - np.copysign(shafts_apart(one.symbol), level)
        yield Seat((place + 0.5) * apart, level, float(beyond), one.ratio)
        level = float(beyond)


def _shafts(chain: Sequence[DriveShaft], seats: Sequence[Seat], letter: str) -> Iterator[Sketch]:
    """Each shaft's line from the stage before it to that behind it, with its numeral; the last with its letter."""
    apart = 2 * seats[0].x
    first = 0
    for number, shaft in enumerate(chain, start=1):
        last = first + len(shaft.elements) - 1
        level = seats[last].level
        is_driven = number > 1 or shaft.elements[0].symbol == "motor"
        begin = seats[first].x - (apart if number > 1 else 0.0 if is_driven else 0.35 * apart)
        beyond = 0.35 * apart if shafts_apart(shaft.elements[-1].symbol) else 0.0
        sketch = Sketch(1.0)
        sketch.add([line([(begin, level), (seats[last].x + beyond, level)])])
        between = seats[first].x + (-0.5 if number > 1 else 0.5 if last > first else -0.3) * apart
        if len(chain) > 1 or last > first:
            sketch.add([Label(np.array([between, level + _NUMERAL]), roman(number))])
        if number == len(chain) and letter:
            sketch.add([Label(np.array([seats[last].x + 4.0, level]), letter, "symbol")])
        yield sketch
        first = last + 1


def _numbered(one: DriveElement, seat: Seat, number: int) -> Sketch:
    """A symbol with its number, on the side away from the next shaft."""
    away = float(np.sign(seat.level - seat.beyond)) or 1.0
    sketch = Sketch(1.0)
    sketch.add(symbol_parts(one.symbol, seat))
    height = seat.level + away * (reach(one.symbol, seat) + _NUMBER)
    sketch.add([Label(np.array([seat.x, height]), str(number))])
    return sketch


_LETTERS = np.array([[-2.0, 2.0], [-1.5, 1.5]])
"""What a number fills about its middle. [mm]"""
