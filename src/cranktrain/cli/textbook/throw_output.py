"""What `textbook --throw` writes: the throw's table, or its scheme."""

from collections.abc import Mapping
from pathlib import PurePath

from cranktrain.cli.quiet_pictures import save_quietly
from cranktrain.cli.textbook.output_names import CURVES, TABLE
from cranktrain.errors import Problem, refuse
from cranktrain.io.output import write_machine_file, write_whole
from cranktrain.language import _
from cranktrain.one_line import one_line
from cranktrain.plans.machine_throw import ThrownMachine
from cranktrain.plans.throw_loads import CrankMasses
from cranktrain.textbook.statements import Statements
from cranktrain.texts.throw_table import Throw


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
    print(_("written: {name}").format(name=one_line(output)))


def write_machine_throw(
    of: ThrownMachine, asked: tuple[str, float | None, CrankMasses], found: Statements, output: str, *, force: bool
) -> None:
    """Write the curves over the cycle, or draw the scheme with them; say what was written."""
    if PurePath(output).suffix.lower() == CURVES:
        write_whole(output, found.csv(), force=force)
    else:
        from cranktrain.viz.plans.throw_scheme import machine_throw_figure

        save_quietly(lambda: machine_throw_figure(of, *asked), output, force=force)
    print(_("written: {name}").format(name=one_line(output)))
