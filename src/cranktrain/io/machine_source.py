"""A machine file whose numbers are set anew again and again, as on a page: what is typed is read once."""

import os
from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path

from cranktrain.errors import InputError
from cranktrain.io.curve_files import CurveReader, among, beside, with_curves
from cranktrain.io.document import Document
from cranktrain.io.machine_file import MachineFile, document_of, folder_of, with_set, with_settings
from cranktrain.machine import Machine, machine_problems
from cranktrain.paths import item_at, path_text
from cranktrain.record import record

_TEXT = "machine.toml"
"""Name of a machine file of which there is the text alone, as messages have it."""


@record
class MachineSource:
    """A machine file as it is typed.

    Attributes
    ----------
    document : Document
    curves : callable
        What gives the texts of the files that it names.
    folder : Path
        To which these are relative.
    """

    document: Document
    curves: CurveReader
    folder: Path

    def with_set(self, settings: Sequence[str] = (), *, partial: bool = False) -> MachineFile:
        """Read the machine with some values set anew; parameters and errors as of `read_machine`."""
        if settings and self._machine is not None:
            document, paths = with_settings(self.document, settings)
            try:
                machine = self._machine.with_({path_text(path): item_at(document.data, path) for path in paths})
                if not machine_problems(machine, partial=partial):
                    return MachineFile(document, machine)
            except InputError:  # of which more is told where all of it is read
                pass
        return self._read(settings, partial=partial)

    @cached_property
    def _machine(self) -> Machine | None:
        """The machine as it is typed; None where that is wrong, or names files, which may change meanwhile."""
        try:
            data = self.document.data
            if with_curves(data, self.curves)[0] != data:
                return None
            return self._read((), partial=True).machine
        except InputError:
            return None

    def _read(self, settings: Sequence[str], *, partial: bool) -> MachineFile:
        """Read the machine as if for the first time."""
        return with_set(self.document, settings, self.curves, self.folder, partial=partial)


def source_called(source: "str | os.PathLike[str]") -> MachineSource:
    """Take a machine file, or the example of that name, as `read_machine` does."""
    folder = folder_of(source)
    return MachineSource(document_of(source), beside(folder), folder)


def source_of_text(text: str, files: Mapping[str, str]) -> MachineSource:
    """Take the text of a machine file.

    Parameters
    ----------
    text : str
    files : mapping of str
        Texts of the files that it names, by the names that it has for them: nothing is read from the disk.

    Returns
    -------
    MachineSource
    """
    return MachineSource(Document.from_text(text, _TEXT), among(files), Path())
