"""Small tables of one's own, a drive's or a throw's, beside machine files: which of them a name is of."""

import os
from pathlib import PurePath

from cranktrain.io.document import Document
from cranktrain.io.examples import example_called
from cranktrain.io.syntax import parsed
from cranktrain.machine import Machine


def is_machine(source: str) -> bool:
    """Whether a name is that of a machine: an example, or a file with a key that machines alone have."""
    if not os.path.isfile(source):  # noqa: PTH113 - takes a NUL byte
        return example_called(source) is not None
    return _is_of_machine(Document.read(source))


def own_table(source: object) -> Document | None:
    """Read the file of a table that is no machine's; None of all else."""
    if not isinstance(source, str | PurePath):
        return None
    name = os.fspath(source)
    if not os.path.isfile(name):  # noqa: PTH113 - takes a NUL byte
        return None
    document = Document.read(name)
    return None if _is_of_machine(document) else document


def _is_of_machine(document: Document) -> bool:
    """Whether a file has a key that machines alone have."""
    return not Machine.model_fields.keys().isdisjoint(parsed(document.text, document.name))
