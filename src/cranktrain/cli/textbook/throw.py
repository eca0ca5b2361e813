"""`textbook --throw`: (44) to (53) for a throw, each constituent and all together, and its two balances."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import PurePath
from typing import NamedTuple, cast

import numpy as np
from rich.console import Console
from rich.text import Text

from cranktrain.cli.screen.columns import Column, column_tables
from cranktrain.cli.screen.text import INDENT, page, section, table
from cranktrain.cli.textbook.output import CURVES, TABLE, output_problems, write_machine_throw, write_throw
from cranktrain.cli.textbook.source import EXAMPLE, read_own
from cranktrain.cli.textbook.speaking import with_speaking
from cranktrain.cli.textbook.tables import show_curves
from cranktrain.cli.to_type import textbook_command
from cranktrain.errors import Problem, problems_as, refuse
from cranktrain.grouping import grouped
from cranktrain.io.machine_file import read_machine
from cranktrain.io.own_tables import is_machine
from cranktrain.language import said as _
from cranktrain.numerics.ties import first_largest, first_smallest
from cranktrain.one_line import one_line
from cranktrain.plans.machine_throw import ThrownMachine
from cranktrain.plans.throw_loads import CrankMasses
from cranktrain.references import REFERENCES
from cranktrain.saying.wording import figure, number
from cranktrain.textbook.statements import Statements
from cranktrain.textbook.throw_statements import REACTIONS, SOURCE, TOGETHER, machine_statements, throw_statements
from cranktrain.texts.throw_table import Throw, read_throw

_ONE_TURN = 360.0
_ON_A_SCREEN, _WHOLE = 60.0, 30.0
"""Between the rows of a cycle of two turns that fits a screen, and of all else. [deg]"""


_NOTHING = 1e-12
"""Of the largest length or force of a figure; what is less is not shown."""
_SAID = 5e-3
"""A smaller difference is written with its power. [N]"""
_OPTIONS = {"throw_number": "--throw-number", "crank_masses": "--crank-masses"}


class _ThrowFile(NamedTuple):
    """A throw and the text that declares it."""

    throw: Throw
    text: str


class OfMachine(NamedTuple):
    """What is asked of a machine's throw: its number, the crank angle [deg], whose masses, a table over the cycle."""

    number: str | None = None
    at: float | None = None
    masses: str | None = None
    with_table: bool = False

    @property
    def typed(self) -> Mapping[str, str | None]:
        """The options as typed."""
        return {
            "--throw-number": self.number,
            "--at": None if self.at is None else f"{self.at:g}",
            "--crank-masses": self.masses,
            "--table": "" if self.with_table else None,
        }


_OF_TABLE = OfMachine()
"""Nothing is asked of a throw that is no machine's."""


def show_throw(
    source: str,
    settings: Sequence[str],
    output: str | None,
    *,
    asked: OfMachine,
    full: bool,
    force: bool,
    others: Mapping[str, str | None],
) -> None:
    """Show a throw's reactions, or write its table, its curves or its scheme.

    Parameters
    ----------
    source : str
        A file with its table, a machine file or an example with [crankshaft], or `example`, if no file is called so.
    settings : sequence of str
        `SYMBOL=VALUE`; of a machine `PATH=VALUE`.
    output : str or None
        File to write instead: .toml, .png, .svg, .pdf; of a machine .csv, and no .toml.
    asked : OfMachine
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
    allowed = _("must be left out beside --throw")
    found = [Problem(name, value or None, allowed) for name, value in others.items() if value is not None]
    if not source.strip():
        missing = _("must be a file with a throw's table, a machine file, or `{example}`", example=EXAMPLE)
        found.append(Problem("--throw", '""', missing))
    refuse(found)
    of_machine = is_machine(source)
    refuse(output_problems(output, CURVES if of_machine else TABLE, force=force))
    if of_machine:
        _show_of_machine(source, settings, output, asked, full=full, force=force)
        return
    allowed = _("is for the throw of a machine: name its file")
    refuse(Problem(name, value or None, allowed) for name, value in asked.typed.items() if value is not None)
    file = read_throw_file(source, settings)
    if output is not None:
        write_throw(file.throw, file.text, one_line(PurePath(source).name), output, force=force)
        return
    statements = throw_statements(file.throw)
    with page(statements.title) as console:
        _show(console, statements, whole=None if full else _whole(source, settings))


def _show_of_machine(
    source: str, settings: Sequence[str], output: str | None, asked: OfMachine, *, full: bool, force: bool
) -> None:
    """Show the throw of a machine, or write it."""
    file = read_machine(source, settings)
    masses = cast("CrankMasses", asked.masses or "given")  # any other is refused
    unspoken_of = ("mechanism", "crankshaft", *(() if asked.number else ("throw_number",)))
    with (
        problems_as(lambda one: _as_typed(one) if one.path in _OPTIONS else file.document.located(one)),
        problems_as(with_speaking(file.machine, source, settings, unspoken_of)),
    ):
        machine = ThrownMachine(file.machine)
        of = (asked.number or next(iter(machine.throws)), asked.at, masses)
        statements = machine_statements(machine, *of)
    if output is not None:
        write_machine_throw(machine, of, statements, output, force=force)
        return
    with page(statements.title) as console:
        _show(console, statements, with_table=asked.with_table, whole=None if full else _whole(source, settings, asked))


def _whole(source: str, settings: Sequence[str], asked: OfMachine = _OF_TABLE) -> str:
    """The command for all of what was asked."""
    options = (word for name, value in asked.typed.items() if value is not None for word in (name, value) if word)
    return textbook_command("--throw", source, *options, "--full", settings=settings)


def _as_typed(problem: Problem) -> Problem:
    """A problem at the option that has it."""
    return replace(problem, path=_OPTIONS[problem.path])


def read_throw_file(source: str, settings: Sequence[str]) -> _ThrowFile:
    """Read a throw's table with some values set anew; what is wrong stands at its line, or at `--set`."""
    form, nothing = _('must be SYMBOL=VALUE, such as "K1=20 kN"'), _("no throw in it")
    return _ThrowFile(*read_own("throw", source, settings, read_throw, form=form, nothing=nothing))


