"""`run`: compute what a machine file allows, write it where asked, and show it."""

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from rich.text import Text

from cranktrain.analysis import Result, sentences
from cranktrain.cli.asked import (
    AskedAtSpeed,
    CurvesAsked,
    at_running_speed,
    decimal_problems,
    in_units_of,
    units_asked_for,
)
from cranktrain.cli.screen.text import page, paragraph, show_lines
from cranktrain.errors import InputError, Problem, problems_as, refuse
from cranktrain.io.machine_file import MachineFile, inputs_of
from cranktrain.io.output import write_whole
from cranktrain.language import said as _
from cranktrain.one_line import one_line
from cranktrain.record import record

if TYPE_CHECKING:
    from cranktrain.io.writers import Form


@record
class RunRequest(AskedAtSpeed):
    """What is asked of `run`, as typed; `quantities` is None for all."""

    quantities: tuple[str, ...] | None = None
    step_degrees: float = 1.0
    decimal: str = "point"
    facts: bool = False
    curves: CurvesAsked = CurvesAsked()
    why: str | None = None


@record
class Shown:
    """What is shown instead of the answer."""

    full: bool = False
    checks: bool = False
    inputs: bool = False
    missing: bool = False

    def __bool__(self) -> bool:
        """Whether any of them is."""
        return self.full or self.checks or self.inputs or self.missing


def show_run(request: RunRequest, shown: Shown | None = None) -> None:
    """Compute, write and show."""
    form = _form(request)
    refuse(request.curves.problems())
    if request.why is not None:
        from cranktrain.cli.why import refuse_beside

        refuse_beside(request.why, (request.output is not None, request.curves, shown))
    if request.curves and shown:
        raise InputError(
            [Problem("--at", None, _("and --table show curves alone"), _("leave --full and the like out"))]
        )
    if request.quantities == ():
        allowed = _("must be names of results, with commas between; `cranktrain list results` names them")
        raise InputError([Problem("--quantities", '""', allowed)])
    asked = units_asked_for(request.units)
    file = request.read()
    with in_units_of(file, asked):
        if request.why is not None:
            from cranktrain.cli.why import show_why
            from cranktrain.io.title import title

            result = request.result(file, step_degrees=request.step_degrees)
            show_why(title(file.machine), result, request.why, file)
        elif request.curves:
            _show_curves(file, request, form)
        else:
            _show(file, request, shown, form)


def _show_curves(file: MachineFile, request: RunRequest, form: "Form | None") -> None:
    """Compute curves at some crank angles, and write or show them."""
    from cranktrain.cli.curves import angles_asked, chosen_curves, names_asked, show_curves, step_for, table_title

    asked = request.curves
    angles = angles_asked(asked, round(float(np.degrees(file.machine.cycle))))
    names = names_asked(file.machine, asked, request.quantities)
    wanted = replace(request, quantities=names, step_degrees=step_for(angles))
    if asked.table is not None:
        result = request.result(file, Result.find_all, step_degrees=wanted.step_degrees, quantities=names)
    else:
        result = _computed(file, wanted)
    chosen = chosen_curves(result, asked, names, angles)
    if request.output is not None and form is not None:
        from cranktrain.io.writers import written_curves

        write_whole(request.output, written_curves(form, result, chosen.columns, chosen.angles), force=request.force)
    elif request.output is not None:
        from cranktrain.panels.parts import sheet_of
        from cranktrain.viz.curve_table import curve_table
        from cranktrain.viz.output import save

        sheet = sheet_of(result, 0, table_title(asked, chosen))
        save(curve_table(sheet, chosen.columns, chosen.angles), request.output, force=request.force)
    _show_minded(result)
    if request.output is None:
        show_curves(result, asked, request.quantities, chosen)
    else:
        print(_("written: {name}", name=one_line(request.output)))


def _show(file: MachineFile, request: RunRequest, shown: Shown | None, form: "Form | None") -> None:
    """Compute, write and show what was read."""
    if request.output is None or form is None:
        result = _computed(file, request, is_answer=not shown and request.quantities is None)
    else:
        result = _written(file, request, request.output, form)
    if shown:
        _show_parts(file, result, request, shown)
    elif request.output is not None:
        _show_minded(result)
    elif request.quantities is not None:
        _show_numbers(result, request)
    else:
        _show_answer(file, result, request)
    if request.output is not None:
        print(_("written: {name}", name=one_line(request.output)))


