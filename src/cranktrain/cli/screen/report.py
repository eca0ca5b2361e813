"""All of a result on the screen: answers, numbers, checks, what they rest on, and what is missing."""

import itertools
from collections.abc import Iterator, Sequence

import numpy as np
from rich.console import Console
from rich.text import Text

from cranktrain.analysis import Missing, Result, sentences
from cranktrain.analysis.dimensions import Place, rivals
from cranktrain.cli.screen.answer import conditions
from cranktrain.cli.screen.facts import fact_tables
from cranktrain.cli.screen.groups import RowGroup, group_lines
from cranktrain.cli.screen.text import INDENT, paragraph, section, table
from cranktrain.io.description import counted_by_status
from cranktrain.io.machine_file import Input, MachineFile, inputs_of
from cranktrain.language import said as _
from cranktrain.numerics.ties import first_largest, largest_of
from cranktrain.one_line import one_line
from cranktrain.saying.amounts import figures
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.wording import ABSENT, all_of

_NAMED = 4
"""How many of the results that something would give are named."""

_LISTED = ("assumed", "fitted")
"""Status of numbers that nobody measured: each of them is named."""


def show_full(console: Console, file: MachineFile, result: Result, names: Sequence[str], *, is_all: bool) -> None:
    """Show all that there is: answers, numbers, checks, what to mind, what this rests on, what is missing.

    Parameters
    ----------
    console : Console
    file : MachineFile
    result : Result
        Of one machine.
    names : sequence of str
        Which of its quantities.
    is_all : bool
        Whether these are all there are: then what is given by several methods is named, and its sentence has to do.
    """
    for line in conditions(result, console.width):
        console.print(line, soft_wrap=True)
    for sentence in sentences(result.unused):
        first, *more = paragraph(console, str(sentence))
        console.print(Text("\n").join([Text("! ") + first, *(Text("  ") + line for line in more)]), soft_wrap=True)
    console.print()
    groups = [RowGroup(str(title), rows) for title, rows in result.rows()]
    console.print(Text("\n").join(group_lines(groups, console.width)), soft_wrap=True)
    show_numbers(console, result, names, is_all=is_all)
    show_checks(console, result)
    section(console, _("Mind"), result.flags)
    section(console, _("What this rests on"), _provenance(file, console.width - INDENT))
    show_missing(console, result)


def show_numbers(console: Console, result: Result, names: Sequence[str], *, is_all: bool) -> None:
    """Show facts, and the peaks of curves; parameters as of `show_full`."""
    width = console.width - INDENT
    deep = [name for name in names if is_all and len(result.labels_of(result.catalogue[name])) > 1]
    names = [name for name in names if name not in deep]
    facts = [name for name in names if result.catalogue[name].is_fact]
    section(console, _("Results"), fact_tables(result, facts, width))
    peaks = list(_peaks(result, names))
    if peaks:
        step = f"{result.crank_angle[1]:g}°"
        heading = _("Largest values of the curves, in steps of {step}", step=step)
        heads = ("", "", _("peak"), "", _("at °"), _("of"))
        section(console, heading, table(heads, peaks, right=(2, 4), fold=width))
    if deep:
        section(console, _("By each method, with --quantities"), [", ".join(deep)])


def show_checks(console: Console, result: Result) -> None:
    """Show every check with its residual and limit."""
    section(console, _("Checks"), _checks(console, result))


def show_inputs(console: Console, file: MachineFile) -> None:
    """Show every number of the file and where it is from."""
    section(console, _("What this rests on"), input_table(inputs_of(file), console.width - INDENT))


def show_missing(console: Console, result: Result) -> None:
    """Show what the file could say, and what that would give."""
    section(console, _("To learn more"), map(_missing, result.worth_asking))


