"""Designs of a sweep as columns of one machine, each judged as it would be alone; what cannot be is found out.

`designs_in_columns` gives what `in_columns([machine.with_(row) for row in rows])` gives of the rows that can be, number
for number, without a machine for each. Values are read once each; where they stand in the tables is found by machines
that differ in one of them; the rules are asked of all at once (`rules`). Where that cannot be done for sure, and for some
designs of each group always, the machine itself is asked.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple, cast, overload

import numpy as np
from numpy.typing import NDArray

from cranktrain.columns import as_columns, in_columns, numbers_of, with_numbers
from cranktrain.errors import InputError, Problem
from cranktrain.grouping import grouped
from cranktrain.machine import Machine, machine_problems
from cranktrain.motion import Array
from cranktrain.paths import PathParts, with_values
from cranktrain.quantities import Given
from cranktrain.record import record
from cranktrain.spec import with_tuples
from cranktrain.study.sweep.numbers import bits
from cranktrain.study.sweep.places import Place, are_numbers, designs_tried, place_of, words_of
from cranktrain.study.sweep.rules import judged_together
from cranktrain.study.sweep.varied import SweptDesigns

Rows = NDArray[np.intp]

_FEW = 24
"""Designs that are alike in all but numbers, of which fewer are asked one by one."""
_TRIED = 4
"""Designs of which one is to be right by its tables, so that it is found where numbers stand."""
_ASKED = 4
"""Designs of each group that are asked one by one, too."""


@record
class DesignsInColumns:
    """Designs that differ in numbers alone.

    Attributes
    ----------
    machine : Machine
        The first of them, whose quantities have the numbers of all as their columns: `in_columns` of all.
    places : array of int, shape (design,)
        Which designs of the block they are, from 0.
    each : sequence of Machine
        Each by itself, made when it is asked for; nothing is wrong with it.
    were_followed : bool
        Whether rules were asked of all at once, and not of each.
    """

    machine: Machine
    places: Rows
    each: Sequence[Machine]
    were_followed: bool


class InColumns(NamedTuple):
    """Designs of a block: those that can be, in groups that differ in numbers alone, and what is wrong with others."""

    groups: tuple[DesignsInColumns, ...]
    refused: "RefusedDesigns"


class RefusedDesigns(Mapping[int, Problem]):
    """What is wrong with designs that cannot be, the first of it, by their places; said when it is asked for."""

    def __init__(self, machine: Machine, designs: SweptDesigns, first: int) -> None:
        self._machine, self._designs, self._first = machine, designs, first
        self._said: dict[int, Problem | None] = {}

    def add(self, places: Sequence[int]) -> None:
        """Take places of designs that are refused."""
        self._said |= dict.fromkeys(places)

    def say(self, place: int, problem: Problem) -> None:
        """Take one of which it is known why."""
        self._said[place] = problem

    def unsaid(self, place: int) -> Problem:
        """Give the problem of a design without saying it yet, which takes as long as the design alone."""
        known = self._said[place]
        return UnsaidProblem(self._machine, self._designs.row(self._first + place)) if known is None else known

    def __getitem__(self, place: int) -> Problem:
        problem = self._said[place] = said(self.unsaid(place))
        return problem

    def __contains__(self, place: object) -> bool:
        return place in self._said

    def __iter__(self) -> Iterator[int]:
        return iter(sorted(self._said))

    def __len__(self) -> int:
        return len(self._said)


class UnsaidProblem(Problem):
    """What is wrong with a design that is known to be refused, found when somebody reads it."""

    def __init__(self, machine: Machine, row: Mapping[str, object]) -> None:
        vars(self)["of"] = machine, row

    def __getattribute__(self, name: str) -> Any:
        """Be the problem itself for whoever reads a field of it."""
        if name in Problem.__dataclass_fields__ or name == "__class__":
            return getattr(said(self), name)
        return super().__getattribute__(name)

    def __reduce__(self) -> tuple[object, ...]:
        """Go to other processes unsaid."""
        return UnsaidProblem, vars(self)["of"]


def said(problem: Problem) -> Problem:
    """Give a problem as one that was found."""
    if not issubclass(type(problem), UnsaidProblem):
        return problem
    own = vars(problem)
    if "said" not in own:
        own["said"] = problem_of(*own["of"])
    return cast("Problem", own["said"])


def checked(machine: Machine, row: Mapping[str, object]) -> Machine:
    """Give a design with which nothing is wrong.

    Raises
    ------
    InputError
        With everything that is wrong with it.
    """
    design = machine.with_(row) if row else machine
    if problems := machine_problems(design):
        raise InputError(problems)
    return design


def problem_of(machine: Machine, row: Mapping[str, object]) -> Problem | None:
    """The first of what is wrong with a design; None where nothing is."""
    try:
        checked(machine, row)
    except InputError as error:
        return error.problems[0]
    return None


def designs_in_columns(machine: Machine, designs: SweptDesigns, first: int, last: int) -> InColumns:
    """Give some designs of a sweep as columns.

    Parameters
    ----------
    machine : Machine
        Of which they are variants.
    designs : SweptDesigns
    first, last : int
        Which of them: from `first`, and up to but not with `last`. A group costs some 50 ms however many designs it
        has, and some microseconds for each: blocks of 10⁴ to 10⁵ are quick.

    Returns
    -------
    InColumns
        Every design of the block stands in one group or is refused.
    """
    block = _Block(machine, designs, first, last)
    for rows in block.alike(np.arange(last - first), frozenset()):
        block.take(rows, frozenset())
    return InColumns(tuple(sorted(block.groups, key=lambda group: int(group.places[0]))), block.refused)


class _Block:
    """Designs of a block on their way into groups."""

    def __init__(self, machine: Machine, designs: SweptDesigns, first: int, last: int) -> None:
        self.machine, self.designs, self.first = machine, designs, first
        self.axes = designs.block(first, last)
        self.groups: list[DesignsInColumns] = []
        self.refused = RefusedDesigns(machine, designs, first)

    def row(self, place: int) -> dict[str, object]:
        """Values of a design, by path."""
        found = ((one.path, one.values[index[place]]) for one, index in self.axes)
        return {path: value for path, value in found if value is not None}

    def alike(self, rows: Rows, worded: frozenset[str]) -> Iterator[Rows]:
        """Put designs together that are alike in all but numbers, in their units too, and at the paths that are named."""
        key = np.zeros(rows.size, dtype=np.int64)
        for one, index in self.axes:
            kinds = np.arange(len(one.values)) if one.path in worded else one.kinds
            if np.any(kinds != kinds[0]):
                key = np.unique(key, return_inverse=True)[1] * len(kinds) + kinds[index[rows]]
        _keys, found = np.unique(key, return_inverse=True)
        order = np.argsort(found, kind="stable")
        yield from (rows[own] for own in np.split(order, np.flatnonzero(np.diff(found[order])) + 1) if own.size)

    def take(self, rows: Rows, worded: frozenset[str]) -> None:
        """Judge designs that are alike but in numbers."""
        differing = [
            (one, index)
            for one, index in self.axes
            if one.path not in worded and one.are_numbers[index[rows[0]]] and np.any(index[rows] != index[rows[0]])
        ]
        if rows.size < _FEW or not differing:
            self.ask_each(rows)
            return
        start = self._start(rows, {one.path for one, _index in differing})
        if start is None:
            self.ask_each(rows)
            return
        places: list[Place | None] = []
        for one, index in differing:
            tried = designs_tried(start, one, np.unique(index[rows]))
            if not are_numbers(start, tried):
                for own in self.alike(rows, worded | {one.path}):
                    self.take(own, worded | {one.path})
                return
            places.append(place_of(start, one, tried))
        known = [place for place in places if place is not None]
        if len(known) < len(places) or not _Group(self, start, rows, known).is_taken():
            self.ask_each(rows)

    def _start(self, rows: Rows, numbers: set[str]) -> Machine | None:
        """Give one of the designs, or one with the file's own numbers, whose tables are right each by itself."""
        tried = [self.row(place) for place in rows[np.linspace(0, rows.size - 1, _TRIED).astype(np.intp)].tolist()]
        tried.append({path: value for path, value in tried[0].items() if path not in numbers})
        for row in tried:
            try:
                return self.machine.with_(row)
            except InputError:
                continue
        return None

    def ask_each(self, rows: Rows) -> None:
        """Judge designs one by one."""
        found: list[tuple[object, tuple[int, Machine]]] = []
        for place in rows.tolist():
            row = self.row(place)
            try:
                design = checked(self.machine, row)
            except InputError as error:
                self.refused.say(place, error.problems[0])
            else:
                found.append((words_of(design), (place, design)))
        for own in grouped(found).values():
            places, each = zip(*own, strict=True)
            self.groups.append(DesignsInColumns(in_columns(each), np.array(places), each, were_followed=False))