def _show_parts(file: MachineFile, result: Result, request: RunRequest, shown: Shown) -> None:
    """Show what was asked for by options."""
    from cranktrain.analysis.result_sections import check_section, missing_section, result_sections
    from cranktrain.cli.screen.sections import show_sections
    from cranktrain.io.input_sections import input_section, provenance_section
    from cranktrain.io.title import title

    with page(title(file.machine)) as console:
        if shown.full:
            show_lines(console, _above_all(result, console.width))
            names = None if request.quantities is None else _chosen(result, request)
            show_sections(console, result_sections(result, names, provenance_section(file)))
        if shown.checks and not shown.full:
            show_sections(console, check_section(result))
        if shown.inputs:
            show_sections(console, input_section(inputs_of(file)))
        if shown.missing and not shown.full:
            show_sections(console, missing_section(result))


def _above_all(result: Result, width: int) -> Iterator[Text]:
    """At which speed all is, where it varies, and what of the file is not used."""
    from cranktrain.cli.screen.answer import MARK, conditions

    yield from map(Text, conditions(result, width))
    for sentence in sentences(result.unused):
        for place, line in enumerate(paragraph(str(sentence), width - len(MARK))):
            yield Text(" " * len(MARK) if place else MARK) + line


def _show_numbers(result: Result, request: RunRequest) -> None:
    """Show the quantities that were asked for, and what is to be minded before them."""
    from cranktrain.analysis.result_sections import number_sections
    from cranktrain.cli.screen.sections import show_sections

    _show_minded(result)
    with page() as console:
        show_sections(console, number_sections(result, _chosen(result, request), is_all=False))


def _show_minded(result: Result) -> None:
    """Show what is to be minded."""
    from cranktrain.cli.screen.answer import minded_lines

    with page() as console:
        show_lines(console, (Text(line) for line in minded_lines(result, console.width)))


def _show_answer(file: MachineFile, result: Result, request: RunRequest) -> None:
    """Show the answer on one screen."""
    from cranktrain.cli.screen.answer import answer_lines

    with page() as console:
        show_lines(console, answer_lines(file, result, request.file, console.width))


def _form(request: RunRequest) -> "Form | None":
    """How the output is to be written, by its suffix and what was asked besides; None where there is none."""
    refuse(decimal_problems(request.decimal))
    if request.output is None:
        given = {"--decimal": request.decimal != "point", "--facts": request.facts}
        needs = _("is for a file: name one with -o, such as -o {name}", name="facts.csv")
        refuse(Problem(option, None, needs) for option, is_given in given.items() if is_given)
        return None
    from cranktrain.cli.run_files import form_of, form_or_picture  # only where something is written

    how = form_of if request.curves.table is None else form_or_picture  # a table may be on a sheet of paper
    return how(request.output, request.decimal, facts=request.facts)


def _computed(file: MachineFile, request: RunRequest, *, is_answer: bool = False) -> Result:
    """Compute all, or what the answer takes; refuse a quantity that was asked for and that this machine has not."""
    with problems_as(at_running_speed):
        find = Result.find_answer if is_answer else Result.find_all
        result = request.result(file, find, step_degrees=request.step_degrees, quantities=request.quantities)
    names = request.quantities or ()
    refuse(_absence(name, result, request.file) for name in names if name not in result.catalogue)
    return result


def _absence(name: str, result: Result, file: str) -> Problem:
    """Say what a quantity needs that the file does not give."""
    allowed = _("is no result of this machine; `cranktrain check {file}` names what is", file=file)
    if needs := result.needs_of(name):
        allowed = _("needs {needs} in the file", needs=", ".join(map(str, needs)))
    return Problem("quantities", name, allowed)


def _written(file: MachineFile, request: RunRequest, output: str, form: "Form") -> Result:
    """Compute once the output is known to be possible, and write it."""
    from cranktrain.io.writers import written

    made: list[Result] = []

    def pieces() -> Iterator[str | bytes]:
        result = _computed(file, request)
        made.append(result)
        is_all = request.quantities is None
        yield from written(form, result, file.document.data, _chosen(result, request), is_all=is_all)

    write_whole(output, pieces(), force=request.force)
    return made[0]


def _chosen(result: Result, request: RunRequest) -> tuple[str, ...]:
    """Names of the quantities to show and write, in the order of the catalogue."""
    return tuple(name for name in result.catalogue if request.quantities is None or name in request.quantities)
