"""`textbook --drive`: reads a crank-rocker's drive, and shows it or writes it."""

import shlex
from collections.abc import Sequence
from dataclasses import replace
from pathlib import PurePath
from typing import TYPE_CHECKING, NamedTuple

from cranktrain.cli.run_files import texts_of
from cranktrain.cli.textbook.output import CURVES, TABLE, output_problems, show_or_write
from cranktrain.cli.textbook.source import EXAMPLE, SETTING, read_own
from cranktrain.cli.textbook.typed import OF_MOTION, OF_THROW, TextbookRequest
from cranktrain.errors import InputError, Problem, problems_as, refuse
from cranktrain.io.machine_file import read_machine
from cranktrain.io.own_tables import is_machine
from cranktrain.language import said as _
from cranktrain.one_line import one_line
from cranktrain.plans.machine_drive import machine_drive
from cranktrain.textbook.commands import textbook_command
from cranktrain.textbook.drive_statements import SOURCE, USUAL_ANGLE, drive_statements
from cranktrain.textbook.shown.drive import ALL, FIGURE, drive_sections
from cranktrain.textbook.speaking import with_speaking
from cranktrain.textbook.statements import Statements
from cranktrain.texts.drive_table import DRIVE_KEYS, CrankRockerDrive, read_drive

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_OTHERS = ("FILE", "--source", "--table", "--errata", *OF_MOTION, *OF_THROW, "--throw")


class _DriveFile(NamedTuple):
    """A drive and the text that declares it; none of a machine's."""

    drive: CrankRockerDrive
    text: str | None


def show_drive(asked: TextbookRequest) -> None:
    """Show a crank-rocker's drive, or write its table, its curves or its figures.

    Parameters
    ----------
    asked : TextbookRequest
        `drive` is a file with its table, or a machine file or an example with a crank-rocker, or `example`; `settings`
        are `SYMBOL=VALUE`, of a machine `PATH=VALUE`, too.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    source = asked.drive or ""
    refuse([*asked.beside(_("must be left out beside --drive"), *_OTHERS), *output_problems(asked, TABLE, *CURVES)])
    file = read_drive_file(source, asked.settings)
    at = USUAL_ANGLE if asked.at is None else asked.at

    def figure() -> "Figure":
        from cranktrain.viz.plans.drive_figure import drive_figure

        return drive_figure(file.drive, one_line(PurePath(source).name), at)

    def stated() -> Statements:
        return drive_statements(file.drive)

    def table() -> str:
        if file.text is None:
            allowed = _("is for a drive's table: a machine has a file of its own")
            raise InputError([Problem("-o", asked.output, allowed)])
        return file.text

    typed = ("--drive", source, *(word for pair in asked.typed("--at") for word in pair))
    whole, picture = (textbook_command(*typed, *one.split(), settings=asked.settings) for one in (ALL, FIGURE))
    heading = _("Drive of a crank-rocker, (1) to (21) [{source}]", source=SOURCE)
    sections = drive_sections(file.drive, at, commands=None if asked.full else {ALL: whole, FIGURE: picture})
    texts = {TABLE: table, CURVES[0]: lambda: stated().csv(), **texts_of(stated)}
    show_or_write(asked, heading, sections, texts, figure)


def read_drive_file(source: str, settings: Sequence[str]) -> _DriveFile:
    """Read a drive's table, or a machine; some values set anew. What is wrong stands at its line, or at `--set`."""
    if not source.strip():
        allowed = _("must be a file with a drive's table, a machine file, or `{example}`", example=EXAMPLE)
        raise InputError([Problem("--drive", '""', allowed)])
    if not is_machine(source):
        form, nothing = _('must be SYMBOL=VALUE, such as "Q=4 kN"'), _("no drive in it")
        return _DriveFile(*read_own("drive", source, settings, read_drive, form=form, nothing=nothing))
    pairs = {one: [part.strip() for part in one.partition("=")] for one in settings}
    own = {key: value for key, _equals, value in pairs.values() if key in DRIVE_KEYS}
    others = [one for one, (key, *_value) in pairs.items() if key not in DRIVE_KEYS]
    file = read_machine(source, others)
    with (
        problems_as(lambda one: replace(one, position=SETTING) if one.path in own else file.document.located(one)),
        problems_as(with_speaking(file.machine, source, others, ("mechanism",))),
    ):
        return _DriveFile(machine_drive(file.machine, own, as_set=_as_set), None)


def _as_set(symbol: str, value: str) -> str:
    """Write how a symbol is set in the terminal."""
    return shlex.join(("--set", f"{symbol}={value}"))
