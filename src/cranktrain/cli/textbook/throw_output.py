"""What `textbook --throw` writes: the throw's table, or its scheme."""

import logging
from collections.abc import Callable, Iterator, Mapping
from pathlib import PurePath
from typing import Any

from cranktrain.errors import Problem, refuse
from cranktrain.io.output import write_machine_file, write_whole
from cranktrain.language import _
from cranktrain.one_line import one_line
from cranktrain.plans.machine_throw import ThrownMachine
from cranktrain.plans.throw_loads import CrankMasses
from cranktrain.textbook.throw_statements import machine_statements
from cranktrain.texts.throw_table import Throw
from cranktrain.viz.output import FORMATS, save

_TABLE, _CURVES = ".toml", ".csv"


def refuse_without_throw(
    output: str | None, *, at: float | None, force: bool, of_throw: Mapping[str, str | None]
) -> None:
    """Refuse to write where nothing can be written, and what is asked of a throw or a drive where there is none."""
    allowed = _("is for a throw or a drive: ask for --throw FILE or --drive FILE, too")
    given = (("-o", output), ("--force", "" if force else None))
    found = [Problem(option, value or None, allowed) for option, value in given if value is not None]
    if at is not None:
        found.append(
            Problem("--at", f"{at:g}", _("is for a throw or a drive: ask for --throw FILE or --drive FILE, too"))
        )
    allowed = _("is for a machine's throw: ask for --throw FILE, too")
    found += [Problem(option, value, allowed) for option, value in of_throw.items() if value is not None]
    refuse(found)


def output_problems(output: str | None, *, of_machine: bool) -> Iterator[Problem]:
    """Refuse a name that says nothing of what is to be written."""
    known = (_CURVES if of_machine else _TABLE, *FORMATS)
    if output is not None and PurePath(output).suffix.lower() not in known:
        yield Problem("-o", output, _("must end in one of: {suffixes}").format(suffixes=", ".join(known)))


def write_throw(throw: Throw, text: str, name: str, output: str, *, force: bool) -> None:
    """Write the table, or draw the scheme; say what was written."""
    if PurePath(output).suffix.lower() == _TABLE:
        write_machine_file(output, text, force=force)
    else:
        from cranktrain.viz.plans.throw_scheme import throw_figure

        _save(lambda: throw_figure(throw, name), output, force=force)
    print(_("written: {name}").format(name=one_line(output)))


def write_machine_throw(
    of: ThrownMachine, asked: tuple[str, float | None, CrankMasses], output: str, *, force: bool
) -> None:
    """Write the curves over the cycle, or draw the scheme with them; say what was written."""
    if PurePath(output).suffix.lower() == _CURVES:
        write_whole(output, machine_statements(of, *asked).csv(), force=force)
    else:
        from cranktrain.viz.plans.throw_scheme import machine_throw_figure

        _save(lambda: machine_throw_figure(of, *asked), output, force=force)
    print(_("written: {name}").format(name=one_line(output)))


def _save(draw: Callable[[], Any], output: str, *, force: bool) -> None:
    """Save a figure; what the plotting library says of its fonts and its folder is nothing that a user asked for."""
    logging.getLogger("matplotlib").setLevel(logging.ERROR)
    save(draw, output, force=force)
