"""`textbook --drive`: (1) to (21) of a crank-rocker's drive, as printed, right and refuted, over a turn."""

import shlex
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import PurePath
from typing import NamedTuple

import numpy as np
from rich.cells import cell_len
from rich.console import Console
from rich.text import Text

from cranktrain.cli.screen.columns import Column, column_table, side_by_side
from cranktrain.cli.screen.text import INDENT, page, section, table
from cranktrain.cli.textbook.output import CURVES, TABLE, output_problems, write_drive
from cranktrain.cli.textbook.source import EXAMPLE, SETTING, read_own
from cranktrain.cli.textbook.speaking import with_speaking
from cranktrain.cli.to_type import textbook_command
from cranktrain.errors import InputError, Problem, problems_as, refuse
from cranktrain.io.machine_file import read_machine
from cranktrain.io.own_tables import is_machine
from cranktrain.language import said as _
from cranktrain.one_line import one_line
from cranktrain.plans.machine_drive import machine_drive
from cranktrain.references import REFERENCES
from cranktrain.saying.wording import figure, number
from cranktrain.textbook.drive_statements import FACTS, PEAKS, SOURCE, USUAL_ANGLE, drive_statements
from cranktrain.textbook.statements import Statement, Statements
from cranktrain.texts.drive_curves import AT_MOTOR
from cranktrain.texts.drive_table import DRIVE_KEYS, CrankRockerDrive, read_drive

_LEADING = ("(1)", "(2)", "(3) (4)", "(16) (17)")
"""What leads from the load to the motor's shaft, on the first screen."""
_ROUNDING = 1e-12
"""What is less is 0."""


_Asked = tuple[str, float | None, Sequence[str]]
"""The file, the angle [deg] and the settings that were typed."""


class _DriveFile(NamedTuple):
    """A drive and the text that declares it; none of a machine's."""

    drive: CrankRockerDrive
    text: str | None


def show_drive(
    source: str,
    settings: Sequence[str],
    output: str | None,
    *,
    angle: float | None = None,
    full: bool,
    force: bool,
    others: Mapping[str, str | None],
) -> None:
    """Show a crank-rocker's drive, or write its table, its curves or its figures.

    Parameters
    ----------
    source : str
        A file with its table, or a machine file or an example with a crank-rocker, or `example`.
    settings : sequence of str
        `SYMBOL=VALUE`; of a machine `PATH=VALUE`, too.
    output : str or None
        File to write instead: .toml, .csv, .png, .svg, .pdf.
    angle : float, optional
        Crank angle from the line of the fixed pivots at which forces are shown. [deg]
    full : bool
        Whether to show all, not the first screen alone.
    force : bool
        Replace a file that is there.
    others : mapping of options to str or None
        What else was typed and means nothing here.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    allowed = _("must be left out beside --drive")
    found = [Problem(name, value or None, allowed) for name, value in others.items() if value is not None]
    refuse([*found, *output_problems(output, TABLE, CURVES, force=force)])
    file = read_drive_file(source, settings)
    at = USUAL_ANGLE if angle is None else angle
    if output is not None:
        write_drive(file.drive, file.text, one_line(PurePath(source).name), output, angle=at, force=force)
        return
    with page(_("Drive of a crank-rocker, (1) to (21) [{source}]", source=SOURCE)) as console:
        _show(console, drive_statements(file.drive, at), at, first_of=None if full else (source, angle, settings))


def read_drive_file(source: str, settings: Sequence[str]) -> _DriveFile:
    """Read a drive's table, or a machine; some values set anew. What is wrong stands at its line, or at `--set`."""
    if not source.strip():
        allowed = _("must be a file with a drive's table, a machine file, or `{example}`", example=EXAMPLE)
        raise InputError([Problem("--drive", '""', allowed)])
    own = [one for one in settings if one.partition("=")[0].strip() in DRIVE_KEYS]
    others = [one for one in settings if one not in own]
    if is_machine(source):
        return _of_machine(source, own, others)
    form, nothing = _('must be SYMBOL=VALUE, such as "Q=4 kN"'), _("no drive in it")
    return _DriveFile(*read_own("drive", source, settings, read_drive, form=form, nothing=nothing))


def _of_machine(source: str, own: Sequence[str], settings: Sequence[str]) -> _DriveFile:
    """Take a machine's crank-rocker; what it does not say is asked for as settings."""
    file = read_machine(source, settings)
    typed = {key.strip(): value.strip() for key, _equals, value in (one.partition("=") for one in own)}
    with (
        problems_as(lambda one: replace(one, position=SETTING) if one.path in typed else file.document.located(one)),
        problems_as(with_speaking(file.machine, source, settings, ("mechanism",))),
    ):
        return _DriveFile(machine_drive(file.machine, typed, as_set=_as_set), None)


def _as_set(symbol: str, value: str) -> str:
    """Write how a symbol is set in the terminal."""
    return shlex.join(("--set", f"{symbol}={value}"))


