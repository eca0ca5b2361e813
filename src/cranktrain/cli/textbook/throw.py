"""`textbook --throw`: reads a throw, or a machine's, and shows it or writes it."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from pathlib import PurePath
from typing import TYPE_CHECKING, NamedTuple, cast

from cranktrain.cli.run_files import texts_of
from cranktrain.cli.textbook.output import CURVES, TABLE, output_problems, show_or_write
from cranktrain.cli.textbook.source import EXAMPLE, read_own
from cranktrain.cli.textbook.typed import OF_MOTION, TextbookRequest
from cranktrain.errors import Problem, problems_as, refuse
from cranktrain.io.machine_file import read_machine
from cranktrain.io.own_tables import is_machine
from cranktrain.language import said as _
from cranktrain.one_line import one_line
from cranktrain.plans.machine_throw import ThrownMachine
from cranktrain.plans.throw_loads import CrankMasses
from cranktrain.textbook.commands import textbook_command
from cranktrain.textbook.shown.throw import throw_sections
from cranktrain.textbook.speaking import with_speaking
from cranktrain.textbook.statements import Statements
from cranktrain.textbook.throw_statements import machine_statements, throw_statements
from cranktrain.texts.throw_table import read_throw

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_OTHERS = ("FILE", "--source", "--errata", *OF_MOTION)
_OF_MACHINE = ("--throw-number", "--at", "--crank-masses", "--table")
_OPTIONS = {"throw_number": "--throw-number", "crank_masses": "--crank-masses"}


class _ThrowFile(NamedTuple):
    """What is stated of a throw, and what can be written of it."""

    statements: Statements
    texts: Mapping[str, Callable[[], str | Iterable[str | bytes]]]
    draw: "Callable[[], Figure]"


def show_throw(asked: TextbookRequest) -> None:
    """Show a throw's reactions, or write its table, its curves or its scheme.

    Parameters
    ----------
    asked : TextbookRequest
        `throw` is a file with its table, a machine file or an example with [crankshaft], or `example`, if no file is
        called so; `settings` are `SYMBOL=VALUE`, of a machine `PATH=VALUE`.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    source = asked.throw or ""
    found = [*asked.beside(_("must be left out beside --throw"), *_OTHERS)]
    if not source.strip():
        missing = _("must be a file with a throw's table, a machine file, or `{example}`", example=EXAMPLE)
        found.append(Problem("--throw", '""', missing))
    refuse(found)
    of_machine = is_machine(source)
    refuse(output_problems(asked, *(CURVES if of_machine else (TABLE,))))
    file = _of_machine(asked, source) if of_machine else _of_table(asked, source)
    options = (word for pair in asked.typed(*_OF_MACHINE) for word in pair if word)
    whole = textbook_command("--throw", source, *options, "--full", settings=asked.settings)
    sections = throw_sections(file.statements, with_table=asked.table, whole=None if asked.full else whole)
    show_or_write(asked, file.statements.heading, sections, file.texts, file.draw)


def _of_table(asked: TextbookRequest, source: str) -> _ThrowFile:
    """Read a throw's table with some values set anew; what is wrong stands at its line, or at `--set`."""
    refuse(asked.beside(_("is for the throw of a machine: name its file"), *_OF_MACHINE))
    form, nothing = _('must be SYMBOL=VALUE, such as "K1=20 kN"'), _("no throw in it")
    throw, text = read_own("throw", source, asked.settings, read_throw, form=form, nothing=nothing)

    def scheme() -> "Figure":
        from cranktrain.viz.plans.throw_scheme import throw_figure

        return throw_figure(throw, one_line(PurePath(source).name))

    return _ThrowFile(throw_statements(throw), {TABLE: lambda: text}, scheme)


def _of_machine(asked: TextbookRequest, source: str) -> _ThrowFile:
    """Take the throw of a machine; what is wrong stands at its line, or at the option that has it."""
    file = read_machine(source, asked.settings)
    masses = cast("CrankMasses", asked.crank_masses or "given")  # any other is refused
    unspoken_of = ("mechanism", "crankshaft", *(() if asked.throw_number else ("throw_number",)))
    with (
        problems_as(lambda one: _as_typed(one) if one.path in _OPTIONS else file.document.located(one)),
        problems_as(with_speaking(file.machine, source, asked.settings, unspoken_of)),
    ):
        machine = ThrownMachine(file.machine)
        of = (asked.throw_number or next(iter(machine.throws)), asked.at, masses)
        statements = machine_statements(machine, *of)

    def scheme() -> "Figure":
        from cranktrain.viz.plans.throw_scheme import machine_throw_figure

        return machine_throw_figure(machine, *of)

    return _ThrowFile(statements, {CURVES[0]: statements.csv, **texts_of(lambda: statements)}, scheme)


def _as_typed(problem: Problem) -> Problem:
    """A problem at the option that has it."""
    return replace(problem, path=_OPTIONS[problem.path])
