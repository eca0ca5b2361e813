"""`compare`: two machines side by side, or one with itself where some values are others."""

from collections.abc import Iterator
from pathlib import Path

from rich.text import Text

from cranktrain.analysis import Result, sentences
from cranktrain.analysis.comparison import Comparison, compared
from cranktrain.cli.asked import Asked, in_units_of, units_asked_for
from cranktrain.cli.how_far import says_how_far
from cranktrain.cli.run_files import form_or_picture, write_run
from cranktrain.cli.screen.sections import show_sections
from cranktrain.cli.screen.text import page
from cranktrain.cli.why import refuse_beside, show_why
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.io.examples import example_called
from cranktrain.io.machine_file import MachineFile, computed, read_machine
from cranktrain.io.title import title
from cranktrain.language import said as _
from cranktrain.one_line import one_line
from cranktrain.record import record


@record
class CompareRequest(Asked):
    """What is asked of `compare`, as typed; `quantities` is None for the headlines."""

    second: str | None = None
    decimal: str = "point"
    quantities: tuple[str, ...] | None = None
    why: str | None = None


def show_comparison(request: CompareRequest) -> None:
    """Compute both, compare, draw where asked, and show.

    Raises
    ------
    InputError
        With everything that is wrong with the request, else with both machines.
    """
    _check(request)
    refuse_beside(request.why, (request.output is not None,))
    asked = units_asked_for(request.units)
    files = _read(request)
    with in_units_of(files[0], asked):
        _show(files, request)


def _show(files: tuple[MachineFile, MachineFile], request: CompareRequest) -> None:
    """Compute both, compare, draw where asked, and show."""
    results = _computed(files, request)
    comparison = compared(results, _names(request), request.quantities)
    if request.why is not None:
        show_why(_heads(comparison, files, request)[0], comparison, request.why, files[0])
        return
    if request.output is not None:
        form = form_or_picture(request.output, request.decimal)
        if form is not None:
            refuse(_is_curve(name) for name in request.quantities or () if name not in comparison.catalogue)
            write_run(comparison, form, request.output, {}, force=request.force)
            return
        from cranktrain.cli.quiet_pictures import save_quietly

        save_quietly(comparison.plot, request.output, force=request.force)
        print(_("written: {name}", name=one_line(request.output)))
        return
    heads = _heads(comparison, files, request)
    with page(heads[0]) as console:
        console.print(Text(heads[1], style="bold"))
        show_sections(console, comparison.sections())
        console.print()
        for line in _minded(comparison):
            console.print(Text(line), soft_wrap=len(line) <= console.width)


def _heads(comparison: Comparison, files: tuple[MachineFile, MachineFile], request: CompareRequest) -> list[str]:
    """Name both machines; of one with other values, these."""
    heads = [f"{one_line(name)}: {title(file.machine)}" for name, file in zip(comparison.names, files, strict=True)]
    if request.second is None:
        heads[1] = _("changed: {values}", values=one_line(", ".join(request.settings)))
    return heads


def _is_curve(name: str) -> Problem:
    """Refuse a curve among the facts of two machines."""
    allowed = _("is a curve, and a file of two machines has facts")
    return Problem("quantities", name, allowed, _("write the curves of one, or draw both: -o FILE.png"))


def _minded(comparison: Comparison) -> Iterator[str]:
    """Say what of a machine's tables is not used, and where to read what else is to be minded."""
    for name, result in zip(comparison.names, comparison.results, strict=True):
        said = sentences(result.unused)
        yield from (f"! {one_line(name)}: {sentence}" for sentence in said)
        n_failed = sum(bool((check.judged & ~check.passed).any()) for check in result.checks)
        if n_failed:
            yield _("! {name}: checks that do not hold: {n}", name=one_line(name), n=n_failed)
    flagged = [len(result.flag_words) for result in comparison.results]
    if any(flagged):
        first, second = (one_line(name) for name in comparison.names)
        yield _(
            "Flags: {n_first} of {first}, {n_second} of {second}; `cranktrain run` says them.",
            n_first=flagged[0],
            first=first,
            n_second=flagged[1],
            second=second,
        )


def _check(request: CompareRequest) -> None:
    """Refuse what cannot be compared, and a file that cannot be written."""
    if request.output is not None:
        form_or_picture(request.output, request.decimal)
    if request.quantities == ():
        allowed = _("must be names of results, with commas between; `cranktrain list results` names them")
        raise InputError([Problem("--quantities", '""', allowed)])
    if request.second is None and not request.settings:
        allowed = _("must be compared with something: another machine, or itself with --set PATH=VALUE")
        repair = _("write cranktrain compare {first} kamaz_740, or --set shaft.main.speed=1500rpm", first=request.file)
        raise InputError([Problem("compare", request.file, allowed, repair)])
    if request.second is not None and _is_same(request.file, request.second):
        allowed = _("is named twice, and differs in nothing from itself")
        repair = _("name another, or name it once and set a value: --set PATH=VALUE")
        raise InputError([Problem("compare", request.second, allowed, repair)])


def _is_same(first: str, second: str) -> bool:
    """Whether two names mean one file, or one example."""
    if Path(first).is_file() or Path(second).is_file():
        return Path(first).exists() and Path(second).exists() and Path(first).samefile(second)
    return first == second or (example_called(first) is not None and example_called(first) == example_called(second))


def _read(request: CompareRequest) -> tuple[MachineFile, MachineFile]:
    """Read both machines; what is wrong with either is told."""
    asked = (
        (request.file, () if request.second is None else request.settings),
        (request.file if request.second is None else request.second, request.settings),
    )
    found: list[MachineFile] = []
    problems: list[Problem] = []
    for source, settings in asked:
        try:
            found.append(read_machine(source, settings, partial=request.is_partial))
        except InputError as error:
            problems += [problem for problem in error.problems if problem not in problems]
    refuse(problems)
    return found[0], found[1]


def _computed(files: tuple[MachineFile, MachineFile], request: CompareRequest) -> tuple[Result, Result]:
    """Compute both."""
    with says_how_far():
        one, other = (computed(file, partial=request.is_partial, quantities=request.quantities) for file in files)
        for result in (one, other):
            (Result.find_answer if request.quantities is None else Result.find_all)(result)
    return one, other


def _names(request: CompareRequest) -> tuple[str, str]:
    """Name both machines as they were typed; of one with other values, these."""
    if request.second is None:
        values = ", ".join(setting.replace("=", " = ", 1) for setting in request.settings)
        return request.file, _("{name} with {values}", name=request.file, values=values)
    return request.file, request.second
