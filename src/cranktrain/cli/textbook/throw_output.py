"""What `textbook --throw` writes: the throw's table, or its scheme."""

import logging
from collections.abc import Iterator
from pathlib import PurePath

from cranktrain.errors import Problem, refuse
from cranktrain.io.output import write_machine_file
from cranktrain.language import _
from cranktrain.one_line import one_line
from cranktrain.texts.throw_table import Throw
from cranktrain.viz.output import FORMATS, save

_TABLE = ".toml"


def refuse_without_throw(output: str | None, *, at: float | None, force: bool) -> None:
    """Refuse to write where nothing can be written, and the angle of a drive where there is none."""
    allowed = _("is for a throw or a drive: ask for --throw FILE or --drive FILE, too")
    given = (("-o", output), ("--force", "" if force else None))
    found = [Problem(option, value or None, allowed) for option, value in given if value is not None]
    if at is not None:
        found.append(Problem("--at", f"{at:g}", _("is for a drive: ask for --drive FILE, too")))
    refuse(found)


def output_problems(output: str | None) -> Iterator[Problem]:
    """Refuse a name that says nothing of what is to be written."""
    if output is not None and PurePath(output).suffix.lower() not in (_TABLE, *FORMATS):
        allowed = _("must end in one of: {suffixes}").format(suffixes=", ".join((_TABLE, *FORMATS)))
        yield Problem("-o", output, allowed)


def write_throw(throw: Throw, text: str, name: str, output: str, *, force: bool) -> None:
    """Write the table, or draw the scheme; say what was written."""
    if PurePath(output).suffix.lower() == _TABLE:
        write_machine_file(output, text, force=force)
    else:
        from cranktrain.viz.plans.throw_scheme import throw_figure

        # What the plotting library says of its fonts and its folder is nothing that a user asked for.
        logging.getLogger("matplotlib").setLevel(logging.ERROR)
        save(lambda: throw_figure(throw, name), output, force=force)
    print(_("written: {name}").format(name=one_line(output)))
