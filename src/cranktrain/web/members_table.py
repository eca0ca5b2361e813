"""Pins and links of what is drawn as tables whose numbers a page writes at its crank angle."""

from collections.abc import Iterable, Iterator, Sequence
from typing import TypeAlias

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import Listed, Words, _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.motion import Array
from cranktrain.panels.formulas import formula
from cranktrain.panels.members import MovingLink, MovingPin, has_speed, members
from cranktrain.panels.shapes import peak
from cranktrain.plans.vectors import spoken_name
from cranktrain.record import record
from cranktrain.saying.names import said_name
from cranktrain.saying.scales import scale_for
from cranktrain.saying.wording import decimals_for

_FIGURES = 4
"""Of the largest number of a column, all of which have as many decimals, so that they do not jump."""
_DEGREES = 2
"""Decimals of directions, as in all answers."""
_PLACES, _DIRECTIONS = 2, 1
"""Columns that need no speed."""

_Found: TypeAlias = "tuple[CursorColumn, Array]"
"""A column, and the parts of its values by row."""


@record
class CursorColumn:
    """A column of numbers at the crank angle of a page.

    Attributes
    ----------
    head : Words
        With its unit.
    step : float
        One of the last decimal.
    n_parts : int
        Of how many parts across each other the numbers are the size; of one they are that themselves.
    around : float or None
        After which it begins again; None of what does not.
    """

    head: Words
    step: float
    n_parts: int = 1
    around: float | None = None


@record
class CursorTable:
    """A table of numbers at the crank angle of a page.

    Attributes
    ----------
    head : Words
        What the rows are.
    names : tuple of Words
        Of the rows.
    columns : tuple of CursorColumn
    values : Array, shape (row, part, n)
        Of one column's parts after the other's, at crank angles that stand evenly from 0 to the end of the cycle, both
        included; NaN where the links cannot close.
    """

    head: Words
    names: tuple[Words, ...]
    columns: tuple[CursorColumn, ...]
    values: Array


@record
class PageMembers:
    """Pins and links of what is drawn, and how they are counted."""

    tables: tuple[CursorTable, ...]
    note: Words


def page_members(result: Result, places: Sequence[PlacedMechanism], angles: Array) -> PageMembers:
    """Collect where pins are, and how fast they go if that is known, and how links stand and turn.

    Parameters
    ----------
    result : Result
        Of one machine.
    places : sequence of PlacedMechanism
        What is drawn.
    angles : Array, shape (n,)
        Crank angles as the machine shows them, evenly over the cycle. [deg]
    """
    found = members(result, places, angles)
    if not found.pins:
        return PageMembers((), "")
    n_of_pins, n_of_links = (None, None) if has_speed(result) else (_PLACES, _DIRECTIONS)
    has_several = len({one.mechanism for one in (*found.pins, *found.links)}) > 1
    pins = (_named(one, Listed(tuple(map(_pin, one.names))), has_several) for one in found.pins)
    links = (_named(one, _link(one), has_several) for one in found.links)
    tables = (
        _table(_("pin"), pins, list(_of_pins(found.pins))[:n_of_pins]),
        _table(_("link"), links, list(_of_links(found.links))[:n_of_links]),
    )
    note = _(
        "{x} to the right and {y} up from the centre of the main shaft, as seen from the free end; directions count"
        " from {x} anticlockwise, and so do {speed} and {acceleration} of links.",
        x=formula("X"),
        y=formula("Y"),
        speed=formula(r"\omega"),
        acceleration=formula(r"\varepsilon"),
    )
    return PageMembers(tables, note)


def _named(one: MovingPin | MovingLink, words: Words, has_several: bool) -> Words:
    """Name a pin or a link, with its mechanism where there are several."""
    return Listed((one.mechanism, words), " ") if has_several else words


def _pin(name: str) -> Words:
    """Name a pin."""
    return said_name(spoken_name(name))


def _link(one: MovingLink) -> Words:
    """Name a link, and the pins from which to which it is looked at."""
    return Listed((said_name(one.name), Listed(tuple(map(_pin, one.pins)), "–")), " ")


def _of_pins(pins: Sequence[MovingPin]) -> Iterator[_Found]:
    """Give columns: where pins are, how fast they go, how much that changes."""
    places = np.stack([one.place for one in pins])
    for axis, symbol in enumerate("XY"):
        yield _column(symbol, "m", places[:, [axis]], peak(places))
    for symbol, unit, vectors in (
        ("v", "m/s", np.stack([one.velocity for one in pins])),
        ("a", "m/s^2", np.stack([one.acceleration for one in pins])),
    ):
        yield _column(symbol, unit, vectors, peak(np.hypot(vectors[:, 0], vectors[:, 1])))


def _of_links(links: Sequence[MovingLink]) -> Iterator[_Found]:
    """Give columns: how links stand, how fast they turn, how much that changes."""
    turn = 2 * np.pi
    scale = scale_for("rad", turn)
    decimals = _DEGREES if scale.label == "°" else decimals_for(scale.of(turn), _FIGURES)
    column = CursorColumn(Listed((_("direction"), scale.label)), 10.0**-decimals, around=scale.of(turn))
    yield column, scale.of(np.stack([[one.direction] for one in links]))
    for symbol, unit, values in (
        (r"\omega", "rad/s", np.stack([[one.speed] for one in links])),
        (r"\varepsilon", "rad/s^2", np.stack([[one.acceleration] for one in links])),
    ):
        yield _column(symbol, unit, values, peak(values))


def _column(symbol: str, unit: str, values: Array, largest: float) -> _Found:
    """Give a column with as many decimals as the largest number has."""
    scale = scale_for(unit, largest)
    decimals = max(0, decimals_for(scale.of(largest), _FIGURES))
    head = Listed((formula(symbol), scale.label))
    return CursorColumn(head, 10.0**-decimals, n_parts=values.shape[1]), scale.of(values)


def _table(head: Words, names: Iterable[Words], found: Sequence[_Found]) -> CursorTable:
    """Put columns side by side."""
    columns, values = zip(*found, strict=True)
    return CursorTable(head, tuple(names), columns, np.concatenate(values, axis=1))