def _show(console: Console, found: Statements, angle: float, *, first_of: _Asked | None) -> None:
    """Show the linkage, forces at one angle, all curves, what is absurd, and pin friction.

    Or the first screen of what was asked: what leads to the motor, and what shows the rest.
    """
    width = console.width - INDENT
    (linkage, of_linkage), *others = found.notes.items()
    shown = _first(found) if first_of else found
    section(console, linkage, of_linkage)
    heading = _("At α = {angle:g}° from the line of the pivots", angle=angle)
    section(console, heading, _force_lines(shown, width))
    section(console, _("Over a turn"), _curve_lines(shown, width))
    if first_of:
        section(console, _("To go on"), _go_on(width, *first_of))
        return
    for subject, sentences in others:
        section(console, subject, _listed(sentences, width))
    section(console, _("Source"), [REFERENCES[SOURCE].text])


def _first(found: Statements) -> Statements:
    """Take what leads to the motor's shaft, right and printed."""
    numbers = (*_LEADING, *AT_MOTOR)
    return replace(
        found,
        each=tuple(one for one in found if one.equation in numbers and one.verdict != "refuted"),
        curves=tuple(one for one in found.curves if one.equation in AT_MOTOR and one.verdict != "refuted"),
    )


def _go_on(width: int, source: str, angle: float | None, settings: Sequence[str]) -> Iterator[str]:
    """Say what shows the rest; a command that has no room in a line by what is to be added to the typed one."""
    at = [] if angle is None else ["--at", f"{angle:g}"]
    for added, said in (
        (["--full"], _("all, with what is refuted, and pin friction")),
        (["-o", "fig2.svg"], _("fig. 2, redrawn; as .csv its curves")),
    ):
        command = f"`{textbook_command('--drive', source, *at, *added, settings=settings)}`"
        shown = command if cell_len(command) < width else _("the same with {option}", option=" ".join(added))
        yield f"{shown}: {said}"


def _listed(sentences: Sequence[str], width: int) -> Sequence[str | Text]:
    """One sentence as a paragraph, several with dashes."""
    return sentences if len(sentences) == 1 else table(("", ""), [("-", one) for one in sentences], fold=width)


def _force_lines(found: Statements, width: int) -> Iterator[Text]:
    """Directions, forces, the instant centre, the weights: (1) to (11), (15) to (17)."""
    curves = {one.name for one in found.curves}
    rows = [
        (
            f"{one.equation} {one.name}, {one.symbol}".strip(),
            _amount(one),
            "" if one.verdict == "right" else _(one.verdict),
        )
        for one in found
        if one.name not in curves
    ]
    yield from table(("", "", ""), rows, right=(1,), fold=width)


def _amount(one: Statement) -> str:
    """A number with its unit."""
    if one.unit == "rad":
        return f"{np.degrees(one.value):.4f}°"
    return f"{one.value:.6f}" if one.unit == "1" else str(number(one.value, "mm" if one.unit == "m" else one.unit))


def _curve_lines(found: Statements, width: int) -> Iterator[Text]:
    """Every curve with its value at the angle, its peaks in both half-periods, means and work."""
    words = {"right": _("right"), "printed": _("printed"), "refuted": _("refuted")}
    heads = (_("at α"), _("advancing"), _("going back"), _("mean"), _("rms"), _("a turn, J"))
    for unit in ("1", "N*m", "kg", "kg*m^2"):
        curves = [one for one in found.curves if one.unit == unit and one.verdict in words]
        if not curves:
            continue
        rows: list[list[str]] = []
        for curve in curves:
            facts = {one.at: one for one in found if (one.equation, one.name) == (curve.equation, curve.name)}
            rows.append([_fact(facts[at]) if at in facts else "" for at in FACTS])
        columns = [Column(head, "", tuple(texts)) for head, *texts in zip(heads, *rows, strict=True) if any(texts)]
        title = {"1": "", "N*m": "N·m", "kg": "kg", "kg*m^2": ""}[unit]
        if unit == "kg*m^2":
            yield Text("GD², kg·m² (kgf·m²)", style="bold")
        yield from _named(
            columns, title, [(one.equation, f"{words[one.verdict]}: {one.name}") for one in curves], width
        )


def _named(columns: Sequence[Column], title: str, named: Sequence[tuple[str, str]], width: int) -> Iterator[Text]:
    """Rows with numbers before and names below; columns for which there is no room stand in a table of their own."""
    numbers = [number for number, _name in named]
    for part in side_by_side(columns, width - max(map(cell_len, numbers))):
        head, *lines = column_table(part, numbers, title, has_units=False)
        yield head
        for line, (_number, name) in zip(lines, named, strict=True):
            yield line
            yield Text(f"       {name}")


def _fact(one: Statement) -> str:
    """A value, of a peak with its angle; five figures, and what is but rounding is 0."""
    if one.at == "turn":
        return figure(one.value, "J")
    plain = "0" if abs(one.value) < _ROUNDING else f"{one.value:.5g}"
    return f"{plain} {one.crank_angle:.1f}°" if one.at in PEAKS and np.isfinite(one.crank_angle) else plain
