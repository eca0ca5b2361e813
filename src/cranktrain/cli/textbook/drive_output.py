"""What `textbook --drive` writes: the drive's table, its curves, or its figures."""

import logging
from collections.abc import Iterator
from pathlib import PurePath

from cranktrain.errors import InputError, Problem
from cranktrain.io.output import write_machine_file, write_whole
from cranktrain.language import _
from cranktrain.one_line import one_line
from cranktrain.textbook.drive_statements import drive_statements
from cranktrain.texts.drive_table import CrankRockerDrive
from cranktrain.viz.output import FORMATS, save

_TABLE, _CURVES = ".toml", ".csv"


def drive_output_problems(output: str | None) -> Iterator[Problem]:
    """Refuse a name that says nothing of what is to be written."""
    known = (_TABLE, _CURVES, *FORMATS)
    if output is not None and PurePath(output).suffix.lower() not in known:
        yield Problem("-o", output, _("must end in one of: {suffixes}").format(suffixes=", ".join(known)))


def write_drive(
    drive: CrankRockerDrive, text: str | None, name: str, output: str, *, angle: float, force: bool
) -> None:
    """Write the table or the curves, or draw both figures; say what was written."""
    suffix = PurePath(output).suffix.lower()
    if suffix == _TABLE:
        if text is None:
            raise InputError([Problem("-o", output, _("is for a drive's table: a machine has a file of its own"))])
        write_machine_file(output, text, force=force)
    elif suffix == _CURVES:
        write_whole(output, drive_statements(drive).csv(), force=force)
    else:
        from cranktrain.viz.plans.drive_figure import drive_figure

        # What the plotting library says of its fonts and its folder is nothing that a user asked for.
        logging.getLogger("matplotlib").setLevel(logging.ERROR)
        save(lambda: drive_figure(drive, name, angle), output, force=force)
    print(_("written: {name}").format(name=one_line(output)))
