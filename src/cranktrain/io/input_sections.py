"""What a machine's results rest on, as sections: the numbers of its file, and where they are from."""

from collections.abc import Iterable, Iterator, Sequence, Set
from functools import lru_cache

from cranktrain.io.description import counted_by_status
from cranktrain.io.machine_file import Input, MachineFile, inputs_of
from cranktrain.language import said as _
from cranktrain.one_line import one_line
from cranktrain.saying.run import BehindQuantity
from cranktrain.saying.sections import Part, Rows, ShownSection, section

_OF_A_BANK = 2
"""Keys in the path of a bank, of which nothing below is its own."""
_MOST_PATHS = 4096
"""Of numbers that are looked for again and again."""

_LISTED = ("assumed", "fitted")
"""Status of numbers that nobody measured: each of them is named."""


def input_section(inputs: Sequence[Input]) -> Iterator[ShownSection]:
    """Give numbers of a file: path, value, status and note."""
    yield from section(_("What this rests on"), _rows(inputs))


def provenance_section(file: MachineFile) -> Iterator[ShownSection]:
    """Count the numbers of a file by status, and name those that are assumed or fitted."""
    inputs = inputs_of(file)
    counted = counted_by_status(one.given for one in inputs)
    said = _("{n} numbers of the file: {counted}", n=len(inputs), counted=counted)
    listed = [one for status in _LISTED for one in inputs if one.given.status == status]
    yield from section(_("What this rests on"), [said, *_rows(listed)])


def inputs_behind(file: MachineFile, found: BehindQuantity) -> Iterator[Input]:
    """Numbers of the file in the tables that are read on the way."""
    yield from inputs_in(inputs_of(file), found.tables)


def inputs_in(inputs: Iterable[Input], tables: Set[str]) -> Iterator[Input]:
    """Of numbers of a file those that stand in some tables, or in what these have."""
    return (one for one in inputs if not tables.isdisjoint(_above(one.path)))


@lru_cache(_MOST_PATHS)
def _above(path: str) -> tuple[str, ...]:
    """Give what a number stands in, and itself."""
    keys = path.partition("[")[0].split(".")
    above = [".".join(keys[:length]) for length in range(1, len(keys) + 1)]
    # Of a bank or a shaft its own keys; of what else has a name all that stands in it.
    return tuple(above) if keys[0] not in ("bank", "shaft") else (above[-2], *above[_OF_A_BANK:])


def _rows(inputs: Sequence[Input]) -> Iterator[Part]:
    """A row for each number."""
    notes = ["; ".join(one_line(word) for word in (given.note, given.source) if word) for _path, given in inputs]
    rows = [
        (path, one_line(given.text), given.status or "", note)
        for (path, given), note in zip(inputs, notes, strict=True)
    ]
    if rows:
        yield Rows(rows)
