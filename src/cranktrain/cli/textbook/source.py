"""The machine whose motion is compared with the sources' formulas."""

from collections.abc import Sequence

from cranktrain.errors import Position, Problem, refuse
from cranktrain.io.machine_file import MachineFile, read_machine
from cranktrain.language import _


def machine_file(source: str, settings: Sequence[str], example: str) -> MachineFile:
    """Read the machine with its settings; where none is named, say what could be typed."""
    if not source:
        refuse([file_missing(example)])
    return read_machine(source, settings)


def file_missing(example: str) -> Problem:
    """Say that no machine is named, and what could be typed."""
    repair = _("such as: {example}").format(example=example)
    return Problem("", None, _("FILE is missing"), repair, Position("cranktrain textbook"))