class _Group:
    """Designs that are alike but in numbers of which it is known where they stand in the tables."""

    def __init__(self, block: _Block, start: Machine, rows: Rows, places: Sequence[Place]) -> None:
        self.block, self.start, self.places = block, start, places
        index = {one.path: index for one, index in block.axes}
        self._index = [index[place.varied.path] for place in places]
        is_right = np.ones(rows.size, dtype=bool)
        for place, own in zip(places, self._index, strict=True):
            is_right &= place.read.is_right[own[rows]]
        self.rows, self.misread = rows[is_right], rows[~is_right]

    def is_taken(self) -> bool:
        """Put them among the groups and the refused; False, and nothing is done, where they cannot be judged at once."""
        if not self.rows.size:
            return False
        judged = judged_together(self.start, self.columns(self.rows), self.rows.size)
        good, wrong = self.rows[~judged.is_wrong & ~judged.is_unknown], self.rows[judged.is_wrong]
        if not good.size and not wrong.size:
            return False
        each = _Each(self, good)
        if not self._are_as_alone(each) or not self._are_refused(wrong) or not self._are_refused(self.misread):
            return False
        self.block.refused.add(np.concatenate([self.misread, wrong]).tolist())
        if good.size:
            together = as_columns(each[0], self.columns(good), good.size)
            self.block.groups.append(DesignsInColumns(together, good, each, were_followed=True))
        self.block.ask_each(self.rows[judged.is_unknown])
        return True

    def columns(self, rows: Rows) -> dict[PathParts, Array]:
        """Numbers in SI of some designs, by where they stand."""
        found = [(place, place.read.si[own[rows]]) for place, own in zip(self.places, self._index, strict=True)]
        return {where: column for place, column in found for where in place.where}

    def alone(self, row: int) -> Machine:
        """Give one of them by itself, as `Machine.with_` does, which would check it again."""
        given: dict[PathParts, Given] = {}
        for place, own in zip(self.places, self._index, strict=True):
            given |= dict.fromkeys(place.where, place.quantity.given(place.varied.values[own[row]]))
        design = with_numbers(self.start, given)
        declared, _paths = with_values(self.block.machine.declared, with_tuples(self.block.row(row)))
        vars(design).update(declared=declared, table_problems=(), closing_problems=())
        return design

    def _are_refused(self, rows: Rows) -> bool:
        """Whether some of the designs that are to be refused are, asked one by one."""
        asked = (self.block.row(row) for row in rows[_spread(rows.size)].tolist())
        return all(problem_of(self.block.machine, row) is not None for row in asked)

    def _are_as_alone(self, each: "_Each") -> bool:
        """Whether some of the designs that are to be right are, and are what they were found to be."""
        for number in _spread(len(each)).tolist():
            try:
                alone = checked(self.block.machine, self.block.row(each.rows[number]))
            except InputError:
                return False
            if words_of(alone) != words_of(each[number]) or not _have_same_numbers(alone, each[number]):
                return False
        return True


class _Each(Sequence[Machine]):
    """Designs by themselves, made when they are asked for."""

    def __init__(self, group: _Group, rows: Rows) -> None:
        self._group, self.rows = group, rows

    def __len__(self) -> int:
        return self.rows.size

    @overload
    def __getitem__(self, which: int) -> Machine: ...
    @overload
    def __getitem__(self, which: slice) -> Sequence[Machine]: ...
    def __getitem__(self, which: int | slice) -> Machine | Sequence[Machine]:
        found: Any = self.rows[which]
        return tuple(map(self._group.alone, found.tolist())) if isinstance(which, slice) else self._group.alone(found)


def _spread(n_designs: int) -> Rows:
    """Some of many: the first, the last, and some between."""
    return np.unique(np.linspace(0, n_designs - 1, min(_ASKED, n_designs)).astype(np.intp))


def _have_same_numbers(one: Machine, other: Machine) -> bool:
    """Whether all quantities of two designs are the same, to the last bit, as they were written."""
    pairs = zip(numbers_of(one), numbers_of(other), strict=True)
    return all(own == twin and bits(own[1].si) == bits(twin[1].si) for own, twin in pairs)
