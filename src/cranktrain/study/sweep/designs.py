"""Designs of a sweep as columns of one machine, each judged as it would be alone; what cannot be is found out.

`designs_in_columns` gives what `in_columns([machine.with_(row) for row in rows])` gives of the rows that can be, number
for number, without a machine for each:

1. designs are put together that are alike in all but numbers (`_Block`);
2. where these numbers stand in the tables is found by some machines that differ in one of them (`places`);
3. each value is read once, by the reader of its field (`numbers`);
4. the rules are asked of all designs at once (`rules`), by numbers that are followed through them (`followed`);
5. some designs of each group are asked by themselves, too; where anything is otherwise there, or the rules cannot be
   followed, each is (`alike`).
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.columns import in_columns
from cranktrain.errors import InputError
from cranktrain.grouping import grouped
from cranktrain.machine import Machine
from cranktrain.record import record
from cranktrain.study.sweep.alike import AlikeDesigns, EachAlone, Rows
from cranktrain.study.sweep.places import are_numbers, designs_tried, place_of, words_of
from cranktrain.study.sweep.refused import RefusedDesigns, checked
from cranktrain.study.sweep.varied import SweptDesigns, Varied

_FEW = 24
"""Designs that are alike in all but numbers, of which fewer are asked one by one."""
_TRIED = 4
"""Designs of which one is to be right by its tables, so that it is found where numbers stand."""


@record
class DesignsInColumns:
    """Designs with which nothing is wrong, and which differ in numbers alone, but not in their cycle.

    Attributes
    ----------
    machine : Machine
        The first of them, in which every quantity has the numbers of all as its column, shape (design,), as
        `in_columns` of all gives it.
    places : array of int, shape (design,)
        Which designs of the block they are, from 0.
    each : sequence of Machine
        Each by itself, made when it is asked for.
    were_followed : bool
        Whether rules were asked of all at once; else they were of each.
    """

    machine: Machine
    places: Rows
    each: Sequence[Machine]
    were_followed: bool


class InColumns(NamedTuple):
    """Designs of a block, each in one group or refused.

    Attributes
    ----------
    groups : tuple of DesignsInColumns
        In the order of their first designs.
    refused : mapping of int to Problem
        The first of what is wrong with a design that cannot be, by its place in the block. It is found when it is asked
        for, in the time that `Machine.with_` takes; `unsaid` puts that off until somebody reads the problem.
    """

    groups: tuple[DesignsInColumns, ...]
    refused: RefusedDesigns


def designs_in_columns(machine: Machine, designs: SweptDesigns, first: int, last: int) -> InColumns:
    """Give some designs of a sweep as columns.

    Parameters
    ----------
    machine : Machine
        Of which they are variants.
    designs : SweptDesigns
    first, last : int
        Which of them: a block from `first` up to, but not with, `last`. A group takes some 20 ms however many designs
        it has and then a microsecond for each, and each column 8 bytes: blocks of 10⁴ to 10⁵ are well.

    Returns
    -------
    InColumns
    """
    block = _Block(machine, designs, first, last)
    for rows in block.alike(np.arange(last - first), frozenset()):
        block.take(rows, frozenset())
    return InColumns(tuple(sorted(block.groups, key=lambda group: int(group.places[0]))), block.refused)


class _Block:
    """Designs of a block on their way into groups."""

    def __init__(self, machine: Machine, designs: SweptDesigns, first: int, last: int) -> None:
        self.machine = machine
        self.axes = designs.block(first, last)
        self.groups: list[DesignsInColumns] = []
        self.refused = RefusedDesigns(machine, designs, first)

    def row(self, place: int) -> dict[str, object]:
        """Values of a design, by path."""
        found = ((one.path, one.values[index[place]]) for one, index in self.axes)
        return {path: value for path, value in found if value is not None}

    def alike(self, rows: Rows, worded: frozenset[str]) -> Iterator[Rows]:
        """Put designs together that are alike in all but numbers of one unit; and alike at the paths that are named."""
        key = np.zeros(rows.size, dtype=np.int64)
        for one, index in self.axes:
            kinds = np.arange(len(one.values)) if one.path in worded else one.kinds
            if np.any(kinds != kinds[0]):
                key = np.unique(key, return_inverse=True)[1] * len(kinds) + kinds[index[rows]]
        order = np.argsort(key, kind="stable")
        yield from (rows[own] for own in np.split(order, np.flatnonzero(np.diff(key[order])) + 1))

    def take(self, rows: Rows, worded: frozenset[str]) -> None:
        """Judge designs that are alike in all but numbers; values at the paths that are named are words, and alike."""
        differing = [
            (one, index)
            for one, index in self.axes
            if one.path not in worded and one.are_numbers[index[rows[0]]] and np.any(index[rows] != index[rows[0]])
        ]
        start = self._start(rows, differing) if rows.size >= _FEW and differing else None
        if start is None:
            self._ask_each(rows)
            return
        tried = [designs_tried(start, one, np.unique(index[rows])) for one, index in differing]
        words = {one.path for (one, _), own in zip(differing, tried, strict=True) if not are_numbers(start, own)}
        if words:
            for own in self.alike(rows, worded | words):
                self.take(own, worded | words)
            return
        places = [place_of(start, one, own) for (one, _), own in zip(differing, tried, strict=True)]
        known = {place: index for place, (_, index) in zip(places, differing, strict=True) if place is not None}
        if len(known) == len(places):
            self._judge(AlikeDesigns(self.machine, start, self.row, known), rows)
        else:
            self._ask_each(rows)

    def _start(self, rows: Rows, differing: Sequence[tuple[Varied, Rows]]) -> Machine | None:
        """Give one of the designs, or one with the file's own numbers, whose tables are right each by itself."""
        tried = [self.row(place) for place in rows[np.linspace(0, rows.size - 1, _TRIED).astype(np.intp)].tolist()]
        numbers = {one.path for one, _index in differing}
        tried.append({path: value for path, value in tried[0].items() if path not in numbers})
        for row in tried:
            try:
                return self.machine.with_(row) if row else self.machine
            except InputError:
                continue
        return None

    def _judge(self, designs: AlikeDesigns, rows: Rows) -> None:
        """Judge designs together, if that can be done for sure."""
        found = designs.judged(rows)
        if found is None:
            self._ask_each(rows)
            return
        self.refused.add(found.wrong.tolist())
        for right in found.right:
            together, each = designs.together(right), EachAlone(designs, right)
            self.groups.append(DesignsInColumns(together, right, each, were_followed=True))
        self._ask_each(found.unknown)

    def _ask_each(self, rows: Rows) -> None:
        """Judge designs one by one."""
        found: list[tuple[object, tuple[int, Machine]]] = []
        for place in rows.tolist():
            try:
                design = checked(self.machine, self.row(place))
            except InputError as error:
                self.refused.say(place, error.problems[0])
            else:
                found.append(((design.cycle, *words_of(design)), (place, design)))
        for own in grouped(found).values():
            places, each = zip(*own, strict=True)
            self.groups.append(DesignsInColumns(in_columns(each), np.array(places), each, were_followed=False))
