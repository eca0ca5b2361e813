"""The machine whose motion is compared with the sources' formulas."""

import os
from collections.abc import Sequence

from cranktrain.errors import Position, Problem, refuse
from cranktrain.io.document import Document
from cranktrain.io.examples import example_names
from cranktrain.io.machine_file import MachineFile, read_machine
from cranktrain.io.syntax import parsed
from cranktrain.language import _
from cranktrain.machine import Machine


def machine_file(source: str, settings: Sequence[str], example: str) -> MachineFile:
    """Read the machine with its settings; where none is named, say what could be typed."""
    if not source:
        refuse([file_missing(example)])
    return read_machine(source, settings)


def file_missing(example: str) -> Problem:
    """Say that no machine is named, and what could be typed."""
    repair = _("such as: {example}").format(example=example)
    return Problem("", None, _("FILE is missing"), repair, Position("cranktrain textbook"))


def is_machine(source: str) -> bool:
    """Whether a name is that of a machine: an example, or a file with a key that machines alone have."""
    if not os.path.isfile(source):  # noqa: PTH113 - takes a NUL byte
        return source.casefold().replace("-", "_") in example_names()
    document = Document.read(source)
    return not Machine.model_fields.keys().isdisjoint(parsed(document.text, document.name))
