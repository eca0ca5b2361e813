"""Where the numbers of a machine file are from."""

from collections.abc import Iterator, Sequence

from rich.text import Text

from cranktrain.cli.screen.text import table
from cranktrain.io.description import counted_by_status
from cranktrain.io.machine_file import Input, MachineFile, inputs_of
from cranktrain.language import _
from cranktrain.one_line import one_line

_LISTED = ("assumed", "fitted")
"""Status of numbers that nobody measured: each of them is named."""


def provenance(file: MachineFile, width: int) -> Iterator[str | Text]:
    """Count the numbers of a file by status, and name those that are assumed or fitted, in a width of columns."""
    inputs = inputs_of(file)
    counted = counted_by_status(one.given for one in inputs)
    yield _("{n} numbers of the file: {counted}").format(n=len(inputs), counted=counted)
    listed = [one for status in _LISTED for one in inputs if one.given.status == status]
    if listed:
        yield from input_table(listed, width)


def input_table(inputs: Sequence[Input], width: int) -> list[Text]:
    """Path, value, status and note of numbers of a file, in a width of columns."""
    notes = ["; ".join(one_line(word) for word in (given.note, given.source) if word) for _path, given in inputs]
    rows = [
        (path, one_line(given.text), given.status or "", note)
        for (path, given), note in zip(inputs, notes, strict=True)
    ]
    return table(("", "", "", ""), rows, fold=width)
