"""Where a machine is from: the text of its file, where that is, and what reads the files that it names."""

from collections.abc import Callable, Mapping
from dataclasses import field
from pathlib import Path
from typing import Any, TypeAlias

from cranktrain.errors import Problem
from cranktrain.record import record

FileReader: TypeAlias = Callable[[Mapping[str, object]], tuple[dict[str, Any], tuple[Problem, ...]]]
"""Gives tables with what the files hold that they name, and what is wrong with these."""


def _unread(data: Mapping[str, object]) -> tuple[dict[str, Any], tuple[Problem, ...]]:
    """Leave tables as they are."""
    return dict(data), ()


@record
class TypedFile:
    """Where a machine is from; of one that was made in Python nothing.

    Attributes
    ----------
    files_read : callable
        What puts into tables what the files hold that they name.
    folder : Path
        From which these are found.
    text : str
        Of the machine file as it was typed.
    data : mapping
        The tables of that.
    """

    files_read: FileReader = _unread
    folder: Path = Path()
    text: str = ""
    data: Mapping[str, Any] = field(default_factory=dict[str, Any])

    @property
    def reads(self) -> bool:
        """Whether files that tables name are read: of a machine made in Python nobody knows where they would be."""
        return self.files_read is not _unread
