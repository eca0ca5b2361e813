"""What `textbook --drive` writes: the drive's table, its curves, or its figures."""

from pathlib import PurePath

from cranktrain.cli.quiet_pictures import save_quietly
from cranktrain.cli.textbook.output_names import CURVES, TABLE
from cranktrain.errors import InputError, Problem
from cranktrain.io.output import write_machine_file, write_whole
from cranktrain.language import _
from cranktrain.one_line import one_line
from cranktrain.textbook.drive_statements import drive_statements
from cranktrain.texts.drive_table import CrankRockerDrive


def write_drive(
    drive: CrankRockerDrive, text: str | None, name: str, output: str, *, angle: float, force: bool
) -> None:
    """Write the table or the curves, or draw both figures; say what was written."""
    suffix = PurePath(output).suffix.lower()
    if suffix == TABLE:
        if text is None:
            raise InputError([Problem("-o", output, _("is for a drive's table: a machine has a file of its own"))])
        write_machine_file(output, text, force=force)
    elif suffix == CURVES:
        write_whole(output, drive_statements(drive).csv(), force=force)
    else:
        from cranktrain.viz.plans.drive_figure import drive_figure

        save_quietly(lambda: drive_figure(drive, name, angle), output, force=force)
    print(_("written: {name}").format(name=one_line(output)))
