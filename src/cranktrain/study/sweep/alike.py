"""Designs that differ in numbers alone, of which it is known where these stand in the tables."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple, overload

import numpy as np
from numpy.typing import NDArray

from cranktrain.columns import as_columns, numbers_of, with_numbers
from cranktrain.errors import InputError
from cranktrain.machine import Machine
from cranktrain.motion import Array, single
from cranktrain.paths import PathParts, with_values
from cranktrain.quantities import Given
from cranktrain.spec import with_tuples
from cranktrain.study.sweep.numbers import bits
from cranktrain.study.sweep.places import NumberPlace, words_of
from cranktrain.study.sweep.refused import checked, problem_of
from cranktrain.study.sweep.rules import judged_together

Rows = NDArray[np.intp]

_ASKED = 4
"""Designs of each group that are asked one by one, too."""


class SortedDesigns(NamedTuple):
    """Designs of a block by what they are: right, in groups of one cycle, wrong, or not to be told together."""

    right: tuple[Rows, ...]
    wrong: Rows
    unknown: Rows


class AlikeDesigns:
    """Designs of a block that differ in numbers alone.

    Parameters
    ----------
    machine : Machine
        Of which they are variants.
    start : Machine
        One like them, whose tables are right each by itself.
    row : callable (place) → dict
        Values of a design of the block, by path.
    places : mapping of NumberPlace to array of int, shape (design,)
        Where the numbers stand, and which of the values each design of the block has.
    """

    def __init__(
        self,
        machine: Machine,
        start: Machine,
        row: Callable[[int], dict[str, object]],
        places: Mapping[NumberPlace, Rows],
    ) -> None:
        self._machine, self._start, self._row, self._places = machine, start, row, places

    def judged(self, rows: Rows) -> SortedDesigns | None:
        """Judge some of them together; None where that cannot be done for sure."""
        can_be_read = np.ones(rows.size, dtype=bool)
        for place, index in self._places.items():
            can_be_read &= place.read.is_right[index[rows]]
        read, misread = rows[can_be_read], rows[~can_be_read]
        if not read.size:
            return None
        is_wrong, is_unknown, cycle = judged_together(self._start, self._columns(read), read.size)
        is_right = ~is_wrong & ~is_unknown
        right = tuple(read[is_right & (cycle == one)] for one in np.unique(cycle[is_right]))
        found = SortedDesigns(right, read[is_wrong], read[is_unknown])
        if not all(map(self._are_right, right)) or not self._are_wrong(found.wrong) or not self._are_wrong(misread):
            return None
        return found._replace(wrong=np.concatenate([misread, found.wrong]))

    def together(self, rows: Rows) -> Machine:
        """Give some of them, which are right, as columns of the first."""
        return as_columns(self.alone(int(rows[0])), self._columns(rows), rows.size)

    def alone(self, row: int) -> Machine:
        """Give one of them, which is right, as `Machine.with_` does, which would check it again."""
        given: dict[PathParts, Given] = {}
        for place, index in self._places.items():
            given |= dict.fromkeys(place.where, place.quantity.given(place.varied.values[index[row]]))
        design = with_numbers(self._start, given)
        declared, _paths = with_values(self._machine.declared, with_tuples(self._row(row)))
        vars(design).update(declared=declared, table_problems=(), closing_problems=())
        return design

    def _columns(self, rows: Rows) -> dict[PathParts, Array]:
        """Numbers in SI of some of them, by where they stand."""
        found = [(place, place.read.si[index[rows]]) for place, index in self._places.items()]
        return {where: column for place, column in found for where in place.where}

    def _are_wrong(self, rows: Rows) -> bool:
        """Whether some of those that are to be refused are, asked one by one."""
        return all(problem_of(self._machine, self._row(row)) is not None for row in _some(rows))

    def _are_right(self, rows: Rows) -> bool:
        """Whether some of those that are to be right are, and are what they were found to be."""
        for row in _some(rows):
            try:
                asked = checked(self._machine, self._row(row))
            except InputError:
                return False
            found = self.alone(row)
            if (asked.cycle, words_of(asked)) != (found.cycle, words_of(found)) or not _have_same_numbers(asked, found):
                return False
        return True


class EachAlone(Sequence[Machine]):
    """Designs by themselves, made when they are asked for."""

    def __init__(self, alike: AlikeDesigns, rows: Rows) -> None:
        self._alike, self._rows = alike, rows

    def __len__(self) -> int:
        return self._rows.size

    @overload
    def __getitem__(self, which: int) -> Machine: ...
    @overload
    def __getitem__(self, which: slice) -> Sequence[Machine]: ...
    def __getitem__(self, which: int | slice) -> Machine | Sequence[Machine]:
        found: Any = self._rows[which].tolist()
        return tuple(map(self._alike.alone, found)) if isinstance(which, slice) else self._alike.alone(found)


def _some(rows: Rows) -> list[int]:
    """Some of many: the first, the last, and some between."""
    return rows[np.unique(np.linspace(0, rows.size - 1, min(_ASKED, rows.size)).astype(np.intp))].tolist()


def _have_same_numbers(one: Machine, other: Machine) -> bool:
    """Whether all quantities of two designs are the same, to the last bit, as they were written."""
    pairs = zip(numbers_of(one), numbers_of(other), strict=True)
    return all(own == twin and bits(single(own[1].si)) == bits(single(twin[1].si)) for own, twin in pairs)
