"""Where the numbers of a machine file are from."""

from collections.abc import Iterator, Sequence

from rich.text import Text

from cranktrain.cli.screen.text import table
from cranktrain.io.description import counted_by_status
from cranktrain.io.machine_file import Input, MachineFile, inputs_of
from cranktrain.language import _
from cranktrain.one_line import one_line

_TOLD = ("assumed", "fitted")
"""Status of numbers that nobody measured: each of them is named."""


def provenance(file: MachineFile, width: int) -> Iterator[str | Text]:
    """Count the numbers of a file by status, and name those that are assumed or fitted, in a width of columns."""
    inputs = inputs_of(file)
    counted = counted_by_status(one.given for one in inputs)
    yield _("{n} numbers of the file: {counted}").format(n=len(inputs), counted=counted)
    told = [one for status in _TOLD for one in inputs if one.given.status == status]
    if told:
        yield from table(("", "", "", ""), list(_rows(told)), fold=width)


def input_table(file: MachineFile, width: int) -> list[Text]:
    """Every number of a file, with its status and note, in a width of columns."""
    return table(("", "", "", ""), list(_rows(inputs_of(file))), fold=width)


def _rows(inputs: Sequence[Input]) -> Iterator[tuple[str, str, str, str]]:
    """Give path, value, status and note of inputs."""
    for path, given in inputs:
        about = "; ".join(one_line(word) for word in (given.note, given.source) if word)
        yield path, one_line(given.text), given.status or "", about
