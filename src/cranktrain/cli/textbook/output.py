"""What `textbook -o` writes, by how the name ends: a drive's or a throw's table, its curves, or its figures."""

from collections.abc import Iterator, Mapping
from pathlib import PurePath

from cranktrain.cli.quiet_pictures import save_quietly
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.io.output import write_machine_file, write_whole
from cranktrain.language import said as _
from cranktrain.one_line import one_line
from cranktrain.plans.machine_throw import ThrownMachine
from cranktrain.plans.throw_loads import CrankMasses
from cranktrain.textbook.drive_statements import drive_statements
from cranktrain.textbook.statements import Statements
from cranktrain.texts.drive_table import CrankRockerDrive
from cranktrain.texts.throw_table import Throw
from cranktrain.viz.output import FORMATS

TABLE, CURVES = ".toml", ".csv"


def output_problems(output: str | None, *kinds: str, force: bool) -> Iterator[Problem]:
    """Refuse a name that says nothing of what is to be written: one of `kinds`, or a picture; `--force` without one."""
    if output is None and force:
        yield Problem("--force", None, _("is for a file that is written: ask for -o FILE, too"))
    known = (*kinds, *FORMATS)
    if output is not None and PurePath(output).suffix.lower() not in known:
        yield Problem("-o", output, _("must end in one of: {suffixes}", suffixes=", ".join(known)))


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
    print(_("written: {name}", name=one_line(output)))


def refuse_without_throw(
    output: str | None, *, at: float | None, force: bool, of_throw: Mapping[str, str | None]
) -> None:
    """Refuse to write where nothing can be written, and what is asked of a throw or a drive where there is none."""
    allowed = _("is for a throw or a drive: ask for --throw FILE or --drive FILE, too")
    given = (("-o", output), ("--force", "" if force else None), ("--at", None if at is None else f"{at:g}"))
    found = [Problem(option, value or None, allowed) for option, value in given if value is not None]
    allowed = _("is for a machine's throw: ask for --throw FILE, too")
    found += [Problem(option, value, allowed) for option, value in of_throw.items() if value is not None]
    refuse(found)


def write_throw(throw: Throw, text: str, name: str, output: str, *, force: bool) -> None:
    """Write the table, or draw the scheme; say what was written."""
    if PurePath(output).suffix.lower() == TABLE:
        write_machine_file(output, text, force=force)
    else:
        from cranktrain.viz.plans.throw_scheme import throw_figure

        save_quietly(lambda: throw_figure(throw, name), output, force=force)
    print(_("written: {name}", name=one_line(output)))


def write_machine_throw(
    of: ThrownMachine, asked: tuple[str, float | None, CrankMasses], found: Statements, output: str, *, force: bool
) -> None:
    """Write the curves over the cycle, or draw the scheme with them; say what was written."""
    if PurePath(output).suffix.lower() == CURVES:
        write_whole(output, found.csv(), force=force)
    else:
        from cranktrain.viz.plans.throw_scheme import machine_throw_figure

        save_quietly(lambda: machine_throw_figure(of, *asked), output, force=force)
    print(_("written: {name}", name=one_line(output)))
