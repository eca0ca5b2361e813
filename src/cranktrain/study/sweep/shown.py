"""Facts of a sweep as they are shown: in columns, as many as a screen has room for, and what had no room."""

import itertools
from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

import numpy as np

from cranktrain.language import Words, _
from cranktrain.motion import Array
from cranktrain.numerics.ties import ALIKE
from cranktrain.one_line import short
from cranktrain.saying.amounts import Amount
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.names import said_name
from cranktrain.saying.sections import Column, Grid, Part
from cranktrain.study.facts_of_rows import FactsOfRows
from cranktrain.study.sweep.varied import SweptDesigns, Varied

_MOST_LINES = 24
"""Of a table on the screen."""
_MOST_OTHERS = 5
"""Values of whatever else is varied, of which each fact has a column."""
_FEW_FACTS = 4
"""Are shown with all their columns."""
_MOST_COLUMNS = 24
"""Of all tables together, of more facts."""
_LONGEST_VALUE = 30
"""Characters of a value of a list, which may be a table."""


class FactsAlong(NamedTuple):
    """What of a sweep is shown.

    Attributes
    ----------
    designs : SweptDesigns
    found : FactsOfRows
    catalogue : mapping of str to Entry
        Facts that are shown, by name.
    along : tuple of Varied
        What is varied, a dimension each.
    over : int or None
        Which of these is the axis.
    apart : callable
        From a fact to its values by its members.
    """

    designs: SweptDesigns
    found: FactsOfRows
    catalogue: Mapping[str, Entry]
    along: tuple[Varied, ...]
    over: int | None
    apart: Callable[[str], list[tuple[str, Array]]]


def shown_facts(sweep: FactsAlong) -> Iterator[Part]:
    """Give the facts in columns, those that are alike in all designs in a sentence, and say what had no room."""
    own = 0 if sweep.over is None else sweep.over
    beside = [one for place, one in enumerate(sweep.along) if place != own]
    lines = evenly(len(sweep.along[own].values), _MOST_LINES)
    others = evenly(len(_combinations(beside)), _MOST_OTHERS)
    alike = {name: value for name in sweep.catalogue if (value := _value_of_all(sweep, name)) is not None}
    if len(alike) == len(sweep.catalogue):
        alike = {}
    found = {name: list(_columns(sweep, name, lines, others)) for name in sweep.catalogue if name not in alike}
    without_room = _without_room({name: len(columns) for name, columns in found.items()})
    columns = list(_given(sweep, lines))
    columns += itertools.chain.from_iterable(own for name, own in found.items() if name not in without_room)
    heads = [str(line + 1) if sweep.designs.is_listed else sweep.along[own].texts[line] for line in lines]
    yield Grid(columns, heads, title=said_name(sweep.along[own].spoken), names_quantities=True)
    if alike:
        entries = sweep.found.entries
        said = (f"{said_name(name)} {Amount(value, entries[name].shown, name)}" for name, value in alike.items())
        yield _("alike in all designs: {facts}", facts=", ".join(said))
    if any(one.numbers is not None and not one.unit for one in beside):
        yield _("behind each symbol: {names}", names=", ".join(said_name(one.spoken) for one in beside))
    yield from _left_out(sweep.along[own], len(lines), beside, len(others))
    if without_room:
        names = ", ".join(without_room)
        yield _("no room here for {names}: ask for fewer facts, or write a file", names=names)


def _without_room(sizes: Mapping[str, int]) -> list[str]:
    """Names of facts with so many columns each that have no room: of many those with most columns."""
    if len(sizes) <= _FEW_FACTS:
        return []
    room, without = _MOST_COLUMNS, list[str]()
    for name in sorted(sizes, key=lambda name: sizes[name]):
        room -= sizes[name]
        if room < 0:
            without.append(name)
    return without


def _left_out(own: Varied, n_lines: int, beside: list[Varied], n_others: int) -> Iterator[Words]:
    """Say that some designs are not shown."""
    said = _("shown are {n} of {all} values of {name}; a file has all")
    if n_lines < len(own.values):
        yield said.format(n=n_lines, all=len(own.values), name=said_name(own.spoken))
    if n_others < (n_all := len(_combinations(beside))):
        name = " × ".join(said_name(one.spoken) for one in beside)
        yield said.format(n=n_others, all=n_all, name=name)


def _combinations(beside: list[Varied]) -> list[tuple[str, ...]]:
    """Values of whatever else is varied, as they are called at the head of a column."""
    return list(itertools.product(*(one.texts for one in beside)))


def _value_of_all(sweep: FactsAlong, name: str) -> float | None:
    """The value of a fact that all members of all designs have; None where they differ, or only one has any."""
    values = sweep.found.values[name]
    known = values[np.isfinite(values)]
    if len(sweep.designs) == 1 or not known.size or np.ptp(known) > ALIKE * np.max(np.abs(known)):
        return None
    return float(known[0])


def _given(sweep: FactsAlong, lines: list[int]) -> Iterator[Column]:
    """Values of designs that are listed, as they were typed."""
    if sweep.designs.is_listed:
        for one in sweep.designs.varied:
            texts = one.texts
            yield Column(said_name(one.spoken), [short(texts[line], _LONGEST_VALUE) for line in lines])


def _columns(sweep: FactsAlong, name: str, lines: list[int], others: list[int]) -> Iterator[Column]:
    """One fact over the lines: a column for each combination of the rest."""
    entry, over = sweep.found.entries[name], sweep.over or 0
    heads = _combinations([one for place, one in enumerate(sweep.along) if place != over])
    members: list[tuple[str, Array]] = sweep.apart(name)
    for place in others:
        for whose, values in members:
            own = np.moveaxis(values, over, 0)[lines].reshape(len(lines), -1)[:, place]
            symbol = entry.symbol or said_name(name)
            head = " ".join(filter(None, (symbol, whose, *heads[place])))
            yield Column(head, own.tolist(), entry.shown, "amounts", name, symbol)


def evenly(n: int, most: int) -> list[int]:
    """Places among n, no more than `most` of them, in even steps from the first; and the last.

    Examples
    --------
    >>> evenly(4, 9), evenly(11, 3), evenly(12, 4)
    ([0, 1, 2, 3], [0, 5, 10], [0, 4, 8, 11])
    """
    step = max(1, -(-(n - 1) // (most - 1)))
    return sorted({*range(0, n, step), n - 1})