def _peaks(result: Result, names: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """Give the largest size of every curve, by each method: name, symbol, value, unit, where and whose."""
    for entry in map(result.catalogue.__getitem__, names):
        if entry.is_fact:
            continue
        labels = result.titles_of(entry)
        for place, method in rivals(labels):
            value, at, member = _refined(result, entry, place) or _in_steps(result, entry, place)
            shown = figures(np.array([value]), entry.shown)
            along = [names for names, chosen in zip(labels.values(), place, strict=True) if isinstance(chosen, slice)]
            members = [", ".join(names) for names in itertools.product(*along)]
            whose = ", ".join(filter(None, (method, members[member] if len(members) > 1 else "")))
            words = (ABSENT, "", "", method) if np.isnan(value) else (shown.texts[0], shown.unit, at, whose)
            yield entry.name, entry.symbol, *words


def _in_steps(result: Result, entry: Entry, place: Place) -> tuple[float, str, int]:
    """Largest size of a curve among its steps, at which and whose; NaN where it has none."""
    curves = np.reshape(getattr(result, entry.name)[place], (-1, result.crank_angle.size))
    size = np.nan_to_num(np.abs(curves), nan=-1.0)
    member, step = np.unravel_index(first_largest(size), size.shape)
    return float(curves[member, step]), f"{result.crank_angle[step]:g}", int(member)


def _refined(result: Result, entry: Entry, place: Place) -> tuple[float, str, int] | None:
    """Largest size of a curve, where and whose, if facts are its ends: no step has a part in these."""
    found: list[tuple[float, str, int]] = []
    for extreme in (one for one in result.catalogue.values() if one.of == entry.name):
        values, angles = (np.ravel(getattr(result, name)[place]) for name in (extreme.name, extreme.at))
        sizes = np.nan_to_num(np.abs(values), nan=-1.0)
        member = first_largest(sizes)
        if sizes[member] >= 0:
            where = "" if np.isnan(angles[member]) else f"{angles[member]:.1f}"  # of what is level, nowhere
            found.append((float(values[member]), where, member))
    # Of ends that are as far from 0, the lower one.
    return largest_of(sorted(found), lambda one: abs(one[0])) if found else None


def _checks(console: Console, result: Result) -> Iterator[Text]:
    """Say of every check whether it holds, how well, and what is compared."""
    for check in result.checks:
        residual = float(check.residual[0])
        if not check.judged[0]:
            yield from paragraph(console, f"– {check.verdict()}: {check.sentence}", "")
            continue
        mark, style = ("✓", "") if check.passed[0] else ("✗", "red")
        said = _(
            "{mark} {verdict} (residual {residual}, limit {limit:.0e}): {sentence}",
            mark=mark,
            verdict=check.verdict(),
            residual=f"{residual:.1e}" if residual else "0",
            limit=check.limit,
            sentence=check.sentence,
        )
        yield from paragraph(console, said, style)


def _missing(missing: Missing) -> str:
    """Say what the file would have to say, and what it would give."""
    results = ", ".join(missing.results[:_NAMED])
    more = len(missing.results) - _NAMED
    if more > 0:
        results = _("{results} and {n} more", results=results, n=more)
    return _("{needs}: gives {results}", needs=all_of(missing.needs), results=results)


def _provenance(file: MachineFile, width: int) -> Iterator[str | Text]:
    """Count the numbers of a file by status, and name those that are assumed or fitted, in a width of columns."""
    inputs = inputs_of(file)
    counted = counted_by_status(one.given for one in inputs)
    yield _("{n} numbers of the file: {counted}", n=len(inputs), counted=counted)
    listed = [one for status in _LISTED for one in inputs if one.given.status == status]
    if listed:
        yield from input_table(listed, width)


def input_table(inputs: Sequence[Input], width: int) -> list[Text]:
    """Path, value, status and note of numbers of a file, in a width of columns."""
    notes = ["; ".join(one_line(word) for word in (given.note, given.source) if word) for _path, given in inputs]
    rows = [
        (path, one_line(given.text), given.status or "", note)
        for (path, given), note in zip(inputs, notes, strict=True)
    ]
    return table(("", "", "", ""), rows, fold=width)
