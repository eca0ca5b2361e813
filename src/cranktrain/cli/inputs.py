"""Where the numbers of a machine file are from."""

from collections import Counter
from collections.abc import Sequence

from rich.console import RenderableType
from rich.text import Text

from cranktrain.cli.screen import plain, table
from cranktrain.io.machine_file import Input, MachineFile, inputs_of
from cranktrain.language import _

_TOLD = ("assumed", "fitted")
"""Status of numbers that nobody measured: each of them is named."""


def provenance(file: MachineFile) -> RenderableType:
    """Count the numbers of a file by status, and name those that are assumed or fitted."""
    inputs = inputs_of(file)
    told = [one for one in inputs if one.given.status in _TOLD]
    counts = Counter(one.given.status for one in inputs)
    words = {
        "published": _("{n} published"),
        "derived": _("{n} derived"),
        "assumed": _("{n} assumed"),
        "fitted": _("{n} fitted"),
        None: _("{n} without a status"),
    }
    counted = ", ".join(word.format(n=counts[status]) for status, word in words.items() if counts[status])
    said = Text(_("{n} numbers of the file: {counted}").format(n=len(inputs), counted=counted) + (":" if told else ""))
    if not told:
        return said
    from rich.console import Group

    return Group(said, table(("", "", "", ""), _rows(sorted(told, key=lambda one: _TOLD.index(str(one.given.status))))))


def input_table(file: MachineFile) -> RenderableType:
    """Every number of a file, with its status and note."""
    return table(("", "", "", ""), _rows(inputs_of(file)))


def _rows(inputs: Sequence[Input]) -> list[tuple[str, str, str, str]]:
    """Give path, value, status and note of inputs; neighbours in a list that agree in all else share a line."""
    rows: list[tuple[str, str, str, str]] = []
    for path, given in inputs:
        about = "; ".join(plain(word) for word in (given.note, given.source) if word)
        rows.append((path, plain(given.text), given.status or "", about))
    return rows