def _show(console: Console, found: Statements, *, with_table: bool = False, whole: str | None) -> None:
    """Show lengths, forces, reactions, balance, and what is to be minded; or a first screen.

    The command for the whole stands below the first screen.
    """
    width = console.width - INDENT
    (throw, about), (balance, follows), (mind, minded) = found.notes.items()
    if whole is None or not with_table:
        section(console, throw, [*about, *_figure_lines(found, width)])
        section(console, _("Loads of the journals on the bearings L and P"), _reaction_lines(found, width))
        if found.curves:
            section(console, _("Over the cycle, at whole degrees"), _cycle_lines(found, width))
    if with_table:
        curves = ((one.symbol, one) for one in found.curves)
        is_on_a_screen = whole is not None and found.crank_angle[-1] > _ONE_TURN
        step = _ON_A_SCREEN if is_on_a_screen else _WHOLE
        show_curves(console, _("Over the cycle"), found.crank_angle, curves, _("split"), step)
    if whole is not None:
        said = _("`{command}`: all, with both balances of the rotating masses and what is to be minded")
        section(console, _("To go on"), [said.format(command=whole)])
        return
    section(console, balance, [*_balance_lines(found), "", *follows])
    section(console, mind, table(("", ""), [("-", one) for one in minded], fold=width))
    section(console, _("Source"), [REFERENCES[SOURCE].text])


def _figure_lines(found: Statements, width: int) -> Iterator[Text]:
    """Lengths and forces of fig. 35, but those that are 0."""
    for unit, shown in (("m", "mm"), ("N", "N")):
        own = [one for one in found.numbered("fig. 35") if one.unit == unit and one.symbol != "l"]
        peak = max((abs(one.value) for one in own), default=0.0)
        columns = [
            Column(one.symbol, shown, (figure(one.value, shown),)) for one in own if abs(one.value) > _NOTHING * peak
        ]
        if columns:
            yield from column_tables(columns, [""], width)


def _reaction_lines(found: Statements, width: int) -> Iterator[str | Text]:
    """Each constituent in a row, all together, what has no letter, and the split shaft; the resultants."""
    each = [one for one in found if one.symbol in REACTIONS.values()]
    names = dict.fromkeys(one.name for one in each)
    rows = [(name, {one.symbol: one for one in each if one.name == name}) for name in names]
    labels = [f"{name} {' '.join(dict.fromkeys(one.equation for one in own.values()))}".strip() for name, own in rows]
    cells = [{symbol: one.value for symbol, one in own.items()} for _name, own in rows]
    whole = dict(rows)[_(TOGETHER)]
    labels[list(names).index(_(TOGETHER))] = _(TOGETHER)
    if found.curves:
        labels.append(_("split shaft"))
        cells.append({symbol: one.exact for symbol, one in whole.items()})
    columns = [
        Column(symbol, "N", tuple(figure(own.get(symbol, 0.0), "N") for own in cells)) for symbol in REACTIONS.values()
    ]
    yield _("K inward, to the axis; T with the rotation, at the crank pin's angle.")
    yield from column_tables(columns, labels, width)
    yield ""
    right, left = (next(one for one in found if one.symbol == symbol) for symbol in ("R_P", "R_L"))
    yield _("Resultants: R_P = {right}, R_L = {left}.", right=number(right.value, "N"), left=number(left.value, "N"))
    if any(one.verdict == "beyond" for one in each):
        yield _(
            "Rows without a number are loads for which the text has no letter. With them, as the split shaft has it: "
            "R_P = {right}, R_L = {left}.",
            right=number(right.exact, "N"),
            left=number(left.exact, "N"),
        )


def _cycle_lines(found: Statements, width: int) -> Iterator[Text]:
    """Least and largest of each reaction by the text, and how far it is from the split shaft."""
    columns: list[Column] = []
    for head, pick in ((_("least"), first_smallest), (_("largest"), first_largest)):
        places = [pick(one.values) for one in found.curves]
        values = [float(one.values[at]) for one, at in zip(found.curves, places, strict=True)]
        columns.append(Column(head, "N", tuple(figure(value, "N") for value in values)))
        columns.append(Column("φ", "deg", tuple(f"{found.crank_angle[at]:g}" for at in places)))
    off = [float(np.max(np.abs(one.values - one.exact))) for one in found.curves if one.exact is not None]
    columns.append(
        Column(_("off by"), "N", tuple(f"{value:.1e}" if value < _SAID else figure(value, "N") for value in off))
    )
    yield from column_tables(columns, [one.symbol for one in found.curves], width)


def _balance_lines(found: Statements) -> Iterator[Text]:
    """Both conditions with what is left over."""
    conditions = grouped((one.name, one) for one in found.numbered("after (53)"))
    rows = [
        (
            name,
            *(str(number(one.value, one.unit)) for one in own),
            _("does not") if any(one.value for one in own) else _("holds"),
        )
        for name, own in conditions.items()
    ]
    yield from table((_("balance"), _("outward"), _("against the rotation"), ""), rows, right=(1, 2))
