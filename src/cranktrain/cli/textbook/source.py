"""What is compared with the sources' formulas: a machine, or a drive's or a throw's own table."""

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Literal, TypeVar

from cranktrain.cli.textbook.typed import TextbookRequest
from cranktrain.errors import InputError, Position, Problem, problems_as, refuse
from cranktrain.io.document import Document
from cranktrain.io.machine_file import MachineFile, read_machine
from cranktrain.io.syntax import parsed
from cranktrain.language import said as _
from cranktrain.saying.comments import with_said_comments
from cranktrain.texts.example_tables import example_table

_Own = TypeVar("_Own")

EXAMPLE = "example"
"""What is typed for the text's own drive or throw, if no file is called so."""
SETTING = Position("--set")


def machine_file(asked: TextbookRequest, example: str) -> MachineFile:
    """Read the machine with its settings; where none is named, say what could be typed."""
    if not asked.file:
        refuse([file_missing(example)])
    return read_machine(asked.file or "", asked.settings)


def file_missing(example: str) -> Problem:
    """Say that no machine is named, and what could be typed."""
    repair = _("such as: {example}", example=example)
    return Problem("", None, _("FILE is missing"), repair, Position("cranktrain textbook"))


def read_own(
    kind: Literal["drive", "throw"],
    source: str,
    settings: Sequence[str],
    read: Callable[[Mapping[str, object]], _Own],
    *,
    form: str,
    nothing: str,
) -> tuple[_Own, str]:
    """Read an own table with some values set anew; what is wrong stands at its line, or at `--set`.

    Parameters
    ----------
    kind : "drive" or "throw"
    source : str
        Its file, or `example`.
    settings : sequence of str
        `SYMBOL=VALUE`
    read : callable
        Makes what the table declares of its data.
    form, nothing : str
        What is said of a setting that is none, and of a file that declares nothing.

    Returns
    -------
    tuple
        What `read` makes, and the text.
    """
    typed = document = _document(kind, source, nothing)
    for setting in settings:
        key, equals, value = (part.strip() for part in setting.partition("="))
        if not equals or not key.isidentifier():
            raise InputError([Problem("", setting, form, position=SETTING)])
        with problems_as(lambda problem: replace(problem, position=SETTING)):
            document = document.with_value(key, value)
    keys = [one.partition("=")[0].strip() for one in settings]
    with problems_as(lambda one: replace(one, position=SETTING) if one.path in keys else typed.located(one)):
        return read(parsed(document.text, document.name)), document.text


def _document(kind: Literal["drive", "throw"], source: str, nothing: str) -> Document:
    """Read the text of an own table; a file that says nothing is refused."""
    is_file = os.path.isfile(source)  # noqa: PTH113 - takes a NUL byte
    if source.strip().casefold() == EXAMPLE and not is_file:
        return Document.from_text(with_said_comments(example_table(kind)), EXAMPLE)
    repair = _("start with: {command}", command=f"cranktrain textbook --{kind} example -o {kind}.toml")
    with problems_as(lambda problem: replace(problem, repair=problem.repair or repair)):
        document = Document.read(source)
    if not parsed(document.text, document.name):
        raise InputError([Problem("", None, nothing, repair, Position(document.name))])
    return document
